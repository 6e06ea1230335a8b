#include "Logic/Registration/PreparedPreop.h"

#include <numeric>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Registration/ScanSample.h"

namespace falciform {

namespace {

constexpr double kGridCellMm = 4, kGridMarginMm = 40, kLabelMarginMm = 60;
constexpr Index kSample = 8000;

const Surface& checked(const Surface& preop) {
  checkSurface(preop, "pre-op surface");
  if (preop.size() < 3)
    throw InputError("pre-op surface has " + std::to_string(preop.size()) +
                     " points; a pose needs at least 3");
  return preop;
}

}  // namespace

PreparedPreop::PreparedPreop(const Surface& preop) : surface_(checked(preop)), modes_(preop) {
  normals_ = vertexNormals(preop);
  areas_ = vertexAreas(preop);
  sample_ = randomRows(preop.size(), kSample);
  std::vector<int> all(static_cast<std::size_t>(preop.size()));
  std::iota(all.begin(), all.end(), 0);
  grid_ = ClosestPointGrid(preop.points, all, kGridCellMm, kGridMarginMm);
  for (const int label : patchLabels(preop))
    labelGrids_[label] =
        ClosestPointGrid(preop.points, pointsOfPatch(preop, label), kGridCellMm, kLabelMarginMm);
  target_ = std::make_shared<const LabelledTarget>(preop, patchLabels(preop));
}

}  // namespace falciform

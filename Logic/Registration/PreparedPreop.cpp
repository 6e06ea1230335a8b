#include "Logic/Registration/PreparedPreop.h"

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Registration/ScanSample.h"

namespace falciform {

namespace {

constexpr Index kSample = 4000;

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
  coarse_ = CoarseTarget(preop, normals_);
  target_ = std::make_shared<const LabelledTarget>(preop, patchLabels(preop));
}

}  // namespace falciform

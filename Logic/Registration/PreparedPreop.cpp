#include "Logic/Registration/PreparedPreop.h"

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"

namespace falciform {

PreparedPreop::PreparedPreop(const Surface& preop) : surface_(preop) {
  checkSurface(preop, "pre-op surface");
  if (preop.size() < 3)
    throw InputError("pre-op surface has " + std::to_string(preop.size()) +
                     " points; a pose needs at least 3");
  normals_ = vertexNormals(preop);
  areas_ = vertexAreas(preop);
  target_ = std::make_shared<const LabelledTarget>(preop, patchLabels(preop));
}

}  // namespace falciform

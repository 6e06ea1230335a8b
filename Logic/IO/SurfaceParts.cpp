#include "Logic/IO/SurfaceParts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "Logic/Core/Errors.h"
#include "Logic/IO/NumberText.h"

namespace falciform {

void TriangleCollector::addPolygon(std::span<const long long> ids) {
  for (const long long id : ids)
    if (id < 0 || id >= points_)
      throw InputError(name_ + ": a face names point " + std::to_string(id) + ", but there are points 0 to " +
                       std::to_string(points_ - 1) + "; the file is damaged, export it again");
  for (std::size_t k = 2; k < ids.size(); ++k)
    if (ids[0] != ids[k - 1] && ids[k - 1] != ids[k] && ids[k] != ids[0])
      ids_.insert(ids_.end(),
                  {static_cast<int>(ids[0]), static_cast<int>(ids[k - 1]), static_cast<int>(ids[k])});
}

Triangles TriangleCollector::triangles() const {
  return Eigen::Map<const Triangles>(ids_.data(), static_cast<Index>(ids_.size() / 3), 3);
}

void TextureCollector::put(long long point, float u, float v) { corners_.push_back({point, u, v}); }

void TextureCollector::finish(Index points, const std::string& name, RawSurface& raw) const {
  constexpr float kSamePlace = 1e-5F;  // a tenth of a pixel in an image of 10,000
  if (corners_.empty()) return;
  TexturePlaces& places = raw.surface.textureAt;
  places = TexturePlaces::Constant(points, 2, std::numeric_limits<float>::quiet_NaN());
  std::vector<char> seam(static_cast<std::size_t>(points));
  for (const Corner& corner : corners_) {
    if (corner.point < 0 || corner.point >= points)
      throw InputError(name + ": a face names point " + std::to_string(corner.point) +
                       ", which is not there; the file is damaged, export it again");
    auto place = places.row(corner.point);
    if (!place.allFinite())
      place << corner.u, corner.v;
    else if (!((place - Eigen::RowVector2f(corner.u, corner.v)).cwiseAbs().maxCoeff() <= kSamePlace))
      seam[static_cast<std::size_t>(corner.point)] = 1;
  }
  for (std::size_t i = 0; i < seam.size(); ++i)
    if (seam[i]) raw.seam.push_back(static_cast<int>(i));
}

std::vector<int> patchLabelsFrom(const VectorXd& values, const std::string& name) {
  std::vector<int> labels(static_cast<std::size_t>(values.size()));
  for (Index i = 0; i < values.size(); ++i) {
    if (!(values[i] >= 0 && values[i] <= patch::kMax && values[i] == std::floor(values[i])))
      throw InputError(name + ": 'Patch' holds " + numberText(values[i]) +
                       "; labels are whole numbers from 0 to 255");
    labels[static_cast<std::size_t>(i)] = static_cast<int>(values[i]);
  }
  return labels;
}

Points unitNormalsFrom(Points normals) {
  if (!normals.allFinite()) return Points(0, 3);
  for (Index i = 0; i < normals.rows(); ++i)
    if (const double length = normals.row(i).norm(); length > 0) normals.row(i) /= length;
  return normals;
}

Colours coloursFrom(const Points& rgb) {
  return rgb.unaryExpr([](double v) { return v > 0 ? std::round(std::min(v, 255.0)) : 0.0; })
      .cast<std::uint8_t>();
}

void readPatchNameComment(std::string_view comment, Surface& surface) {
  if (nextWord(comment) != "patch") return;
  const std::string_view entry = comment.substr(std::min(comment.find_first_not_of(' '), comment.size()));
  const std::size_t equals = entry.find('=');
  int label = 0;
  if (equals != std::string_view::npos && parseNumber(entry.substr(0, equals), label) && label > 0 &&
      label <= patch::kMax)
    surface.patchNames[label] = std::string(entry.substr(equals + 1));
}

std::vector<std::string> patchNameComments(const Surface& surface) {
  std::vector<std::string> comments;
  for (const auto& [label, name] : surface.patchNames) {
    std::string comment = "patch " + std::to_string(label) + "=" + name;
    std::replace_if(
        comment.begin(), comment.end(), [](unsigned char c) { return c < ' '; }, ' ');
    comments.push_back(comment);
  }
  return comments;
}

}  // namespace falciform

#include "Widgets/Rendering/SurfacePresenter.h"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "Widgets/Rendering/SurfaceGeometry.h"

namespace falciform {

namespace {

void write(vtkUnsignedCharArray* colours, Index point, const Vector3d& colour) {
  unsigned char rgb[3];
  for (int c = 0; c < 3; ++c)
    rgb[c] = static_cast<unsigned char>(std::lround(255 * std::clamp(colour[c], 0.0, 1.0)));
  colours->SetTypedTuple(point, rgb);
}

}  // namespace

SurfacePresenter::SurfacePresenter(vtkRenderer* renderer)
    : renderer_(renderer),
      actor_(vtkSmartPointer<vtkActor>::New()),
      data_(vtkSmartPointer<vtkPolyData>::New()),
      photograph_(renderer) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data_);
  mapper->SetColorModeToDirectScalars();
  actor_->SetMapper(mapper);
  actor_->SetVisibility(false);
  // Points have no back side in OpenGL, so VTK leaves their normals as they are; seen from behind a scan
  // would be black.
  actor_->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Light::Impl", true,
      "if (normalVCVSOutput.z < 0.0) normalVCVSOutput = -normalVCVSOutput;\n//VTK::Light::Impl", false);
  renderer_->AddActor(actor_);
}

SurfacePresenter::~SurfacePresenter() { renderer_->RemoveActor(actor_); }

void SurfacePresenter::show(std::shared_ptr<const Surface> surface) {
  const bool same = surface && surface_ && sameGeometry(*surface, *surface_);
  const bool samePhotograph = same && surface->texture == surface_->texture &&
                              surface->textureAt.rows() == surface_->textureAt.rows();
  const bool moved = !same && surface && surface_ && sameTriangles(*surface, *surface_);
  surface_ = std::move(surface);
  labels_ = surface_ ? surface_->patch : std::vector<int>();
  if (moved) {
    moveGeometry(data_, *surface_);
  } else if (!same) {
    data_ = surface_ ? displayGeometry(*surface_) : vtkSmartPointer<vtkPolyData>::New();
    colours_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colours_->SetName("Shown");
    colours_->SetNumberOfComponents(3);
    colours_->SetNumberOfTuples(surface_ ? surface_->size() : 0);
    data_->GetPointData()->SetScalars(colours_);
    vtkPolyDataMapper::SafeDownCast(actor_->GetMapper())->SetInputData(data_);
  }
  if (!samePhotograph) photograph_.show(surface_.get(), data_);
  recolour();
  applyStyle();
}

// Views set everything again at each change; a scan that only moves need not be coloured thirty times a
// second.
void SurfacePresenter::setStyle(const SurfaceStyle& style) {
  if (style == style_) return;
  style_ = style;
  recolour();
  applyStyle();
}

void SurfacePresenter::setScalarMap(const std::optional<ScalarMap>& map) {
  if (map == map_) return;
  map_ = map;
  recolour();
  applyStyle();
}

void SurfacePresenter::setPatchLabels(const std::vector<int>& ids, const std::vector<int>& values) {
  if (!surface_) return;
  labels_.resize(static_cast<std::size_t>(surface_->size()), patch::kNone);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    labels_[static_cast<std::size_t>(ids[i])] = values[i];
    write(colours_, ids[i], colourAt(ids[i]));
  }
  colours_->Modified();
  if (style_.patches) photograph_.setPainted(ids, values);
}

void SurfacePresenter::setSceneFromSurface(const Isometry3d& motion) {
  sceneFromSurface_ = motion;
  vtkNew<vtkMatrix4x4> matrix;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) matrix->SetElement(r, c, motion.matrix()(r, c));
  actor_->SetUserMatrix(matrix);
  photograph_.actor()->SetUserMatrix(matrix);
}

Vector3d SurfacePresenter::colourAt(Index point) const {
  if (map_) {
    const auto values = surface_->arrays.find(map_->array);
    const bool known = values != surface_->arrays.end() && point < values->second.size();
    return colourOf(*map_, known ? values->second[point] : std::numeric_limits<double>::quiet_NaN());
  }
  const int label = labels_.empty() ? patch::kNone : labels_[static_cast<std::size_t>(point)];
  if (style_.patches && label != patch::kNone && !style_.hiddenPatches.contains(label)) {
    const auto own = style_.patchColours.find(label);
    return own != style_.patchColours.end() ? own->second : patchColour(label);
  }
  if (style_.ownColours && surface_->colours.rows() > point)
    return surface_->colours.row(point).cast<double>().transpose() / 255.0;
  return style_.colour;
}

void SurfacePresenter::recolour() {
  if (!surface_) return;
  for (Index i = 0; i < surface_->size(); ++i) write(colours_, i, colourAt(i));
  colours_->Modified();
  photograph_.setPainted(labels_, style_.patches);
}

void SurfacePresenter::applyStyle() {
  vtkProperty* property = actor_->GetProperty();
  property->SetOpacity(style_.opacity);
  property->SetEdgeVisibility(style_.edges);
  property->SetBackfaceCulling(style_.frontOnly);
  property->SetPointSize(static_cast<float>(style_.pointPx));
  // Values must be read off the bar, so shading may darken them only a little.
  property->SetAmbient(map_ ? 0.55 : 0.22);
  property->SetDiffuse(map_ ? 0.45 : 0.80);
  property->SetSpecular(map_ ? 0.0 : 0.12);
  property->SetSpecularPower(20);
  actor_->SetVisibility(style_.visible && surface_ && surface_->size() > 0);
  // Over a see-through surface a second coat would be seen twice; its points have the photograph's colours.
  vtkActor* photograph = photograph_.actor();
  photograph->GetProperty()->DeepCopy(property);
  photograph->GetProperty()->SetEdgeVisibility(false);
  photograph->SetVisibility(actor_->GetVisibility() && style_.ownColours && !map_ && !style_.edges &&
                            style_.opacity >= 1 && !photograph_.empty());
}

}  // namespace falciform

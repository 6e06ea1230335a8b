#include "Widgets/Rendering/TextureOverlay.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkTexture.h>

#include <algorithm>

namespace falciform {

namespace {

constexpr unsigned char kOpaque = 255, kClear = 0;

/// VTK's images have row 0 at the bottom.
vtkSmartPointer<vtkImageData> toVtk(const ColourImage& image) {
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const std::size_t row = static_cast<std::size_t>(image.width) * 3;
  for (int y = 0; y < image.height; ++y)
    std::copy_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(y)), row,
                static_cast<unsigned char*>(data->GetScalarPointer(0, image.height - 1 - y, 0)));
  return data;
}

vtkSmartPointer<vtkCellArray> placedTriangles(const Surface& surface) {
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (Index t = 0; t < surface.triangles.rows(); ++t) {
    const auto corners = surface.triangles.row(t);
    bool placed = true;
    for (const int corner : {corners[0], corners[1], corners[2]})
      placed = placed && surface.textureAt.row(corner).allFinite();
    const vtkIdType ids[3] = {corners[0], corners[1], corners[2]};
    if (placed) cells->InsertNextCell(3, ids);
  }
  return cells;
}

vtkSmartPointer<vtkFloatArray> placesOf(const Surface& surface) {
  auto places = vtkSmartPointer<vtkFloatArray>::New();
  places->SetName("TCoords");
  places->SetNumberOfComponents(2);
  places->SetNumberOfTuples(surface.size());
  for (Index i = 0; i < surface.size(); ++i) {
    const bool placed = surface.textureAt.row(i).allFinite();
    places->SetTuple2(i, placed ? surface.textureAt(i, 0) : 0.0F, placed ? surface.textureAt(i, 1) : 0.0F);
  }
  return places;
}

}  // namespace

TextureOverlay::TextureOverlay(vtkRenderer* renderer)
    : renderer_(renderer),
      actor_(vtkSmartPointer<vtkActor>::New()),
      coat_(vtkSmartPointer<vtkUnsignedCharArray>::New()) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetColorModeToDirectScalars();
  // Just before the surface itself, which has the same points.
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2, -2);
  actor_->SetMapper(mapper);
  actor_->SetVisibility(false);
  actor_->PickableOff();
  actor_->ForceTranslucentOn();
  renderer_->AddActor(actor_);
}

TextureOverlay::~TextureOverlay() { renderer_->RemoveActor(actor_); }

void TextureOverlay::show(const Surface* surface, vtkPolyData* geometry) {
  const bool textured = surface && surface->texture && surface->textureAt.rows() == surface->size() &&
                        surface->triangles.rows() > 0;
  if (!textured) {
    image_.reset();
    actor_->SetVisibility(false);
    actor_->SetTexture(nullptr);
    return;
  }
  if (image_ != surface->texture) {
    image_ = surface->texture;
    vtkNew<vtkTexture> texture;
    texture->SetInputData(toVtk(*image_));
    texture->InterpolateOn();
    texture->RepeatOff();
    texture->EdgeClampOn();
    actor_->SetTexture(texture);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(geometry->GetPoints());
  data->SetPolys(placedTriangles(*surface));
  data->GetPointData()->SetNormals(geometry->GetPointData()->GetNormals());
  data->GetPointData()->SetTCoords(placesOf(*surface));
  coat_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
  coat_->SetName("Coat");
  coat_->SetNumberOfComponents(4);
  coat_->SetNumberOfTuples(surface->size());
  coat_->Fill(kOpaque);
  data->GetPointData()->SetScalars(coat_);
  vtkPolyDataMapper::SafeDownCast(actor_->GetMapper())->SetInputData(data);
}

void TextureOverlay::setPainted(const std::vector<int>& labels, bool paintShown) {
  if (empty()) return;
  for (vtkIdType i = 0; i < coat_->GetNumberOfTuples(); ++i) {
    const bool painted = paintShown && !labels.empty() && labels[static_cast<std::size_t>(i)] > 0;
    coat_->SetTypedComponent(i, 3, painted ? kClear : kOpaque);
  }
  coat_->Modified();
}

void TextureOverlay::setPainted(const std::vector<int>& ids, const std::vector<int>& labels) {
  if (empty()) return;
  for (std::size_t i = 0; i < ids.size(); ++i)
    coat_->SetTypedComponent(ids[i], 3, labels[i] > 0 ? kClear : kOpaque);
  coat_->Modified();
}

}  // namespace falciform

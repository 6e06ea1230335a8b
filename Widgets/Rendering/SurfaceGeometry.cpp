#include "Widgets/Rendering/SurfaceGeometry.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPCANormalEstimation.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"
#include "Widgets/Rendering/ScanView.h"

namespace falciform {

namespace {

vtkSmartPointer<vtkFloatArray> toVtk(const Points& normals) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName("Normals");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(normals.rows());
  for (Index i = 0; i < normals.rows(); ++i) array->SetTuple3(i, normals(i, 0), normals(i, 1), normals(i, 2));
  return array;
}

/// Normals of a cloud, so that light shows its shape. Signs are chosen point by point against one direction:
/// right for what a scanner sees from one side.
Points cloudNormals(const Surface& cloud, vtkPolyData* data) {
  const Vector3d towards = seenFrom(cloud);
  vtkNew<vtkPCANormalEstimation> fit;
  fit->SetInputData(data);
  fit->SetSampleSize(static_cast<int>(std::min<Index>(20, cloud.size())));
  fit->SetNormalOrientationToAsComputed();
  fit->Update();
  vtkDataArray* fitted = fit->GetOutput()->GetPointData()->GetNormals();
  Points normals(cloud.size(), 3);
  for (Index i = 0; i < cloud.size(); ++i) {
    Vector3d normal;
    fitted->GetTuple(i, normal.data());
    if (!normal.allFinite()) normal = towards;
    normals.row(i) = (normal.dot(towards) < 0 ? -normal : normal).transpose();
  }
  return normals;
}

}  // namespace

vtkSmartPointer<vtkPolyData> displayGeometry(const Surface& surface) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(surface.size());
  for (Index i = 0; i < surface.size(); ++i) points->SetPoint(i, surface.points.row(i).data());
  data->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  for (Index t = 0; t < surface.triangles.rows(); ++t) {
    const auto row = surface.triangles.row(t);
    cells->InsertNextCell({row[0], row[1], row[2]});
  }
  if (surface.triangles.rows() > 0) {
    data->SetPolys(cells);
  } else {
    for (Index i = 0; i < surface.size(); ++i) cells->InsertNextCell({static_cast<vtkIdType>(i)});
    data->SetVerts(cells);
  }
  if (surface.normals.rows() == surface.size() && surface.size() > 0)
    data->GetPointData()->SetNormals(toVtk(surface.normals));
  else if (surface.triangles.rows() > 0)
    data->GetPointData()->SetNormals(toVtk(vertexNormals(surface)));
  else if (surface.size() >= 3)
    data->GetPointData()->SetNormals(toVtk(cloudNormals(surface, data)));
  else  // the shader wants normals always
    data->GetPointData()->SetNormals(
        toVtk(Points(Vector3d::UnitZ().transpose().replicate(surface.size(), 1))));
  return data;
}

void moveGeometry(vtkPolyData* geometry, const Surface& surface) {
  vtkPoints* points = geometry->GetPoints();
  std::copy_n(surface.points.data(), surface.points.size(),
              vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0));
  points->Modified();
  const bool given = surface.normals.rows() == surface.size();
  const Points normals = given ? Points() : vertexNormals(surface);
  auto* array = vtkFloatArray::SafeDownCast(geometry->GetPointData()->GetNormals());
  const Points& from = given ? surface.normals : normals;
  std::transform(from.data(), from.data() + from.size(), array->GetPointer(0),
                 [](double value) { return static_cast<float>(value); });
  array->Modified();
  geometry->Modified();
}

double pointSpacing(const Points& points) {
  if (points.rows() < 5) return 0;
  const KdTree tree(points);
  const Index stride = std::max<Index>(1, points.rows() / 500);
  std::vector<double> distances;
  for (Index i = 0; i < points.rows(); i += stride)
    distances.push_back(std::sqrt(tree.nearest(points.row(i).transpose(), 5).back().squaredDistance));
  std::ranges::nth_element(distances, distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2));
  return distances[distances.size() / 2];
}

bool sameGeometry(const Surface& a, const Surface& b) {
  const auto same = [](const auto& x, const auto& y) { return x.rows() == y.rows() && x == y; };
  return same(a.points, b.points) && same(a.triangles, b.triangles) && same(a.normals, b.normals);
}

bool sameTriangles(const Surface& a, const Surface& b) {
  return a.size() == b.size() && a.triangles.rows() > 0 && a.triangles.rows() == b.triangles.rows() &&
         a.triangles == b.triangles;
}

}  // namespace falciform

#include "Logic/VtkBridge/SurfaceFilters.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <cassert>

namespace falciform {

namespace {

Points pointsOf(vtkPolyData* data) {
  Points points(data->GetNumberOfPoints(), 3);
  for (Index i = 0; i < points.rows(); ++i) data->GetPoint(i, points.row(i).data());
  return points;
}

/// A grid in index coordinates over the same voxels, not a copy.
vtkNew<vtkImageData> indexGrid(const Image& field) {
  vtkNew<vtkFloatArray> scalars;
  scalars->SetArray(const_cast<float*>(field.voxels.data()), static_cast<vtkIdType>(field.voxels.size()), 1);
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(field.size.x(), field.size.y(), field.size.z());
  grid->GetPointData()->SetScalars(scalars);
  return grid;
}

/// The triangles, and `extra` points after the surface's own that no triangle uses.
vtkNew<vtkPolyData> bareCopy(const Surface& surface, const Points& extra) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(surface.size() + extra.rows());
  for (Index i = 0; i < surface.size(); ++i) points->SetPoint(i, surface.points.row(i).data());
  for (Index i = 0; i < extra.rows(); ++i) points->SetPoint(surface.size() + i, extra.row(i).data());
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(surface.triangles.rows(), surface.triangles.size());
  for (Index f = 0; f < surface.triangles.rows(); ++f) {
    const vtkIdType ids[3] = {surface.triangles(f, 0), surface.triangles(f, 1), surface.triangles(f, 2)};
    cells->InsertNextCell(3, ids);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

}  // namespace

Surface isosurface(const Image& field, double level) {
  assert(static_cast<Index>(field.voxels.size()) == field.size.cast<Index>().prod());
  Surface surface;
  if (field.size.minCoeff() < 2) return surface;  // no cell to march through

  const vtkNew<vtkImageData> grid = indexGrid(field);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(grid);
  contour->SetValue(0, level);
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  vtkPolyData* const found = contour->GetOutput();

  // The filter works in index coordinates, so that shear, oblique axes and handedness are ours alone to
  // apply.
  const Matrix3d axes = field.worldFromIndex.topLeftCorner<3, 3>();
  const Vector3d origin = field.worldFromIndex.topRightCorner<3, 1>();
  surface.points = pointsOf(found) * axes.transpose();
  surface.points.rowwise() += origin.transpose();

  const bool mirrored = axes.determinant() < 0;
  surface.triangles.resize(found->GetNumberOfPolys(), 3);
  const auto cells = vtk::TakeSmartPointer(found->GetPolys()->NewIterator());
  Index f = 0;
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++f) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    for (int c = 0; c < 3; ++c) surface.triangles(f, c) = static_cast<int>(ids[mirrored ? 2 - c : c]);
  }
  return surface;
}

Surface smoothWindowedSinc(const Surface& surface, int iterations, double passBand) {
  Surface smooth = surface;
  smooth.normals.resize(0, 3);  // they belonged to the old shape
  if (iterations <= 0 || surface.triangles.rows() == 0) return smooth;

  vtkNew<vtkWindowedSincPolyDataFilter> filter;
  // The filter's response at zero frequency is near 1, not 1: it scales the whole body about the centre of
  // its box, and so depends on the axes. Two free points, the corners of the box, show the scale, and it is
  // taken out again.
  Points corners(2, 3);
  corners << surface.points.colwise().minCoeff(), surface.points.colwise().maxCoeff();
  const vtkNew<vtkPolyData> data = bareCopy(surface, corners);
  filter->SetInputData(data);
  filter->SetNumberOfIterations(iterations);
  filter->SetPassBand(passBand);
  filter->NormalizeCoordinatesOn();
  filter->BoundarySmoothingOff();
  filter->FeatureEdgeSmoothingOff();
  filter->NonManifoldSmoothingOff();
  filter->Update();
  const Points filtered = pointsOf(filter->GetOutput());
  const Eigen::RowVector3d centre = corners.colwise().mean();
  const double scale = (filtered.row(filtered.rows() - 1) - filtered.row(filtered.rows() - 2)).norm() /
                       (corners.row(1) - corners.row(0)).norm();
  smooth.points = (filtered.topRows(surface.size()).rowwise() - centre) / scale;
  smooth.points.rowwise() += centre;
  return smooth;
}

}  // namespace falciform

#include <gmock/gmock.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkShortArray.h>

#include "Logic/Core/Errors.h"
#include "Logic/VtkBridge/PolyDataBridge.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using namespace test;

Surface everything() {
  Surface surface = lumpyBody(2);
  surface.frame = "scanner";
  surface.patch[0] = 200;
  surface.patchNames = {{200, "cut, edge"}};
  surface.arrays["a_mm"] = VectorXd::LinSpaced(surface.size(), -3, 8);
  surface.arrays["a_mm"][1] = std::numeric_limits<double>::quiet_NaN();
  surface.colours = Colours::Constant(surface.size(), 3, 17);
  surface.normals = surface.points.rowwise().normalized();
  return surface;
}

TEST(PolyDataBridge, ASurfaceComesBackAsItWas) {
  const Surface surface = everything(), back = fromVtk(toVtk(surface));
  EXPECT_EQ(back.points, surface.points);
  EXPECT_EQ(back.triangles, surface.triangles);
  EXPECT_EQ(back.patch, surface.patch);
  EXPECT_EQ(back.patchNames, surface.patchNames);
  EXPECT_EQ(back.colours, surface.colours);
  EXPECT_LT((back.normals - surface.normals).cwiseAbs().maxCoeff(), 1e-15);  // normalised again: one rounding
  EXPECT_EQ(back.frame, "scanner");
  ASSERT_EQ(back.arrays.size(), 1u);
  EXPECT_TRUE(std::isnan(back.arrays.at("a_mm")[1]));  // no value stays no value
  EXPECT_EQ(back.arrays.at("a_mm")[2], surface.arrays.at("a_mm")[2]);
}

TEST(PolyDataBridge, ACloudGetsAVertexCellAPoint) {
  Surface cloud = everything();
  cloud.triangles.resize(0, 3);
  const auto data = toVtk(cloud);
  EXPECT_EQ(data->GetNumberOfVerts(), cloud.size());
  EXPECT_EQ(data->GetNumberOfPolys(), 0);
  EXPECT_EQ(fromVtk(data).points, cloud.points);
}

TEST(PolyDataBridge, TheCopyDoesNotShareMemory) {
  Surface surface = everything();
  const auto data = toVtk(surface);
  const double before = data->GetPoint(0)[0];
  surface.points(0, 0) += 1;
  EXPECT_EQ(data->GetPoint(0)[0], before);
}

TEST(PolyDataBridge, NothingGivesAnEmptySurface) {
  EXPECT_EQ(fromVtk(nullptr).size(), 0);
  EXPECT_EQ(fromVtk(vtkNew<vtkPolyData>()).size(), 0);
  EXPECT_EQ(fromVtk(toVtk(Surface{})).size(), 0);
}

class FromVtk : public testing::Test {
 protected:
  void SetUp() override {
    // A concave quadrangle (an arrow head), and a point above.
    for (const auto& p :
         {Vector3d(0, 0, 0), Vector3d(10, 5, 0), Vector3d(0, 10, 0), Vector3d(3, 5, 0), Vector3d(0, 0, 9)})
      points->InsertNextPoint(p.data());
    data->SetPoints(points);
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyData> data;
};

TEST_F(FromVtk, ConcavePolygonsAreCutInside) {
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({0, 1, 2, 3});
  data->SetPolys(cells);
  const Surface surface = fromVtk(data);
  ASSERT_EQ(surface.triangles.rows(), 2);
  double area = 0;
  for (Index i = 0; i < 2; ++i) {
    const Vector3d a = surface.points.row(surface.triangles(i, 0)),
                   b = surface.points.row(surface.triangles(i, 1)),
                   c = surface.points.row(surface.triangles(i, 2));
    area += (b - a).cross(c - a).norm() / 2;
    EXPECT_GT((b - a).cross(c - a).z(), 0);  // the polygon's own sense
  }
  EXPECT_NEAR(area, 35, 1e-12);  // mm^2: 50 less the notch of 15; a cut across the notch would give more
}

TEST_F(FromVtk, StripsKeepTheirSenseAndDropDegenerateTriangles) {
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({0, 1, 2, 4, 4});
  data->SetStrips(strips);
  Triangles expected(2, 3);
  expected << 0, 1, 2, 2, 1, 4;
  EXPECT_EQ(fromVtk(data).triangles, expected);
}

TEST_F(FromVtk, PatchesOfAnyNumberTypeAreTakenIfTheyAreLabels) {
  vtkNew<vtkFloatArray> labels;
  labels->SetName("Patch");
  for (const float value : {0, 1, 2, 3, 255}) labels->InsertNextValue(value);
  data->GetPointData()->AddArray(labels);
  EXPECT_THAT(fromVtk(data).patch, testing::ElementsAre(0, 1, 2, 3, 255));
  for (const float bad : {0.5f, -1.0f, 256.0f, std::numeric_limits<float>::quiet_NaN()}) {
    labels->SetValue(2, bad);
    EXPECT_THROW((void)fromVtk(data), InputError) << bad;
  }
}

TEST_F(FromVtk, UnknownArraysOfOneComponentBecomeAnalysisArrays) {
  vtkNew<vtkShortArray> depth;
  depth->SetName("depth_mm");
  for (const short value : {5, 4, 3, 2, -1}) depth->InsertNextValue(value);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("displacement");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(5);
  vectors->Fill(0);
  data->GetPointData()->AddArray(depth);
  data->GetPointData()->AddArray(vectors);
  const Surface surface = fromVtk(data);
  ASSERT_EQ(surface.arrays.size(), 1u);
  EXPECT_EQ(surface.arrays.at("depth_mm")[4], -1);
}

TEST_F(FromVtk, DamagedCellsAndArraysAreRefused) {
  vtkNew<vtkIdTypeArray> offsets, ids;
  for (const vtkIdType value : {0, 3}) offsets->InsertNextValue(value);
  for (const vtkIdType value : {0, 1, 2}) ids->InsertNextValue(value);
  vtkNew<vtkCellArray> cells;
  const auto refused = [&] {
    cells->SetData(offsets, ids);
    data->SetPolys(cells);
    EXPECT_THROW((void)fromVtk(data), InputError);
  };
  ids->SetValue(2, 5);
  refused();
  ids->SetValue(2, -1);
  refused();
  ids->SetValue(2, 2);
  offsets->SetValue(1, 30);
  refused();
  offsets->SetValue(1, -3);
  refused();
  offsets->SetValue(1, 3);
  cells->SetData(offsets, ids);
  data->SetPolys(cells);
  EXPECT_EQ(fromVtk(data).triangles.rows(), 1);
  vtkNew<vtkDoubleArray> tooShort;
  tooShort->SetName("a");
  tooShort->SetNumberOfValues(4);
  data->GetPointData()->AddArray(tooShort);
  EXPECT_THROW((void)fromVtk(data), InputError);
}

}  // namespace
}  // namespace falciform

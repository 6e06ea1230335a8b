#include "Widgets/Rendering/Picking.h"

#include <gtest/gtest.h>
#include <vtkCellPicker.h>
#include <vtkNew.h>

#include <memory>

#include "Testing/Support/SmallSurfaces.h"
#include "Widgets/Rendering/CameraViews.h"
#include "Widgets/Rendering/OffscreenWindow.h"
#include "Widgets/Rendering/Scene.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform {

namespace {

struct PickingTest : testing::Test {
  PickingTest() {
    scene.add<SurfacePresenter>().show(body);
    window.show(scene);
    setStandardView(scene.renderer(), StandardView::Anterior);
    window.render();
  }
  std::shared_ptr<Surface> body = std::make_shared<Surface>(test::lumpyBody(4));
  Scene scene;
  OffscreenWindow window{320, 240};
};

}  // namespace

TEST_F(PickingTest, HitsTheTriangleThatVtkPicks) {
  const SurfacePicker picker(body);
  vtkNew<vtkCellPicker> vtk;
  vtk->SetTolerance(0);
  int hits = 0;
  for (int y = 7; y < 240; y += 13)
    for (int x = 5; x < 320; x += 17) {
      const auto mine = picker.pick(pickRay(scene.renderer(), x, y));
      const bool theirs = vtk->Pick(x, y, 0, scene.renderer()) != 0;
      ASSERT_EQ(mine.has_value(), theirs) << x << ", " << y;
      if (!mine) continue;
      ++hits;
      EXPECT_EQ(mine->triangle, vtk->GetCellId()) << x << ", " << y;
      Vector3d at;
      vtk->GetPickPosition(at.data());
      EXPECT_LT((mine->point - at).norm(), 1e-3) << "mm; VTK computes the ray in single precision at places";
    }
  EXPECT_GT(hits, 60) << "the body fills the view";
}

TEST_F(PickingTest, RayThroughAPixelIsDrawnAtThatPixel) {
  for (const Eigen::Vector2d& pixel :
       {Eigen::Vector2d(10, 20), Eigen::Vector2d(160, 120), Eigen::Vector2d(300, 200)}) {
    const PickRay ray = pickRay(scene.renderer(), pixel.x(), pixel.y());
    EXPECT_NEAR(ray.direction.norm(), 1, 1e-12);
    EXPECT_GT(ray.direction.y(), 0) << "from anterior the view runs to posterior";
    for (const double along : {1.0, 100.0, 300.0})
      EXPECT_LT((screenPosition(scene.renderer(), ray.origin + along * ray.direction) - pixel).norm(), 1e-6)
          << "pixels";
  }
}

TEST_F(PickingTest, NearestVertexIsACornerOfTheTriangle) {
  const SurfacePicker picker(body);
  const auto hit = picker.pick(pickRay(scene.renderer(), 160, 120));
  ASSERT_TRUE(hit);
  double nearest = 1e9;
  int expected = -1;
  for (const int vertex : body->triangles.row(hit->triangle)) {
    const double distance = (body->points.row(vertex).transpose() - hit->point).norm();
    if (distance < nearest) {
      nearest = distance;
      expected = vertex;
    }
  }
  EXPECT_EQ(hit->vertex, expected);
}

TEST_F(PickingTest, OnACloudTheFrontPointWins) {
  auto cloud = std::make_shared<Surface>(*body);
  cloud->triangles.resize(0, 3);
  const SurfacePicker onMesh(body), onCloud(cloud);
  const PickRay ray = pickRay(scene.renderer(), 170, 110);
  const auto mesh = onMesh.pick(ray), point = onCloud.pick(ray, 4);
  ASSERT_TRUE(mesh && point);
  EXPECT_EQ(point->triangle, -1);
  // The spacing is about 5 mm, so the front point lies this near to the front place.
  EXPECT_LT((mesh->point - point->point).norm(), 8);
  EXPECT_FALSE(onCloud.pick(pickRay(scene.renderer(), 2, 2), 4));
}

TEST_F(PickingTest, MillimetresPerPixelAgreeWithTheView) {
  const Vector3d centre = Vector3d::Zero();
  const double mm = mmPerPixel(scene.renderer(), centre);
  const Vector3d right(1, 0, 0);
  const Eigen::Vector2d moved =
      screenPosition(scene.renderer(), centre + 10 * mm * right) - screenPosition(scene.renderer(), centre);
  EXPECT_NEAR(moved.x(), 10, 1e-6);
}

}  // namespace falciform

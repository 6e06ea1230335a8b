#include "Logic/Patches/PatchPaintingLogic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using testing::Each;
using testing::IsEmpty;

struct PatchPainting : testing::Test {
  Case document;

  void openPreop(Surface surface) { document.setPreop(std::make_shared<Surface>(std::move(surface))); }

  /// A stroke of one dab where a ray from `eye` towards `aim` meets the target surface.
  static PatchEdit strokeAt(PatchPaintingLogic& logic, const Surface& surface, const Vector3d& eye,
                            const Vector3d& aim) {
    const Vector3d view = (aim - eye).normalized();
    const auto hit = TriangleTree(surface).cast(eye, view);
    logic.beginStroke();
    if (hit) (void)logic.dab(hit->triangle, hit->point, view);
    return logic.endStroke();
  }

  /// The number of points of `surface` in the case that bear `label`.
  static std::size_t count(const std::shared_ptr<const Surface>& surface, int label) {
    return pointsOfPatch(*surface, label).size();
  }
};

TEST_F(PatchPainting, PaintsADiscOfTheBrushsRadiusOnAPlane) {
  const Surface plane = test::grid(40, 40);
  openPreop(plane);
  PatchPaintingLogic logic(document);
  logic.radiusMm = 7.5;
  const PatchEdit edit = strokeAt(logic, plane, {20.2, 19.7, 50}, {20.2, 19.7, 0});
  for (Index i = 0; i < plane.size(); ++i) {
    const bool under = (Vector3d(plane.points.row(i)) - Vector3d(20.2, 19.7, 0)).norm() <= 7.5;
    EXPECT_EQ(document.preop()->patchAt(i), under ? patch::kFalciform : patch::kNone) << i;
  }
  EXPECT_EQ(edit.ids.size(), count(document.preop(), patch::kFalciform));
  EXPECT_THAT(edit.before, Each(0));
  EXPECT_THAT(edit.after, Each(patch::kFalciform));
}

TEST_F(PatchPainting, ReturnsOnlyWhatEachDabChangesAndTheStrokeWhole) {
  const Surface plane = test::grid(40, 40);
  openPreop(plane);
  PatchPaintingLogic logic(document);
  const TriangleTree tree(plane);
  logic.beginStroke();
  std::size_t changed = 0;
  for (const double x : {10.3, 12.3, 14.3}) {
    const auto hit = tree.cast({x, 20, 9}, {0, 0, -1});
    const PatchEdit edit = logic.dab(hit->triangle, hit->point);
    EXPECT_FALSE(edit.empty());
    EXPECT_THAT(edit.before, Each(0)) << "what an earlier dab painted is not told again";
    EXPECT_TRUE(logic.dab(hit->triangle, hit->point).empty());
    changed += edit.ids.size();
  }
  EXPECT_EQ(count(document.preop(), 1), 0U) << "the case is written at the end of the stroke, not before";
  EXPECT_EQ(std::accumulate(logic.labels().begin(), logic.labels().end(), 0), static_cast<int>(changed));
  EXPECT_EQ(logic.endStroke().ids.size(), changed);
  EXPECT_EQ(count(document.preop(), 1), changed);
}

TEST_F(PatchPainting, PaintsNeitherTheFarSideNorASheetBehind) {
  // A plate 1 mm thick: the brush of 6 mm is wider than the plate, and reaches round its rim, yet paints the
  // near side alone.
  Surface plate = test::grid(20, 20);
  const Index n = plate.size(), m = plate.triangles.rows();
  Points points(2 * n, 3);
  points << plate.points, plate.points;
  points.bottomRows(n).col(2).setConstant(-1);
  Triangles triangles(2 * m, 3);
  triangles << plate.triangles, plate.triangles;
  for (Index t = m; t < 2 * m; ++t)
    triangles.row(t) << plate.triangles(t - m, 0) + static_cast<int>(n),
        plate.triangles(t - m, 2) + static_cast<int>(n), plate.triangles(t - m, 1) + static_cast<int>(n);
  for (int i = 0; i < 20; ++i) {  // one rim, at y = 0, joins the two
    int a = -1, b = -1;
    for (int v = 0; v < n; ++v) {
      if (points.row(v) == Eigen::RowVector3d(i, 0, 0)) a = v;
      if (points.row(v) == Eigen::RowVector3d(i + 1, 0, 0)) b = v;
    }
    ASSERT_GE(std::min(a, b), 0);
    triangles.conservativeResize(triangles.rows() + 2, 3);
    triangles.bottomRows(2) << b, a, a + static_cast<int>(n), b, a + static_cast<int>(n),
        b + static_cast<int>(n);
  }
  plate.points = points;
  plate.triangles = triangles;
  openPreop(plate);
  PatchPaintingLogic logic(document);
  const PatchEdit edit = strokeAt(logic, plate, {10, 1, 30}, {10, 1, 0});
  EXPECT_GT(edit.ids.size(), 50U);
  for (const int id : edit.ids) EXPECT_LT(id, n);
  // Without a view direction the same brush goes round the rim.
  logic.beginStroke();
  const auto hit = TriangleTree(plate).cast({10, 1, 30}, {0, 0, -1});
  const PatchEdit all = logic.dab(hit->triangle, hit->point);
  EXPECT_GT(std::count_if(all.ids.begin(), all.ids.end(), [&](int id) { return id >= n; }), 20);
}

TEST_F(PatchPainting, PaintsTheSideThatIsSeenEvenIfTrianglesRunTheOtherWay) {
  const Surface plane = test::grid(20, 20);
  openPreop(plane);
  PatchPaintingLogic logic(document);
  EXPECT_GT(strokeAt(logic, plane, {10, 10, -20}, {10, 10, 0}).ids.size(), 80U);
}

TEST_F(PatchPainting, UndoesAndRedoesStrokeByStroke) {
  const Surface body = test::sphere(50, 4);
  openPreop(body);
  PatchPaintingLogic logic(document);
  std::vector<std::vector<int>> states{logic.labels()};
  int label = 1;
  for (const Vector3d& eye :
       {Vector3d(200, 0, 0), Vector3d(195, 20, 0), Vector3d(0, 200, 0), Vector3d(200, 10, 0)}) {
    logic.label = label = (label + 1) % 3;  // 2, 0 (erases), 1, 2
    const bool changes = !strokeAt(logic, body, eye, {0, 0, 0}).empty();
    EXPECT_TRUE(changes);
    states.push_back(document.preop()->patch);
  }
  for (std::size_t k = states.size() - 1; k > 0; --k) {
    EXPECT_TRUE(logic.canUndo());
    const PatchEdit edit = logic.undo();
    EXPECT_EQ(document.preop()->patch, states[k - 1]);
    for (std::size_t i = 0; i < edit.ids.size(); ++i)
      EXPECT_EQ(edit.after[i], states[k - 1][static_cast<std::size_t>(edit.ids[i])]);
  }
  EXPECT_FALSE(logic.canUndo());
  EXPECT_TRUE(logic.undo().empty());
  for (std::size_t k = 1; k < states.size(); ++k) {
    (void)logic.redo();
    EXPECT_EQ(document.preop()->patch, states[k]);
    EXPECT_EQ(logic.labels(), states[k]);
  }
  EXPECT_FALSE(logic.canRedo());
}

TEST_F(PatchPainting, LeavesNoStepForAStrokeThatChangesNothing) {
  const Surface body = test::sphere(50, 3);
  openPreop(body);
  PatchPaintingLogic logic(document);
  const auto before = document.preop();
  EXPECT_TRUE(strokeAt(logic, body, {200, 0, 0}, {400, 0, 0}).empty());  // beside it
  logic.label = 0;
  EXPECT_TRUE(strokeAt(logic, body, {200, 0, 0}, {0, 0, 0}).empty());  // erases what is bare
  EXPECT_FALSE(logic.canUndo());
  EXPECT_EQ(document.preop(), before) << "nothing was written";
  logic.label = 1;
  (void)strokeAt(logic, body, {200, 0, 0}, {0, 0, 0});
  EXPECT_TRUE(strokeAt(logic, body, {200, 0, 0}, {0, 0, 0}).empty());  // painted already
  (void)logic.undo();
  EXPECT_FALSE(logic.canUndo());
  EXPECT_TRUE(logic.canRedo());
}

TEST_F(PatchPainting, ANewStrokeEndsTheRoadOfRedo) {
  const Surface body = test::sphere(50, 3);
  openPreop(body);
  PatchPaintingLogic logic(document);
  (void)strokeAt(logic, body, {200, 0, 0}, {0, 0, 0});
  (void)logic.undo();
  (void)strokeAt(logic, body, {0, 200, 0}, {0, 0, 0});
  EXPECT_FALSE(logic.canRedo());
}

TEST_F(PatchPainting, KeepsTheLast200Steps) {
  const Surface plane = test::grid(10, 10);
  openPreop(plane);
  PatchPaintingLogic logic(document);
  logic.replaces = true;
  for (int k = 0; k < 230; ++k) {
    logic.label = k % 2 == 0 ? 1 : 2;
    ASSERT_FALSE(strokeAt(logic, plane, {5, 5, 9}, {5, 5, 0}).empty());
  }
  int steps = 0;
  for (; logic.canUndo(); ++steps) (void)logic.undo();
  EXPECT_EQ(steps, 200);
  EXPECT_EQ(count(document.preop(), 1), 0U);
  EXPECT_GT(count(document.preop(), 2), 0U) << "the 30th stroke, the last that cannot be undone, painted 2";
}

TEST_F(PatchPainting, ForgetsItsStepsAndTheRunningStrokeWhenAnotherSurfaceComes) {
  const Surface body = test::sphere(50, 4);
  openPreop(body);
  PatchPaintingLogic logic(document);
  logic.replaces = true;
  (void)strokeAt(logic, body, {200, 0, 0}, {0, 0, 0});
  logic.beginStroke();
  (void)logic.dab(0, body.points.row(body.triangles(0, 0)));
  Surface other = test::grid(5, 5);
  other.patch.assign(static_cast<std::size_t>(other.size()), 2);
  openPreop(other);
  EXPECT_FALSE(logic.inStroke());
  EXPECT_FALSE(logic.canUndo());
  EXPECT_TRUE(logic.dab(0, {1, 1, 0}).empty());
  EXPECT_TRUE(logic.endStroke().empty());
  EXPECT_EQ(logic.labels(), other.patch);
  EXPECT_FALSE(strokeAt(logic, other, {2, 2, 9}, {2, 2, 0}).empty());  // and paints on the new one
  document.clear();
  EXPECT_FALSE(logic.canUndo());
  EXPECT_TRUE(logic.labels().empty());
  EXPECT_NE(logic.missingInput(), "");
}

TEST_F(PatchPainting, ClearsAPatchInOneStep) {
  Surface body = test::sphere(50, 3);
  body.patch.assign(static_cast<std::size_t>(body.size()), 0);
  body.patch[3] = body.patch[8] = 2;
  body.patch[5] = 1;
  openPreop(body);
  PatchPaintingLogic logic(document);
  EXPECT_TRUE(logic.clearPatch(7).empty());
  EXPECT_EQ(logic.clearPatch(2).ids, (std::vector<int>{3, 8}));
  EXPECT_EQ(document.preop()->patchAt(3), 0);
  EXPECT_EQ(document.preop()->patchAt(5), 1);
  (void)logic.undo();
  EXPECT_EQ(document.preop()->patch, body.patch);
}

TEST_F(PatchPainting, KeepsThePreopAndTheScanApart) {
  const Surface body = test::sphere(50, 3);
  openPreop(body);
  document.setScan(std::make_shared<Surface>(test::grid(20, 20)));
  PatchPaintingLogic logic(document);
  (void)strokeAt(logic, body, {200, 0, 0}, {0, 0, 0});
  logic.target = PaintTarget::Scan;
  EXPECT_FALSE(logic.canUndo());
  EXPECT_FALSE(strokeAt(logic, *document.scan(), {10, 10, 9}, {10, 10, 0}).empty());
  openPreop(body);
  EXPECT_TRUE(logic.canUndo()) << "the scan's steps outlive a new pre-op surface";
  logic.target = PaintTarget::Preop;
  EXPECT_FALSE(logic.canUndo());
}

TEST_F(PatchPainting, PaintsSupportsBesideThePatchesWithTheirOwnUndo) {
  const Surface plane = test::grid(20, 20);
  openPreop(plane);
  PatchPaintingLogic logic(document);
  (void)strokeAt(logic, plane, {5, 5, 50}, {5, 5, 0});
  const auto patches = document.preop()->patch;
  logic.target = PaintTarget::Supports;
  logic.label = support_label::kLeftPacking;
  EXPECT_FALSE(logic.canUndo());
  const PatchEdit edit = strokeAt(logic, plane, {12, 12, 50}, {12, 12, 0});
  ASSERT_FALSE(edit.empty());
  EXPECT_EQ(document.preop()->patch, patches);
  ASSERT_NE(document.supports(), nullptr);
  EXPECT_EQ(document.supports()->labels[static_cast<std::size_t>(edit.ids.front())],
            support_label::kLeftPacking);
  EXPECT_EQ(document.supports()->regions.at(support_label::kLeftPacking).kind, SupportRegionKind::Pushed);

  // Kind and distance may be changed, patches painted: both leave labels and undo alone.
  SupportPainting pushed = *document.supports();
  pushed.regions[support_label::kLeftPacking].pushMm = 35;
  document.setSupports(std::make_shared<const SupportPainting>(pushed));
  logic.target = PaintTarget::Preop;
  (void)logic.undo();
  logic.target = PaintTarget::Supports;
  ASSERT_TRUE(logic.canUndo());
  (void)logic.undo();
  EXPECT_THAT(document.supports()->labels, Each(support_label::kFree));
  EXPECT_EQ(document.supports()->regions.at(support_label::kLeftPacking).pushMm, 35);
  (void)logic.redo();
  EXPECT_EQ(document.supports()->labels, pushed.labels);
}

TEST_F(PatchPainting, ATemplateIsOneStepAndAnUnknownLabelGetsARegion) {
  openPreop(test::grid(10, 10));
  PatchPaintingLogic logic(document);
  logic.target = PaintTarget::Supports;
  const auto points = static_cast<std::size_t>(document.preop()->size());
  (void)logic.replaceLabels(std::vector<int>(points, 9));
  EXPECT_EQ(document.supports()->regions.at(9).name, "support 9");
  EXPECT_NO_THROW(checkSupportPainting(*document.supports(), document.preop()->size(), "supports"));
  (void)logic.undo();
  EXPECT_THAT(document.supports()->labels, Each(0));
  EXPECT_FALSE(logic.canUndo());
  EXPECT_THROW((void)logic.replaceLabels({1, 2, 3}), InputError);
  // Supports of a case that is opened meanwhile are no steps of ours.
  (void)logic.redo();
  document.setSupports(nullptr);
  EXPECT_FALSE(logic.canUndo());
}

TEST_F(PatchPainting, SaysWhatIsMissingAndPaintsNothingWithoutIt) {
  PatchPaintingLogic logic(document);
  EXPECT_EQ(logic.missingInput(), "Import or open a surface first.");
  logic.beginStroke();
  EXPECT_FALSE(logic.inStroke());
  EXPECT_THAT(logic.dab(0, {0, 0, 0}).ids, IsEmpty());
  EXPECT_TRUE(logic.endStroke().empty());
}

TEST_F(PatchPainting, IgnoresHitsThatAreNoPlaceOfTheSurface) {
  openPreop(test::sphere(50, 2));
  PatchPaintingLogic logic(document);
  logic.beginStroke();
  EXPECT_TRUE(logic.dab(-1, {50, 0, 0}).empty());
  EXPECT_TRUE(logic.dab(1000000, {50, 0, 0}).empty());
  EXPECT_TRUE(logic.dab(0, {NAN, 0, 0}).empty());
}

TEST_F(PatchPainting, OnACloudStaysOnTheConnectedSheet) {
  // Two sheets of points 1 mm apart in x and y, 5 mm apart in height: within the brush's ball, but beyond its
  // steps of 3 mm.
  Surface cloud = test::grid(20, 20);
  const Index n = cloud.size();
  Points points(2 * n, 3);
  points << cloud.points, cloud.points;
  points.bottomRows(n).col(2).setConstant(-5);
  cloud.points = points;
  cloud.triangles.resize(0, 3);
  document.setScan(std::make_shared<Surface>(cloud));
  PatchPaintingLogic logic(document);
  logic.target = PaintTarget::Scan;
  logic.radiusMm = 8;
  logic.beginStroke();
  const PatchEdit edit = logic.dab(-1, {10, 10, 0.2});
  for (Index i = 0; i < 2 * n; ++i) {
    const bool under = i < n && (Vector3d(points.row(i)) - Vector3d(10, 10, 0.2)).norm() <= 8;
    EXPECT_EQ(std::binary_search(edit.ids.begin(), edit.ids.end(), static_cast<int>(i)), under) << i;
  }
}

}  // namespace
}  // namespace falciform

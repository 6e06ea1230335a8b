#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/Logic/Atlas/BeanLiver.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;

/// One method, and how well it must do on the bean; each figure is about twice what was measured. The
/// statistics expect the members' mean, which is no stiff body.
struct MethodCase {
  UpdateMethod method;
  double bentMm;   ///< mean error left of a bending: within the atlas's span, where there is one
  double stiffMm;  ///< bending found where there is none
};

void PrintTo(const MethodCase& c, std::ostream* out) { *out << enumToString(c.method); }

class UpdateMethods : public testing::TestWithParam<MethodCase> {
 protected:
  static const PreparedUpdate& prepared() {
    static std::map<UpdateMethod, PreparedUpdate> made;
    const UpdateMethod method = GetParam().method;
    return made.try_emplace(method, method, beanSurface(), basisOf(method)).first->second;
  }
  /// Where the methods begin, as `falciform update` does.
  static Isometry3d registered(const BeanTruth& truth) {
    return registerSurfaces(beanSurface(), truth.scan, {}).scanFromPreop;
  }
  static UpdateBasis basisOf(UpdateMethod method) {
    if (needsDeformations(method)) return std::make_shared<const Atlas>(beanAtlas());
    return std::make_shared<const TetrahedralMesh>(beanMesh());
  }
};

TEST_P(UpdateMethods, RecoversABendingOfItsKind) {
  if (GetParam().method == UpdateMethod::Incremental)
    GTEST_SKIP() << "it holds the liver where nothing holds the bean: see IncrementalUpdate";
  const BeanTruth truth = beanTruth({3, 0, 0, 2, 0, 0}, 0.1);
  const Isometry3d start = registered(truth);
  UpdateResult rigid;
  rigid.scanFromPreop = start;
  rigid.displacements = Points::Zero(truth.displacements.rows(), 3);
  ASSERT_GT(meanError(prepared().mesh(), rigid, truth), 4);  // mm: what there is to be mended
  const UpdateResult update = updateByMethod(prepared(), truth.scan, start);
  EXPECT_LT(meanError(prepared().mesh(), update, truth), GetParam().bentMm);
  EXPECT_GT(update.minDetJ, 0);
  EXPECT_GT(update.seconds, 0);
  EXPECT_EQ(update.covariance.size() == 0, prepared().model() == nullptr);
}

TEST_P(UpdateMethods, LeavesAStiffBodyStiff) {
  const BeanTruth truth = beanTruth({}, 0);
  const UpdateResult update = updateByMethod(prepared(), truth.scan, registered(truth));
  EXPECT_LT(meanError(prepared().mesh(), update, truth), GetParam().stiffMm);
  EXPECT_LT(update.largestMm, 5 * GetParam().stiffMm);
}

TEST_P(UpdateMethods, FollowsTheScanWhereverItLies) {
  const BeanTruth truth = beanTruth({3, 0, 0, 2, 0, 0}, 0.1);
  const Isometry3d elsewhere = randomMotion(9, 400);
  const UpdateResult here = updateByMethod(prepared(), truth.scan, truth.scanFromPreop);
  const UpdateResult there = updateByMethod(prepared(), transformed(truth.scan, elsewhere, "scanner"),
                                            elsewhere * truth.scanFromPreop);
  // mm: rounding only, but a point between two vertices may take the other one.
  EXPECT_LT((there.displacements - here.displacements).cwiseAbs().maxCoeff(), 1e-2);
}

TEST_P(UpdateMethods, SameBitsForAnyNumberOfThreads) {
  const BeanTruth truth = beanTruth({3, 0, 0, 2, 0, 0}, 0.2);
  std::vector<UpdateResult> results;
  for (const int count : {1, 3}) {
    setThreads(count);
    results.push_back(updateByMethod(prepared(), truth.scan, truth.scanFromPreop,
                                     {.maxIterations = 12, .samplePoints = 600}));
  }
  setThreads(0);
  EXPECT_EQ(results[0].displacements, results[1].displacements);
  EXPECT_EQ(results[0].scanFromPreop.matrix(), results[1].scanFromPreop.matrix());
}

TEST_P(UpdateMethods, TooFewPointsAreRefused) {
  Surface scan;
  scan.points = Points::Random(5, 3);
  EXPECT_THROW((void)updateByMethod(prepared(), scan, Isometry3d::Identity()), InputError);
}

INSTANTIATE_TEST_SUITE_P(
    All, UpdateMethods,
    testing::Values(MethodCase{UpdateMethod::Loads, 2.2, 0.1}, MethodCase{UpdateMethod::Libr, 2.2, 0.1},
                    MethodCase{UpdateMethod::Incremental, 0, 0.1}, MethodCase{UpdateMethod::Icat, 0.1, 0.1},
                    MethodCase{UpdateMethod::IcatStar, 0.4, 0.4},
                    MethodCase{UpdateMethod::Constrained, 0.1, 0.1}, MethodCase{UpdateMethod::Pca, 0.4, 2.5}),
    [](const auto& each) {
      std::string name = enumToString(each.param.method);
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

UpdateBasis atlasBasis(const Atlas& atlas = beanAtlas()) { return std::make_shared<const Atlas>(atlas); }

std::string refusalOf(UpdateMethod method, const Surface& preop, const UpdateBasis& basis) {
  try {
    (void)PreparedUpdate(method, preop, basis);
  } catch (const InputError& error) {
    return error.what();
  }
  return "was taken";
}

TEST(UpdateBasis, AnAtlasThatDoesNotSuitIsRefusedInWords) {
  EXPECT_THAT(
      refusalOf(UpdateMethod::Icat, beanSurface(), std::make_shared<const TetrahedralMesh>(beanMesh())),
      HasSubstr("needs an atlas"));
  EXPECT_THAT(refusalOf(UpdateMethod::Loads, beanSurface(), atlasBasis()), HasSubstr("surface loads"));
  Surface elsewhere = beanSurface();
  elsewhere.points.col(0).array() += 40;
  EXPECT_THAT(refusalOf(UpdateMethod::Icat, elsewhere, atlasBasis()), HasSubstr("another liver"));
  elsewhere = beanSurface();
  elsewhere.frame = "tracker";
  EXPECT_THAT(refusalOf(UpdateMethod::Icat, elsewhere, atlasBasis()), HasSubstr("frame"));
  Atlas endless = beanAtlas();
  endless.modes.resize(200000);
  EXPECT_THAT(refusalOf(UpdateMethod::Pca, beanSurface(), atlasBasis(endless)), HasSubstr("200000 modes"));
  Atlas empty = beanAtlas();
  empty.modes.clear();
  EXPECT_THAT(refusalOf(UpdateMethod::Pca, beanSurface(), atlasBasis(empty)), HasSubstr("no deformations"));
}

}  // namespace
}  // namespace falciform::test

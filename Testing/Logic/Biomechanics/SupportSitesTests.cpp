#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Biomechanics/SupportTemplates.h"
#include "Logic/Core/Errors.h"

namespace falciform::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The built-in liver, meshed once for all tests here.
struct Liver {
  Surface preop;
  TetrahedralMesh mesh;
  BoundaryFaces faces;
  SupportSites sites;
};

const Liver& liver() {
  static const Liver made = [] {
    SyntheticLiverSettings shape;
    shape.edgeLengthMm = 3;
    Liver result;
    result.preop = makeSyntheticLiver(shape).surface;
    MeshSettings settings;
    settings.edgeLengthMm = 7;
    settings.order = ElementOrder::Linear;
    result.mesh = meshLiver(result.preop, {}, settings).mesh;
    result.faces = boundaryFaces(result.mesh);
    result.sites = findSupportSites(result.preop, result.mesh, result.faces);
    return result;
  }();
  return made;
}

std::vector<const std::vector<int>*> regions(const SupportSites& sites) {
  return {&sites.venaCava, &sites.posteriorBed, &sites.leftUnderside, &sites.rightUnderside};
}

Vector3d meanNormal(const std::vector<int>& faces) {
  Vector3d sum = Vector3d::Zero();
  for (const int f : faces) sum += liver().faces.areaVectors.row(f).transpose();
  return sum.normalized();
}

TEST(SupportSites, NoFaceIsInTwoRegionsAndNoneIsEmpty) {
  std::set<int> seen;
  std::size_t count = 0;
  for (const std::vector<int>* region : regions(liver().sites)) {
    EXPECT_FALSE(region->empty());
    EXPECT_TRUE(std::is_sorted(region->begin(), region->end()));
    seen.insert(region->begin(), region->end());
    count += region->size();
  }
  EXPECT_EQ(seen.size(), count);
  EXPECT_LT(*seen.rbegin(), liver().faces.size());
  EXPECT_THAT(liver().sites.warnings, IsEmpty());
}

TEST(SupportSites, LieWhereAnatomyHasThem) {
  const SupportSites& sites = liver().sites;
  EXPECT_TRUE(sites.groove.painted);
  // The built-in liver's groove runs at x = 0 at the notch, slanted a little to the left above it.
  EXPECT_NEAR(sites.groove.point.x(), 0, 10);
  for (const int f : sites.leftUnderside) EXPECT_GT(sites.groove.leftOf(sites.centres.row(f).transpose()), 0);
  for (const int f : sites.rightUnderside)
    EXPECT_LE(sites.groove.leftOf(sites.centres.row(f).transpose()), 0);
  // Directions: the undersides look down, bed and cava back.
  EXPECT_LT(meanNormal(sites.rightUnderside).z(), -0.6);
  EXPECT_LT(meanNormal(sites.leftUnderside).z(), -0.4);
  EXPECT_GT(meanNormal(sites.posteriorBed).y(), 0.7);
  EXPECT_GT(meanNormal(sites.venaCava).y(), 0.7);
  // The vena cava: above both undersides, behind the middle, beside the groove's plane (within 40 mm of 210).
  const Vector3d cava = centreOf(sites, sites.venaCava);
  EXPECT_GT(cava.z(), centreOf(sites, sites.leftUnderside).z());
  EXPECT_GT(cava.z(), centreOf(sites, sites.rightUnderside).z());
  EXPECT_GT(cava.y(), liver().preop.points.col(1).mean());
  EXPECT_LT(std::abs(sites.groove.leftOf(cava)), 40);
}

TEST(SupportSites, FollowThePaintedGroove) {
  // The same liver with its groove painted 20 mm further to the right: the lobes part there.
  Surface moved = liver().preop;
  for (std::size_t i = 0; i < moved.patch.size(); ++i) {
    const Vector3d p = moved.points.row(static_cast<Index>(i)).transpose();
    moved.patch[i] = std::abs(p.x() + 20) < 4 && p.y() < -30 ? patch::kFalciform : patch::kNone;
  }
  const SupportSites sites = findSupportSites(moved, liver().mesh, liver().faces);
  EXPECT_NEAR(sites.groove.point.x(), -20, 2);  // mm; half the painted stripe
  EXPECT_GT(sites.leftUnderside.size(), liver().sites.leftUnderside.size());
}

TEST(SupportSites, WithoutAPaintedGrooveTheMiddleOfTheBoxPartsTheLobesWithAWarning) {
  Surface bare = liver().preop;
  bare.patch.clear();
  const SupportSites sites = findSupportSites(bare, liver().mesh, liver().faces);
  EXPECT_FALSE(sites.groove.painted);
  EXPECT_THAT(sites.warnings, ElementsAre(HasSubstr("no falciform patch")));
  EXPECT_DOUBLE_EQ(sites.groove.point.x(),
                   (bare.points.col(0).minCoeff() + bare.points.col(0).maxCoeff()) / 2);
}

TEST(SupportSites, MoveWithTheLiver) {
  // A patient who lies elsewhere in the scanner has the same supports.
  const Vector3d shift(1000, -500, 250);
  Surface preop = liver().preop;
  preop.points.rowwise() += shift.transpose();
  TetrahedralMesh mesh = liver().mesh;
  mesh.points.rowwise() += shift.transpose();
  const SupportSites sites = findSupportSites(preop, mesh, boundaryFaces(mesh));
  const auto before = regions(liver().sites), after = regions(sites);
  for (std::size_t r = 0; r < before.size(); ++r) {
    // Rounding may decide for a face on a border otherwise: a hundredth of them.
    std::vector<int> differing;
    std::set_symmetric_difference(before[r]->begin(), before[r]->end(), after[r]->begin(), after[r]->end(),
                                  std::back_inserter(differing));
    EXPECT_LE(differing.size(), 1 + before[r]->size() / 100);
  }
}

TEST(SupportSites, RefuseWhatIsNoLiverInLps) {
  // Head and feet exchanged by a turn about x: what looked back now looks forward.
  Surface turned = liver().preop;
  TetrahedralMesh mesh = liver().mesh;
  for (Points* points : {&turned.points, &mesh.points}) {
    points->col(1) *= -1;
    points->col(2) *= -1;
  }
  turned.points.col(0).array() += 1000;  // and the groove's plane far from the mesh
  EXPECT_THROW(
      {
        try {
          (void)findSupportSites(turned, mesh, boundaryFaces(mesh));
        } catch (const InputError& error) {
          EXPECT_THAT(error.what(), HasSubstr("vena cava"));
          throw;
        }
      },
      InputError);
  EXPECT_THROW((void)groovePlane(Surface{}), InputError);
}

TEST(PackingSite, IsAConnectedDiscOfItsRadiusOnTheUnderside) {
  const SupportSites& sites = liver().sites;
  const Vector3d centre = centreOf(sites, sites.rightUnderside);
  const std::vector<int> small = packingSite(sites, centre, 15), large = packingSite(sites, centre, 30);
  EXPECT_TRUE(std::includes(large.begin(), large.end(), small.begin(), small.end()));
  double area = 0;
  for (const int f : large) {
    area += sites.areasMm2(f);
    // Straight is never longer than along the surface; the centre itself may hang 10 mm off the hollow face.
    EXPECT_LT((sites.centres.row(f).transpose() - centre).norm(), 30 + 10);
    EXPECT_TRUE(std::binary_search(sites.rightUnderside.begin(), sites.rightUnderside.end(), f) ||
                std::binary_search(sites.leftUnderside.begin(), sites.leftUnderside.end(), f));
  }
  // A disc of 30 mm has 2827 mm2; the hollow and the elements' size change it by less than a fifth.
  EXPECT_NEAR(area, 2827, 0.2 * 2827);
  EXPECT_FALSE(packingSite(sites, centre, 0.01).empty());
  EXPECT_THROW((void)packingSite(sites, centre, 0), InputError);
}

TEST(PackingSites, AreEvenlySpreadAndTheSameEachTime) {
  const SupportSites& sites = liver().sites;
  const std::vector<Vector3d> places = packingSites(sites, 20);
  ASSERT_EQ(places.size(), 20u);
  EXPECT_EQ(places, packingSites(sites, 20));
  double closest = 1e9, area = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) closest = std::min(closest, (places[i] - places[j]).norm());
  for (const auto* region : {&sites.leftUnderside, &sites.rightUnderside})
    for (const int f : *region) area += sites.areasMm2(f);
  // On a honeycomb of the same density neighbours are sqrt(1.155 A / n) apart; half of it is still even.
  EXPECT_GT(closest, 0.5 * std::sqrt(1.155 * area / 20));
  EXPECT_THROW((void)packingSites(sites, 0), InputError);
  EXPECT_THROW((void)packingSites(sites, 1000000), InputError);
}

TEST(SupportTemplates, HoldTheVenaCavaAndPushInwardsUnderTheirLobe) {
  const SupportSites& sites = liver().sites;
  const std::vector<Support> left = leftLobePacked(sites, 20, 30), right = rightLobePacked(sites, 25, 30);
  ASSERT_EQ(left.size(), 3u);
  ASSERT_EQ(right.size(), 2u);
  EXPECT_EQ(left[0].kind, SupportKind::Fixed);
  EXPECT_EQ(left[0].faces, sites.venaCava);
  EXPECT_EQ(left[1].kind, SupportKind::Sliding);
  EXPECT_EQ(left[2].kind, SupportKind::Pushed);
  EXPECT_EQ(left[2].pushMm, 20);
  EXPECT_EQ(right[1].pushMm, 25);
  EXPECT_TRUE(std::includes(sites.leftUnderside.begin(), sites.leftUnderside.end(), left[2].faces.begin(),
                            left[2].faces.end()));
  EXPECT_TRUE(std::includes(sites.rightUnderside.begin(), sites.rightUnderside.end(), right[1].faces.begin(),
                            right[1].faces.end()));
}

TEST(SupportTemplates, TurningToTheLeftBringsGravityToTheLeftAndKeepsItsLength) {
  const Vector3d supine(0, 9.81, 0);
  EXPECT_LT(gravityChangeOfTurn(0).norm(), 1e-15);
  const Vector3d turned = supine + gravityChangeOfTurn(30);
  EXPECT_NEAR(turned.norm(), 9.81, 1e-12);  // m/s2, rounding
  EXPECT_NEAR(turned.x(), 9.81 / 2, 1e-12);
  SupportTemplateSettings settings;
  settings.posture = SupportTemplate::TurnedLeft;
  EXPECT_GT(supportTemplate(liver().sites, settings).gravityChangeMPerS2.x(), 1);
  settings.pushMm = -1;
  EXPECT_THROW((void)supportTemplate(liver().sites, settings), InputError);
}

}  // namespace
}  // namespace falciform::test

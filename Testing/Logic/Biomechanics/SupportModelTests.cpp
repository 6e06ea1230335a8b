#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Biomechanics/SupportResponse.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Results.h"

namespace falciform::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The built-in liver on a coarse mesh, prepared once for all tests here.
std::shared_ptr<const SupportModel> model() {
  static const auto made = [] {
    SyntheticLiverSettings shape;
    shape.edgeLengthMm = 4;
    LiverModelSettings settings;
    settings.edgeLengthMm = 18;
    return prepareSupportModel(std::make_shared<const Surface>(makeSyntheticLiver(shape).surface), {},
                               nullptr, settings);
  }();
  return made;
}

SupportPainting packed(SupportTemplate posture) {
  SupportTemplateSettings settings;
  settings.posture = posture;
  return paintedTemplate(*model(), emptySupportPainting(model()->preop->size()), settings);
}

double meanAlong(const DeformedLiver& liver, const std::vector<int>& faces, const Vector3d& direction) {
  double sum = 0;
  int count = 0;
  const std::vector<char> wanted = [&] {
    std::vector<char> marks(static_cast<std::size_t>(model()->sites.centres.rows()), 0);
    for (const int f : faces) marks[static_cast<std::size_t>(f)] = 1;
    return marks;
  }();
  for (Index i = 0; i < liver.surface->size(); ++i)
    if (wanted[static_cast<std::size_t>(model()->faceOfPoint[static_cast<std::size_t>(i)])]) {
      sum += (liver.surface->points.row(i) - model()->preop->points.row(i)).dot(direction);
      ++count;
    }
  return sum / count;
}

TEST(PaintedSupports, ATemplateComesBackFromItsPaintAsTheSameFaces) {
  SupportTemplateSettings settings;
  const std::vector<Support> meant = supportTemplate(model()->sites, settings).supports;
  const PaintedSupports painted = supportsOf(*model(), packed(SupportTemplate::LeftLobePacked));
  ASSERT_EQ(painted.supports.size(), meant.size());
  EXPECT_THAT(painted.warnings, IsEmpty());
  for (std::size_t s = 0; s < meant.size(); ++s) {
    EXPECT_EQ(painted.supports[s].name, meant[s].name);
    EXPECT_EQ(painted.supports[s].kind, meant[s].kind);
    EXPECT_EQ(painted.supports[s].pushMm, meant[s].pushMm);
    EXPECT_EQ(painted.supports[s].faces, meant[s].faces);
  }
  EXPECT_EQ(missingSupport(*model(), painted), "");
}

TEST(PaintedSupports, ANewTemplateKeepsTheUsersRegionsAndReplacesTheLabels) {
  SupportPainting painting = emptySupportPainting(model()->preop->size());
  painting.regions[9] = {"kidney", SupportRegionKind::Sliding, 0};
  painting.labels.front() = 9;
  SupportTemplateSettings settings;
  settings.posture = SupportTemplate::RightLobePacked;
  settings.pushMm = 33;
  const SupportPainting filled = paintedTemplate(*model(), painting, settings);
  EXPECT_EQ(filled.regions.at(9).name, "kidney");
  EXPECT_EQ(filled.regions.at(support_label::kRightPacking).pushMm, 33);
  EXPECT_EQ(paintedSupports(filled),
            (std::vector<int>{support_label::kVenaCava, support_label::kRightPacking}));
}

TEST(PaintedSupports, SaysInWordsWhatCannotBeComputed) {
  const Index points = model()->preop->size();
  SupportPainting painting = emptySupportPainting(points);
  EXPECT_THAT(missingSupport(*model(), supportsOf(*model(), painting)), HasSubstr("template"));
  // One point is less than half of any face's.
  painting.labels.front() = support_label::kVenaCava;
  EXPECT_THAT(supportsOf(*model(), painting).warnings, testing::ElementsAre(HasSubstr("smaller")));
  // Fixed on the dome, for which nothing was prepared.
  for (Index i = 0; i < points; ++i)
    if (model()->preop->points(i, 2) > 60)
      painting.labels[static_cast<std::size_t>(i)] = support_label::kVenaCava;
  EXPECT_THAT(missingSupport(*model(), supportsOf(*model(), painting)), HasSubstr("prepare the model again"));
  painting.labels.pop_back();
  EXPECT_THROW((void)supportsOf(*model(), painting), InputError);
}

TEST(PaintedSupports, WhatIsPaintedBeforePreparingMayBeHeldAfterwards) {
  auto painting = std::make_shared<SupportPainting>(emptySupportPainting(model()->preop->size()));
  for (Index i = 0; i < model()->preop->size(); ++i)
    if (model()->preop->points(i, 2) > 60)
      painting->labels[static_cast<std::size_t>(i)] = support_label::kVenaCava;
  LiverModelSettings settings;
  settings.edgeLengthMm = 25;
  const auto prepared = prepareSupportModel(model()->preop, {}, painting, settings);
  const PaintedSupports painted = supportsOf(*prepared, *painting);
  EXPECT_EQ(missingSupport(*prepared, painted), "");
  EXPECT_NO_THROW((void)SupportResponse(prepared, painted.supports).at({0}, 10));
}

TEST(SupportResponse, IsTheSolutionOfTheWholeHypothesis) {
  std::vector<Support> supports = supportsOf(*model(), packed(SupportTemplate::LeftLobePacked)).supports;
  const SupportResponse response(model(), supports);
  supports.back().pushMm = 17;
  const Points whole = model()->solver.solve({supports, gravityChangeOfTurn(25)});
  const Points expected = model()->preop->points + Points(model()->places.interpolate(whole));
  const DeformedLiver liver = response.at({0, 0, 17}, 25);
  // mm; the solver answers to single precision of the largest displacement, here about 20.
  EXPECT_LT((liver.surface->points - expected).cwiseAbs().maxCoeff(), 20 * 1e-5);
  const VectorXd lengths = (liver.surface->points - model()->preop->points).rowwise().norm();
  EXPECT_LT((liver.surface->arrays.at(kDisplacement) - lengths).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_DOUBLE_EQ(liver.largestMm, lengths.maxCoeff());
}

TEST(SupportResponse, AtNoDistanceAndNoTurnTheLiverIsAtRest) {
  const SupportResponse response(model(),
                                 supportsOf(*model(), packed(SupportTemplate::LeftLobePacked)).supports);
  const DeformedLiver liver = response.at({0, 0, 0}, 0);
  EXPECT_EQ(liver.surface->points, model()->preop->points);
  EXPECT_EQ(liver.largestMm, 0);
  EXPECT_DOUBLE_EQ(liver.check.minDetJ, 1);
  EXPECT_THROW((void)response.at({0}, 0), InputError);
}

TEST(SupportResponse, PackingLiftsItsLobeMoreThanTheOther) {
  const PaintedSupports left = supportsOf(*model(), packed(SupportTemplate::LeftLobePacked));
  const DeformedLiver liver = SupportResponse(model(), left.supports).at({0, 0, 20}, 0);
  const std::vector<int>& packedFaces = left.supports.back().faces;
  Vector3d outward = Vector3d::Zero();
  for (const int f : packedFaces) outward += model()->solver.faces().areaVectors.row(f).transpose();
  // Pushed inwards by 20 mm along normals that spread by some 30 degrees about their mean.
  EXPECT_GT(meanAlong(liver, packedFaces, -outward.normalized()), 12);
  EXPECT_LT(std::abs(meanAlong(liver, model()->sites.venaCava, Vector3d::UnitZ())), 0.5);
  // The rest turns about the vena cava, which is all that is fixed, but less than the packed lobe moves.
  const VectorXd& lengths = liver.surface->arrays.at(kDisplacement);
  double leftSum = 0, rightSum = 0;
  int leftCount = 0, rightCount = 0;
  for (Index i = 0; i < lengths.size(); ++i) {
    const bool isLeft = model()->sites.groove.leftOf(model()->preop->points.row(i).transpose()) > 0;
    (isLeft ? leftSum : rightSum) += lengths[i];
    ++(isLeft ? leftCount : rightCount);
  }
  EXPECT_GT(leftSum / leftCount, 1.5 * rightSum / rightCount);
}

TEST(SupportResponse, OnItsLeftSideTheLiverSinksToTheLeft) {
  const SupportPainting turned = packed(SupportTemplate::TurnedLeft);
  EXPECT_GT(turned.turnDeg, 0);
  const DeformedLiver liver =
      SupportResponse(model(), supportsOf(*model(), turned).supports).at({0, 0}, turned.turnDeg);
  EXPECT_GT((liver.surface->points - model()->preop->points).col(0).mean(), 0);
}

TEST(SupportModels, RefuseSettingsOutOfRangeAndStopWhenAsked) {
  LiverModelSettings settings;
  settings.poissonsRatio = 0.5;
  EXPECT_THROW((void)prepareSupportModel(model()->preop, {}, nullptr, settings), InputError);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)prepareSupportModel(model()->preop, {}, nullptr, {},
                                         Progress([](double, std::string_view) {}, stop.get_token())),
               Cancelled);
}

}  // namespace
}  // namespace falciform::test

#include "Logic/Core/Case.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace falciform {

namespace {

using Part = Case::Part;

struct Watched {
  Case document;
  std::vector<Part> parts;
  Connection connection = document.changed.connect([this](Part part) { parts.push_back(part); });

  /// As after registration and distance map of a loaded case.
  Watched() {
    document.setPreop(std::make_shared<Surface>());
    document.setScan(std::make_shared<Surface>());
    document.setRegistration(std::make_shared<RegistrationResult>());
    document.setDistance(std::make_shared<DistanceMap>());
    parts.clear();
  }
  [[nodiscard]] bool announced(Part part) const { return std::count(parts.begin(), parts.end(), part) == 1; }
};

}  // namespace

TEST(Case, StartsEmptyAndUnmodified) {
  const Case document;
  EXPECT_FALSE(document.modified());
  EXPECT_FALSE(document.registrationStale());
  EXPECT_FALSE(document.preop() || document.scan() || document.labels() || document.registration() ||
               document.distance());
}

TEST(Case, NewSurfacesMakeTheRegistrationStaleAndDropTheDistanceMap) {
  for (const bool preop : {true, false}) {
    Watched watched;
    const auto surface = std::make_shared<Surface>();
    preop ? watched.document.setPreop(surface) : watched.document.setScan(surface);
    EXPECT_TRUE(watched.document.registration()) << "it is kept, and marked";
    EXPECT_TRUE(watched.document.registrationStale());
    EXPECT_FALSE(watched.document.distance());
    EXPECT_TRUE(watched.announced(preop ? Part::Preop : Part::Scan));
    EXPECT_TRUE(watched.announced(Part::Distance));
  }
}

TEST(Case, ANewRegistrationIsFreshAndDropsTheDistanceMap) {
  Watched watched;
  watched.document.setScan(std::make_shared<Surface>());
  watched.document.setDistance(std::make_shared<DistanceMap>());
  watched.document.setRegistration(std::make_shared<RegistrationResult>());
  EXPECT_FALSE(watched.document.registrationStale());
  EXPECT_FALSE(watched.document.distance());
  EXPECT_TRUE(watched.announced(Part::Registration));
}

TEST(Case, WithoutARegistrationNothingIsStale) {
  Case document;
  document.setPreop(std::make_shared<Surface>());
  document.setScan(std::make_shared<Surface>());
  EXPECT_FALSE(document.registrationStale());
}

TEST(Case, WhoeverHearsOfANewSurfaceFindsTheRegistrationStaleAndTheDistanceMapGone) {
  for (const bool preop : {true, false}) {
    Watched watched;
    bool stale = false, gone = false;
    const Connection connection = watched.document.changed.connect([&](Part part) {
      if (part != Part::Preop && part != Part::Scan) return;
      stale = watched.document.registrationStale();
      gone = watched.document.distance() == nullptr;
    });
    const auto surface = std::make_shared<Surface>();
    preop ? watched.document.setPreop(surface) : watched.document.setScan(surface);
    EXPECT_TRUE(stale);
    EXPECT_TRUE(gone) << "no listener may see a map of another surface";
  }
}

TEST(Case, LandmarksNamesAndStructuresLeaveResultsAlone) {
  Watched watched;
  watched.document.setName("case 5");
  watched.document.setPreopLandmarks({{{"dome", {1, 2, 3}}}, "LPS"});
  watched.document.setScanLandmarks({});
  watched.document.setStructure("tumour", std::make_shared<Surface>());
  watched.document.setLabels(std::make_shared<LabelMap>());
  watched.document.setCt(std::make_shared<Image>());
  watched.document.setTargets({{{"tumour 1", {1, 2, 3}}}, "LPS"});
  watched.document.setTruthTargets({});
  EXPECT_FALSE(watched.document.registrationStale());
  EXPECT_TRUE(watched.document.distance());
  EXPECT_EQ(watched.parts,
            (std::vector<Part>{Part::Name, Part::PreopLandmarks, Part::ScanLandmarks, Part::Structures,
                               Part::Labels, Part::Ct, Part::Targets, Part::TruthTargets}));
}

TEST(Case, SupportsStayWhilePatchesArePaintedAndGoWithTheShape) {
  Case document;
  Surface liver;
  liver.points = Points::Random(10, 3);
  document.setPreop(std::make_shared<const Surface>(liver));
  document.setSupports(std::make_shared<const SupportPainting>(emptySupportPainting(10)));
  liver.patch.assign(10, patch::kFalciform);
  document.setPreop(std::make_shared<const Surface>(liver));
  EXPECT_NE(document.supports(), nullptr);
  bool told = false;
  const Connection watching = document.changed.connect([&](Case::Part part) {
    EXPECT_EQ(document.supports(), nullptr) << "whoever hears of the new shape finds no old supports";
    told = told || part == Case::Part::Supports;
  });
  liver.points(3, 1) += 1;
  document.setPreop(std::make_shared<const Surface>(liver));
  EXPECT_TRUE(told);
}

TEST(Case, AStructureIsRemovedByNothing) {
  Case document;
  document.setStructure("tumour", std::make_shared<Surface>());
  EXPECT_EQ(document.structures().count("tumour"), 1U);
  document.setStructure("tumour", nullptr);
  EXPECT_TRUE(document.structures().empty());
}

TEST(Case, AnyChangeMarksItModifiedUntilItIsSaved) {
  Case document;
  document.setName("x");
  EXPECT_TRUE(document.modified());
  document.setUnmodified();
  EXPECT_FALSE(document.modified());
  document.setScanLandmarks({});
  EXPECT_TRUE(document.modified());
}

TEST(Case, ClearingLeavesItAsAfterConstructionAndAnnouncesEveryPart) {
  Watched watched;
  watched.document.setScan(std::make_shared<Surface>());
  watched.document.setStructure("vein", std::make_shared<Surface>());
  watched.document.setName("case 5");
  watched.parts.clear();
  watched.document.clear();
  EXPECT_FALSE(watched.document.modified());
  EXPECT_FALSE(watched.document.registrationStale());
  EXPECT_EQ(watched.document.name(), Case().name());
  EXPECT_TRUE(watched.document.structures().empty());
  EXPECT_FALSE(watched.document.preop() || watched.document.scan() || watched.document.registration() ||
               watched.document.distance());
  for (const Part part : {Part::Labels, Part::Preop, Part::Scan, Part::Structures, Part::PreopLandmarks,
                          Part::ScanLandmarks, Part::Registration, Part::Distance, Part::Supports, Part::Ct,
                          Part::Targets, Part::TruthTargets, Part::Name})
    EXPECT_TRUE(watched.announced(part)) << static_cast<int>(part);
  watched.document.setName("next");
  EXPECT_EQ(watched.parts.back(), Part::Name) << "connections stay";
}

}  // namespace falciform

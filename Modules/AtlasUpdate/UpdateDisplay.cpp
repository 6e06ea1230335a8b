#include "Modules/AtlasUpdate/UpdateDisplay.h"

#include <QCoreApplication>
#include <algorithm>

#include "Logic/Atlas/ScanNext.h"
#include "Logic/Deformation/DistanceMapping.h"

namespace falciform {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("UpdateDisplay", text); }

std::shared_ptr<const Surface> inPreop(const Surface& inScan, const Isometry3d& preopFromScan) {
  return std::make_shared<const Surface>(transformed(inScan, preopFromScan, "LPS"));
}

/// Part of the way from one surface to another of the same points; colours those of the nearer end, motion in
/// proportion.
std::shared_ptr<const Surface> onTheWay(const std::shared_ptr<const Surface>& from,
                                        const std::shared_ptr<const Surface>& to, double share) {
  if (share <= 0) return from;
  if (share >= 1) return to;
  auto surface = std::make_shared<Surface>(share < 0.5 ? *from : *to);
  surface->points = (1 - share) * from->points + share * to->points;
  surface->normals.resize(0, 3);
  if (const auto motion = to->arrays.find(kAgainstRigid); motion != to->arrays.end())
    surface->arrays[kAgainstRigid] = share * motion->second;
  return surface;
}

/// The targets of the case on their way, pre-op mm.
std::shared_ptr<const Points> targetsOnTheWay(const UpdatedCase& made, double share) {
  const Isometry3d preopFromScan = made.registration->scanFromPreop.inverse();
  Points places(0, 3);
  for (const UpdatedTarget& target : made.targets) {
    if (target.structure) continue;
    places.conservativeResize(places.rows() + 1, 3);
    places.bottomRows<1>() = ((1 - share) * target.before + share * (preopFromScan * target.now)).transpose();
  }
  return std::make_shared<const Points>(std::move(places));
}

/// The same surface elsewhere; nullptr for another number of points.
std::shared_ptr<const Surface> movedTo(const Surface& surface, const Points& points) {
  if (surface.size() != points.rows()) return nullptr;
  auto moved = std::make_shared<Surface>(surface);
  moved->points = points;
  moved->normals.resize(0, 3);
  return moved;
}

std::string onTheWayCaption(double share) {
  return "On the way, " + QString::number(share, 'f', 2).toStdString();
}

double largestOf(const Surface& surface, const char* array) {
  const auto found = surface.arrays.find(array);
  return found == surface.arrays.end() || found->second.size() == 0 ? 0 : found->second.maxCoeff();
}

}  // namespace

std::shared_ptr<const UpdateMaps> mapsOf(std::shared_ptr<const UpdatedCase> made, const Progress& progress) {
  auto maps = std::make_shared<UpdateMaps>();
  const Isometry3d pose = made->registration->scanFromPreop, preopFromScan = pose.inverse();
  progress.report(0, "Distances to the scan");
  DistanceSettings settings;
  settings.curvatureRadiusMm = 0;  // only distances are shown
  const DistanceMap rigid = mapDistances(*made->preop, *made->scan, pose, settings, progress.part(0, 0.5));
  const DistanceMap updated =
      mapDistances(*made->surface, *made->scan, Isometry3d::Identity(), settings, progress.part(0.5, 1));
  maps->rigidResidualMm = rigid.scanAll.rms;
  maps->updatedResidualMm = updated.scanAll.rms;

  auto before = std::make_shared<Surface>(*made->preop);
  before->arrays[kSignedDistance] = rigid.preop.arrays.at(kSignedDistance);
  before->arrays[kAgainstRigid] = VectorXd::Zero(before->size());
  maps->rigid = before;
  auto after = std::make_shared<Surface>(*inPreop(*made->surface, preopFromScan));
  after->arrays[kSignedDistance] = updated.preop.arrays.at(kSignedDistance);
  maps->updated = after;
  for (const auto& [name, structure] : made->structures) {
    maps->rigidStructures[name] = made->structuresBefore.at(name);
    maps->updatedStructures[name] = inPreop(*structure, preopFromScan);
  }
  maps->of = std::move(made);
  return maps;
}

std::optional<ScalarMap> mapFor(UpdateColours colours, const UpdateMaps& maps) {
  switch (colours) {
    case UpdateColours::Plain:
      return std::nullopt;
    case UpdateColours::Motion:
      return magnitudeMap(kAgainstRigid, "Motion against rigid", "mm",
                          largestOf(*maps.updated, kAgainstRigid));
    case UpdateColours::Residual:
      return symmetricMap(kSignedDistance, "Residual (fit)", "mm", {maps.rigid.get(), maps.updated.get()});
    case UpdateColours::ExpectedError:
      return magnitudeMap(kExpectedError, "Expected error", "mm", largestOf(*maps.updated, kExpectedError));
    case UpdateColours::ScanGain:
      return magnitudeMap(kScanGain, "Scan here next", "mm", largestOf(*maps.updated, kScanGain));
  }
  return std::nullopt;
}

QString meaningOf(UpdateColours colours) {
  switch (colours) {
    case UpdateColours::Plain:
      return tr("Patches in their colours, the scan on the liver.");
    case UpdateColours::Motion:
      return tr("How far each place lies from where the rigid registration puts it, mm.");
    case UpdateColours::Residual:
      return tr(
          "Distance to the scan, mm; red: the scan lies outside, blue: inside, grey: no scan there. Fit, not "
          "target error: it may be small where targets are far off.");
    case UpdateColours::ExpectedError:
      return tr(
          "How far each place may be off, mm (root mean square): the update's own estimate, not measured. It "
          "grows away from the scan.");
    case UpdateColours::ScanGain:
      return tr(
          "Where more scanning would help: by how many mm the expected error at the targets (without any, "
          "over "
          "the liver) would fall if the surface around each place were scanned too. Whether the scanner can "
          "see "
          "it is not asked.");
  }
  return {};
}

void showUpdate(ViewState& view, const UpdateMaps* maps, const UpdateLook& look) {
  view.edit([&](ViewOptions& options) {
    options.slicesShown = look.slices;
    options.updateShown = maps != nullptr;
    if (!maps) {
      options.liveDeformed.reset();
      options.comparedLiver.reset();
      options.movedStructures.clear();
      options.movedTargets.reset();
      options.updateColours.reset();
      return;
    }
    const double share = look.share;
    options.liveDeformed = onTheWay(maps->rigid, maps->updated, share);
    options.updateColours = mapFor(look.colours, *maps);
    options.deformedCaption = share >= 1   ? "Model update"
                              : share <= 0 ? "Rigid registration"
                                           : onTheWayCaption(share);
    options.structuresBefore = look.before && share > 0;
    options.movedStructures.clear();
    for (const auto& [name, structure] : maps->updatedStructures)
      options.movedStructures[name] = onTheWay(maps->rigidStructures.at(name), structure, share);
    options.movedTargets = targetsOnTheWay(*maps->of, share);
    options.comparedLiver = look.compare ? maps->rigid : nullptr;
    options.comparedCaption = "Rigid registration";
  });
}

void showSettling(ViewState& view, const Case& document, const UpdateShape& shape, int iteration) {
  const auto liver = document.preop() ? movedTo(*document.preop(), shape.liver) : nullptr;
  if (!liver) return;
  view.edit([&](ViewOptions& options) {
    options.updateShown = true;
    options.liveDeformed = liver;
    options.deformedCaption = "Settling: iteration " + std::to_string(iteration);
    options.updateColours.reset();
    options.comparedLiver.reset();
    options.structuresBefore = false;
    options.movedStructures.clear();
    for (const auto& [name, points] : shape.structures)
      if (const auto known = document.structures().find(name); known != document.structures().end())
        if (const auto moved = movedTo(*known->second, points)) options.movedStructures[name] = moved;
  });
}

void hideUpdate(ViewState& view) {
  view.edit([](ViewOptions& options) {
    if (options.updateShown) options.liveDeformed.reset();
    options.updateShown = options.slicesShown = options.structuresBefore = false;
    options.updateColours.reset();
    options.comparedLiver.reset();
    options.movedStructures.clear();
    options.movedTargets.reset();
  });
}

}  // namespace falciform

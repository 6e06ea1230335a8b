#include "Modules/CommandLine/UpdatePictures.h"

#include "Logic/Atlas/UpdatedPlaces.h"
#include "Modules/CommandLine/SlicePicture.h"
#include "Modules/CommandLine/UpdateTiles.h"

namespace falciform::commandline {

namespace {

Structures movedStructures(const CaseUpdate& update, const Structures& structures) {
  Structures moved;
  for (const auto& [name, surface] : structures) {
    if (surface->size() == 0) continue;
    auto now = std::make_shared<Surface>(*surface);
    now->points = scanFromPreop(update.liver.mesh, update.result, surface->points);
    now->normals.resize(0, 3);
    moved[name] = now;
  }
  return moved;
}

std::string mm(double value) { return fixed(value, 2) + " mm"; }

}  // namespace

const std::vector<std::string>& updatePictureNames() {
  static const std::vector<std::string> names{
      "update_registered.png", "update_moved.png",  "update_expected.png",  "update_scan_before.png",
      "update_scan_after.png", "update_inside.png", "update_ct_before.png", "update_ct_after.png"};
  return names;
}

std::vector<PictureFile> saveUpdatePictures(const CaseUpdate& update, const DistanceMap& registered,
                                            const Structures& structures, const BentCt& ct,
                                            const std::filesystem::path& folder, const Progress& progress) {
  std::vector<PictureFile> pictures;
  const auto add = [&](std::size_t which, const RenderedImage& image, const std::string& caption) {
    const std::filesystem::path file = folder / updatePictureNames()[which];
    savePng(image, file, Overwrite::Replace);
    pictures.push_back({file, caption});
    progress.report(static_cast<double>(which + 1) / 8, "Drawing pictures of the update");
  };
  const UpdateTiles tiles(update.liver.surface, update.updated->moved, update.input.scan,
                          update.rigid->scanFromPreop);
  add(0, tiles.registered(), "As the rigid registration leaves the liver, under the scan's points.");
  add(1, tiles.moved(),
      "As the update moves it, coloured by how far it has bent beside the rigid motion, up to " +
          fixed(update.result.largestMm, 1) + " mm.");
  if (tiles.expectsError())
    add(2, tiles.expectedError(), "The error to be expected of the updated liver, by its own opinion.");
  const ScalarMap colours =
      symmetricMap(kSignedDistance, "Signed distance", "mm", {&registered.scan, &update.distance.scan});
  add(3, tiles.residual("Scan against the registered liver", registered.scan, colours),
      "Signed distance of the scan to the registered liver: RMS " + mm(registered.scanAll.rms) +
          ". Grey: farther than the reach.");
  add(4, tiles.residual("Scan against the updated liver", update.distance.scan, colours),
      "The same after the update, in the same colours: RMS " + mm(update.distance.scanAll.rms) +
          " (fit, not target error).");
  if (!structures.empty())
    add(5, tiles.structures(structures, movedStructures(update, structures)),
        "Vessels (blue) and tumours (orange) where they are now; grey: where the registration alone puts "
        "them.");
  if (ct.before && ct.after) {
    const SlicePictures cuts =
        slicePictures(*ct.before, *ct.after, update.liver.surface, update.liver.mesh, update.result);
    add(6, cuts.before, "Axial cut through the CT as it was, where the liver has bent most.");
    add(7, cuts.after,
        "The same cut of the CT as it would look now, bent only. Yellow: the liver now; dashed: as it was.");
  }
  return pictures;
}

}  // namespace falciform::commandline

#include "Widgets/Rendering/Pictures.h"

#include <cstdio>

#include "Logic/Core/Errors.h"
#include "Widgets/Rendering/OffscreenWindow.h"
#include "Widgets/Rendering/PictureScenes.h"

namespace falciform {

namespace {

void save(Scene& scene, const std::filesystem::path& file, Overwrite overwrite, PictureSize size) {
  OffscreenWindow window(size.width, size.height);
  window.show(scene);
  window.savePng(file, overwrite);
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f %%", 100 * share);
  return text;
}

std::string afterCaption(const RegistrationResult& result) {
  char text[200];
  std::snprintf(text, sizeof text,
                "After registration: both surfaces in the scan's frame, seen from the scan's side. RMS "
                "residual %.2f mm "
                "(fit, not target error).",
                result.rmsMm);
  return text;
}

constexpr char kSign[] =
    "Positive (red): the scan lies outside the pre-operative surface; negative (blue): inside; grey: no "
    "value.";

}  // namespace

void savePreopPicture(const Surface& preop, const Structures& structures, const std::filesystem::path& file,
                      Overwrite overwrite, PictureSize size) {
  save(*preopScene(preop, structures, size), file, overwrite, size);
}

void saveScanPicture(const Surface& scan, const std::filesystem::path& file, Overwrite overwrite,
                     PictureSize size) {
  save(*scanScene(scan, size), file, overwrite, size);
}

void saveOverlayPicture(const Surface& preop, const Surface& scan, const Isometry3d& scanFromPreop,
                        const std::string& title, const std::filesystem::path& file, Overwrite overwrite,
                        PictureSize size) {
  save(*overlayScene(preop, scan, scanFromPreop, title, size), file, overwrite, size);
}

void saveDistancePicture(const DistanceMap& map, DistanceSide side, const std::filesystem::path& file,
                         Overwrite overwrite, PictureSize size,
                         const std::optional<Isometry3d>& scanFromPreop) {
  save(*distanceScene(map, side, size, scanFromPreop), file, overwrite, size);
}

void saveHistogramPicture(const DistanceMap& map, const std::filesystem::path& file, Overwrite overwrite,
                          PictureSize size) {
  save(*histogramScene(map, size), file, overwrite, size);
}

void saveConvergencePicture(const RegistrationResult& registration, const std::filesystem::path& file,
                            Overwrite overwrite, PictureSize size) {
  save(*convergenceScene(registration, size), file, overwrite, size);
}

std::vector<PictureFile> savePictures(const PictureSources& sources, const std::filesystem::path& folder,
                                      Overwrite overwrite, PictureSize size, const Progress& progress) {
  makeFolder(folder);
  std::vector<PictureFile> pictures;
  const auto add = [&](const char* name, const std::string& caption, Scene& scene) {
    progress.report(static_cast<double>(pictures.size()) / 8, "Drawing pictures");
    save(scene, folder / name, overwrite, size);
    pictures.push_back({folder / name, caption});
  };
  const auto& [preop, scan, registration, distance, structures, start] = sources;

  if (preop)
    add("preop.png", "The pre-operative surface with its patches.", *preopScene(*preop, structures, size));
  if (scan) add("scan.png", "The intra-operative scan with its patches.", *scanScene(*scan, size));
  if (preop && scan && registration) {
    const Isometry3d& pose = registration->scanFromPreop;
    // One view for both, or before and after could not be compared.
    const ViewDirection view = viewOfScan(*scan, transformed(preop->points, pose), pose);
    add("before.png",
        "Before registration: both surfaces in the scan's frame, from the same direction as after it.",
        *overlayScene(*preop, *scan, start, "Before registration", size, view));
    add("after.png", afterCaption(*registration),
        *overlayScene(*preop, *scan, pose, "After registration", size, view));
  }
  if (distance) {
    const auto pose = registration ? std::optional(registration->scanFromPreop) : std::nullopt;
    add("distance_preop.png",
        "Signed distance in mm on the pre-operative surface, " + percent(distance->coverage) +
            " of it covered. " + kSign,
        *distanceScene(*distance, DistanceSide::Preop, size, pose));
    add("distance_scan.png", std::string("Signed distance in mm on the scan. ") + kSign,
        *distanceScene(*distance, DistanceSide::Scan, size, pose));
    add("histogram.png", "How the signed distances are spread, in mm, on both surfaces.",
        *histogramScene(*distance, size));
  }
  if (registration && !registration->history.empty())
    add("convergence.png", "RMS residual in mm and patch weight over the iterations.",
        *convergenceScene(*registration, size));
  progress.report(1, "Drawing pictures");
  return pictures;
}

}  // namespace falciform

#include "Widgets/Rendering/Pictures.h"

#include <algorithm>
#include <cstdio>
#include <memory>

#include "Widgets/Rendering/OffscreenWindow.h"
#include "Widgets/Rendering/PictureScenes.h"

namespace falciform {

namespace {

/// Draws what `compose(size)` makes, twice as large where that is possible, and saves it at the size asked
/// for.
template <class Compose>
void save(const std::filesystem::path& file, Overwrite overwrite, PictureSize size, const Compose& compose) {
  const bool doubled = std::max(size.width, size.height) <= 4096;
  if (doubled) size = {2 * size.width, 2 * size.height};
  const std::unique_ptr<Scene> scene = compose(size);
  OffscreenWindow window(size.width, size.height);
  window.show(*scene);
  const RenderedImage image = window.image();
  savePng(doubled ? halved(image) : image, file, overwrite);
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
  save(file, overwrite, size, [&](PictureSize drawn) { return preopScene(preop, structures, drawn); });
}

void saveScanPicture(const Surface& scan, const std::filesystem::path& file, Overwrite overwrite,
                     PictureSize size) {
  save(file, overwrite, size, [&](PictureSize drawn) { return scanScene(scan, drawn); });
}

void saveOverlayPicture(const Surface& preop, const Surface& scan, const Isometry3d& scanFromPreop,
                        const std::string& title, const std::filesystem::path& file, Overwrite overwrite,
                        PictureSize size) {
  save(file, overwrite, size,
       [&](PictureSize drawn) { return overlayScene(preop, scan, scanFromPreop, title, drawn); });
}

void saveDistancePicture(const DistanceMap& map, DistanceSide side, const std::filesystem::path& file,
                         Overwrite overwrite, PictureSize size,
                         const std::optional<Isometry3d>& scanFromPreop) {
  save(file, overwrite, size,
       [&](PictureSize drawn) { return distanceScene(map, side, drawn, scanFromPreop); });
}

void saveHistogramPicture(const DistanceMap& map, const std::filesystem::path& file, Overwrite overwrite,
                          PictureSize size) {
  save(file, overwrite, size, [&](PictureSize drawn) { return histogramScene(map, drawn); });
}

void saveConvergencePicture(const RegistrationResult& registration, const std::filesystem::path& file,
                            Overwrite overwrite, PictureSize size) {
  save(file, overwrite, size, [&](PictureSize drawn) { return convergenceScene(registration, drawn); });
}

std::vector<PictureFile> savePictures(const PictureSources& sources, const std::filesystem::path& folder,
                                      Overwrite overwrite, PictureSize size, const Progress& progress) {
  makeFolder(folder);
  std::vector<PictureFile> pictures;
  const auto add = [&](const char* name, const std::string& caption, const auto& compose) {
    progress.report(static_cast<double>(pictures.size()) / 8, "Drawing pictures");
    save(folder / name, overwrite, size, compose);
    pictures.push_back({folder / name, caption});
  };
  const auto& s = sources;
  if (s.preop)
    add("preop.png", "The pre-operative surface with its patches.",
        [&](PictureSize drawn) { return preopScene(*s.preop, s.structures, drawn); });
  if (s.scan)
    add("scan.png", "The intra-operative scan with its patches.",
        [&](PictureSize drawn) { return scanScene(*s.scan, drawn); });
  if (s.preop && s.scan && s.registration) {
    const Isometry3d& pose = s.registration->scanFromPreop;
    // One view for both, or before and after could not be compared.
    const ViewDirection view = viewOfScan(*s.scan, transformed(s.preop->points, pose), pose);
    const auto overlay = [&](const Isometry3d& scanFromPreop, const char* title) {
      return [&, title](PictureSize drawn) {
        return overlayScene(*s.preop, *s.scan, scanFromPreop, title, drawn, view);
      };
    };
    add("before.png",
        "Before registration: both surfaces in the scan's frame, seen from the same direction as after it.",
        overlay(s.scanFromPreopStart, "Before registration"));
    add("after.png", afterCaption(*s.registration), overlay(pose, "After registration"));
  }
  if (s.distance) {
    const auto pose = s.registration ? std::optional(s.registration->scanFromPreop) : std::nullopt;
    const auto side = [&](DistanceSide which) {
      return [&, which](PictureSize drawn) { return distanceScene(*s.distance, which, drawn, pose); };
    };
    add("distance_preop.png",
        "Signed distance in mm on the pre-operative surface, " + percent(s.distance->coverage) +
            " of it covered. " + kSign,
        side(DistanceSide::Preop));
    add("distance_scan.png", std::string("Signed distance in mm on the scan. ") + kSign,
        side(DistanceSide::Scan));
    add("histogram.png", "How the signed distances are spread, in mm, on both surfaces.",
        [&](PictureSize drawn) { return histogramScene(*s.distance, drawn); });
  }
  if (s.registration && !s.registration->history.empty())
    add("convergence.png", "RMS residual in mm and patch weight over the iterations.",
        [&](PictureSize drawn) { return convergenceScene(*s.registration, drawn); });
  progress.report(1, "Drawing pictures");
  return pictures;
}

}  // namespace falciform

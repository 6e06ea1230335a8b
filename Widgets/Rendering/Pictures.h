#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Results.h"
#include "Logic/Core/Surface.h"
#include "Logic/IO/OutputFile.h"
#include "Widgets/Rendering/PictureSources.h"

namespace falciform {

// PNG pictures for the command line and for reports, drawn without a display. Link Falciform::Offscreen and
// call falciform_offscreen_executable(target) in CMake. Each carries "Research use only: not a medical
// device".

/// The pre-operative surface from the front, patches in their colours with a legend, structures inside it
/// (the surface then is see-through).
void savePreopPicture(const Surface& preop, const Structures& structures, const std::filesystem::path& file,
                      Overwrite overwrite, PictureSize size = {});

/// The scan from its scanner's side, in its own colours where it has them, patches in theirs.
void saveScanPicture(const Surface& scan, const std::filesystem::path& file, Overwrite overwrite,
                     PictureSize size = {});

/// Both surfaces in the scan's frame (thesis Fig. III.10): pre-op patches red, scan patches blue. Seen from
/// the scan's side. `title` stands at the top.
void saveOverlayPicture(const Surface& preop, const Surface& scan, const Isometry3d& scanFromPreop,
                        const std::string& title, const std::filesystem::path& file, Overwrite overwrite,
                        PictureSize size = {});

/// One side of a distance map: symmetric colours around 0 with a bar in mm, grey where there is no value, and
/// a sentence on what the sign means. Both sides share the range. Upright as the
/// patient stands if the pose is given.
void saveDistancePicture(const DistanceMap& map, DistanceSide side, const std::filesystem::path& file,
                         Overwrite overwrite, PictureSize size = {},
                         const std::optional<Isometry3d>& scanFromPreop = {});

/// Histogram of the signed distances of both sides, mm against the share of values.
void saveHistogramPicture(const DistanceMap& map, const std::filesystem::path& file, Overwrite overwrite,
                          PictureSize size = {});

/// RMS residual (mm) and patch weight over the iterations of the start that won.
void saveConvergencePicture(const RegistrationResult& registration, const std::filesystem::path& file,
                            Overwrite overwrite, PictureSize size = {});

/// A picture on disk and one sentence on what it shows, for a report. Plain text, not escaped for HTML.
struct PictureFile {
  std::filesystem::path file;
  std::string caption;
};

/// Writes what the sources allow into `folder` (made if need be): preop.png, scan.png, before.png, after.png,
/// distance_preop.png, distance_scan.png, histogram.png, convergence.png. Returns them in this order.
[[nodiscard]] std::vector<PictureFile> savePictures(const PictureSources& sources,
                                                    const std::filesystem::path& folder, Overwrite overwrite,
                                                    PictureSize size = {}, const Progress& progress = {});

}  // namespace falciform

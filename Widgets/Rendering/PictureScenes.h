#pragma once
#include <memory>
#include <optional>
#include <string>

#include "Widgets/Rendering/CameraViews.h"
#include "Widgets/Rendering/PictureSources.h"
#include "Widgets/Rendering/Scene.h"

namespace falciform {

// What Pictures.h saves, as scenes that any render window of the given size can show.

[[nodiscard]] std::unique_ptr<Scene> preopScene(const Surface& preop, const Structures& structures,
                                                PictureSize size);
[[nodiscard]] std::unique_ptr<Scene> scanScene(const Surface& scan, PictureSize size);
/// Seen from `view`, in the scan's frame; none: viewOfScan().
[[nodiscard]] std::unique_ptr<Scene> overlayScene(const Surface& preop, const Surface& scan,
                                                  const Isometry3d& scanFromPreop, const std::string& title,
                                                  PictureSize size,
                                                  const std::optional<ViewDirection>& view = {});
/// Upright as the patient stands if the pose is given.
[[nodiscard]] std::unique_ptr<Scene> distanceScene(const DistanceMap& map, DistanceSide side,
                                                   PictureSize size,
                                                   const std::optional<Isometry3d>& scanFromPreop = {});
[[nodiscard]] std::unique_ptr<Scene> histogramScene(const DistanceMap& map, PictureSize size);
[[nodiscard]] std::unique_ptr<Scene> convergenceScene(const RegistrationResult& registration,
                                                      PictureSize size);

/// The view from which the scan was taken, in its frame, the patient upright. `preopInScan` lies where the
/// pose puts it and tells the liver's inside from its outside.
[[nodiscard]] ViewDirection viewOfScan(const Surface& scan, const Points& preopInScan,
                                       const Isometry3d& scanFromPreop);

}  // namespace falciform

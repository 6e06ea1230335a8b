#pragma once
#include <filesystem>
#include <optional>

#include "Logic/Geometry/GridField.h"

namespace falciform::bench {

/// What another program made of the same two distance images.
struct PeerMap {
  double wallS = 0;
  Points toSource;  ///< of the places asked for
};

/// elastix (affine, then B-splines of 8 mm in four resolutions, mean squares) and transformix; nothing if it
/// is not installed or fails. Files go to `folder`.
[[nodiscard]] std::optional<PeerMap> elastix(const GridField& target, const GridField& source,
                                             const Points& places, const std::filesystem::path& folder);
/// plastimatch (affine, then B-splines of 30, 15 and 8 mm, mean squares).
[[nodiscard]] std::optional<PeerMap> plastimatch(const GridField& target, const GridField& source,
                                                 const Points& places, const std::filesystem::path& folder);

}  // namespace falciform::bench

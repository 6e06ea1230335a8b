#pragma once
#include <filesystem>
#include <optional>

#include "Logic/Core/TrackedPoints.h"
#include "Logic/IO/Loaded.h"

namespace falciform {

/// Reads a tracker's recording from CSV (commas, semicolons or tabs; first line names the columns, in any
/// order and case; other columns are passed over):
///
/// | column                           | meaning                                                         |
/// |----------------------------------|-----------------------------------------------------------------|
/// | x, y, z or tx, ty, tz            | place; with _mm, _cm or _m behind, else mm                        |
/// | q0, qx, qy, qz (or qw)           | the tool's turn, needed with `tipInTool` only                     |
/// | stroke, swab or segment          | a new value begins a new stroke                                   |
/// | time, t, seconds, time_s, time_ms| a pause of more than a second begins a new stroke                 |
/// | state, status, visible, valid    | only OK, good, enabled, visible, true or 1 is taken               |
///
/// A file of three columns of numbers without names is x, y, z. A sample with an empty place is lost.
/// `tipInTool`: the tip in the tool's own frame, mm, from its calibration; the place is then the tool's
/// origin. `frame` is "tracker" unless a remark "# space=NAME" says otherwise. Throws InputError: not such a
/// table, no place in it, a time that runs backwards, a quaternion of length 0.
[[nodiscard]] Loaded<TrackedPoints> readTrackedPoints(const std::filesystem::path& file,
                                                      const std::optional<Vector3d>& tipInTool = {});

}  // namespace falciform

#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

/// What to do with a surface of several pieces.
enum class Pieces { Refuse, KeepLargest, KeepAll };

/// Makes a surface ready to be filled: points in the same place joined, triangles that occur twice or have no
/// area dropped, points of no triangle dropped, an inside-out surface turned round; what was done is added to
/// `warnings` in words that begin with `what`. Throws InputError in one line for a surface that is empty,
/// open (how many open edges, and where the first is), not a manifold, or in several pieces where `pieces`
/// says so.
[[nodiscard]] Surface closedSurface(const Surface& surface, const std::string& what, Pieces pieces,
                                    std::vector<std::string>& warnings);

/// The pieces of a surface that hang together by vertices, in order of their first point.
[[nodiscard]] std::vector<Surface> piecesOf(const Surface& surface);

}  // namespace falciform

#include <array>
#include <cstring>
#include <unordered_map>

#include "Logic/Core/Errors.h"
#include "Logic/IO/NumberText.h"
#include "Logic/IO/SurfaceFormats.h"
#include "Logic/IO/SurfaceParts.h"

namespace falciform {

namespace {

constexpr std::size_t kHeader = 84, kFacet = 50;

using Corner = std::array<float, 3>;

struct CornerHash {
  std::size_t operator()(const Corner& corner) const {
    std::uint64_t hash = 0;
    for (const float value : corner) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15ull;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

/// Corners that are equal to the last bit are one point: STL knows no neighbours, a mesh must. Points keep
/// the order in which they first appear.
class CornerMerger {
 public:
  void add(Corner corner) {
    for (float& value : corner) value += 0.0f;  // -0 and 0 are one place
    const auto [place, fresh] = ids_.try_emplace(corner, static_cast<long long>(ids_.size()));
    if (fresh) coordinates_.insert(coordinates_.end(), corner.begin(), corner.end());
    corners_.push_back(place->second);
  }

  [[nodiscard]] Surface surface(const std::string& name) const {
    Surface merged;
    merged.points =
        Eigen::Map<const Points>(coordinates_.data(), static_cast<Index>(coordinates_.size() / 3), 3);
    TriangleCollector triangles(merged.size(), name);
    for (std::size_t i = 0; i + 3 <= corners_.size(); i += 3)
      triangles.addPolygon(std::span<const long long>(corners_).subspan(i, 3));
    merged.triangles = triangles.triangles();
    return merged;
  }

 private:
  std::unordered_map<Corner, long long, CornerHash> ids_;
  std::vector<double> coordinates_;
  std::vector<long long> corners_;
};

RawSurface readBinary(const std::string& bytes, std::uint32_t facets, const std::string& name) {
  RawSurface raw;
  CornerMerger corners;
  for (std::uint32_t i = 0; i < facets; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      Corner corner;
      std::memcpy(corner.data(), bytes.data() + kHeader + i * kFacet + 12 * (k + 1), sizeof corner);
      corners.add(corner);
    }
  raw.surface = corners.surface(name);
  raw.space = spaceTagIn(std::string_view(bytes).substr(0, 80));
  return raw;
}

RawSurface readText(const std::string& text, const std::string& name) {
  RawSurface raw;
  CornerMerger corners;
  TextCursor cursor(text);
  std::size_t inFacet = 0;
  bool ended = false;
  const auto refuse = [&](const std::string& why) {
    throw InputError(name + ", line " + std::to_string(cursor.line()) + ": " + why + "; export it again");
  };
  for (std::string_view line; cursor.nextLine(line);) {
    const std::string_view whole = line;
    const std::string_view keyword = nextWord(line);
    ended = keyword == "endsolid" || (keyword.empty() && ended);
    if (keyword == "solid") {
      if (const auto tag = spaceTagIn(whole); tag && !raw.space) raw.space = tag;
    } else if (keyword == "vertex") {
      Corner corner;
      for (float& value : corner)
        if (!parseNumber(nextWord(line), value)) refuse("a vertex lacks a number");
      corners.add(corner);
      ++inFacet;
    } else if (keyword == "endfacet") {
      if (inFacet != 3) refuse("a facet has " + std::to_string(inFacet) + " corners, not 3");
      inFacet = 0;
    }
  }
  if (!ended) refuse("the file ends without 'endsolid' (truncated)");
  raw.surface = corners.surface(name);
  return raw;
}

}  // namespace

RawSurface readStl(const std::string& bytes, const std::string& name) {
  std::uint32_t facets = 0;
  if (bytes.size() >= kHeader) std::memcpy(&facets, bytes.data() + 80, sizeof facets);
  const std::size_t expected = kHeader + facets * kFacet;
  const bool exact = bytes.size() >= kHeader && bytes.size() == expected;
  // Some binary files begin with "solid" too, so the size decides first.
  if (!exact && bytes.starts_with("solid") && bytes.find("facet") != std::string::npos)
    return readText(bytes, name);
  if (bytes.size() < expected || facets == 0)
    throw InputError(name + " is not a sound STL file: it announces " + std::to_string(facets) +
                     " triangles (" + std::to_string(expected) + " bytes) and has " +
                     std::to_string(bytes.size()) + " bytes (truncated or no STL); export it again");
  RawSurface raw = readBinary(bytes, facets, name);
  if (!exact)
    raw.warnings.push_back(name + ": " + std::to_string(bytes.size() - expected) +
                           " bytes after the last triangle were ignored");
  return raw;
}

}  // namespace falciform

#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>

#include "Logic/Atlas/Atlas.h"

namespace falciform {

/// Version of the file's layout (Docs/Atlas.md), in its attribute `falciform_atlas_version`.
inline constexpr int kAtlasFileVersion = 1;

/// Writes HDF5, readable by any HDF5 reader. `provenance`: what toJson(Provenance) gives. Writes to the
/// file's final name: the caller stages it. Throws InputError if the disk does not take it.
void writeAtlas(const std::filesystem::path& file, const Atlas& atlas, const nlohmann::json& provenance);

struct StoredAtlas {
  Atlas atlas;
  nlohmann::json provenance;
};
/// Throws InputError in one line for a file that is missing, no atlas, newer than this program, cut off,
/// changed since it was written, or inconsistent.
[[nodiscard]] StoredAtlas readAtlas(const std::filesystem::path& file);

}  // namespace falciform

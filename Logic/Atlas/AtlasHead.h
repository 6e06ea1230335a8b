#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>

#include "Logic/Atlas/AtlasDesign.h"
#include "Logic/Atlas/Hdf5Store.h"

namespace falciform {

// What every atlas file begins with, whatever its kind. Inside Logic/Atlas only.

inline constexpr char kAtlasFileKind[] = "falciform atlas";

void writeAtlasHead(Hdf5Writer& file, const AtlasDesign& design, const nlohmann::json& provenance);

struct AtlasHead {
  AtlasDesign design;
  nlohmann::json provenance;
};
[[nodiscard]] AtlasHead readAtlasHead(const Hdf5Reader& file, const std::filesystem::path& path);

/// Throws InputError: what is wrong within an atlas file that is whole.
[[noreturn]] void refuseInconsistent(const std::filesystem::path& file, const std::string& what);

}  // namespace falciform

#pragma once
#include <string>
#include <vector>

namespace falciform {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

[[nodiscard]] std::size_t sizeOf(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float;
  bool isList = false;
  PlyType countType = PlyType::UInt8;  ///< of a list's length
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

/// What a PLY file says about itself. Inside Logic/IO only.
struct PlyHeader {
  std::string name;  ///< of the file, for messages
  PlyFormat format = PlyFormat::Ascii;
  std::vector<std::string> comments;
  std::vector<PlyElement> elements;
  std::size_t bodyBegin = 0;  ///< first byte after end_header
};

/// Throws InputError for anything that is no PLY header, and for counts that the rest of the file cannot
/// hold.
[[nodiscard]] PlyHeader readPlyHeader(const std::string& bytes, const std::string& name);

}  // namespace falciform

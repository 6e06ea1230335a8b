#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

struct PcdField {
  std::string name;
  char type = 'F';       ///< I, U or F
  std::size_t size = 4;  ///< bytes of one value: 1, 2, 4 or 8
  std::size_t count = 1;
};

enum class PcdCoding { Ascii, Binary, Compressed };

/// What a PCD file (Point Cloud Library, version 0.7) says about itself. Inside Logic/IO only.
struct PcdHeader {
  std::vector<PcdField> fields;
  int width = 0, height = 1;
  Vector3d viewpoint = Vector3d::Zero();  ///< where the scanner stood
  PcdCoding coding = PcdCoding::Ascii;
  std::string space;          ///< a space tag in a comment; empty: none
  std::size_t bodyBegin = 0;  ///< first byte after the DATA line

  [[nodiscard]] std::size_t points() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  [[nodiscard]] std::size_t pointBytes() const;
};

/// Throws InputError for anything that is no PCD header, and for more points than `bytes` could hold.
[[nodiscard]] PcdHeader readPcdHeader(const std::string& bytes, const std::string& name);

}  // namespace falciform

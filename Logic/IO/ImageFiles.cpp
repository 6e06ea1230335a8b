#include "Logic/IO/ImageFiles.h"

#include <fstream>

#include "Logic/Core/Errors.h"
#include "Logic/IO/ImageCodecs.h"

namespace falciform {

ColourImage readColourImage(const std::filesystem::path& file) {
  const std::string bytes = readTextFile(file), name = file.filename().string();
  if (isPng(bytes)) return decodePng(bytes, name);
  if (bytes.starts_with("\xFF\xD8\xFF")) return decodeJpeg(bytes, name);
  throw InputError(name + " is neither a PNG nor a JPEG picture; save it as .png");
}

DepthImage readDepthImage(const std::filesystem::path& file) {
  const std::string bytes = readTextFile(file), name = file.filename().string();
  if (!isPng(bytes)) throw InputError(name + " is no PNG; save the depths as a PNG of 16 bits");
  return decodeDepthPng(bytes, name);
}

bool isDepthImage(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  char head[26] = {};
  if (!in.read(head, sizeof head)) return false;
  constexpr int kBitDepthAt = 24, kColourTypeAt = 25;
  return isPng({head, sizeof head}) && head[kBitDepthAt] == 16 && head[kColourTypeAt] == 0;
}

void writePng(const std::filesystem::path& file, const ColourImage& image, Overwrite overwrite,
              const std::vector<std::pair<std::string, std::string>>& texts) {
  if (image.width < 1 || image.height < 1)
    throw InputError("the picture for '" + file.string() + "' is empty; there is nothing to write");
  writeTextFile(file, overwrite, encodePng(image, texts));
}

void writePng(const std::filesystem::path& file, const DepthImage& image, Overwrite overwrite) {
  if (image.width < 1 || image.height < 1)
    throw InputError("the depths for '" + file.string() + "' are empty; there is nothing to write");
  writeTextFile(file, overwrite, encodePng(image));
}

}  // namespace falciform

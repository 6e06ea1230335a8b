#include "Testing/Benchmarks/PressedLiverFiles.h"

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

#include "Logic/IO/SurfaceFiles.h"

namespace falciform::bench {
namespace {

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

Surface readDepthFrame(const std::filesystem::path& depthFile) {
  Surface frame = readSurface(depthFile).value;
  frame.triangles.resize(0, 3);
  frame.normals.resize(0, 3);
  return frame;
}

Points readNodes(const std::filesystem::path& file) {
  const std::string text = contents(file);
  const std::size_t head = text.find("POINTS ");
  std::istringstream stream(head == std::string::npos ? "" : text.substr(head));
  std::string word, type;
  Index count = 0;
  if (!(stream >> word >> count >> type) || count < 1)
    throw std::runtime_error("no nodes in " + file.string());
  Points nodes(count, 3);
  for (Index i = 0; i < nodes.size(); ++i)
    if (!(stream >> nodes.data()[i])) throw std::runtime_error("nodes are missing in " + file.string());
  return nodes;
}

}  // namespace falciform::bench

#include "Logic/Atlas/SealedFile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

constexpr std::size_t kBlock = 1 << 20;  // a multiple of 8

struct Seal {
  std::string kind, checksum;
  int version = 0;
  std::uintmax_t bytes = 0;
};

std::string headOf(const Seal& seal) {
  std::string head = seal.kind + "\nversion " + std::to_string(seal.version) + "\nbytes " +
                     std::to_string(seal.bytes) + "\nchecksum " + seal.checksum +
                     "\nAn HDF5 file follows; open it with any HDF5 reader.\n";
  head.resize(kSealBytes - 1, ' ');
  return head + "\n";
}

/// What the head says; nothing where it is not of this form.
bool readHead(std::istream& stream, Seal& seal) {
  std::string head(kSealBytes, '\0');
  if (!stream.read(head.data(), kSealBytes)) return false;
  std::istringstream lines(head);
  std::string word;
  return std::getline(lines, seal.kind) && lines >> word >> seal.version && word == "version" &&
         lines >> word >> seal.bytes && word == "bytes" && lines >> word >> seal.checksum &&
         word == "checksum";
}

/// Of all that follows the head.
std::string checksumOfRest(std::istream& stream) {
  Checksum sum;
  std::vector<char> block(kBlock);
  stream.clear();
  stream.seekg(kSealBytes);
  while (stream) {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    sum.add(block.data(), static_cast<std::size_t>(stream.gcount()));
  }
  return sum.text();
}

}  // namespace

void Checksum::add(const void* bytes, std::size_t count) {
  const char* from = static_cast<const char*>(bytes);
  for (; count > 0;) {
    const std::size_t step = std::min<std::size_t>(count, 8);
    std::uint64_t word = 0;
    std::memcpy(&word, from, step);
    state_ = (state_ ^ word) * 0x100000001b3ULL;
    state_ ^= state_ >> 29;  // carries the high bits down: words are wider than FNV's bytes
    from += step;
    count -= step;
  }
}

std::string Checksum::text() const {
  std::array<char, 16> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), state_, 16).ptr;
  const std::string text(digits.data(), end);
  return std::string(16 - text.size(), '0') + text;
}

void sealFile(const std::filesystem::path& file, const std::string& kind, int version) {
  std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
  std::error_code error;
  Seal seal{
      .kind = kind, .checksum = {}, .version = version, .bytes = std::filesystem::file_size(file, error)};
  seal.checksum = checksumOfRest(stream);
  stream.clear();
  stream.seekp(0);
  const std::string head = headOf(seal);
  stream.write(head.data(), static_cast<std::streamsize>(head.size()));
  stream.close();
  if (!stream || error) throw InputError("cannot write '" + file.string() + "'; is the disk full?");
}

std::string sealFault(const std::filesystem::path& file, const std::string& kind, int newest) {
  const std::string name = "'" + file.string() + "'";
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return name + " does not exist; check the path";
  if (std::filesystem::is_directory(file, error)) return name + " is a folder; name a file";
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return name + " cannot be read; check its permissions";
  Seal seal;
  if (!readHead(stream, seal) || seal.kind != kind)
    return name + " is no " + kind + "; give a file that falciform wrote";
  if (seal.version < 1 || seal.version > newest)
    return name + " is a " + kind + " of version " + std::to_string(seal.version) +
           ", newer than this program reads (" + std::to_string(newest) +
           "; install a newer falciform or build it anew";
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  if (error || bytes != seal.bytes)
    return name + " has " + std::to_string(bytes) + " bytes but was written with " +
           std::to_string(seal.bytes) + "; copy it again or build it anew";
  if (checksumOfRest(stream) != seal.checksum)
    return name + " has changed since it was written; copy it again or build it anew";
  return "";
}

void checkSeal(const std::filesystem::path& file, const std::string& kind, int newest) {
  if (const std::string fault = sealFault(file, kind, newest); !fault.empty()) throw InputError(fault);
}

}  // namespace falciform

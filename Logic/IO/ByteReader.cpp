#include "Logic/IO/ByteReader.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>

namespace falciform {

namespace {

constexpr std::size_t kBlock = 1 << 16;
constexpr int kGzipOrZlib = 15 + 32;  // largest window, header told by its first bytes
constexpr std::uint64_t kBestRatio =
    1032;  // deflate cannot pack more bytes than this into one (zlib, "Maximum Compression Factor")

}  // namespace

ByteReader::ByteReader(const std::filesystem::path& file, std::uint64_t offset, Packing packing)
    : path_(file), packing_(packing) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) refuseVolume(file, "there is no such file; check the name");
  if (!std::filesystem::is_regular_file(status))
    refuseVolume(file, "this is no ordinary file; give a volume file");
  const std::uint64_t size = std::filesystem::file_size(file, error);
  if (!error) in_.open(file, std::ios::binary);
  if (error || !in_) refuseVolume(file, "the file cannot be opened; check its permissions");
  if (offset > size)
    refuseVolume(file, "the file ends before its voxels begin (" + std::to_string(size) + " of " +
                           std::to_string(offset) + " bytes); it is truncated: copy it again");
  in_.seekg(static_cast<std::streamoff>(offset));
  bytes_ = size - offset;
  if (packing != Packing::Deflated) return;
  stream_ = std::make_unique<z_stream_s>();
  if (inflateInit2(stream_.get(), kGzipOrZlib) != Z_OK) throw std::bad_alloc();
  block_.resize(kBlock);
}

ByteReader::~ByteReader() {
  if (stream_) inflateEnd(stream_.get());
}

std::size_t ByteReader::read(void* into, std::size_t count) {
  return packing_ == Packing::Deflated ? inflateInto(into, count) : readFile(into, count);
}

std::uint64_t ByteReader::skip(std::uint64_t count) {
  std::vector<char> unwanted(kBlock);
  std::uint64_t done = 0;
  while (done < count) {
    const std::size_t got = read(unwanted.data(), std::min<std::uint64_t>(unwanted.size(), count - done));
    if (got == 0) break;
    done += got;
  }
  return done;
}

std::uint64_t ByteReader::mostBytes() const {
  return packing_ == Packing::Deflated ? bytes_ * kBestRatio : bytes_;
}

std::size_t ByteReader::readFile(void* into, std::size_t count) {
  in_.read(static_cast<char*>(into), static_cast<std::streamsize>(count));
  if (in_.bad()) refuseVolume(path_, "the disk reports an error while reading; copy the file again");
  return static_cast<std::size_t>(in_.gcount());
}

bool ByteReader::refill() {
  stream_->next_in = block_.data();
  stream_->avail_in = static_cast<uInt>(readFile(block_.data(), block_.size()));
  return stream_->avail_in > 0;
}

std::size_t ByteReader::inflateInto(void* into, std::size_t count) {
  stream_->next_out = static_cast<Bytef*>(into);
  std::size_t left = count;
  while (left > 0 && !finished_) {
    if (stream_->avail_in == 0 && !refill()) break;
    const auto room = static_cast<uInt>(std::min<std::size_t>(left, std::numeric_limits<uInt>::max()));
    stream_->avail_out = room;
    const int result = inflate(stream_.get(), Z_NO_FLUSH);
    left -= room - stream_->avail_out;
    if (result == Z_STREAM_END) {
      // gzip members may follow one another; anything else behind the end is no data.
      finished_ = (stream_->avail_in == 0 && !refill()) || stream_->next_in[0] != 0x1f;
      if (!finished_) inflateReset(stream_.get());
    } else if (result != Z_OK && result != Z_BUF_ERROR) {
      refuseVolume(path_, "its compressed data is damaged; copy the file again");
    }
  }
  return count - left;
}

bool isGzip(const std::filesystem::path& file) {
  ByteReader reader(file, 0, Packing::Raw);
  unsigned char magic[2] = {};
  return reader.read(magic, 2) == 2 && magic[0] == 0x1f && magic[1] == 0x8b;
}

}  // namespace falciform

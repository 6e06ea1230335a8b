#include "Logic/IO/Deflate.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>
#include <vector>

#include "Logic/Core/Errors.h"

namespace falciform {

namespace {

constexpr int kLevel = 4;  // label maps shrink as well as at 9, a CT in a third of the time
constexpr std::size_t kBlock = 1 << 16;

class Deflater {
 public:
  Deflater(std::ostream& out, DeflateFormat format) : out_(out), block_(kBlock) {
    const int window = format == DeflateFormat::Gzip ? 15 + 16 : 15;
    if (deflateInit2(&stream_, kLevel, Z_DEFLATED, window, 8, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  ~Deflater() { deflateEnd(&stream_); }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;

  void write(Bytes part, bool last) {
    auto* next = static_cast<const Bytef*>(part.data);
    std::size_t left = part.count;
    do {
      const auto now = static_cast<uInt>(std::min<std::size_t>(left, std::numeric_limits<uInt>::max()));
      stream_.next_in = const_cast<Bytef*>(next);  // zlib's interface is older than const
      stream_.avail_in = now;
      next += now;
      left -= now;
      drain(last && left == 0 ? Z_FINISH : Z_NO_FLUSH);
    } while (left > 0);
  }
  [[nodiscard]] std::uint64_t written() const { return written_; }

 private:
  void drain(int flush) {
    do {
      stream_.next_out = block_.data();
      stream_.avail_out = static_cast<uInt>(block_.size());
      deflate(&stream_, flush);
      const std::size_t count = block_.size() - stream_.avail_out;
      out_.write(reinterpret_cast<const char*>(block_.data()), static_cast<std::streamsize>(count));
      written_ += count;
    } while (stream_.avail_out == 0);
  }

  std::ostream& out_;
  std::vector<unsigned char> block_;
  z_stream stream_{};
  std::uint64_t written_ = 0;
};

}  // namespace

std::uint64_t writeDeflated(std::ostream& out, const Bytes* parts, std::size_t partCount,
                            DeflateFormat format) {
  Deflater deflater(out, format);
  for (std::size_t p = 0; p < partCount; ++p) deflater.write(parts[p], p + 1 == partCount);
  return deflater.written();
}

std::uint64_t writeDeflated(std::ostream& out, const void* bytes, std::size_t count, DeflateFormat format) {
  const Bytes part{bytes, count};
  return writeDeflated(out, &part, 1, format);
}

void checkWritten(std::ostream& out) {
  out.flush();
  if (!out)
    throw InputError(
        "the volume could not be written: the disk is full or was taken away; make room and try again");
}

}  // namespace falciform

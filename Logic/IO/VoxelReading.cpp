#include "Logic/IO/VoxelReading.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <type_traits>

#include "Logic/IO/ByteReader.h"
#include "Logic/IO/HeaderText.h"

namespace falciform {

namespace {

constexpr std::size_t kVoxelsAtOnce = 1 << 16;

template <class Stored>
Stored decoded(const unsigned char* bytes, bool swap) {
  unsigned char ordered[sizeof(Stored)];
  for (std::size_t b = 0; b < sizeof(Stored); ++b) ordered[b] = bytes[swap ? sizeof(Stored) - 1 - b : b];
  return std::bit_cast<Stored>(ordered);
}

std::string place(const VolumeLayout& layout, std::size_t voxel) {
  const auto nx = static_cast<std::size_t>(layout.size.x()), ny = static_cast<std::size_t>(layout.size.y());
  return "voxel (" + std::to_string(voxel % nx) + ", " + std::to_string(voxel / nx % ny) + ", " +
         std::to_string(voxel / nx / ny) + ")";
}

/// Takes values in file order and keeps them as labels or as intensities.
template <class T>
class Receiver {
 public:
  Receiver(const VolumeLayout& layout, std::vector<T>& out) : layout_(layout), out_(out) {}

  void take(double stored) {
    const double value = layout_.slope * stored + layout_.intercept;
    if constexpr (std::is_same_v<T, float>) {
      constexpr double most = std::numeric_limits<float>::max();
      if (!std::isfinite(value)) ++notFinite_;
      out_.push_back(static_cast<float>(std::isfinite(value) ? std::clamp(value, -most, most) : value));
    } else {
      // A scaled label may miss its whole number by rounding, never by as much as this.
      const double whole = std::round(value);
      if (!(std::abs(value - whole) <= 1e-6 && whole >= 0 && whole <= std::numeric_limits<T>::max()))
        refuseVolume(layout_.file,
                     place(layout_, out_.size()) + " holds " + shortText(value) +
                         "; a label map holds whole numbers in 0..65535: is this a CT? give the label map");
      out_.push_back(static_cast<T>(whole));
    }
  }
  [[nodiscard]] std::size_t notFinite() const { return notFinite_; }

 private:
  const VolumeLayout& layout_;
  std::vector<T>& out_;
  std::size_t notFinite_ = 0;
};

[[noreturn]] void refuseTruncated(const VolumeLayout& layout, std::size_t found, std::size_t expected) {
  refuseVolume(layout.file,
               "its data ends after " + std::to_string(found) + " of " + std::to_string(expected) +
                   " voxels; the file is truncated or its header is wrong: copy or export it again");
}

template <class Stored, class T>
void takeBinary(ByteReader& reader, const VolumeLayout& layout, std::size_t count, Receiver<T>& receiver) {
  const bool swap = layout.bigEndian != (std::endian::native == std::endian::big);
  std::vector<unsigned char> block(std::min(count, kVoxelsAtOnce) * sizeof(Stored));
  for (std::size_t done = 0; done < count;) {
    const std::size_t wanted = std::min(kVoxelsAtOnce, count - done);
    const std::size_t got = reader.read(block.data(), wanted * sizeof(Stored)) / sizeof(Stored);
    for (std::size_t v = 0; v < got; ++v)
      receiver.take(static_cast<double>(decoded<Stored>(&block[v * sizeof(Stored)], swap)));
    done += got;
    if (got < wanted) refuseTruncated(layout, done, count);
  }
}

template <class T>
void takeNumbers(ByteReader& reader, const VolumeLayout& layout, std::size_t count, Receiver<T>& receiver) {
  switch (layout.scalar) {
    case Scalar::Int8:
      return takeBinary<std::int8_t>(reader, layout, count, receiver);
    case Scalar::UInt8:
      return takeBinary<std::uint8_t>(reader, layout, count, receiver);
    case Scalar::Int16:
      return takeBinary<std::int16_t>(reader, layout, count, receiver);
    case Scalar::UInt16:
      return takeBinary<std::uint16_t>(reader, layout, count, receiver);
    case Scalar::Int32:
      return takeBinary<std::int32_t>(reader, layout, count, receiver);
    case Scalar::UInt32:
      return takeBinary<std::uint32_t>(reader, layout, count, receiver);
    case Scalar::Int64:
      return takeBinary<std::int64_t>(reader, layout, count, receiver);
    case Scalar::UInt64:
      return takeBinary<std::uint64_t>(reader, layout, count, receiver);
    case Scalar::Float32:
      return takeBinary<float>(reader, layout, count, receiver);
    case Scalar::Float64:
      return takeBinary<double>(reader, layout, count, receiver);
  }
}

template <class T>
void takeText(ByteReader& reader, const VolumeLayout& layout, std::size_t count, Receiver<T>& receiver) {
  std::string text;  // no more than one block and the word that its end cut
  std::size_t done = 0;
  std::vector<char> block(1 << 16);
  for (bool more = true; more && done < count;) {
    const std::size_t got = reader.read(block.data(), block.size());
    more = got > 0;
    text.append(block.data(), got);
    const std::size_t whole =
        more ? text.find_last_of(" \t\r\n,") + 1 : text.size();  // 0 where there is none
    for (const std::string_view word : words(std::string_view(text).substr(0, whole))) {
      const auto value = toNumber(word);
      if (!value)
        refuseVolume(layout.file,
                     place(layout, done) + " is " + inQuotes(word) + ", not a number; export it again");
      receiver.take(*value);
      if (++done == count) break;
    }
    text.erase(0, whole);
    if (text.size() > 1000)
      refuseVolume(layout.file, "its text data holds " + inQuotes(text) + ", not numbers; export it again");
  }
  if (done < count) refuseTruncated(layout, done, count);
}

template <class T>
Loaded<Volume<T>> readVolume(VolumeLayout layout) {
  const std::size_t count = static_cast<std::size_t>(layout.size.x()) *
                            static_cast<std::size_t>(layout.size.y()) *
                            static_cast<std::size_t>(layout.size.z());
  ByteReader reader(layout.dataFile, layout.fileOffset, layout.packing);
  const bool text = layout.packing == Packing::Text;
  const std::size_t smallest =
      text ? count * 2 - 1 : count * bytesOf(layout.scalar);  // text: a digit and a blank each
  if (layout.streamOffset + smallest > reader.mostBytes())
    refuseVolume(layout.file, "it holds at most " + std::to_string(reader.mostBytes()) +
                                  " bytes where its header needs " +
                                  std::to_string(layout.streamOffset + smallest) +
                                  "; the file is truncated or its header is wrong: copy or export it again");
  if (reader.skip(layout.streamOffset) < layout.streamOffset) refuseTruncated(layout, 0, count);

  Loaded<Volume<T>> loaded;
  loaded.value.size = layout.size;
  loaded.value.worldFromIndex = layout.worldFromIndex;
  Receiver<T> receiver(layout, loaded.value.voxels);
  try {
    loaded.value.voxels.reserve(count);
  } catch (const std::bad_alloc&) {
    refuseVolume(layout.file,
                 "its " + std::to_string(count) + " voxels do not fit into memory; crop or resample it");
  }
  if (text)
    takeText(reader, layout, count, receiver);
  else
    takeNumbers(reader, layout, count, receiver);

  char extra;
  if (!text && reader.read(&extra, 1) == 1)
    layout.warnings.emplace_back("the file holds more data than its header says; the rest was left out");
  else if (!text && !reader.complete())
    refuseVolume(layout.file, "its compressed data has no end; the file is truncated: copy it again");
  if (receiver.notFinite() > 0)
    layout.warnings.push_back(std::to_string(receiver.notFinite()) + " voxels hold no finite number");
  loaded.warnings = std::move(layout.warnings);
  return loaded;
}

}  // namespace

Loaded<LabelMap> readLabels(VolumeLayout layout) { return readVolume<std::uint16_t>(std::move(layout)); }
Loaded<Image> readIntensities(VolumeLayout layout) { return readVolume<float>(std::move(layout)); }

}  // namespace falciform

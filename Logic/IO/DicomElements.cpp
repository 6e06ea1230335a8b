#include "Logic/IO/DicomElements.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "Logic/Core/Errors.h"
#include "Logic/IO/HeaderText.h"

namespace falciform {

namespace {

using namespace dicomtag;

constexpr int kDeepest = 12;  // sequences within sequences; real files have 4
constexpr std::uint32_t kUndefined = 0xFFFFFFFF;
constexpr DicomTag kItem = 0xFFFEE000, kItemEnd = 0xFFFEE00D, kSequenceEnd = 0xFFFEE0DD;

// Sorted. All else is stepped over: what is not read cannot leave the reader.
constexpr DicomTag kWanted[] = {kTransferSyntax,
                                kCharacterSet,
                                kSopClass,
                                kInstance,
                                kStudyDate,
                                kModality,
                                kSeriesDescription,
                                kPatientName,
                                kPatientId,
                                kBirthDate,
                                kThickness,
                                kBetweenSlices,
                                kSeries,
                                kAcquisition,
                                kPosition,
                                kOrientation,
                                kTemporalPosition,
                                kPlanePosition,
                                kPlaneOrientation,
                                kSamples,
                                kPhotometric,
                                kFrames,
                                kRows,
                                kColumns,
                                kPixelSpacing,
                                kBitsAllocated,
                                kBitsStored,
                                kHighBit,
                                kSigned,
                                kIntercept,
                                kSlope,
                                kPixelMeasures,
                                kPixelTransformation,
                                kSegmentationType,
                                kSegments,
                                kSegmentNumber,
                                kSegmentLabel,
                                kSegmentIdentification,
                                kReferencedSegment,
                                kMaximumFraction,
                                kSharedGroups,
                                kFrameGroups,
                                kPixelData};

[[noreturn]] void refuse(const std::string& what) { throw InputError(what + "; export or copy it again"); }

bool isWanted(DicomTag tag) { return std::binary_search(std::begin(kWanted), std::end(kWanted), tag); }

/// Steps through the bytes of a file; nothing beyond their end is ever read.
class Walker {
 public:
  Walker(DicomBytes bytes, bool explicitVr, bool bigEndian)
      : bytes_(bytes), explicitVr_(explicitVr), bigEndian_(bigEndian) {}

  std::size_t at = 0;

  /// Elements from `at` to `end`, or to an item's end mark where `end` is open.
  void dataSet(std::size_t end, bool openEnded, int depth, DicomItem* into) {
    if (depth > kDeepest) refuse("its sequences lie more than " + std::to_string(kDeepest) + " deep");
    if (into) into->bigEndian = bigEndian_;
    while (at < end) {
      const Header head = header();
      if (head.tag == kItemEnd && openEnded) return;
      if (depth == 0 && head.tag > kPixelData) return;
      element(head, end, depth, into);
      if (depth == 0 && head.tag == kPixelData) return;
    }
    if (openEnded) refuse("one of its items has no end");
  }

  /// The file's own group 2: nothing if another group comes first.
  void metaGroup(DicomItem& into) {
    while (at + 8 <= bytes_.size() && bytes_[at] == 2 && bytes_[at + 1] == 0)
      element(header(), bytes_.size(), 0, &into);
  }

 private:
  struct Header {
    DicomTag tag = 0;
    std::uint32_t length = 0;
    bool sequence = false, unknown = false;
  };

  std::uint32_t number(std::size_t count) {
    if (bytes_.size() - at < count) refuse("it ends in the middle of an element");
    std::uint32_t value = 0;
    for (std::size_t b = 0; b < count; ++b)
      value |= std::uint32_t{bytes_[at + b]} << 8 * (bigEndian_ ? count - 1 - b : b);
    at += count;
    return value;
  }

  Header header() {
    Header head;
    head.tag = number(2) << 16;
    head.tag |= number(2);
    if (!explicitVr_ || head.tag >> 16 == 0xFFFE) {
      head.length = number(4);
      return head;
    }
    if (bytes_.size() - at < 4) refuse("it ends in the middle of an element");
    const std::string_view vr(reinterpret_cast<const char*>(&bytes_[at]), 2);
    at += 2;
    for (const char letter : vr)
      if (letter < 'A' || letter > 'Z') refuse("an element is of a type that DICOM does not know");
    const std::string_view longOnes[] = {"OB", "OD", "OF", "OL", "OV", "OW", "SQ",
                                         "SV", "UC", "UN", "UR", "UT", "UV"};
    head.sequence = vr == "SQ";
    head.unknown = vr == "UN";
    if (std::find(std::begin(longOnes), std::end(longOnes), vr) == std::end(longOnes)) {
      head.length = number(2);
    } else {
      at += 2;
      head.length = number(4);
    }
    return head;
  }

  void element(const Header& head, std::size_t end, int depth, DicomItem* into) {
    DicomElement* kept = into && isWanted(head.tag) ? &into->elements[head.tag] : nullptr;
    if (kept) *kept = {};  // of two with the same tag the later counts
    if (head.length == kUndefined) {
      if (head.tag == kPixelData && depth == 0) return fragments(end, kept);
      // A sequence whose type was lost is written as implicit little endian (PS3.5, 6.2.2).
      const bool wasExplicit = explicitVr_;
      if (head.unknown) explicitVr_ = false;
      sequence(end, true, depth, kept);
      explicitVr_ = wasExplicit;
      return;
    }
    if (at > end || head.length > end - at)
      refuse("an element is said to have " + std::to_string(head.length) + " bytes, " +
             std::to_string(end - std::min(at, end)) + " are left: the file is truncated or damaged");
    const std::size_t after = at + head.length;
    if (kept && isSequence(head)) {
      sequence(after, false, depth, kept);
    } else if (kept) {
      kept->value = bytes_.subspan(at, head.length);
    }
    at = after;
  }

  /// In implicit files the type is the dictionary's.
  [[nodiscard]] static bool isSequence(const Header& head) {
    for (const DicomTag tag : {kPlanePosition, kPlaneOrientation, kPixelMeasures, kPixelTransformation,
                               kSegments, kSegmentIdentification, kSharedGroups, kFrameGroups})
      if (head.tag == tag) return true;
    return head.sequence;
  }

  void sequence(std::size_t end, bool openEnded, int depth, DicomElement* into) {
    if (depth >= kDeepest) refuse("its sequences lie more than " + std::to_string(kDeepest) + " deep");
    while (at < end) {
      const Header head = header();
      if (head.tag == kSequenceEnd && openEnded) return;
      if (head.tag != kItem) refuse("a sequence holds something that is no item");
      const bool open = head.length == kUndefined;
      if (!open && (at > end || head.length > end - at)) refuse("an item reaches beyond its sequence");
      DicomItem* item = into ? &into->items.emplace_back() : nullptr;
      dataSet(open ? end : at + head.length, open, depth + 1, item);
    }
    if (openEnded) refuse("a sequence has no end");
  }

  void fragments(std::size_t end, DicomElement* into) {
    while (true) {
      if (at >= end) refuse("its compressed pixel data has no end: the file is truncated");
      const Header head = header();
      if (head.tag == kSequenceEnd) return;
      if (head.tag != kItem || at > end || head.length > end - at)
        refuse("its compressed pixel data is damaged");
      if (into) into->fragments.push_back(bytes_.subspan(at, head.length));
      at += head.length;
    }
  }

  DicomBytes bytes_;
  bool explicitVr_, bigEndian_;
};

constexpr std::size_t kPreamble = 128;

bool hasMark(DicomBytes bytes) {
  return bytes.size() >= kPreamble + 4 && std::equal(&bytes[kPreamble], &bytes[kPreamble] + 4, "DICM");
}

/// Files of old programs begin with their first element: group 2 or 8, of a small element number.
bool beginsWithElement(DicomBytes bytes) {
  return bytes.size() >= 8 && (bytes[0] == 2 || bytes[0] == 8) && bytes[1] == 0 && bytes[3] == 0 &&
         (bytes[2] == 0 || bytes[2] == 1 || bytes[2] == 5 || bytes[2] == 8 || bytes[2] == 0x10 ||
          bytes[2] == 0x16);
}

bool isUpper(unsigned char c) { return c >= 'A' && c <= 'Z'; }

}  // namespace

const DicomElement* DicomItem::find(DicomTag tag) const {
  const auto found = elements.find(tag);
  return found == elements.end() ? nullptr : &found->second;
}

std::string_view DicomItem::text(DicomTag tag) const {
  const DicomElement* element = find(tag);
  if (!element || element->value.empty()) return {};
  std::string_view text(reinterpret_cast<const char*>(element->value.data()), element->value.size());
  text = text.substr(0, text.find('\0'));
  return trimmed(text);
}

std::optional<std::vector<double>> DicomItem::numbers(DicomTag tag, std::size_t count) const {
  std::string_view rest = text(tag);
  std::vector<double> values;
  while (values.size() < count) {
    const std::size_t end = std::min(rest.find('\\'), rest.size());
    const auto value = toNumber(trimmed(rest.substr(0, end)));
    if (!value || !std::isfinite(*value)) return std::nullopt;
    values.push_back(*value);
    if (end == rest.size()) {
      rest = {};
      break;
    }
    rest.remove_prefix(end + 1);
  }
  if (values.size() != count || !rest.empty()) return std::nullopt;
  return values;
}

std::optional<double> DicomItem::number(DicomTag tag) const {
  const auto one = numbers(tag, 1);
  return one ? std::optional((*one)[0]) : std::nullopt;
}

std::optional<int> DicomItem::unsignedShort(DicomTag tag) const {
  const DicomElement* element = find(tag);
  if (!element || element->value.size() < 2) return std::nullopt;
  const int low = element->value[bigEndian ? 1 : 0], high = element->value[bigEndian ? 0 : 1];
  return high << 8 | low;
}

const DicomItem* DicomItem::first(DicomTag sequence) const {
  const DicomElement* element = find(sequence);
  return element && !element->items.empty() ? &element->items.front() : nullptr;
}

bool beginsAsDicom(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  unsigned char start[kPreamble + 4] = {};
  in.read(reinterpret_cast<char*>(start), sizeof start);
  const DicomBytes bytes(start, static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return hasMark(bytes) || beginsWithElement(bytes);
}

DicomFile parseDicom(std::vector<unsigned char> bytes) {
  DicomFile file;
  file.bytes = std::move(bytes);
  const DicomBytes all = file.bytes;
  if (!hasMark(all) && !beginsWithElement(all)) refuse("this is no DICOM file");
  Walker meta(all, true, false);
  meta.at = hasMark(all) ? kPreamble + 4 : 0;
  DicomItem group2;
  meta.metaGroup(group2);
  file.transferSyntax = group2.text(kTransferSyntax);
  if (file.transferSyntax == "1.2.840.10008.1.2.1.99")
    throw InputError("it is deflated as a whole (a rare transfer syntax); save it uncompressed");
  const bool implicit = file.transferSyntax == "1.2.840.10008.1.2";
  bool explicitVr = !implicit;
  if (file.transferSyntax.empty()) {
    explicitVr = all.size() - meta.at >= 6 && isUpper(all[meta.at + 4]) && isUpper(all[meta.at + 5]);
    file.transferSyntax = explicitVr ? "1.2.840.10008.1.2.1" : "1.2.840.10008.1.2";
  }
  Walker walker(all, explicitVr, file.transferSyntax == "1.2.840.10008.1.2.2");
  walker.at = meta.at;
  walker.dataSet(all.size(), false, 0, &file.data);
  return file;
}

DicomFile readDicomFile(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  const std::streamoff length = in ? static_cast<std::streamoff>(in.tellg()) : -1;
  if (length < 0) throw InputError("it cannot be read; check its permissions");
  std::vector<unsigned char> bytes(static_cast<std::size_t>(length));
  in.seekg(0);
  in.read(reinterpret_cast<char*>(bytes.data()), length);
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return parseDicom(std::move(bytes));
}

}  // namespace falciform

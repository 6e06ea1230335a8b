#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace falciform {

// The elements of a DICOM file that a volume is made of. Every length is held against the bytes that are
// there before it is believed (Docs/Decisions/Dicom.md). Inside Logic/IO only: what these types hold may name
// a patient.

using DicomTag = std::uint32_t;  ///< group * 65536 + element
using DicomBytes = std::span<const unsigned char>;

class DicomItem;

struct DicomElement {
  DicomBytes value;                   ///< of the file's bytes
  std::vector<DicomItem> items;       ///< of a sequence
  std::vector<DicomBytes> fragments;  ///< of encapsulated pixel data, its offset table first
};

/// One data set: the whole file's, or one item of a sequence.
class DicomItem {
 public:
  std::map<DicomTag, DicomElement> elements;
  bool bigEndian = false;

  [[nodiscard]] const DicomElement* find(DicomTag tag) const;
  /// Text without padding; empty where there is none.
  [[nodiscard]] std::string_view text(DicomTag tag) const;
  /// All of a decimal or integer string; nothing where it is missing or no list of `count` finite numbers.
  [[nodiscard]] std::optional<std::vector<double>> numbers(DicomTag tag, std::size_t count) const;
  [[nodiscard]] std::optional<double> number(DicomTag tag) const;
  /// A 16-bit number.
  [[nodiscard]] std::optional<int> unsignedShort(DicomTag tag) const;
  /// The first item of a sequence.
  [[nodiscard]] const DicomItem* first(DicomTag sequence) const;
};

struct DicomFile {
  std::vector<unsigned char> bytes;  ///< the elements point into these
  std::string transferSyntax;
  DicomItem data;
};

/// True if the file begins as DICOM files do, by its first bytes.
[[nodiscard]] bool beginsAsDicom(const std::filesystem::path& file);

/// Reads the elements that Falciform knows, up to and with the pixel data. Throws InputError for files that
/// are damaged, truncated or no DICOM; the message names neither file nor content.
[[nodiscard]] DicomFile readDicomFile(const std::filesystem::path& file);
[[nodiscard]] DicomFile parseDicom(std::vector<unsigned char> bytes);

namespace dicomtag {
constexpr DicomTag kTransferSyntax = 0x00020010, kCharacterSet = 0x00080005, kSopClass = 0x00080016,
                   kInstance = 0x00080018, kStudyDate = 0x00080020, kModality = 0x00080060,
                   kSeriesDescription = 0x0008103E, kPatientName = 0x00100010, kPatientId = 0x00100020,
                   kBirthDate = 0x00100030, kThickness = 0x00180050, kBetweenSlices = 0x00180088,
                   kSeries = 0x0020000E, kAcquisition = 0x00200012, kPosition = 0x00200032,
                   kOrientation = 0x00200037, kTemporalPosition = 0x00200100, kSamples = 0x00280002,
                   kPhotometric = 0x00280004, kFrames = 0x00280008, kRows = 0x00280010, kColumns = 0x00280011,
                   kPixelSpacing = 0x00280030, kBitsAllocated = 0x00280100, kBitsStored = 0x00280101,
                   kHighBit = 0x00280102, kSigned = 0x00280103, kIntercept = 0x00281052, kSlope = 0x00281053,
                   kPlanePosition = 0x00209113, kPlaneOrientation = 0x00209116, kPixelMeasures = 0x00289110,
                   kPixelTransformation = 0x00289145, kSegmentationType = 0x00620001, kSegments = 0x00620002,
                   kSegmentNumber = 0x00620004, kSegmentLabel = 0x00620005,
                   kSegmentIdentification = 0x0062000A, kReferencedSegment = 0x0062000B,
                   kMaximumFraction = 0x0062000E, kSharedGroups = 0x52009229, kFrameGroups = 0x52009230,
                   kPixelData = 0x7FE00010;
}  // namespace dicomtag

}  // namespace falciform

#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace falciform::test {

/// How a file's elements are written.
enum class DicomSyntax { ImplicitLittle, ExplicitLittle, ExplicitBig };

/// A DICOM data set built element by element, independent of the reader under test and of GDCM.
class DicomBytes {
 public:
  explicit DicomBytes(DicomSyntax syntax = DicomSyntax::ExplicitLittle) : syntax_(syntax) {}

  DicomBytes& text(std::uint32_t tag, const char* vr, const std::string& value);
  DicomBytes& shortNumber(std::uint32_t tag, int value);
  /// Items of a sequence: each a data set of the same syntax; of defined length, or with end marks.
  DicomBytes& sequence(std::uint32_t tag, const std::vector<DicomBytes>& items, bool openEnded = false);
  /// Pixel data as it stands.
  DicomBytes& pixels(const std::string& bytes, const char* vr = "OW");
  /// Encapsulated: an offset table and fragments.
  DicomBytes& fragments(const std::vector<std::string>& parts, const std::string& table = {});
  DicomBytes& raw(const std::string& bytes);

  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  [[nodiscard]] DicomSyntax syntax() const { return syntax_; }
  [[nodiscard]] std::string number(std::uint32_t value, int count) const;

 private:
  void header(std::uint32_t tag, const char* vr, std::size_t length);

  DicomSyntax syntax_;
  std::string bytes_;
};

/// Preamble, group 2 and the data set.
[[nodiscard]] std::string dicomFile(const DicomBytes& data, const std::string& transferSyntax = {});

/// What a slice of a small synthetic series is like.
struct SlicePlan {
  DicomSyntax syntax = DicomSyntax::ExplicitLittle;
  std::string transferSyntax = {};  ///< of compressed pixels; empty: that of `syntax`
  std::string series = "1.2.3.4", instance = "1.2.3.4.1", modality = "CT", description = {};
  std::string patient = "MARKER^SURNAME", patientId = "MARKERID77", date = "19830704";
  int columns = 4, rows = 3, bits = 16, stored = 12, highBit = 11, isSigned = 0;
  std::string photometric = "MONOCHROME2";
  std::string position = "0\\0\\0", orientation = "1\\0\\0\\0\\1\\0", spacing = "2\\1.5", thickness = "5";
  std::string slope = "1", intercept = "-1024";
  std::vector<int> values = {};         ///< stored values; empty: 0, 1, 2, ...
  std::vector<std::string> coded = {};  ///< compressed fragments instead of values
  int acquisition = 1;
};
[[nodiscard]] std::string dicomSlice(const SlicePlan& plan);

/// Names that must not be seen outside the reader.
[[nodiscard]] bool tellsIdentity(const std::string& text);

/// "slice_3" and so on in `folder`, from `plan` with position (0, 0, z) and instance changed.
void writeSeries(const std::filesystem::path& folder, SlicePlan plan, const std::vector<double>& z);

/// A binary DICOM SEG with two segments, 'Liver' on slices z = 0, 2, 4 and 'Tumour' on z = 2 and 4, of 8 x 4
/// pixels, bits packed.
[[nodiscard]] std::string dicomSegmentation();

}  // namespace falciform::test

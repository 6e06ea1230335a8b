#include "Testing/Logic/IO/DicomBytes.h"

#include <cstdio>
#include <fstream>

namespace falciform::test {

std::string DicomBytes::number(std::uint32_t value, int count) const {
  std::string bytes;
  for (int b = 0; b < count; ++b) {
    const int shift = 8 * (syntax_ == DicomSyntax::ExplicitBig ? count - 1 - b : b);
    bytes += static_cast<char>(value >> shift & 255);
  }
  return bytes;
}

void DicomBytes::header(std::uint32_t tag, const char* vr, std::size_t length) {
  bytes_ += number(tag >> 16, 2) + number(tag & 0xFFFF, 2);
  const auto size = static_cast<std::uint32_t>(length);
  const std::string type = vr;
  if (syntax_ == DicomSyntax::ImplicitLittle || type.empty()) {
    bytes_ += number(size, 4);
  } else if (type == "OW" || type == "OB" || type == "SQ" || type == "UN") {
    bytes_ += type + number(0, 2) + number(size, 4);
  } else {
    bytes_ += type + number(size, 2);
  }
}

DicomBytes& DicomBytes::text(std::uint32_t tag, const char* vr, const std::string& value) {
  const std::string padded = value.size() % 2 ? value + (std::string(vr) == "UI" ? '\0' : ' ') : value;
  header(tag, vr, padded.size());
  bytes_ += padded;
  return *this;
}

DicomBytes& DicomBytes::shortNumber(std::uint32_t tag, int value) {
  header(tag, "US", 2);
  bytes_ += number(static_cast<std::uint32_t>(value), 2);
  return *this;
}

DicomBytes& DicomBytes::sequence(std::uint32_t tag, const std::vector<DicomBytes>& items, bool openEnded) {
  std::string content;
  for (const DicomBytes& item : items) {
    content += number(0xFFFE, 2) + number(0xE000, 2) +
               number(openEnded ? 0xFFFFFFFF : static_cast<std::uint32_t>(item.bytes().size()), 4) +
               item.bytes();
    if (openEnded) content += number(0xFFFE, 2) + number(0xE00D, 2) + number(0, 4);
  }
  if (openEnded) content += number(0xFFFE, 2) + number(0xE0DD, 2) + number(0, 4);
  header(tag, "SQ", openEnded ? 0xFFFFFFFF : content.size());
  bytes_ += content;
  return *this;
}

DicomBytes& DicomBytes::pixels(const std::string& bytes, const char* vr) {
  header(0x7FE00010, vr, bytes.size());
  bytes_ += bytes;
  return *this;
}

DicomBytes& DicomBytes::fragments(const std::vector<std::string>& parts, const std::string& table) {
  header(0x7FE00010, "OB", 0xFFFFFFFF);
  const auto item = [&](const std::string& part) {
    return number(0xFFFE, 2) + number(0xE000, 2) + number(static_cast<std::uint32_t>(part.size()), 4) + part;
  };
  bytes_ += item(table);
  for (const std::string& part : parts) bytes_ += item(part.size() % 2 ? part + '\0' : part);
  bytes_ += number(0xFFFE, 2) + number(0xE0DD, 2) + number(0, 4);
  return *this;
}

DicomBytes& DicomBytes::raw(const std::string& bytes) {
  bytes_ += bytes;
  return *this;
}

std::string dicomFile(const DicomBytes& data, const std::string& transferSyntax) {
  const char* plain[] = {"1.2.840.10008.1.2", "1.2.840.10008.1.2.1", "1.2.840.10008.1.2.2"};
  DicomBytes group2;
  group2.text(0x00020010, "UI",
              transferSyntax.empty() ? plain[static_cast<int>(data.syntax())] : transferSyntax);
  return std::string(128, '\0') + "DICM" + group2.bytes() + data.bytes();
}

std::string dicomSlice(const SlicePlan& plan) {
  DicomBytes data(plan.syntax);
  data.text(0x00080005, "CS", "ISO_IR 100")
      .text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.2")
      .text(0x00080018, "UI", plan.instance)
      .text(0x00080020, "DA", plan.date)
      .text(0x00080060, "CS", plan.modality);
  if (!plan.description.empty()) data.text(0x0008103E, "LO", plan.description);
  data.text(0x00100010, "PN", plan.patient)
      .text(0x00100020, "LO", plan.patientId)
      .text(0x00100030, "DA", plan.date)
      .text(0x00180050, "DS", plan.thickness)
      .text(0x0020000E, "UI", plan.series)
      .text(0x00200012, "IS", std::to_string(plan.acquisition))
      .text(0x00200032, "DS", plan.position)
      .text(0x00200037, "DS", plan.orientation)
      .shortNumber(0x00280002, 1)
      .text(0x00280004, "CS", plan.photometric)
      .shortNumber(0x00280010, plan.rows)
      .shortNumber(0x00280011, plan.columns)
      .text(0x00280030, "DS", plan.spacing)
      .shortNumber(0x00280100, plan.bits)
      .shortNumber(0x00280101, plan.stored)
      .shortNumber(0x00280102, plan.highBit)
      .shortNumber(0x00280103, plan.isSigned)
      .text(0x00281052, "DS", plan.intercept)
      .text(0x00281053, "DS", plan.slope);
  if (!plan.coded.empty()) {
    data.fragments(plan.coded);
    return dicomFile(data, plan.transferSyntax);
  }
  std::string bytes;
  for (int p = 0; p < plan.rows * plan.columns; ++p)
    bytes += data.number(
        static_cast<std::uint32_t>(plan.values.empty() ? p : plan.values[static_cast<std::size_t>(p)]),
        plan.bits / 8);
  return dicomFile(data.pixels(bytes.size() % 2 ? bytes + '\0' : bytes), plan.transferSyntax);
}

bool tellsIdentity(const std::string& text) {
  for (const char* secret :
       {"MARKER", "SURNAME", "Marker", "Surname", "marker", "surname", "ID77", "19830704", "1983-07"})
    if (text.find(secret) != std::string::npos) return true;
  return false;
}

void writeSeries(const std::filesystem::path& folder, SlicePlan plan, const std::vector<double>& z) {
  std::filesystem::create_directories(folder);
  for (std::size_t s = 0; s < z.size(); ++s) {
    char place[64];
    std::snprintf(place, sizeof place, "0\\0\\%g", z[s]);
    SlicePlan own = plan;
    own.position = place;
    own.instance = plan.instance + "." + std::to_string(s);
    std::ofstream(folder / ("slice_" + std::to_string(s)), std::ios::binary) << dicomSlice(own);
  }
}

std::string dicomSegmentation() {
  const auto frame = [](int segment, const std::string& position) {
    return DicomBytes()
        .sequence(0x00209113, {DicomBytes().text(0x00200032, "DS", position)})
        .sequence(0x0062000A, {DicomBytes().shortNumber(0x0062000B, segment)});
  };
  const auto segment = [](int number, const char* name) {
    return DicomBytes().shortNumber(0x00620004, number).text(0x00620005, "LO", name);
  };
  DicomBytes data;
  data.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.66.4")
      .text(0x00080018, "UI", "1.2.3.9.1")
      .text(0x00080060, "CS", "SEG")
      .text(0x00100010, "PN", "MARKER^SURNAME")
      .text(0x0020000E, "UI", "1.2.3.9")
      .shortNumber(0x00280002, 1)
      .text(0x00280004, "CS", "MONOCHROME2")
      .text(0x00280008, "IS", "5")
      .shortNumber(0x00280010, 4)
      .shortNumber(0x00280011, 8)
      .shortNumber(0x00280100, 1)
      .shortNumber(0x00280101, 1)
      .shortNumber(0x00280102, 0)
      .shortNumber(0x00280103, 0)
      .text(0x00620001, "CS", "BINARY")
      .sequence(0x00620002, {segment(1, "Liver"), segment(2, "Tumour of Marker")})
      .sequence(0x52009229,
                {DicomBytes()
                     .sequence(0x00209116, {DicomBytes().text(0x00200037, "DS", "1\\0\\0\\0\\1\\0")})
                     .sequence(0x00289110, {DicomBytes()
                                                .text(0x00180050, "DS", "5")
                                                .text(0x00180088, "DS", "2")
                                                .text(0x00280030, "DS", "1\\1")})})
      .sequence(0x52009230,
                {frame(1, "10\\20\\4"), frame(1, "10\\20\\0"), frame(1, "10\\20\\2"), frame(2, "10\\20\\2"),
                 frame(2, "10\\20\\4")},
                true);
  // 4 bytes a frame: 8 x 4 bits, least significant first. Liver: columns 0..3 of every row; tumour: column 3.
  std::string bits;
  for (int f = 0; f < 3; ++f) bits += std::string(4, '\x0F');
  for (int f = 0; f < 2; ++f) bits += std::string(4, '\x08');
  return dicomFile(data.pixels(bits, "OB"));
}

}  // namespace falciform::test

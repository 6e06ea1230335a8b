#include "Testing/Logic/IO/PackedSlice.h"

#include <gdcmImage.h>
#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmSequenceOfFragments.h>

#include <stdexcept>

namespace falciform::test {

SlicePlan patternedSlice(int stored) {
  SlicePlan plan;
  plan.columns = 16;
  plan.rows = 12;
  plan.bits = stored > 8 ? 16 : 8;
  plan.stored = stored;
  plan.highBit = stored - 1;
  plan.intercept = "0";
  for (int p = 0; p < 16 * 12; ++p) plan.values.push_back((p * p * 7 + p / 16) % (1 << stored));
  return plan;
}

SlicePlan packedSlice(SlicePlan plan, gdcm::TransferSyntax::TSType syntax) {
  gdcm::ImageChangeTransferSyntax change;
  gdcm::SmartPointer<gdcm::Image> image = new gdcm::Image;
  image->SetNumberOfDimensions(2);
  image->SetDimension(0, static_cast<unsigned>(plan.columns));
  image->SetDimension(1, static_cast<unsigned>(plan.rows));
  image->SetPixelFormat(gdcm::PixelFormat(1, static_cast<unsigned short>(plan.bits),
                                          static_cast<unsigned short>(plan.stored),
                                          static_cast<unsigned short>(plan.highBit), 0));
  image->SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
  image->SetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  std::string bytes;
  for (const int value : plan.values) {
    bytes += static_cast<char>(value & 255);
    if (plan.bits == 16) bytes += static_cast<char>(value >> 8);
  }
  gdcm::DataElement pixels(gdcm::Tag(0x7FE0, 0x0010));
  pixels.SetByteValue(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  image->SetDataElement(pixels);
  change.SetTransferSyntax(syntax);
  change.SetInput(*image);
  if (!change.Change()) throw std::runtime_error("GDCM could not pack the slice");
  const auto* fragments = change.GetOutput().GetDataElement().GetSequenceOfFragments();
  plan.transferSyntax = gdcm::TransferSyntax(syntax).GetString();
  for (gdcm::SequenceOfFragments::SizeType f = 0; f < fragments->GetNumberOfFragments(); ++f) {
    const auto* value = fragments->GetFragment(f).GetByteValue();
    plan.coded.emplace_back(value->GetPointer(), value->GetLength());
  }
  return plan;
}

}  // namespace falciform::test

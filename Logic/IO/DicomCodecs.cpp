#include "Logic/IO/DicomCodecs.h"

#include <fcntl.h>
#include <gdcmDataElement.h>
#include <gdcmFragment.h>
#include <gdcmImage.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmTrace.h>
#include <unistd.h>

#include <mutex>

#include "Logic/Core/Errors.h"

namespace falciform {

namespace {

[[noreturn]] void refuse(const std::string& what) { throw InputError(what + "; export or copy it again"); }

/// GDCM writes to the console unless told not to.
void silenceGdcm() {
  static std::once_flag once;
  std::call_once(once, [] {
    gdcm::Trace::DebugOff();
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
  });
}

/// The JPEG decoder in GDCM prints what it thinks of a damaged stream; nothing else can stop it. Standard
/// error is closed to it while at least one thread decodes.
class QuietDecoder {
 public:
  QuietDecoder() {
    const std::lock_guard lock(mutex());
    if (users()++ > 0) return;
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    kept() = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
    if (nowhere >= 0 && kept() >= 0) dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) close(nowhere);
  }
  ~QuietDecoder() {
    const std::lock_guard lock(mutex());
    if (--users() > 0 || kept() < 0) return;
    dup2(kept(), STDERR_FILENO);
    close(kept());
  }
  QuietDecoder(const QuietDecoder&) = delete;
  QuietDecoder& operator=(const QuietDecoder&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }
  static int& users() {
    static int count = 0;
    return count;
  }
  static int& kept() {
    static int descriptor = -1;
    return descriptor;
  }
};

gdcm::TransferSyntax::TSType gdcmSyntax(const std::string& transferSyntax) {
  return gdcm::TransferSyntax::GetTSType(transferSyntax.c_str());
}

}  // namespace

DicomCoding dicomCoding(const std::string& syntax) {
  // JPEG-LS is left out: CharLS 2.4 runs on for half a minute where a stream is cut
  // (Docs/Decisions/Dicom.md).
  const std::string root = "1.2.840.10008.1.2";
  for (const char* plain : {"", ".1", ".2"})
    if (syntax == root + plain) return DicomCoding::None;
  if (syntax == root + ".5") return DicomCoding::RunLength;
  for (const char* jpeg : {".4.50", ".4.51", ".4.57", ".4.70"})
    if (syntax == root + jpeg) return DicomCoding::Jpeg;
  for (const char* jpeg2000 : {".4.90", ".4.91"})
    if (syntax == root + jpeg2000) return DicomCoding::Jpeg2000;
  throw InputError(
      "its pixels are compressed in a way that is not known; export it uncompressed, or as JPEG lossless, "
      "JPEG 2000 or RLE");
}

DecodedPixels decodeCompressed(DicomBytes stream, DicomCoding coding, const DicomPixelFormat& format) {
  if (coding == DicomCoding::RunLength) return decodeRunLength(stream, format);
  const CodedSize size = codedSize(stream, coding);
  if (size.rows != static_cast<std::uint32_t>(format.rows) ||
      size.columns != static_cast<std::uint32_t>(format.columns) || size.components != 1 || size.bits < 2 ||
      size.bits > 16 || size.bits > format.bitsAllocated)
    refuse("its compressed slices are not of the size that its header gives");
  const bool lossless = format.transferSyntax.ends_with(".57") || format.transferSyntax.ends_with(".70");
  if (coding == DicomCoding::Jpeg && lossless != (size.process == 0xC3))
    refuse("its compressed slices are not of the kind that its header gives");
  silenceGdcm();
  DecodedPixels pixels;
  pixels.bytesPerPixel = size.bits <= 8 ? 1 : 2;
  gdcm::Image image;
  image.SetNumberOfDimensions(2);
  image.SetDimension(0, size.columns);
  image.SetDimension(1, size.rows);
  const auto bits = static_cast<unsigned short>(size.bits);
  image.SetPixelFormat(gdcm::PixelFormat(1, static_cast<unsigned short>(8 * pixels.bytesPerPixel), bits,
                                         static_cast<unsigned short>(bits - 1), format.isSigned ? 1 : 0));
  image.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
  image.SetTransferSyntax(gdcmSyntax(format.transferSyntax));
  gdcm::Fragment fragment;
  fragment.SetByteValue(reinterpret_cast<const char*>(stream.data()),
                        static_cast<std::uint32_t>(stream.size()));
  gdcm::SmartPointer<gdcm::SequenceOfFragments> fragments = gdcm::SequenceOfFragments::New();
  fragments->AddFragment(fragment);
  gdcm::DataElement element(gdcm::Tag(0x7FE0, 0x0010));
  element.SetVR(gdcm::VR::OB);
  element.SetValue(*fragments);
  image.SetDataElement(element);
  const std::size_t expected =
      std::size_t{size.rows} * size.columns * static_cast<std::size_t>(pixels.bytesPerPixel);
  if (image.GetBufferLength() != expected)
    refuse("its compressed slices are not of the size that its header gives");
  pixels.bytes.resize(expected);
  bool decoded = false;
  try {
    const QuietDecoder quiet;
    decoded = image.GetBuffer(reinterpret_cast<char*>(pixels.bytes.data()));
  } catch (const std::exception&) {  // gdcm::Exception names its own source files
  }
  if (!decoded) refuse("its compressed pixel data is damaged");
  return pixels;
}

DecodedPixels decodeRunLength(DicomBytes s, const DicomPixelFormat& format) {
  const auto little = [&](std::size_t at) {
    return static_cast<std::size_t>(s[at]) | static_cast<std::size_t>(s[at + 1]) << 8 |
           static_cast<std::size_t>(s[at + 2]) << 16 | static_cast<std::size_t>(s[at + 3]) << 24;
  };
  const std::size_t pixels = static_cast<std::size_t>(format.rows) * static_cast<std::size_t>(format.columns);
  DecodedPixels out;
  out.bytesPerPixel = format.bitsAllocated / 8;
  const auto planes = static_cast<std::size_t>(out.bytesPerPixel);
  if (s.size() < 64 || planes == 0 || little(0) != planes)
    refuse("its run lengths do not fit its number of bits");
  out.bytes.resize(pixels * planes);
  for (std::size_t plane = 0; plane < planes; ++plane) {
    std::size_t at = little(4 + 4 * plane);
    const std::size_t end = plane + 1 < planes ? little(8 + 4 * plane) : s.size();
    if (at < 64 || end > s.size() || at > end) refuse("its run lengths are damaged");
    // The most significant byte comes first.
    unsigned char* to = out.bytes.data() + (planes - 1 - plane);
    std::size_t done = 0;
    while (done < pixels) {
      if (at + 1 >= end) refuse("its run lengths end too early");
      const std::size_t control = s[at++];
      if (control == 128) continue;
      const bool literal = control < 128;
      const std::size_t count = literal ? control + 1 : 257 - control;
      if (count > pixels - done || (literal && count > end - at)) refuse("its run lengths are damaged");
      for (std::size_t k = 0; k < count; ++k) to[(done + k) * planes] = s[literal ? at + k : at];
      at += literal ? count : 1;
      done += count;
    }
  }
  return out;
}

}  // namespace falciform

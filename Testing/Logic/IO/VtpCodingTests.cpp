#include <gmock/gmock.h>
#include <vtkNew.h>
#include <vtkXMLPolyDataWriter.h>

#include "Logic/IO/SurfaceFiles.h"
#include "Logic/VtkBridge/PolyDataBridge.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/TemporaryFolder.h"

// The ways in which other programs code a VTP file: our own texts and checks must understand each.

namespace falciform {
namespace {

using namespace test;

struct Coding {
  const char* name;
  int mode, header;
  bool base64, zlib, bigEndian;
};

std::string written(const Surface& surface, const Coding& coding) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(toVtk(surface));
  writer->SetDataMode(coding.mode);
  writer->SetHeaderType(coding.header);
  writer->SetEncodeAppendedData(coding.base64);
  if (!coding.zlib) writer->SetCompressorTypeToNone();
  if (coding.bigEndian) writer->SetByteOrderToBigEndian();
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputString();
}

class VtpCodings : public testing::TestWithParam<Coding> {};

TEST_P(VtpCodings, AreReadWithTheirTexts) {
  const TemporaryFolder folder;
  Surface surface = fullSurface();
  surface.frame = "scanner";
  const std::string bytes = written(surface, GetParam());
  put(folder / "s.vtp", bytes);
  const auto [read, warnings] = readSurface(folder / "s.vtp");
  EXPECT_THAT(warnings, testing::IsEmpty());
  EXPECT_LT((read.points - surface.points).cwiseAbs().maxCoeff(), 1e-9);  // mm: the text form has 11 digits
  EXPECT_EQ(read.triangles, surface.triangles);
  EXPECT_EQ(read.patch, surface.patch);
  EXPECT_EQ(read.patchNames, surface.patchNames);
  EXPECT_EQ(read.frame, "scanner");
}

TEST_P(VtpCodings, AnnouncingTooManyPointsIsRefusedWithoutAskingForMemory) {
  const TemporaryFolder folder;
  for (const char* many : {"163", "9999999999", "99999999999999999999999"}) {
    std::string bytes = written(fullSurface(), GetParam());
    const std::string count = "NumberOfPoints=\"162\"";
    const std::size_t at = bytes.find(count);
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at, count.size(), "NumberOfPoints=\"" + std::string(many) + "\"");
    put(folder / "s.vtp", bytes);
    EXPECT_THAT(refusalOf([&] { (void)readSurface(folder / "s.vtp"); }),
                testing::HasSubstr("damaged or truncated"))
        << many;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Ways, VtpCodings,
    testing::Values(Coding{"ascii", vtkXMLWriter::Ascii, vtkXMLWriter::UInt32, true, true, false},
                    Coding{"inlineZlib", vtkXMLWriter::Binary, vtkXMLWriter::UInt32, true, true, false},
                    Coding{"inlinePlain64", vtkXMLWriter::Binary, vtkXMLWriter::UInt64, true, false, false},
                    Coding{"appendedPlain", vtkXMLWriter::Appended, vtkXMLWriter::UInt32, true, false, false},
                    Coding{"appendedZlib64", vtkXMLWriter::Appended, vtkXMLWriter::UInt64, true, true, false},
                    Coding{"rawZlib", vtkXMLWriter::Appended, vtkXMLWriter::UInt32, false, true, false},
                    Coding{"rawPlain", vtkXMLWriter::Appended, vtkXMLWriter::UInt64, false, false, false},
                    Coding{"bigEndian", vtkXMLWriter::Appended, vtkXMLWriter::UInt32, true, true, true}),
    [](const auto& coding) { return coding.param.name; });

}  // namespace
}  // namespace falciform

#include <vtkCellArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyDataReader.h>
#include <vtkPolyDataWriter.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <limits>
#include <map>
#include <stdexcept>

#include "Logic/Core/Errors.h"
#include "Logic/IO/SurfaceFormats.h"
#include "Logic/IO/VtpFieldTexts.h"
#include "Logic/VtkBridge/PolyDataBridge.h"
#include "Logic/VtkBridge/VtkErrors.h"

namespace falciform {

namespace {

/// Runs a VTK reader on bytes in memory, and makes its complaints our error.
template <class Reader>
RawSurface readWith(Reader* reader, const std::string& name,
                    const std::map<std::string, std::vector<std::string>>& texts = {}) {
  std::string problem;
  try {
    problem = vtkErrorsOf([&] { reader->Update(); });
  } catch (const std::bad_alloc&) {
    problem = "it asks for more memory than there is";
  } catch (const std::length_error&) {
    problem = "it asks for more memory than there is";
  }
  if (!problem.empty())
    throw InputError(name + " is damaged or truncated (" + problem + "); copy or export it again");
  RawSurface raw;
  vtkPolyData* data = reader->GetOutput();
  for (const auto& [key, values] : texts) {
    vtkNew<vtkStringArray> array;
    array->SetName(key.c_str());
    for (const std::string& value : values) array->InsertNextValue(value);
    data->GetFieldData()->AddArray(array);
  }
  try {
    raw.surface = fromVtk(data);
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  }
  if (data->GetFieldData()->GetAbstractArray("SPACE")) raw.space = spaceTagIn("SPACE=" + raw.surface.frame);
  return raw;
}

/// Into memory, so that a full disk is told of by our own writer, in plain words and with the file's name.
template <class Writer>
void writeInto(Writer* writer) {
  writer->WriteToOutputStringOn();
  bool done = false;
  const std::string problem = vtkErrorsOf([&] { done = writer->Write() == 1; });
  if (!done || !problem.empty()) throw std::runtime_error("VTK cannot encode the surface: " + problem);
}

}  // namespace

RawSurface readVtp(const std::string& bytes, const std::string& name) {
  // The reader stops at the appended data, and would not miss the end of a file that was cut in them.
  if (bytes.find("<VTKFile") == std::string::npos)
    throw InputError(name + " is no VTP file (it has no <VTKFile>); export it again");
  const std::size_t end = bytes.rfind("</VTKFile>");
  if (end == std::string::npos || bytes.size() - end > 1000)
    throw InputError(name + " is truncated: its closing </VTKFile> is missing; copy or export it again");
  if (bytes.find("type=\"PolyData\"") == std::string::npos)
    throw InputError(
        name + " holds no polygonal surface (type=\"PolyData\"); extract the surface and export it as .vtp");
  VtpFieldTexts file = takeFieldTexts(bytes);
  checkVtp(file.fileWithout, name);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(std::move(file.fileWithout));
  return readWith(reader.Get(), name, file.texts);
}

RawSurface readLegacyVtk(const std::string& bytes, const std::string& name) {
  if (bytes.size() > std::numeric_limits<int>::max())
    throw InputError(name + " is larger than 2 GB; decimate it");
  checkLegacyVtk(bytes, name);
  vtkNew<vtkPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetBinaryInputString(bytes.data(), static_cast<int>(bytes.size()));
  reader->ReadAllScalarsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllFieldsOn();
  reader->ReadAllColorScalarsOn();
  RawSurface raw = readWith(reader.Get(), name);
  const std::size_t title = bytes.find('\n');
  const std::size_t titleEnd = bytes.find('\n', title + 1);
  if (const auto tag = spaceTagIn(std::string_view(bytes).substr(title, titleEnd - title)); tag)
    raw.space = tag;
  return raw;
}

std::string vtpOf(const Surface& surface) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(toVtk(surface));
  writeInto(writer.Get());
  return writer->GetOutputString();
}

std::string legacyVtkOf(const Surface& surface) {
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetInputData(toVtk(surface));
  writer->SetFileVersion(
      vtkPolyDataWriter::VTK_LEGACY_READER_VERSION_4_2);  // 5.1 is not read by many programs
  writer->SetFileTypeToBinary();
  writer->SetHeader(("3D Slicer output. " + spaceTagOf(surface)).substr(0, 255).c_str());
  writeInto(writer.Get());
  return writer->GetOutputStdString();
}

}  // namespace falciform

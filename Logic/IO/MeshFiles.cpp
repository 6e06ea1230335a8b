#include "Logic/IO/MeshFiles.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <new>
#include <optional>
#include <stdexcept>

#include "Logic/Core/Errors.h"
#include "Logic/IO/SpaceAndUnits.h"
#include "Logic/IO/SurfaceFormats.h"
#include "Logic/IO/VtpFieldTexts.h"
#include "Logic/VtkBridge/VtkErrors.h"

namespace falciform {

namespace {

constexpr char kRegion[] = "Region";

void checkExtension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension != ".vtu")
    throw InputError("'" + file.filename().string() + "' is no name of a tetrahedral mesh; give .vtu");
}

void checkText(const std::string& bytes, const std::string& name) {
  if (bytes.empty()) throw InputError(name + " is empty (0 bytes); copy or export it again");
  if (bytes.find("<VTKFile") == std::string::npos)
    throw InputError(name + " is no VTU file (it has no <VTKFile>); export it again");
  // The reader stops at the appended data, and would not miss the end of a file that was cut in them.
  const std::size_t end = bytes.rfind("</VTKFile>");
  if (end == std::string::npos || bytes.size() - end > 1000)
    throw InputError(name + " is truncated: its closing </VTKFile> is missing; copy or export it again");
  if (bytes.find("type=\"UnstructuredGrid\"") == std::string::npos)
    throw InputError(name +
                     " holds no cells of solids (type=\"UnstructuredGrid\"); export a tetrahedral mesh");
  if (bytes.find("Name=\"faces\"") != std::string::npos)
    throw InputError(name + " holds polyhedra; export a mesh of tetrahedra only");
}

/// A damaged file may hold offsets that run backwards or past the ids.
void checkCells(vtkUnstructuredGrid* grid, const std::string& name) {
  const auto refuse = [&](const std::string& found) {
    throw InputError("the cells of " + name + " are damaged (" + found + "); export it again");
  };
  vtkDataArray* offsets = grid->GetCells()->GetOffsetsArray();
  vtkDataArray* ids = grid->GetCells()->GetConnectivityArray();
  double last = 0;
  for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i) {
    const double offset = offsets->GetTuple1(i);
    if (!(offset >= last) || offset > static_cast<double>(ids->GetNumberOfValues()) ||
        (i == 0 && offset != 0))
      refuse("cell " + std::to_string(i) + " ends where it should not");
    last = offset;
  }
  for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
    if (const double id = ids->GetTuple1(i);
        !(id >= 0 && id < static_cast<double>(grid->GetNumberOfPoints())))
      refuse("a cell names point " + std::to_string(static_cast<long long>(id)) + " of " +
             std::to_string(grid->GetNumberOfPoints()));
}

std::vector<vtkIdType> tetrahedraOf(vtkUnstructuredGrid* grid, const std::string& name,
                                    std::vector<std::string>& warnings) {
  std::vector<vtkIdType> linear, quadratic;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
    const int type = grid->GetCellType(c);
    const vtkIdType size = grid->GetCells()->GetCellSize(c);
    if (type == VTK_TETRA && size == 4) linear.push_back(c);
    if (type == VTK_QUADRATIC_TETRA && size == 10) quadratic.push_back(c);
  }
  if (linear.empty() && quadratic.empty())
    throw InputError(name + " holds no tetrahedra of 4 or 10 nodes; export a tetrahedral mesh");
  if (!linear.empty() && !quadratic.empty())
    throw InputError(name + " mixes " + std::to_string(linear.size()) + " tetrahedra of 4 nodes and " +
                     std::to_string(quadratic.size()) + " of 10; export one kind");
  std::vector<vtkIdType>& kept = linear.empty() ? quadratic : linear;
  if (const auto others = grid->GetNumberOfCells() - std::ssize(kept); others > 0)
    warnings.push_back(name + ": " + std::to_string(others) + " cells that are no tetrahedra left out");
  return kept;
}

/// Only points that a tetrahedron uses: others would hang loose in a computation.
void dropUnusedNodes(TetrahedralMesh& mesh, const std::string& name, std::vector<std::string>& warnings) {
  std::vector<int> newId(static_cast<std::size_t>(mesh.nodes()), -1), used;
  for (const int node : mesh.elements.reshaped()) newId[static_cast<std::size_t>(node)] = 0;
  for (std::size_t i = 0; i < newId.size(); ++i)
    if (newId[i] == 0) {
      newId[i] = static_cast<int>(used.size());
      used.push_back(static_cast<int>(i));
    }
  if (std::ssize(used) == mesh.nodes()) return;
  warnings.push_back(name + ": " + std::to_string(mesh.nodes() - std::ssize(used)) +
                     " points that belong to no tetrahedron left out");
  mesh.points = Points(mesh.points(used, Eigen::all));
  for (int& node : mesh.elements.reshaped()) node = newId[static_cast<std::size_t>(node)];
}

void readRegions(vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& cells, const std::string& name,
                 TetrahedralMesh& mesh) {
  vtkDataArray* regions = grid->GetCellData()->GetArray(kRegion);
  if (!regions || regions->GetNumberOfComponents() != 1) return;
  for (const vtkIdType cell : cells) {
    const double region = regions->GetTuple1(cell);
    if (!(region >= 0 && region <= 65535) || region != std::floor(region))
      throw InputError(name + ": cell " + std::to_string(cell) + " has region " + std::to_string(region) +
                       "; regions are whole numbers from 0");
    mesh.regions.push_back(static_cast<int>(region));
  }
}

TetrahedralMesh meshOf(vtkUnstructuredGrid* grid, const std::string& name,
                       std::vector<std::string>& warnings) {
  if (grid->GetNumberOfPoints() == 0 || grid->GetNumberOfCells() == 0)
    throw InputError(name + " holds no cells; export the mesh again");
  if (grid->GetNumberOfPoints() > std::numeric_limits<int>::max())
    throw InputError(name + " holds more than 2^31 points; make a coarser mesh");
  checkCells(grid, name);
  const std::vector<vtkIdType> cells = tetrahedraOf(grid, name, warnings);
  TetrahedralMesh mesh;
  mesh.points.resize(grid->GetNumberOfPoints(), 3);
  for (Index i = 0; i < mesh.nodes(); ++i) grid->GetPoint(i, mesh.points.row(i).data());
  mesh.elements.resize(std::ssize(cells), grid->GetCells()->GetCellSize(cells.front()));
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (Index e = 0; e < mesh.size(); ++e) {
    grid->GetCellPoints(cells[static_cast<std::size_t>(e)], count, ids);
    for (Index k = 0; k < mesh.elements.cols(); ++k) mesh.elements(e, k) = static_cast<int>(ids[k]);
  }
  readRegions(grid, cells, name, mesh);
  dropUnusedNodes(mesh, name, warnings);
  return mesh;
}

void addArray(vtkFieldData* data, const std::string& name, const double* values, Index rows, int components,
              Index needed) {
  if (rows != needed)
    throw InputError("the array " + name + " has " + std::to_string(rows) + " values for a mesh of " +
                     std::to_string(needed) + "; give one each");
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(rows);
  std::copy_n(values, rows * components, array->GetPointer(0));
  data->AddArray(array);
}

}  // namespace

Loaded<TetrahedralMesh> readMesh(const std::filesystem::path& file) {
  checkExtension(file);
  const std::string name = file.filename().string();
  const std::string bytes = readTextFile(file);
  checkText(bytes, name);
  VtpFieldTexts texts = takeFieldTexts(bytes);
  checkVtp(texts.fileWithout, name);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(std::move(texts.fileWithout));
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
  Loaded<TetrahedralMesh> loaded;
  loaded.value = meshOf(reader->GetOutput(), name, loaded.warnings);
  std::optional<std::string> space;
  if (const auto found = texts.texts.find("SPACE"); found != texts.texts.end() && !found->second.empty())
    space = spaceTagIn("SPACE=" + found->second.front());
  if (!loaded.value.points.allFinite())
    throw InputError(name + " has coordinates that are not finite numbers; export it again");
  honourSpace(loaded.value.points, loaded.value.frame, space, name, loaded.warnings);
  checkUnits(loaded.value.points, name, loaded.warnings);
  checkMesh(loaded.value, name);
  return loaded;
}

void writeMesh(const std::filesystem::path& file, const TetrahedralMesh& mesh, Overwrite overwrite,
               const MeshArrays& given) {
  checkExtension(file);
  checkMesh(mesh, "the mesh for '" + file.filename().string() + "'", given.mayBeFolded);
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(mesh.nodes());
  std::copy_n(mesh.points.data(), mesh.points.size(), coordinates->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  grid->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  std::vector<vtkIdType> ids(static_cast<std::size_t>(mesh.elements.cols()));
  for (Index e = 0; e < mesh.size(); ++e) {
    std::copy_n(mesh.elements.row(e).data(), ids.size(), ids.begin());
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  grid->SetCells(mesh.quadratic() ? VTK_QUADRATIC_TETRA : VTK_TETRA, cells);
  vtkNew<vtkIntArray> regions;
  regions->SetName(kRegion);
  for (Index e = 0; e < mesh.size(); ++e) regions->InsertNextValue(mesh.regionOf(e));
  grid->GetCellData()->AddArray(regions);
  for (const auto& [name, values] : given.cells)
    addArray(grid->GetCellData(), name, values.data(), values.rows(), 1, mesh.size());
  for (const auto& [name, values] : given.nodes)
    addArray(grid->GetPointData(), name, values.data(), values.rows(), 3, mesh.nodes());
  vtkNew<vtkStringArray> space;
  space->SetName("SPACE");
  space->InsertNextValue(mesh.frame);
  grid->GetFieldData()->AddArray(space);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  writer->WriteToOutputStringOn();
  bool done = false;
  const std::string problem = vtkErrorsOf([&] { done = writer->Write() == 1; });
  if (!done || !problem.empty()) throw std::runtime_error("VTK cannot encode the mesh: " + problem);
  writeTextFile(file, overwrite, writer->GetOutputString());
}

}  // namespace falciform

#include "Logic/IO/MeshFiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <optional>
#include <random>

#include "Logic/Core/Errors.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform {
namespace {

using test::TemporaryFolder;
using testing::Contains;
using testing::HasSubstr;

/// A cube of five tetrahedra, in one region or two; quadratic ones have their edges' nodes bent a little.
TetrahedralMesh cube(bool quadratic) {
  TetrahedralMesh mesh;
  mesh.points.resize(8, 3);
  for (int i = 0; i < 8; ++i) mesh.points.row(i) << 30 * (i & 1), 30 * (i >> 1 & 1), 30.1 * (i >> 2);
  mesh.elements.resize(5, 4);
  mesh.elements << 0, 1, 2, 4, 3, 2, 1, 7, 5, 4, 7, 1, 6, 7, 4, 2, 1, 2, 4, 7;
  for (Index e = 0; e < 5; ++e)
    if (cornerVolume(mesh, e) < 0) std::swap(mesh.elements(e, 0), mesh.elements(e, 1));
  mesh.regions = {0, 0, 2, 0, 1};
  if (!quadratic) return mesh;
  constexpr int kEdges[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}};
  TetrahedralMesh result = mesh;
  result.elements.resize(5, 10);
  result.points.resize(8 + 30, 3);
  result.points.topRows(8) = mesh.points;
  for (Index e = 0; e < 5; ++e)
    for (int k = 0; k < 10; ++k) {
      if (k < 4) result.elements(e, k) = mesh.elements(e, k);
      if (k < 4) continue;
      const auto node = static_cast<int>(8 + 6 * e + k - 4);
      result.elements(e, k) = node;
      result.points.row(node) = (mesh.points.row(mesh.elements(e, kEdges[k - 4][0])) +
                                 mesh.points.row(mesh.elements(e, kEdges[k - 4][1]))) /
                                    2 +
                                Eigen::RowVector3d(0.1, 0.02, -0.03);
    }
  return result;
}

std::string refusalOf(const std::filesystem::path& file) {
  try {
    (void)readMesh(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MeshFiles, ComeBackAsTheyWere) {
  const TemporaryFolder folder;
  for (const bool quadratic : {false, true}) {
    TetrahedralMesh mesh = cube(quadratic);
    mesh.frame = "tracker 1";
    writeMesh(folder / "mesh.vtu", mesh, Overwrite::Replace);
    const Loaded<TetrahedralMesh> loaded = readMesh(folder / "mesh.vtu");
    EXPECT_TRUE(loaded.value.points == mesh.points);  // to the last bit
    EXPECT_TRUE(loaded.value.elements == mesh.elements);
    EXPECT_EQ(loaded.value.regions, mesh.regions);
    EXPECT_EQ(loaded.value.frame, "tracker 1");
    EXPECT_THAT(loaded.warnings, testing::IsEmpty());
  }
}

TEST(MeshFiles, AreNotReplacedWithoutLeave) {
  const TemporaryFolder folder;
  writeMesh(folder / "mesh.vtu", cube(false), Overwrite::Refuse);
  EXPECT_THROW(writeMesh(folder / "mesh.vtu", cube(false), Overwrite::Refuse), InputError);
  EXPECT_THROW(writeMesh(folder / "mesh.vtk", cube(false), Overwrite::Refuse), InputError);
  TetrahedralMesh inverted = cube(false);
  std::swap(inverted.elements(1, 0), inverted.elements(1, 1));
  EXPECT_THROW(writeMesh(folder / "other.vtu", inverted, Overwrite::Refuse), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "other.vtu"));
}

/// As ParaView writes in ASCII: two tetrahedra, a triangle beside them, a loose point, no space tag.
std::string foreignText(const std::string& space, const std::string& scale = "") {
  const std::string s = scale;
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
         "byte_order=\"LittleEndian\"><UnstructuredGrid>" +
         space +
         "<Piece NumberOfPoints=\"6\" NumberOfCells=\"3\"><Points><DataArray type=\"Float32\" "
         "NumberOfComponents=\"3\" format=\"ascii\">0 0 0 9 0 0 0 9 0 0 0 9" +
         s + " 9 9 9" + s +
         " 77 7 7</DataArray></Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\" "
         "format=\"ascii\">0 1 2 0 1 2 3 1 4 2 3</DataArray><DataArray type=\"Int32\" Name=\"offsets\" "
         "format=\"ascii\">3 7 11</DataArray><DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5 10 "
         "10</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>\n";
}

TEST(MeshFiles, OfOtherProgramsLoseWhatIsNoTetrahedron) {
  const TemporaryFolder folder;
  writeTextFile(folder / "foreign.vtu", Overwrite::Refuse, foreignText(""));
  const Loaded<TetrahedralMesh> loaded = readMesh(folder / "foreign.vtu");
  EXPECT_EQ(loaded.value.size(), 2);
  EXPECT_EQ(loaded.value.nodes(), 5);
  EXPECT_TRUE(loaded.value.regions.empty());
  EXPECT_THAT(loaded.warnings, Contains(HasSubstr("1 cells that are no tetrahedra")));
  EXPECT_THAT(loaded.warnings, Contains(HasSubstr("1 points that belong to no tetrahedron")));
  EXPECT_THAT(loaded.warnings, Contains(HasSubstr("does not say its space")));
}

TEST(MeshFiles, InRasAreTurnedToLps) {
  const TemporaryFolder folder;
  writeTextFile(folder / "ras.vtu", Overwrite::Refuse,
                foreignText("<FieldData><Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" "
                            "format=\"ascii\">82 65 83 0</Array></FieldData>"));
  const Loaded<TetrahedralMesh> loaded = readMesh(folder / "ras.vtu");
  EXPECT_EQ(loaded.value.frame, "LPS");
  EXPECT_EQ(loaded.value.points.col(0).minCoeff(), -9);
  EXPECT_EQ(loaded.value.points.col(2).maxCoeff(), 9);
}

TEST(MeshFiles, ThatAreWrongAreRefusedInOneLine) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusalOf(folder / "none.vtu"), HasSubstr("none.vtu"));
  EXPECT_THAT(refusalOf(folder / "none.vtk"), HasSubstr("give .vtu"));
  const std::string good = foreignText("");
  const auto refused = [&](std::string from, const std::string& to, const std::string& expected) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    writeTextFile(folder / "bad.vtu", Overwrite::Replace, text);
    const std::string refusal = refusalOf(folder / "bad.vtu");
    EXPECT_THAT(refusal, HasSubstr(expected)) << from << " -> " << to;
    EXPECT_THAT(refusal, testing::Not(HasSubstr("\n")));
  };
  refused("1 4 2 3", "1 4 2 8", "names point 8 of 6");
  refused("1 4 2 3", "4 1 2 3", "inverted");
  refused("3 7 11", "3 9 11", "holds no tetrahedra");
  refused("3 7 11", "3 11 7", "");
  refused("5 10 10", "5 12 12", "holds no tetrahedra");
  refused("NumberOfCells=\"3\"", "NumberOfCells=\"3000000000\"", "NumberOfCells");
  refused("9 9 9", "9 9 nan", "");
  refused("9 9 9", "9 9 9e9", "beyond 1e6 mm");
  refused("</VTKFile>", "", "truncated");
  refused("UnstructuredGrid", "PolyData", "");
  writeTextFile(folder / "bad.vtu", Overwrite::Replace, "");
  EXPECT_THAT(refusalOf(folder / "bad.vtu"), HasSubstr("empty"));
}

TEST(MeshFiles, CarryWhatAResultSaysOfElementsAndNodes) {
  const TemporaryFolder folder;
  const TetrahedralMesh mesh = cube(true);
  VectorXd detJ(5);
  detJ << 0.9, 1.25, -0.5, 1, 0.75;
  Points moved = Points::Zero(mesh.nodes(), 3);
  moved.row(3) << 1.5, -2, 4;
  writeMesh(folder / "mesh.vtu", mesh, Overwrite::Refuse,
            {.cells = {{"min_det_j", detJ}}, .nodes = {{"displacement_mm", moved}}});
  EXPECT_EQ(readMesh(folder / "mesh.vtu").value.points, mesh.points);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((folder / "mesh.vtu").c_str());
  reader->Update();
  vtkDataArray* cells = reader->GetOutput()->GetCellData()->GetArray("min_det_j");
  vtkDataArray* nodes = reader->GetOutput()->GetPointData()->GetArray("displacement_mm");
  ASSERT_TRUE(cells != nullptr && nodes != nullptr);
  for (Index e = 0; e < 5; ++e) EXPECT_EQ(cells->GetTuple1(e), detJ[e]);
  EXPECT_EQ(nodes->GetNumberOfComponents(), 3);
  EXPECT_EQ(nodes->GetComponent(3, 2), 4);
  EXPECT_THROW(writeMesh(folder / "other.vtu", mesh, Overwrite::Refuse,
                         {.cells = {{"a", VectorXd::Zero(4)}}, .nodes = {}}),
               InputError);
}

TEST(MeshFiles, AFoldedMeshIsWrittenOnlyWhereItIsAResult) {
  const TemporaryFolder folder;
  TetrahedralMesh mesh = cube(false);
  mesh.points *= -1;  // inside out
  EXPECT_THROW(writeMesh(folder / "mesh.vtu", mesh, Overwrite::Refuse), InputError);
  writeMesh(folder / "mesh.vtu", mesh, Overwrite::Refuse, {.cells = {}, .nodes = {}, .mayBeFolded = true});
  EXPECT_THAT(refusalOf(folder / "mesh.vtu"), HasSubstr("inverted"));
}

TEST(MeshFiles, WithDamagedBytesAreReadOrRefusedButNeverCrash) {
  const TemporaryFolder folder;
  writeMesh(folder / "good.vtu", cube(true), Overwrite::Refuse);
  const std::string good = readTextFile(folder / "good.vtu");
  std::mt19937 random(7);
  for (int trial = 0; trial < 400; ++trial) {
    std::string bytes = good;
    for (int hits = 1 + static_cast<int>(random() % 3); hits > 0; --hits)
      bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
    if (trial % 5 == 0) bytes.resize(random() % bytes.size());
    writeTextFile(folder / "bad.vtu", Overwrite::Replace, bytes);
    std::optional<TetrahedralMesh> read;
    try {
      read = readMesh(folder / "bad.vtu").value;
    } catch (const InputError&) {
      continue;
    }
    EXPECT_NO_THROW(checkMesh(*read, "read")) << trial;
  }
}

}  // namespace
}  // namespace falciform

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "Logic/IO/CaseFolder.h"
#include "Logic/IO/CsvTable.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/MeshFiles.h"
#include "Logic/IO/ResultFiles.h"
#include "Logic/IO/TrackedPointFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Testing/Fuzz/FuzzTarget.h"
#include "Testing/Logic/IO/ResultSamples.h"
#include "Testing/Support/SmallSurfaces.h"
#ifdef FALCIFORM_WITH_UPDATE
#include "Logic/Atlas/AtlasBuilding.h"
#include "Logic/Atlas/AtlasFiles.h"
#include "Testing/Logic/Atlas/SlabLiver.h"
#endif

namespace falciform::test {

void demand(bool sound, const std::string& what) {
  if (!sound) throw std::logic_error(what);
}

namespace {

using Path = const std::filesystem::path&;

std::string contentOf(Path file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Landmarks sampleLandmarks() {
  return {{{"hilum", {1.5, -20, 30}}, {"tip, left", {-4, 5e-3, 600}}, {"dome", {7, 8, 9}}}, "LPS"};
}

TetrahedralMesh sampleMesh() {
  TetrahedralMesh mesh;
  mesh.points.resize(5, 3);
  mesh.points << 0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10, 10, 10, 10;
  mesh.elements.resize(2, 4);
  mesh.elements << 0, 1, 2, 3, 1, 2, 3, 4;
  return mesh;
}

/// `write` makes the good file under the mutant's name.
FuzzTarget written(const std::string& name, const std::string& fileName, std::function<void(Path)> write,
                   std::function<void(Path)> read) {
  return {name, fileName,
          [=](Path folder) {
            const std::filesystem::path good = folder / fileName;
            write(good);
            std::string bytes = contentOf(good);
            std::filesystem::remove(good);
            return bytes;
          },
          std::move(read)};
}

void readSoundTransform(Path file) {
  const Isometry3d read = readTransform(file);
  demand(read.matrix().allFinite(), "a transform that is not finite");
  demand(std::abs(read.linear().determinant() - 1) < 1e-3, "a transform that is not rigid");
}

void readSoundLandmarks(Path file) {
  for (const Landmark& point : readLandmarks(file).value.points)
    demand(point.position.allFinite(), "a landmark that is not finite");
}

void readSoundTracking(Path file) {
  const TrackedPoints tracked = readTrackedPoints(file, Vector3d(0, 0, 120)).value;
  demand(tracked.size() > 0 && tracked.points.allFinite(), "a place that is not finite");
  demand(static_cast<Index>(tracked.stroke.size()) == tracked.size(), "a point without a stroke");
  demand(std::is_sorted(tracked.stroke.begin(), tracked.stroke.end()), "strokes out of order");
  demand(tracked.stroke.back() + 1 == static_cast<int>(tracked.strokes.size()), "a stroke without a name");
}

void readSoundCsv(Path file) {
  const CsvTable table = readCsvTable(file);
  demand(!table.rows.empty(), "a table without a head");
  for (const CsvRow& row : table.rows)
    demand(row.cells.size() == table.rows[0].cells.size(), "a ragged table");
}

}  // namespace

std::vector<FuzzTarget> otherTargets() {
  std::vector<FuzzTarget> targets;
  for (const std::string kind : {"tfm", "txt", "json"})
    targets.push_back(written(
        "transform_" + kind, "t." + kind,
        [](Path f) { writeTransform(f, randomMotion(3), "scan_from_preop", Overwrite::Refuse); },
        readSoundTransform));
  targets.push_back(written(
      "landmarks_mrk_json", "l.mrk.json",
      [](Path f) { writeLandmarks(f, sampleLandmarks(), Overwrite::Refuse); }, readSoundLandmarks));
  targets.push_back(
      {"landmarks_fcsv", "l.fcsv",
       [](Path) {
         return "# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n# columns = "
                "id,x,y,z,ow,ox,"
                "oy,oz,vis,sel,lock,label,desc,associatedNodeID\n1,1.5,-20,30,0,0,0,1,1,1,0,hilum,,\n2,-4,"
                "0.005,600,0,0,0,1,1,1,0,tip,,\n";
       },
       readSoundLandmarks});
  targets.push_back(
      {"table_csv", "t.csv",
       [](Path) { return "name,\"a, b\",c\n\"x \"\"y\"\"\",1.5,2\nz;,3,-4e-3\n# note\nlast,,\n"; },
       readSoundCsv});
  targets.push_back(
      {"tracked_csv", "s.csv",
       [](Path) {
         return "# "
                "space=tracker\ntime_s,q0,qx,qy,qz,Tx,Ty,Tz,State,swab\n0,1,0,0,0,1.5,-20,300,OK,ridge\n0.1,"
                "0.6,0.8,0,0,2,-19,301,OK,ridge\n0.2,,,,,,,,Missing,ridge\n1.5,1,0,0,0,40,5,310,OK,groove\n";
       },
       readSoundTracking});
  targets.push_back(written(
      "registration_json", "r.json",
      [](Path f) { writeJsonFile(f, toJson(sampleRegistration()), Overwrite::Refuse); },
      [](Path f) {
        demand(registrationFromJson(readJsonFile(f)).scanFromPreop.matrix().allFinite(),
               "a pose that is not finite");
      }));
  targets.push_back(
      {"case_json", "case.json",
       [](Path) {
         return R"({"name": "A", "labelMap": "l.nii", "labels": [1, 2], "scan": "s.ply", "structures": {"vein": )"
                R"("v.vtp"}, "preopLandmarks": "p.mrk.json", "settings": {"import": {"edgeLengthMm": 2}}})";
       },
       [](Path f) { (void)readCaseDescription(f); }});
  targets.push_back(written(
      "mesh_vtu", "m.vtu", [](Path f) { writeMesh(f, sampleMesh(), Overwrite::Refuse); },
      [](Path f) {
        const TetrahedralMesh mesh = readMesh(f).value;
        demand(mesh.points.allFinite() && mesh.size() > 0, "a mesh that cannot be");
        demand(mesh.elements.minCoeff() >= 0 && mesh.elements.maxCoeff() < mesh.points.rows(),
               "a node that is not there");
      }));
#ifdef FALCIFORM_WITH_UPDATE
  targets.push_back(written(
      "atlas_h5", "a.h5",
      [](Path f) {
        const SlabLiver slab = slabLiver(true);
        AtlasDesign design;
        design.kind = AtlasKind::Sampled;
        design.sampled = {.members = 6, .setups = 2, .minExtentMm = 12, .maxExtentMm = 25, .maxPushMm = 20};
        writeAtlas(f, buildAtlas(slab.mesh, slab.sites, design), nlohmann::json::object());
      },
      [](Path f) {  // HDF5 opens no files in memory
        const std::filesystem::path onDisk = f.parent_path() / "disk.h5";
        std::filesystem::copy_file(f, onDisk, std::filesystem::copy_options::overwrite_existing);
        (void)readAtlas(onDisk);
      }));
#endif
  return targets;
}

std::vector<FuzzTarget> allTargets() {
  std::vector<FuzzTarget> all;
  for (const auto& part : {surfaceTargets(), scanTargets(), volumeTargets(), dicomTargets(), otherTargets()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace falciform::test

#include "Logic/Atlas/AtlasFiles.h"

#include "Logic/Atlas/AtlasHead.h"
#include "Logic/Atlas/Hdf5Mesh.h"
#include "Logic/Atlas/Hdf5Store.h"
#include "Logic/Atlas/SealedFile.h"
#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

std::uint64_t count(Index n) { return static_cast<std::uint64_t>(n); }

/// One number of each of some things, written or read under one name: the two directions cannot disagree.
template <class Thing>
struct Column {
  const char* name;
  double (*get)(const Thing&);
  void (*set)(Thing&, double);
};

constexpr Column<MemberFigures> kFigures[] = {
    {"members/rms_mm", [](const MemberFigures& f) { return f.rmsMm; },
     [](MemberFigures& f, double v) { f.rmsMm = v; }},
    {"members/max_mm", [](const MemberFigures& f) { return f.maxMm; },
     [](MemberFigures& f, double v) { f.maxMm = v; }},
    {"members/error_mm", [](const MemberFigures& f) { return f.errorMm; },
     [](MemberFigures& f, double v) { f.errorMm = v; }},
    {"members/min_det_j", [](const MemberFigures& f) { return f.minDetJ; },
     [](MemberFigures& f, double v) { f.minDetJ = v; }},
    {"members/folded_share", [](const MemberFigures& f) { return f.foldedShare; },
     [](MemberFigures& f, double v) { f.foldedShare = v; }},
    {"members/strain_energy_n_mm", [](const MemberFigures& f) { return f.energyNMm; },
     [](MemberFigures& f, double v) { f.energyNMm = v; }},
};
constexpr Column<AtlasMember> kPush{"members/push_mm", [](const AtlasMember& m) { return m.pushMm; },
                                    [](AtlasMember& m, double v) { m.pushMm = v; }};
constexpr Column<AtlasSetup> kSetupNumbers[] = {
    {"setups/extent_mm", [](const AtlasSetup& s) { return s.extentMm; },
     [](AtlasSetup& s, double v) { s.extentMm = v; }},
    {"setups/tumour_stiffness_ratio", [](const AtlasSetup& s) { return s.stiffnessRatio; },
     [](AtlasSetup& s, double v) { s.stiffnessRatio = v; }},
};

template <class Thing>
void writeColumn(Hdf5Writer& file, const Column<Thing>& column, const std::vector<Thing>& things) {
  std::vector<double> values;
  for (const Thing& thing : things) values.push_back(column.get(thing));
  file.numbers(column.name, values.data(), {values.size()});
}

template <class Thing>
void readColumn(const Hdf5Reader& file, const Column<Thing>& column, std::vector<Thing>& things) {
  Lengths lengths{things.size()};
  const std::vector<double> values = file.numbers(column.name, lengths);
  for (std::size_t k = 0; k < things.size(); ++k) column.set(things[k], values[k]);
}

/// The same for three numbers each.
template <class Thing>
void writeVectors(Hdf5Writer& file, const char* name, const std::vector<Thing>& things,
                  Vector3d Thing::*part) {
  Points rows(static_cast<Index>(things.size()), 3);
  for (std::size_t k = 0; k < things.size(); ++k)
    rows.row(static_cast<Index>(k)) = (things[k].*part).transpose();
  file.numbers(name, rows.data(), {things.size(), 3});
}

template <class Thing>
void readVectors(const Hdf5Reader& file, const char* name, std::vector<Thing>& things,
                 Vector3d Thing::*part) {
  Lengths lengths{things.size(), 3};
  const std::vector<double> values = file.numbers(name, lengths);
  for (std::size_t k = 0; k < things.size(); ++k)
    things[k].*part = Eigen::Map<const Vector3d>(values.data() + 3 * k);
}

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

void writeMatrix(Hdf5Writer& file, const char* name, const RowMajor& matrix) {
  file.numbers(name, matrix.data(), {count(matrix.rows()), count(matrix.cols())});
}

RowMajor readMatrix(const Hdf5Reader& file, const char* name, Index rows, Index columns) {
  Lengths lengths{count(rows), count(columns)};
  const std::vector<double> values = file.numbers(name, lengths);
  return Eigen::Map<const RowMajor>(values.data(), rows, columns);
}

constexpr std::pair<SupportKind, const char*> kKinds[] = {
    {SupportKind::Fixed, "fixed"}, {SupportKind::Sliding, "sliding"}, {SupportKind::Pushed, "pushed"}};

void writeSetups(Hdf5Writer& file, const std::vector<AtlasSetup>& setups) {
  std::vector<std::string> names, supportNames, kinds;
  std::vector<std::int32_t> setupOf, begin{0}, faces;
  for (std::size_t s = 0; s < setups.size(); ++s) {
    names.push_back(setups[s].name);
    for (const Support& support : setups[s].supports) {
      setupOf.push_back(static_cast<std::int32_t>(s));
      supportNames.push_back(support.name);
      for (const auto& [kind, name] : kKinds)
        if (kind == support.kind) kinds.emplace_back(name);
      faces.insert(faces.end(), support.faces.begin(), support.faces.end());
      begin.push_back(static_cast<std::int32_t>(faces.size()));
    }
  }
  file.texts("setups/name", names);
  for (const auto& column : kSetupNumbers) writeColumn(file, column, setups);
  writeVectors(file, "setups/centre_mm", setups, &AtlasSetup::centreMm);
  file.integers("supports/setup", setupOf, {setupOf.size()});
  file.texts("supports/name", supportNames);
  file.texts("supports/kind", kinds);
  file.integers("supports/faces_begin", begin, {begin.size()});
  file.integers("supports/faces", faces, {faces.size()});
}

SupportKind kindOf(const std::string& text, const std::filesystem::path& path) {
  for (const auto& [kind, name] : kKinds)
    if (text == name) return kind;
  refuseInconsistent(path, "a support of the kind '" + text + "'");
}

std::vector<AtlasSetup> readSetups(const Hdf5Reader& file, const std::filesystem::path& path) {
  Lengths setupCount{Hdf5Reader::kAny, 3}, supports{Hdf5Reader::kAny}, faceCount{Hdf5Reader::kAny};
  (void)file.numbers("setups/centre_mm", setupCount);
  const std::vector<std::int32_t> setupOf = file.integers("supports/setup", supports);
  Lengths beginCount{supports[0] + 1};
  const std::vector<std::int32_t> begin = file.integers("supports/faces_begin", beginCount),
                                  faces = file.integers("supports/faces", faceCount);
  const std::vector<std::string> names = file.texts("setups/name", setupCount[0]),
                                 supportNames = file.texts("supports/name", supports[0]),
                                 kinds = file.texts("supports/kind", supports[0]);
  std::vector<AtlasSetup> setups(setupCount[0]);
  for (std::size_t s = 0; s < setups.size(); ++s) setups[s].name = names[s];
  for (const auto& column : kSetupNumbers) readColumn(file, column, setups);
  readVectors(file, "setups/centre_mm", setups, &AtlasSetup::centreMm);
  for (std::size_t k = 0; k < setupOf.size(); ++k) {
    if (setupOf[k] < 0 || static_cast<std::size_t>(setupOf[k]) >= setups.size() || begin[k] < 0 ||
        begin[k + 1] < begin[k] || static_cast<std::size_t>(begin[k + 1]) > faces.size())
      refuseInconsistent(path, "support " + std::to_string(k) + " points beyond the file's setups or faces");
    AtlasSetup& setup = setups[static_cast<std::size_t>(setupOf[k])];
    Support support;
    support.name = supportNames[k];
    support.kind = kindOf(kinds[k], path);
    support.faces.assign(faces.begin() + begin[k], faces.begin() + begin[k + 1]);
    if (support.kind == SupportKind::Pushed) {
      support.pushMm = 1;
      setup.pushed = static_cast<int>(setup.supports.size());
    }
    setup.supports.push_back(std::move(support));
  }
  return setups;
}

void writeMembers(Hdf5Writer& file, const Atlas& atlas) {
  std::vector<std::int32_t> setups;
  for (const AtlasMember& member : atlas.members) setups.push_back(member.setup);
  file.integers("members/setup", setups, {setups.size()});
  writeColumn(file, kPush, atlas.members);
  writeVectors(file, "members/gravity_m_per_s2", atlas.members, &AtlasMember::gravityMPerS2);
  writeVectors(file, "members/gravity_change_m_per_s2", atlas.members, &AtlasMember::gravityChangeMPerS2);
  for (const auto& column : kFigures) writeColumn(file, column, atlas.figures);
  writeMatrix(file, "members/coefficients_mm", atlas.coefficients);
}

void readMembers(const Hdf5Reader& file, const std::filesystem::path& path, Atlas& atlas) {
  Lengths lengths{Hdf5Reader::kAny};
  const std::vector<std::int32_t> setups = file.integers("members/setup", lengths);
  atlas.members.resize(setups.size());
  atlas.figures.resize(setups.size());
  for (std::size_t m = 0; m < setups.size(); ++m) {
    if (setups[m] < 0 || static_cast<std::size_t>(setups[m]) >= atlas.setups.size())
      refuseInconsistent(path, "member " + std::to_string(m) + " has setup " + std::to_string(setups[m]));
    atlas.members[m].setup = setups[m];
  }
  readColumn(file, kPush, atlas.members);
  readVectors(file, "members/gravity_m_per_s2", atlas.members, &AtlasMember::gravityMPerS2);
  readVectors(file, "members/gravity_change_m_per_s2", atlas.members, &AtlasMember::gravityChangeMPerS2);
  for (const auto& column : kFigures) readColumn(file, column, atlas.figures);
  atlas.coefficients =
      readMatrix(file, "members/coefficients_mm", static_cast<Index>(setups.size()), atlas.rank());
}

void writeModes(Hdf5Writer& file, const Atlas& atlas) {
  std::vector<double> all;
  for (const Points& mode : atlas.modes) all.insert(all.end(), mode.data(), mode.data() + mode.size());
  file.numbers("modes/displacement_mm", all.data(), {atlas.modes.size(), count(atlas.mesh.nodes()), 3});
  writeMatrix(file, "modes/stiffness_n_per_mm", atlas.stiffness);
  file.numbers("modes/singular_values_mm", atlas.singularValuesMm.data(),
               {count(atlas.singularValuesMm.size())});
}

void readModes(const Hdf5Reader& file, Atlas& atlas) {
  const Index nodes = atlas.mesh.nodes();
  Lengths modes{Hdf5Reader::kAny, count(nodes), 3}, values{Hdf5Reader::kAny};
  const std::vector<double> all = file.numbers("modes/displacement_mm", modes);
  for (std::uint64_t k = 0; k < modes[0]; ++k)
    atlas.modes.emplace_back(Eigen::Map<const Points>(all.data() + k * 3 * count(nodes), nodes, 3));
  atlas.stiffness = readMatrix(file, "modes/stiffness_n_per_mm", atlas.rank(), atlas.rank());
  const std::vector<double> singular = file.numbers("modes/singular_values_mm", values);
  atlas.singularValuesMm = Eigen::Map<const VectorXd>(singular.data(), static_cast<Index>(singular.size()));
}

void checkNumbers(const Atlas& atlas, const std::filesystem::path& path) {
  bool finite = atlas.coefficients.allFinite() && atlas.stiffness.allFinite() &&
                atlas.singularValuesMm.allFinite() && atlas.nodeVolumesMm3.allFinite();
  for (const Points& mode : atlas.modes) finite = finite && mode.allFinite();
  if (!finite) refuseInconsistent(path, "it holds numbers that are not finite");
}

}  // namespace

void writeAtlas(const std::filesystem::path& path, const Atlas& atlas, const nlohmann::json& provenance) {
  Hdf5Writer file(path);
  writeAtlasHead(file, atlas.design, provenance);
  file.attribute("energy", atlas.energy);
  file.attribute("independent_solves", atlas.solves);
  writeMeshArrays(file, atlas.mesh);
  file.numbers("mesh/node_volumes_mm3", atlas.nodeVolumesMm3.data(), {count(atlas.nodeVolumesMm3.size())});
  writeModes(file, atlas);
  writeSetups(file, atlas.setups);
  writeMembers(file, atlas);
  file.close();
  sealFile(path, kAtlasFileKind, kAtlasFileVersion);
}

StoredAtlas readAtlas(const std::filesystem::path& path) {
  checkSeal(path, kAtlasFileKind, kAtlasFileVersion);
  const Hdf5Reader file(path);
  AtlasHead head = readAtlasHead(file, path);
  if (head.design.kind == AtlasKind::SurfaceLoads)
    throw InputError("'" + path.string() +
                     "' is an atlas of surface loads, not of deformations; build one of thesis-packing");
  StoredAtlas stored;
  Atlas& atlas = stored.atlas;
  stored.provenance = std::move(head.provenance);
  atlas.design = std::move(head.design);
  atlas.energy = file.numberAttribute("energy");
  atlas.solves = static_cast<int>(file.numberAttribute("independent_solves"));
  atlas.mesh = readMeshArrays(file, path.string());
  Lengths volumes{count(atlas.mesh.nodes())};
  const std::vector<double> shares = file.numbers("mesh/node_volumes_mm3", volumes);
  atlas.nodeVolumesMm3 = Eigen::Map<const VectorXd>(shares.data(), static_cast<Index>(shares.size()));
  readModes(file, atlas);
  atlas.setups = readSetups(file, path);
  readMembers(file, path, atlas);
  checkNumbers(atlas, path);
  return stored;
}

}  // namespace falciform

#include "Testing/Verification/Calculix.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace falciform::verification {
namespace {

/// CalculiX reads 20 characters of a number: 14 digits, sign and exponent.
std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.13e", value);
  return text;
}

std::string label(Index node) { return std::to_string(node + 1); }

/// The rows of a node's constraint with one axis of each made to depend on the others: [A | v] with A reduced
/// by elimination, so that no equation's first term turns up in another.
void writeEquations(std::ostream& out, const NodeConstraint& constraint, Index& extraNode,
                    std::ostream& nodes, std::ostream& values) {
  Eigen::Matrix<double, 3, 4> rows = Eigen::Matrix<double, 3, 4>::Zero();
  rows.leftCols<3>() = constraint.frame;
  rows.col(3) = constraint.valuesMm;
  std::array<Index, 3> pivot{};
  for (Index r = 0; r < constraint.count; ++r) {
    Index column = 0;
    rows.row(r).head<3>().cwiseAbs().maxCoeff(&column);
    pivot[static_cast<std::size_t>(r)] = column;
    rows.row(r) /= rows(r, column);
    for (Index other = 0; other < constraint.count; ++other)
      if (other != r) rows.row(other) -= rows(other, column) * rows.row(r);
  }
  for (Index r = 0; r < constraint.count; ++r) {
    const Index first = pivot[static_cast<std::size_t>(r)];
    std::vector<std::pair<Index, double>> terms{{first, 1.0}};
    for (Index c = 0; c < 3; ++c)
      if (c != first && std::abs(rows(r, c)) > 1e-15) terms.emplace_back(c, rows(r, c));
    if (terms.size() == 1) {
      values << label(constraint.node) << ',' << first + 1 << ',' << first + 1 << ',' << number(rows(r, 3))
             << '\n';
      continue;
    }
    const bool pushed = rows(r, 3) != 0;
    out << "*EQUATION\n" << terms.size() + (pushed ? 1 : 0) << '\n';
    for (const auto& [axis, factor] : terms)
      out << label(constraint.node) << ',' << axis + 1 << ',' << number(factor) << '\n';
    if (!pushed) continue;
    out << label(extraNode) << ",1," << number(-1) << '\n';  // a node that belongs to nothing bears the value
    nodes << label(extraNode) << ",0.,0.,0.\n";
    values << label(extraNode) << ",1,1," << number(rows(r, 3)) << '\n';
    ++extraNode;
  }
}

/// CalculiX numbers a tetrahedron's faces 1-2-3, 1-4-2, 2-4-3, 3-4-1.
int faceLabel(const TetrahedralMesh& mesh, const BoundaryFaces& faces, int face) {
  constexpr std::array<int, 4> kLabelWithoutCorner{3, 4, 2, 1};
  const int element = faces.elements[static_cast<std::size_t>(face)];
  for (int corner = 0; corner < 4; ++corner) {
    bool there = false;
    for (int k = 0; k < 3; ++k) there = there || faces.nodes(face, k) == mesh.elements(element, corner);
    if (!there) return kLabelWithoutCorner[static_cast<std::size_t>(corner)];
  }
  throw std::logic_error("a face has four corners");
}

void writeElements(std::ostream& out, const TetrahedralMesh& mesh, std::size_t materials) {
  for (std::size_t region = 0; region < materials; ++region) {
    out << "*ELEMENT,TYPE=" << (mesh.quadratic() ? "C3D10" : "C3D4") << ",ELSET=E" << region << '\n';
    for (Index e = 0; e < mesh.size(); ++e) {
      if (mesh.regionOf(e) != static_cast<int>(region)) continue;
      out << e + 1;
      for (Index k = 0; k < mesh.elements.cols(); ++k) out << ',' << label(mesh.elements(e, k));
      out << '\n';
    }
  }
}

void writeMaterials(std::ostream& out, const std::vector<Material>& materials, bool neoHookean) {
  for (std::size_t region = 0; region < materials.size(); ++region) {
    const Material& m = materials[region];
    out << "*MATERIAL,NAME=M" << region << '\n';
    if (neoHookean) {
      const double bulk = m.youngsModulusMPa / (3 * (1 - 2 * m.poissonsRatio));
      out << "*HYPERELASTIC,NEO HOOKE\n" << number(shearModulusMPa(m) / 2) << ',' << number(2 / bulk) << '\n';
    } else {
      out << "*ELASTIC\n" << number(m.youngsModulusMPa) << ',' << number(m.poissonsRatio) << '\n';
    }
    out << "*DENSITY\n"
        << number(m.densityKgPerM3 * 1e-12) << "\n*SOLID SECTION,ELSET=E" << region << ",MATERIAL=M" << region
        << '\n';  // t/mm3, so that mm/s2 give N
  }
}

void writeLoads(std::ostream& out, const SharedProblem& problem) {
  const TetrahedralMesh& mesh = problem.body.mesh;
  if (problem.asNodalForces) {
    out << "*CLOAD\n";
    for (Index n = 0; n < mesh.nodes(); ++n)
      for (Index axis = 0; axis < 3; ++axis)
        if (problem.body.forces(n, axis) != 0)
          out << label(n) << ',' << axis + 1 << ',' << number(problem.body.forces(n, axis)) << '\n';
    return;
  }
  if (const double g = problem.gravityMPerS2.norm(); g > 0) {
    const Vector3d down = problem.gravityMPerS2 / g;
    for (std::size_t region = 0; region < problem.body.materials.size(); ++region)
      out << "*DLOAD\nE" << region << ",GRAV," << number(g * 1e3) << ',' << number(down[0]) << ','
          << number(down[1]) << ',' << number(down[2]) << '\n';
  }
  if (problem.pressedFaces.empty()) return;
  const BoundaryFaces faces = boundaryFaces(mesh);
  out << "*DLOAD\n";
  for (const int face : problem.pressedFaces)
    out << faces.elements[static_cast<std::size_t>(face)] + 1 << ",P" << faceLabel(mesh, faces, face) << ','
        << number(problem.pressureMPa) << '\n';
}

/// The states in CalculiX's file of results, each for a share of the load; those that are not whole left out.
std::vector<LoadState> readStates(const std::filesystem::path& file, Index nodes) {
  std::vector<LoadState> states;
  std::ifstream results(file);
  for (std::string line; std::getline(results, line);) {
    if (const std::size_t time = line.find("and time"); time != std::string::npos) {
      states.push_back({.share = std::atof(line.c_str() + time + 8),
                        .displacements = Points::Constant(nodes, 3, std::nan(""))});
      continue;
    }
    std::istringstream words(line);
    Index node = 0;
    Vector3d u;
    if (!states.empty() && words >> node >> u[0] >> u[1] >> u[2] && node >= 1 && node <= nodes)
      states.back().displacements.row(node - 1) = u.transpose();
  }
  std::erase_if(states, [](const LoadState& state) { return !state.displacements.allFinite(); });
  return states;
}

struct Run {
  int status = 0;
  std::vector<LoadState> states;
};
Run run(const SharedProblem& problem, Printed printed, const std::filesystem::path& calculix,
        const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "problem.inp") << calculixInput(problem, printed);
  const std::string command =
      "cd '" + folder.string() + "' && '" + calculix.string() + "' -i problem >problem.log 2>&1";
  const int status = std::system(command.c_str());
  return {status, readStates(folder / "problem.dat", problem.body.mesh.nodes())};
}

[[noreturn]] void throwWithLog(const SharedProblem& problem, const std::filesystem::path& folder) {
  std::ifstream log(folder / "problem.log");
  std::string all((std::istreambuf_iterator<char>(log)), std::istreambuf_iterator<char>());
  throw std::runtime_error("CalculiX gave no displacements for '" + problem.name +
                           "': " + all.substr(all.size() - std::min<std::size_t>(all.size(), 1000)));
}

}  // namespace

std::optional<std::filesystem::path> findCalculix() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(std::filesystem::path(folder) / "ccx", ignored))
      return std::filesystem::path(folder) / "ccx";
  }
  return {};
}

std::string calculixInput(const SharedProblem& problem, Printed printed) {
  const TetrahedralMesh& mesh = problem.body.mesh;
  std::ostringstream out, extraNodes, equations, values;
  Index extraNode = mesh.nodes();
  for (const NodeConstraint& constraint : problem.body.constraints) {
    if (constraint.count < 3) {
      writeEquations(equations, constraint, extraNode, extraNodes, values);
      continue;
    }
    const Vector3d given = constraint.frame.transpose() * constraint.valuesMm;
    for (Index axis = 0; axis < 3; ++axis)
      values << label(constraint.node) << ',' << axis + 1 << ',' << axis + 1 << ',' << number(given[axis])
             << '\n';
  }
  out << "*NODE,NSET=NALL\n";
  for (Index n = 0; n < mesh.nodes(); ++n)
    out << label(n) << ',' << number(mesh.points(n, 0)) << ',' << number(mesh.points(n, 1)) << ','
        << number(mesh.points(n, 2)) << '\n';
  if (extraNode > mesh.nodes()) out << "*NODE\n" << extraNodes.str();
  writeElements(out, mesh, problem.body.materials.size());
  writeMaterials(out, problem.body.materials, problem.neoHookean);
  // Load grows from 0 to all of it: by a fifth to begin with, then by a third at most.
  const bool every = printed == Printed::EveryState;
  out << equations.str()
      << (!problem.neoHookean ? "*STEP\n*STATIC\n"
          : every             ? "*STEP,NLGEOM,INC=60\n*STATIC\n0.2,1.,0.01,0.2\n"
                              : "*STEP,NLGEOM,INC=60\n*STATIC\n0.2,1.,0.01,0.34\n")
      << "*BOUNDARY\n"
      << values.str();
  writeLoads(out, problem);
  out << "*NODE PRINT,NSET=NALL,FREQUENCY=" << (every ? 1 : 1000000) << "\nU\n*END STEP\n";
  return out.str();
}

std::vector<LoadState> loadPathWithCalculix(const SharedProblem& problem,
                                            const std::filesystem::path& calculix,
                                            const std::filesystem::path& folder) {
  std::vector<LoadState> states = run(problem, Printed::EveryState, calculix, folder).states;
  if (states.empty()) throwWithLog(problem, folder);
  return states;
}

Points solveWithCalculix(const SharedProblem& problem, const std::filesystem::path& calculix,
                         const std::filesystem::path& folder) {
  Run done = run(problem, Printed::LastState, calculix, folder);
  // Where it gives up, it may print the state of a part of the load.
  if (done.status != 0 || done.states.empty() || std::abs(done.states.back().share - 1) > 1e-6)
    throwWithLog(problem, folder);
  return std::move(done.states.back().displacements);
}

}  // namespace falciform::verification

#include "Testing/Benchmarks/CalculixDeck.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace falciform::bench {

namespace {

/// ccx reads 20 characters of a number.
std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.12g", value);
  return buffer;
}

}  // namespace

void writeDeck(const std::filesystem::path& file, const TetrahedralMesh& mesh, const Material& material,
               const std::vector<NodeConstraint>& constraints) {
  std::ofstream deck(file);
  deck << "*NODE, NSET=ALL\n";
  for (Index n = 0; n < mesh.nodes(); ++n) {
    deck << n + 1;
    for (int axis = 0; axis < 3; ++axis) deck << "," << text(mesh.points(n, axis));
    deck << "\n";
  }
  deck << "*ELEMENT, TYPE=C3D10, ELSET=LIVER\n";
  for (Index e = 0; e < mesh.size(); ++e) {
    deck << e + 1;
    for (Index k = 0; k < mesh.elements.cols(); ++k) deck << "," << mesh.elements(e, k) + 1;
    deck << "\n";
  }
  deck << "*MATERIAL, NAME=TISSUE\n*ELASTIC\n"
       << text(material.youngsModulusMPa) << "," << text(material.poissonsRatio)
       << "\n*SOLID SECTION, ELSET=LIVER, MATERIAL=TISSUE\n";
  for (const NodeConstraint& c : constraints) {
    if (c.frame.isIdentity()) continue;
    deck << "*NSET, NSET=N" << c.node + 1 << "\n"
         << c.node + 1 << "\n*TRANSFORM, NSET=N" << c.node + 1 << ", TYPE=R\n";
    for (int row = 0; row < 2; ++row)
      for (int axis = 0; axis < 3; ++axis) deck << (row + axis > 0 ? "," : "") << text(c.frame(row, axis));
    deck << "\n";
  }
  deck << "*STEP\n*STATIC\n*BOUNDARY\n";
  for (const NodeConstraint& c : constraints)
    for (int k = 0; k < c.count; ++k)
      deck << c.node + 1 << "," << k + 1 << "," << k + 1 << "," << text(c.valuesMm[k]) << "\n";
  deck << "*NODE PRINT, NSET=ALL, GLOBAL=YES\nU\n*END STEP\n";
  if (!deck.flush()) throw std::runtime_error("cannot write " + file.string());
}

Points readDisplacements(const std::filesystem::path& datFile, Index nodes) {
  std::ifstream stream(datFile);
  Points result = Points::Constant(nodes, 3, std::nan(""));
  std::string line;
  for (Index seen = 0; std::getline(stream, line);) {
    long node = 0;
    double x = 0, y = 0, z = 0;
    if (std::sscanf(line.c_str(), "%ld %lf %lf %lf", &node, &x, &y, &z) != 4 || node < 1 || node > nodes)
      continue;
    result.row(node - 1) << x, y, z;
    ++seen;
  }
  if (!result.allFinite()) throw std::runtime_error("displacements are missing in " + datFile.string());
  return result;
}

}  // namespace falciform::bench

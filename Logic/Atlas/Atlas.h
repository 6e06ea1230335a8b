#pragma once
#include <vector>

#include "Logic/Atlas/AtlasMembers.h"
#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// How one member deforms the liver, before compression.
struct MemberFigures {
  double rmsMm = 0;        ///< displacement over the volume
  double maxMm = 0;        ///< largest displacement of a node
  double errorMm = 0;      ///< RMS of what the kept modes leave of it
  double minDetJ = 1;      ///< smallest local ratio of volumes: below 0 tissue is turned inside out
  double foldedShare = 0;  ///< of the volume, where it is 0 or less
  double energyNMm = 0;    ///< strain energy c' Q'KQ c / 2, of the kept modes
};

/// A patient's liver under many loads: displacements as sums of few modes, u = sum_k coefficients(m, k)
/// modes[k], and what each member was.
struct Atlas {
  AtlasDesign design;
  TetrahedralMesh mesh;
  std::vector<AtlasSetup> setups;      ///< faces by their numbers in boundaryFaces(mesh)
  std::vector<AtlasMember> members;    ///< M
  std::vector<MemberFigures> figures;  ///< M

  VectorXd nodeVolumesMm3;       ///< N: weights of the inner product, see compressFields
  std::vector<Points> modes;     ///< rank x (N x 3), of RMS 1 each, orthogonal over the volume
  Eigen::MatrixXd coefficients;  ///< M x rank, mm
  VectorXd singularValuesMm;     ///< descending, of all that was solved
  Eigen::MatrixXd stiffness;     ///< rank x rank, N/mm: Q'KQ with the design's materials
  double energy = 1;             ///< share of the mean squared displacement that the modes hold
  int solves = 0;                ///< linearly independent problems that were solved

  [[nodiscard]] Index rank() const { return static_cast<Index>(modes.size()); }
};

/// N x 3, mm: member `m` as the modes hold it.
[[nodiscard]] Points memberDisplacements(const Atlas& atlas, Index m);

}  // namespace falciform

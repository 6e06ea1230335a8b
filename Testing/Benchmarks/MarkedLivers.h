#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "Logic/Patches/FeatureModel.h"

namespace falciform::bench {

/// One of the livers of `surfaces/` with the lines that people drew on its edges.
struct AnnotatedLiver {
  std::string name;
  std::string patient;  ///< some livers are one patient's, scanned again
  Surface surface;      ///< LPS
  std::vector<Eigen::Vector2i> ridgeEdges, grooveEdges;
  MarkedLiver marked;
};

/// All of them, in order of their names. Throws InputError where a file is not as its kind should be.
[[nodiscard]] std::vector<AnnotatedLiver> readAnnotatedLivers(const std::filesystem::path& folder);

/// Points about 1 mm apart along edges of a surface.
[[nodiscard]] Points alongEdges(const Points& points, const std::vector<Eigen::Vector2i>& edges);

/// How well one set of places agrees with another.
struct Agreement {
  double precision = 0, recall = 0;  ///< shares within the tolerance
  double meanToTruthMm = 0, meanFromTruthMm = 0;
};
[[nodiscard]] Agreement agreement(const Points& suggested, const Points& truth, double toleranceMm);

}  // namespace falciform::bench

#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "Logic/Acquisition/Phantom.h"
#include "Logic/Registration/PointRegistration.h"
#include "Modules/CommandLine/Outputs.h"

namespace falciform::commandline {

/// The phantom experiment of thesis ch. III up to its trials: the phantom, its gold standard and the surface
/// that trials register to.
struct PhantomExperiment {
  PhantomPlan plan;
  PhantomCase made;
  /// CT surface with patches, LPS mm: the points within 3 mm of the scan's patches, brought there by the gold
  /// standard, as the thesis did to simulate an imprecise segmentation of the image. Of two labels in reach
  /// the nearer wins.
  Surface preop;
  /// Point-based registration of the seven spheres as located: scanFromPreop, FRE.
  PointRegistrationResult gold;
  VectorXd sphereErrorCtMm, sphereErrorScanMm;  ///< located against true, by sphere
  VectorXd beadErrorMm;                         ///< of each true bead, to the nearest found in the CT
  VectorXd goldTargetErrorMm;                   ///< of the gold standard against the truth, by target
  VectorXd predictedTargetErrorMm;              ///< expected from FRE alone, by target
};

[[nodiscard]] PhantomExperiment makePhantomExperiment(const PhantomPlan& plan, const Progress& progress = {});

/// TRE of a pose at the phantom's targets against the truth, by target, mm.
[[nodiscard]] VectorXd phantomTargetErrors(const PhantomCase& made, const Isometry3d& scanFromPreop);

/// The files of an experiment's folder; `falciform run FOLDER` takes it.
[[nodiscard]] std::vector<std::filesystem::path> phantomFiles(const std::filesystem::path& folder,
                                                              const PhantomPlan& plan);
/// Writes them, announced before.
void writePhantom(const PhantomExperiment& experiment, const std::filesystem::path& folder,
                  const Outputs& outputs);

/// Whole scan, sub-region and CT surface with their patches, from the scanner's side. Only in executables
/// declared with falciform_offscreen_executable().
[[nodiscard]] std::vector<std::filesystem::path> phantomPictures(const std::filesystem::path& folder);
void writePhantomPictures(const PhantomExperiment& experiment, const std::filesystem::path& folder,
                          const Outputs& outputs);

/// Counts, FRE, localisation and target errors for the sidecar; units in the keys.
[[nodiscard]] nlohmann::json phantomFigures(const PhantomExperiment& experiment);

}  // namespace falciform::commandline

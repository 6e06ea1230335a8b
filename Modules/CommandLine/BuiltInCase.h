#pragma once
#include <filesystem>
#include <vector>

#include "Logic/Acquisition/SyntheticDeformation.h"
#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Acquisition/VirtualScanner.h"
#include "Modules/CommandLine/Outputs.h"
#include "Modules/CommandLine/PackedLiver.h"

namespace falciform::commandline {

/// How well a surgeon touches the landmarks.
struct TouchSettings {
  double landmarkErrorMm = 3;  ///< standard deviation per axis
  int seed = 1;
};

template <class Visitor>
void describe(TouchSettings& s, Visitor&& field) {
  field(FieldInfo{"landmarkErrorMm", "Landmark error", "mm", 0, 30,
                  "Standard deviation of the scan landmarks, per axis."},
        s.landmarkErrorMm);
  field(FieldInfo{"seed", "Seed", "", 0, 2147483647, "Draws the landmark error."}, s.seed);
}

struct BuiltInCaseSettings {
  SyntheticLiverSettings liver;
  VirtualScannerSettings scanner;
  ScanFaultSettings faults;
  SyntheticDeformationSettings deformation;
  PackingSettings packing;  ///< above 0 mm: instead of the deformation
  TouchSettings touch;
};

struct BuiltInCase {
  std::string name;
  SyntheticLiver liver;  ///< LPS mm, as the CT saw it
  LabelMap labelMap;
  Image ct;                 ///< on its grid, of even tissues, Hounsfield units
  VirtualScan scan;         ///< of the deformed liver, in the scanner's frame
  Surface rawScan;          ///< what the scanner saw of the room with it; empty in an empty room
  Landmarks scanLandmarks;  ///< the anatomical landmarks as touched, scan mm
  Landmarks truthTargets;   ///< liver.targets where they truly are, scan mm
};

/// Liver, label map, and a scan of the deformed liver with known truth. Deterministic by the settings.
[[nodiscard]] BuiltInCase makeBuiltInCase(const BuiltInCaseSettings& settings, const Progress& progress = {});

/// The files of a case folder: case.json, label map, painted surface, scan, landmarks, structures, targets,
/// truth; with a room also the raw scan.
[[nodiscard]] std::vector<std::filesystem::path> builtInCaseFiles(const std::filesystem::path& folder,
                                                                  const ScanFaultSettings& faults);
/// Writes them, announced before, so that `falciform run FOLDER` works.
void writeBuiltInCase(const BuiltInCase& made, const std::filesystem::path& folder, const Outputs& outputs);

}  // namespace falciform::commandline

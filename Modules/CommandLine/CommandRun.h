#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "Logic/Core/Landmarks.h"
#include "Logic/Core/Progress.h"
#include "Logic/Core/Provenance.h"
#include "Logic/Core/Surface.h"
#include "Logic/Core/TetrahedralMesh.h"
#include "Logic/Core/Volume.h"
#include "Logic/IO/DicomSeries.h"
#include "Logic/IO/Loaded.h"
#include "Modules/CommandLine/Outputs.h"

namespace falciform::commandline {

/// A cancelled run that keeps what it has done so far; the message says what and where.
class Interrupted : public Cancelled {
 public:
  explicit Interrupted(std::string what) : what_(std::move(what)) {}
  const char* what() const noexcept override { return what_.c_str(); }

 private:
  std::string what_;
};

/// What a command works with beside its arguments: progress, inputs that are remembered with their digests,
/// warnings that are said once, outputs that appear all or none, and the sidecar that tells of all these.
class CommandRun {
 public:
  Progress progress;
  Outputs outputs;
  Provenance provenance;
  bool quiet = false;
  nlohmann::json settings = nlohmann::json::object();
  nlohmann::json figures = nlohmann::json::object();  ///< units in the keys
  nlohmann::json frames = nlohmann::json::object();   ///< what is in which coordinates, in words

  /// One warning, for the sidecar and, when all is done, for stderr: a run that fails prints its one line and
  /// no more. The same words are not repeated.
  void warn(const std::string& warning);
  void warn(const std::vector<std::string>& warnings);
  /// One line for stdout, unless --quiet.
  void say(const std::string& line) { lines_.push_back(line); }
  /// Prints warnings and lines.
  void print() const;

  // Readers: value, warnings and SHA-256 in one call. Warnings name the file.
  [[nodiscard]] Surface surface(const std::filesystem::path& file);
  /// A pre-operative surface: refused where edges have three or more triangles, since in and out are then
  /// undefined.
  [[nodiscard]] Surface mesh(const std::filesystem::path& file);
  [[nodiscard]] TetrahedralMesh tetrahedra(const std::filesystem::path& file);
  /// Of a DICOM folder with several series `series` chooses one, by number or code.
  [[nodiscard]] LabelMap labelMap(const std::filesystem::path& file, const std::string& series = {});
  [[nodiscard]] NamedLabels namedLabels(const std::filesystem::path& file, const std::string& series = {});
  [[nodiscard]] Image image(const std::filesystem::path& file, const std::string& series = {});
  [[nodiscard]] Landmarks landmarks(const std::filesystem::path& file);
  [[nodiscard]] Isometry3d transform(const std::filesystem::path& file);
  /// Remembers another input file.
  void remember(const std::filesystem::path& file);

  /// Provenance, settings, frames, units and figures as they stand.
  [[nodiscard]] nlohmann::json sidecar() const;
  /// Writes the sidecar as an announced output.
  void writeSidecar(const std::filesystem::path& file);

 private:
  template <class T>
  T keep(Loaded<T> loaded, const std::filesystem::path& file);
  /// The same for a volume, which may be a DICOM folder: neither its name nor its files' names are kept.
  template <class T>
  T keepVolume(Loaded<T> loaded, const std::filesystem::path& file, const std::string& series);
  void warnOf(const std::string& name, const std::vector<std::string>& warnings);

  std::vector<std::string> lines_;
};

/// `liver.vtp` -> `liver.vtp.json`.
[[nodiscard]] std::filesystem::path sidecarOf(const std::filesystem::path& file);

}  // namespace falciform::commandline

#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "Logic/Atlas/UpdatedCase.h"
#include "Logic/Biomechanics/MeshSettings.h"

namespace falciform {

/// The model update on a Case, without a window: what is missing, jobs from snapshots, results accepted. Main
/// thread only; the jobs may run on any.
class ModelUpdateLogic {
 public:
  explicit ModelUpdateLogic(Case& document);

  MeshSettings mesh{.edgeLengthMm = 13};
  UpdateSettings settings;
  std::uint64_t seed = 1;
  UpdateObserver observer;  ///< called on the job's thread

  using Model = std::shared_ptr<const UpdateModel>;
  using Result = std::shared_ptr<const UpdatedCase>;

  /// What is missing before a model can be prepared, one sentence, or empty.
  [[nodiscard]] std::string missingForModel() const;
  /// Meshing and the answers to surface loads; needs no scan.
  [[nodiscard]] std::function<Model(const Progress&)> prepareModel() const;
  /// The same from an atlas file: of surface loads, solved before; or of deformations, whose mesh is taken.
  /// The job throws InputError for a file that is none, or of another liver.
  [[nodiscard]] std::function<Model(const Progress&)> prepareModel(const std::filesystem::path& atlas) const;
  /// Dropped (false) if the liver's shape has changed meanwhile.
  bool acceptModel(Model model);
  /// Of the case's liver, or nullptr: none yet, or its shape has changed.
  [[nodiscard]] const Model& model() const { return model_; }
  /// Whether the mesh settings have changed since it was prepared.
  [[nodiscard]] bool modelOutdated() const;

  /// What is missing before the scan can be followed, one sentence, or empty.
  [[nodiscard]] std::string missingInput() const;
  [[nodiscard]] std::function<Result(const Progress&)> prepare() const;
  /// Dropped (false) if the liver's shape has changed meanwhile. The case keeps it, and a case that is opened
  /// brings its own, whose `model` is nullptr.
  bool accept(Result result);
  [[nodiscard]] const Result& result() const { return result_; }
  /// Why the result no longer rests on the case as it is, one sentence, or empty.
  [[nodiscard]] std::string staleReason() const;

  /// prepareModel where there is none, prepare, run and accept, for scripts and tests. Throws InputError for
  /// what is missing.
  const UpdatedCase& run(const Progress& progress = {});

 private:
  Case& case_;
  Model model_;
  void takeKept();

  Result result_;
  std::shared_ptr<const KeptUpdate> kept_;  ///< of `result_`, as the case has it
  std::string preparedWith_, updatedWith_;  ///< settings as JSON
  mutable std::string preparing_, updating_;
  Connection watching_;
};

}  // namespace falciform

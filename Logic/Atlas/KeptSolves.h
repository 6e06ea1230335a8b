#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "Logic/Atlas/AtlasBuilding.h"

namespace falciform {

/// What the solves of a job rest on: if any of it changes, those that were done no longer count.
/// {"program", "design", "mesh", "supports"}, the last two as checksums.
[[nodiscard]] nlohmann::json basisOf(const AtlasJob& job, const std::string& programVersion);

/// Finished batches of solves in a folder beside the atlas that is being built, so that a build that is
/// stopped can go on and several processes can share one. Files appear whole; any process may look at any
/// time.
class KeptSolves {
 public:
  KeptSolves(std::filesystem::path folder, nlohmann::json basis, const AtlasJob& job);

  /// Looks at what an earlier run left. One with another basis is deleted if `anew`; else throws InputError
  /// that says what differs.
  void open(bool anew);
  /// Whether the batch is there, whole and of this basis.
  [[nodiscard]] bool has(int batch) const;
  [[nodiscard]] int count() const;
  /// Writes a batch. Throws InputError if that cannot be done.
  void keep(int batch, const std::vector<Points>& fields);
  /// Throws InputError if it is not there.
  [[nodiscard]] std::vector<Points> read(int batch) const;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// Deletes the folder with all that is ours in it.
  void remove() const;

  /// Holds the folder for one process at a time, until its end or the process's.
  class Turn {
   public:
    explicit Turn(const KeptSolves& kept);  ///< waits for the others
    ~Turn();
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

   private:
    int descriptor_ = -1;
  };

 private:
  [[nodiscard]] std::filesystem::path fileOf(int batch) const;
  [[nodiscard]] std::filesystem::path basisFile() const { return folder_ / "build.json"; }
  [[nodiscard]] std::filesystem::path lockFile() const { return folder_ / "turn"; }
  void writeBasis() const;

  std::filesystem::path folder_;
  nlohmann::json basis_;
  std::string digest_;  ///< of the basis
  std::vector<AtlasSolves::Batch> batches_;
  Index nodes_;
};

}  // namespace falciform

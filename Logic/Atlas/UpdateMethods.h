#pragma once
#include <array>
#include <memory>
#include <string_view>
#include <variant>

#include "Logic/Atlas/AtlasModel.h"
#include "Logic/Atlas/IncrementalUpdate.h"
#include "Logic/Atlas/ModelUpdate.h"

namespace falciform {

/// Ways to a model update: ours, and those of the literature to measure it against.
enum class UpdateMethod {
  Loads,        ///< ours, "model": pose and surface loads at once (ModelUpdate.h)
  Icat,         ///< the thesis's iterative closest atlas (ClosestAtlas.h)
  IcatStar,     ///< the same with patches
  Incremental,  ///< surface nodes drawn to the scan (Cash et al. 2005; IncrementalUpdate.h)
  Constrained,  ///< members with shares in [0, 1] (Dumpuri et al. 2007)
  Pca,          ///< statistics of the members (Davatzikos et al. 2001)
  Libr,         ///< control points (after Heiselman et al. 2020; ControlPoints.h)
};
inline std::span<const std::string_view> enumNames(UpdateMethod) {
  static constexpr std::array<std::string_view, 7> names{"model",       "icat", "icat-star", "incremental",
                                                         "constrained", "pca",  "libr"};
  return names;
}

/// What is known before the scan is there, beside the surface: the liver's mesh alone, an atlas of
/// deformations, or answers to surface loads.
using UpdateBasis = std::variant<std::shared_ptr<const TetrahedralMesh>, std::shared_ptr<const Atlas>,
                                 std::shared_ptr<const LoadResponses>>;

/// The pre-operative side of one method, made ready. Immutable; cheap to copy.
class PreparedUpdate {
 public:
  /// `preop`: the surface that the basis's mesh fills, same frame. Where the basis is a mesh, what the method
  /// needs is solved for; incremental FEM takes the mesh of any basis. Throws InputError where the method
  /// needs another basis, or the basis belongs to another liver.
  PreparedUpdate(UpdateMethod method, const Surface& preop, const UpdateBasis& basis,
                 const Progress& progress = {});

  [[nodiscard]] UpdateMethod method() const { return method_; }
  [[nodiscard]] const TetrahedralMesh& mesh() const;
  /// What expectedErrorMm asks for; nullptr where the method knows nothing of its errors.
  [[nodiscard]] const UpdateModel* model() const;

 private:
  friend UpdateResult updateByMethod(const PreparedUpdate&, const Surface&, const Isometry3d&,
                                     const UpdateSettings&, std::uint64_t, const Progress&);
  UpdateMethod method_;
  std::shared_ptr<const std::variant<UpdateModel, AtlasModel, IncrementalModel>> model_;
};

/// The one door to all methods: where a scan says the liver is now, from a rigid registration on. Results
/// differ in how they came about, not in what they mean; `covariance` is empty where model() is nullptr.
/// Throws InputError for fewer than 10 usable scan points.
[[nodiscard]] UpdateResult updateByMethod(const PreparedUpdate& prepared, const Surface& scan,
                                          const Isometry3d& scanFromPreopStart,
                                          const UpdateSettings& settings = {}, std::uint64_t seed = 1,
                                          const Progress& progress = {});

[[nodiscard]] const TetrahedralMesh& meshOf(const UpdateBasis& basis);

/// Whether a method fits an atlas of deformations, and nothing else.
[[nodiscard]] bool needsDeformations(UpdateMethod method);

/// Throws InputError where `mesh` does not fill `preop`, in words: the atlas of another liver, or another
/// frame.
void checkSameLiver(const TetrahedralMesh& mesh, const Surface& preop);

}  // namespace falciform

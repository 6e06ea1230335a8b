#pragma once
#include "Logic/Atlas/ModelUpdate.h"

namespace falciform {

/// Nine places in ten err by less than this many times their expected error, on livers that had no part in
/// finding it (Docs/ModelUpdate.md).
inline constexpr double kNineInTen = 2.2;

/// Expected error in mm of where each pre-op place is now (K x 3 in, K out): the posterior's root mean
/// square, and with it what the model itself errs by, which grows with the deformation. Both factors were
/// fitted to held-out livers (`make-truths`), not to those of Docs/ModelUpdate.md's table. Throws InputError
/// for an update without a covariance.
[[nodiscard]] VectorXd expectedErrorMm(const UpdateModel& model, const UpdateResult& update,
                                       const Points& preopMm);

/// Array on surfaces: expectedErrorOnSurface.
inline constexpr char kExpectedError[] = "expected_error_mm";

/// The same at a pre-op surface's points (N x 3 mm in, N out), carried there from the mesh's nodes, of which
/// there are fewer.
[[nodiscard]] VectorXd expectedErrorOnSurface(const UpdateModel& model, const UpdateResult& update,
                                              const Points& surfaceMm);

/// How each place moves with the unknowns that `update.covariance` is about: (loads + 6) x 3 K, columns x, y,
/// z of each place. Its variance is that of where the place is beside the scan.
[[nodiscard]] Eigen::MatrixXd posteriorRows(const UpdateModel& model, const UpdateResult& update,
                                            const Points& preopMm);

/// What the model errs by, mm: what expectedErrorMm adds to the posterior everywhere.
[[nodiscard]] double modelErrorMm(const UpdateResult& update);

/// The posterior's own root mean square in expectedErrorMm for 1 mm^2 of its variance.
inline constexpr double kPosteriorScale = 0.8;

}  // namespace falciform

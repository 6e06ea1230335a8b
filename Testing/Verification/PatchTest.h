#pragma once

namespace falciform::verification {

/// A shaken block whose outer nodes are moved by a linear field: the largest difference to that field inside,
/// by the largest displacement. Every element must be able to carry a constant strain.
[[nodiscard]] double patchTestError(bool quadratic);

}  // namespace falciform::verification

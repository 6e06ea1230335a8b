#pragma once
#include <functional>
#include <string>

namespace falciform {

/// Runs `work` with VTK's error and warning output caught on this thread instead of printed; returns the
/// first error's text, one line, empty if there was none.
[[nodiscard]] std::string vtkErrorsOf(const std::function<void()>& work);

}  // namespace falciform

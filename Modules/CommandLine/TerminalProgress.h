#pragma once
#include <stop_token>

#include "Logic/Core/Progress.h"

namespace falciform::commandline {

enum class ProgressStyle { Silent, Terminal, Slicer };

/// Progress on stderr as one line that is rewritten ("[ 42 %] Smoothing"), or on stdout as
/// `<filter-progress>` lines for 3D Slicer.
[[nodiscard]] Progress makeProgress(ProgressStyle style, std::stop_token stop);

/// Clears the line that Terminal left.
void clearProgressLine(ProgressStyle style);

/// A source whose stop is requested by SIGINT and SIGTERM from now on. Call once, before any thread starts.
[[nodiscard]] std::stop_source stopOnSignals();

}  // namespace falciform::commandline

#pragma once
#include <QObject>

#include "Logic/Core/Case.h"
#include "Logic/Patches/PatchPaintingLogic.h"
#include "Widgets/Jobs/CaseFiles.h"
#include "Widgets/Jobs/JobRunner.h"
#include "Widgets/Jobs/Log.h"
#include "Widgets/Views/ViewState.h"

namespace falciform {

/// What the panels work on, without a widget: the document, the one job that runs, the log, how the case is
/// looked at, and the brush that the painting panel and the 3D view share.
struct Workbench {
  explicit Workbench(JobRunner::Mode mode = JobRunner::Mode::Background) : runner(mode) {}

  Case document;
  Log log;
  ViewState view;
  PatchPaintingLogic painting{document};
  JobRunner runner;  // last: destroyed first, so that no job outlives what it works on
  CaseFiles files{document, runner, log};
};

}  // namespace falciform

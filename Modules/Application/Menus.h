#pragma once
#include <QMainWindow>
#include <functional>

#include "Modules/Workbench.h"

namespace falciform {

class CaseActions;
class CaseView3D;
class RecentCases;

/// The window's menus, each entry one line of what it calls.
struct Menus {
  struct Targets {
    CaseActions& actions;
    RecentCases& recent;
    CaseView3D& view;
    Workbench& bench;
    std::function<void()> openFile = {}, screenshot = {}, close = {};
    std::function<void(int)> step = {};  ///< that many modules on
  };
  static void addTo(QMainWindow& window, const Targets& targets);
};

}  // namespace falciform

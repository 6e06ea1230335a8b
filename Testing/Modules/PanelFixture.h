#pragma once
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QStringList>
#include <QWidget>

#include "Modules/Workbench.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {

/// A bench whose jobs run in place, and what it logged.
struct PanelTest : testing::Test {
  PanelTest() {
    QObject::connect(&bench.log, &Log::added, [this](Log::Level level, const QString& text) {
      logged << text;
      if (level == Log::Level::Error) errors << text;
    });
    QObject::connect(&bench.runner, &JobRunner::failed, [this](const QString& text) { errors << text; });
  }

  /// A painted body, and the same body seen from the scanner's frame by a known motion.
  void openPreopAndScan() {
    bench.document.setPreop(std::make_shared<const Surface>(lumpyBody(3)));
    bench.document.setScan(
        std::make_shared<const Surface>(transformed(*bench.document.preop(), scanFromPreop, "scanner")));
  }

  Workbench bench{JobRunner::Mode::Inline};
  Isometry3d scanFromPreop = randomMotion(7, 60);
  QStringList logged, errors;
};

/// The child with this objectName; the test stops if there is none.
template <class Widget>
Widget& child(QWidget& parent, const char* name) {
  auto* found = parent.findChild<Widget*>(name);
  if (!found) throw std::runtime_error(std::string("no control named ") + name);
  return *found;
}

inline bool isEnabled(QWidget& panel, const char* button) {
  return child<QAbstractButton>(panel, button).isEnabled();
}
inline void click(QWidget& panel, const char* button) { child<QAbstractButton>(panel, button).click(); }
inline std::string words(QWidget& panel, const char* label) {
  return child<QLabel>(panel, label).text().toStdString();
}
/// Not hidden by itself or a parent below the panel; the panel need not be on screen.
inline bool isShown(QWidget& panel, const char* name) {
  return child<QWidget>(panel, name).isVisibleTo(&panel);
}

}  // namespace falciform::test

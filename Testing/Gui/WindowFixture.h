#pragma once
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QStringList>
#include <functional>
#include <memory>
#include <vector>

#include "Modules/Application/MainWindow.h"
#include "Modules/ModulePanel.h"
#include "Modules/Workbench.h"
#include "Widgets/Views/CaseView3D.h"

namespace falciform::test {

/// The real window, used as a person would: by mouse, keyboard, dialogs and drops. Skips where there is no
/// display.
struct WindowTest : testing::Test {
  void SetUp() override;

  /// Handles events until `condition` holds, or fails after `seconds`.
  void waitUntil(const std::function<bool()>& condition, const char* what, double seconds = 60);
  void waitIdle();
  void handleEvents(int ms = 50);

  /// In the panel on screen, or else in the window; of several the one that is not on a hidden page.
  template <class Widget>
  Widget& control(const char* name) {
    Widget* any = nullptr;
    for (QWidget* place :
         {static_cast<QWidget*>(window->currentPanel()), static_cast<QWidget*>(window.get())})
      for (Widget* found : place->findChildren<Widget*>(name)) {
        if (found->isVisible()) return *found;
        if (!any) any = found;
      }
    if (!any) throw std::runtime_error(std::string("no control named ") + name);
    return *any;
  }
  /// Scrolls it into sight and clicks with the mouse; fails if it is disabled.
  void click(const char* button);
  /// Marks the box's text and types a new one.
  void type(const char* spinBox, const QString& text);
  /// Runs `answer` on the next modal dialog of this class.
  void answerNext(const char* dialogClass, std::function<void(QWidget*)> answer);
  /// Answers the next file dialog with `file`.
  void chooseInNextDialog(const QString& file);
  void drop(const QStringList& files);
  void trigger(const char* action);

  /// Presses at the first, moves through the others, releases at the last: positions in the canvas.
  void drag(const std::vector<QPoint>& way, Qt::MouseButton button = Qt::LeftButton);
  void press(int key);
  /// Keeps a picture of the window in the build's artefacts.
  void keepPicture(const QString& name);

  /// Bench and window as new; false on the way out of a test that destroys them itself.
  void openWindow();
  void closeWindow() {
    window.reset();
    bench.reset();
  }

  std::unique_ptr<Workbench> bench;
  std::unique_ptr<MainWindow> window;
  QStringList errors;
};

}  // namespace falciform::test

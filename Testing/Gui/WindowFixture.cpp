#include "Testing/Gui/WindowFixture.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLineEdit>
#include <QMimeData>
#include <QScrollArea>
#include <QTimer>
#include <QUrl>
#include <QtTest/QTest>

namespace falciform::test {

void WindowTest::SetUp() {
  if (qEnvironmentVariableIsEmpty("DISPLAY"))
    GTEST_SKIP() << "the window needs an X server with OpenGL: install xvfb and xauth, or set DISPLAY";
  openWindow();
}

void WindowTest::openWindow() {
  closeWindow();
  bench = std::make_unique<Workbench>();
  QObject::connect(&bench->log, &Log::added, [this](Log::Level level, const QString& text) {
    if (level == Log::Level::Error) errors << text;
  });
  window = std::make_unique<MainWindow>(*bench);
  window->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  handleEvents();
}

void WindowTest::handleEvents(int ms) { QTest::qWait(ms); }

void WindowTest::waitUntil(const std::function<bool()>& condition, const char* what, double seconds) {
  QElapsedTimer time;
  time.start();
  while (!condition()) {
    ASSERT_LT(time.elapsed(), seconds * 1000) << "waited in vain for: " << what;
    QTest::qWait(5);
  }
}

void WindowTest::waitIdle() {
  handleEvents();
  waitUntil([&] { return !bench->runner.busy(); }, "the job's end", 300);
  handleEvents();  // what was queued at its end may start the next job
  waitUntil([&] { return !bench->runner.busy(); }, "the next job's end", 300);
  handleEvents();
}

void WindowTest::click(const char* name) {
  auto& button = control<QAbstractButton>(name);
  for (QWidget* parent = button.parentWidget(); parent; parent = parent->parentWidget())
    if (auto* scroll = qobject_cast<QScrollArea*>(parent)) scroll->ensureWidgetVisible(&button);
  handleEvents(10);
  ASSERT_TRUE(button.isVisible()) << name << " is not on screen";
  ASSERT_TRUE(button.isEnabled()) << name << " is disabled";
  QTest::mouseClick(&button, Qt::LeftButton, {},
                    QPoint(std::min(12, button.width() / 2), button.height() / 2));
  if (window) handleEvents(10);
}

void WindowTest::type(const char* spinBox, const QString& text) {
  auto& box = control<QAbstractSpinBox>(spinBox);
  box.setFocus();
  box.selectAll();
  QTest::keyClicks(&box, text);
  QTest::keyClick(&box, Qt::Key_Return);
}

void WindowTest::answerNext(const char* dialogClass, std::function<void(QWidget*)> answer) {
  auto* timer = new QTimer(window.get());
  timer->setInterval(20);
  QObject::connect(timer, &QTimer::timeout, timer, [timer, dialogClass, answer = std::move(answer)] {
    QWidget* dialog = QApplication::activeModalWidget();
    if (!dialog || !dialog->inherits(dialogClass)) return;
    timer->stop();
    timer->deleteLater();
    answer(dialog);
  });
  timer->start();
}

void WindowTest::chooseInNextDialog(const QString& file) {
  answerNext("QFileDialog", [file](QWidget* dialog) {
    auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
    name->setText(file);
    QMetaObject::invokeMethod(dialog, "accept");
  });
}

void WindowTest::drop(const QStringList& files) {
  QMimeData data;
  QList<QUrl> urls;
  for (const QString& file : files) urls << QUrl::fromLocalFile(file);
  data.setUrls(urls);
  const QPoint at = window->rect().center();
  QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window.get(), &enter);
  ASSERT_TRUE(enter.isAccepted()) << "files may be dropped on the window";
  QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window.get(), &event);
}

void WindowTest::trigger(const char* action) {
  auto* found = window->findChild<QAction*>(action);
  ASSERT_TRUE(found) << action;
  found->trigger();
}

void WindowTest::drag(const std::vector<QPoint>& way, Qt::MouseButton button) {
  QWidget* canvas = window->view()->canvas();
  QTest::mouseMove(canvas, way.front());
  QTest::mousePress(canvas, button, {}, way.front());
  for (const QPoint& at : way) {
    // QTest::mouseMove has no buttons; a drag is a move with one held.
    QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, button, Qt::NoModifier);
    QApplication::sendEvent(canvas, &move);
  }
  QTest::mouseRelease(canvas, button, {}, way.back());
  handleEvents();
}

void WindowTest::press(int key) {
  window->view()->canvas()->setFocus();
  QTest::keyClick(window->view()->canvas(), static_cast<Qt::Key>(key));
  handleEvents();
}

void WindowTest::keepPicture(const QString& name) {
  const QString folder = qEnvironmentVariable("FALCIFORM_ARTEFACTS");
  if (folder.isEmpty()) return;
  handleEvents(200);
  EXPECT_TRUE(window->grab().save(folder + "/" + name + ".png")) << folder.toStdString();
}

}  // namespace falciform::test

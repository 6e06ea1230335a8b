#include <QAbstractButton>
#include <QApplication>
#include <QSettings>
#include <QtTest/QTest>
#include <cstdio>

#include "Modules/Application/Appearance.h"
#include "Modules/Application/MainWindow.h"
#include "Modules/ModuleList.h"
#include "Modules/ModulePanel.h"
#include "Modules/Workbench.h"
#include "Testing/Support/TemporaryFolder.h"
#include "Widgets/Views/CaseView3D.h"

namespace {

using namespace falciform;

void waitIdle(Workbench& bench) {
  do QTest::qWait(300);
  while (bench.runner.busy());
  QTest::qWait(300);
}

void press(MainWindow& window, const char* button) {
  auto* found = window.currentPanel()->findChild<QAbstractButton*>(button);
  if (found && found->isEnabled()) found->click();
}

}  // namespace

/// Walks a case through the modules and saves a picture of the window at each: for eyes, and for the user
/// guide.
///   WindowPictures FOLDER [CASE or FILE...]
int main(int argc, char** argv) {
  const test::TemporaryFolder settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                     QString::fromStdString(settings.path().string()));
  CaseView3D::prepareApplication();
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication application(argc, argv);
  dressApplication(application);
  if (argc < 2) {
    std::fprintf(stderr, "usage: WindowPictures FOLDER [CASE or FILE...]\n");
    return 2;
  }
  const QString folder = argv[1];
  Workbench bench;
  QObject::connect(&bench.log, &Log::added,
                   [](Log::Level, const QString& text) { std::puts(qPrintable(text)); });
  MainWindow window(bench);
  window.show();
  QTest::qWait(500);
  const auto save = [&](const QString& name) {
    QTest::qWait(500);
    window.grab().save(folder + "/" + name + ".png");
  };
  save("0_empty");
  window.open(QApplication::arguments().mid(2));
  waitIdle(bench);
  for (const Module& module : moduleList()) {
    window.showModule(module.key);
    QTest::qWait(300);
    const QString name = module.key;
    if (name == "SegmentationImport" && bench.document.labels()) {
      press(window, "import");
      waitIdle(bench);
    }
    if (name == "PatchPainting") {
      save(name + "_liver");
      press(window, "paintOnScan");
    }
    if (name == "Registration") {
      save(name + "_before");
      press(window, "register");
      QTest::qWait(3000);
      if (bench.runner.busy()) save(name + "_running");
      waitIdle(bench);
    }
    if (name == "DeformationAnalysis") {
      press(window, "compute");
      waitIdle(bench);
    }
    save(name);
    if (name == "DeformationAnalysis") {
      press(window, "distanceOnScan");
      save(name + "_scan");
    }
  }
  return 0;
}

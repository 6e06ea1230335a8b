#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>

#include "Modules/Application/Appearance.h"
#include "Testing/Gui/EventWatch.h"
#include "Testing/Support/TemporaryFolder.h"
#include "Widgets/Views/CaseView3D.h"

/// The real window on an X server (xvfb-run gives one); without a display every test skips.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  if (qEnvironmentVariableIsEmpty("DISPLAY")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const falciform::test::TemporaryFolder settings;
  qputenv("XDG_DATA_HOME", QByteArray::fromStdString(settings.path().string()));
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                     QString::fromStdString(settings.path().string()));
  falciform::CaseView3D::prepareApplication();
  falciform::test::WatchedApplication application(argc, argv);
  falciform::dressApplication(application);
  QCoreApplication::setOrganizationName("FalciformTests");
  application.setQuitOnLastWindowClosed(false);
  return RUN_ALL_TESTS();
}

#include <gtest/gtest.h>

#include <QApplication>
#include <QLocale>
#include <QSettings>

#include "Testing/Support/TemporaryFolder.h"

/// Widgets without a display: Qt's offscreen platform, and settings of their own.
int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  testing::InitGoogleTest(&argc, argv);
  const falciform::test::TemporaryFolder settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                     QString::fromStdString(settings.path().string()));
  QCoreApplication::setOrganizationName("FalciformTests");
  QLocale::setDefault(QLocale::c());
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}

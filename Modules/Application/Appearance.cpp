#include "Modules/Application/Appearance.h"

#include <QApplication>
#include <QFontDatabase>
#include <QIcon>
#include <QLocale>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>

#include "Version.h"

/// A static library's resources are taken in only when asked for, and from outside any namespace.
static void takeInResources() { Q_INIT_RESOURCE(Resources); }

namespace falciform {

void dressApplication(QApplication& application) {
  takeInResources();
  QCoreApplication::setOrganizationName("Falciform");
  QCoreApplication::setApplicationName("Falciform");
  QCoreApplication::setApplicationVersion(kVersion);
  QLocale::setDefault(QLocale::c());  // "1.5 mm" everywhere, as in the files
  application.setStyle(QStyleFactory::create("Fusion"));
  // Digits of one width and Latin, Greek and signs in one face, whatever the desktop's default.
  if (QFontDatabase().families().contains("DejaVu Sans")) {
    QFont font("DejaVu Sans");
    font.setPointSizeF(9);
    application.setFont(font);
  }
  QPalette palette = application.style()->standardPalette();
  palette.setColor(QPalette::Highlight, QColor("#0072b2"));
  application.setPalette(palette);
  application.setWindowIcon(QIcon(":/icons/falciform.png"));
}

}  // namespace falciform

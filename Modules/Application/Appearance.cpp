#include "Modules/Application/Appearance.h"

#include <QApplication>
#include <QFontDatabase>
#include <QIcon>
#include <QLocale>
#include <QPalette>
#include <QSettings>
#include <QStyle>
#include <QStyleFactory>

#include "Version.h"

/// A static library's resources are taken in only when asked for, and from outside any namespace.
static void takeInResources() { Q_INIT_RESOURCE(Resources); }

namespace falciform {
namespace {

constexpr char kThemeKey[] = "darkTheme";
const QColor kHighlight("#0072b2");

/// Grey, not black: easy in a dim room, with text at a contrast of 10 to 1 and more.
QPalette darkPalette() {
  QPalette palette;
  const QColor window(45, 47, 51), base(32, 34, 37), button(58, 61, 66), text(228, 230, 233),
      faint(140, 144, 150);
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::WindowText, text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, window);
  palette.setColor(QPalette::ToolTipBase, button);
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::Text, text);
  palette.setColor(QPalette::PlaceholderText, faint);
  palette.setColor(QPalette::Button, button);
  palette.setColor(QPalette::ButtonText, text);
  palette.setColor(QPalette::BrightText, Qt::white);
  palette.setColor(QPalette::Link, QColor("#56b4e9"));
  palette.setColor(QPalette::Light, button.lighter(130));
  palette.setColor(QPalette::Midlight, button.lighter(115));
  palette.setColor(QPalette::Mid, window.darker(130));
  palette.setColor(QPalette::Dark, window.darker(160));
  palette.setColor(QPalette::Shadow, Qt::black);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, faint);
  return palette;
}

void applyTheme(bool dark) {
  QPalette palette = dark ? darkPalette() : QApplication::style()->standardPalette();
  palette.setColor(QPalette::Highlight, kHighlight);
  QApplication::setPalette(palette);
}

}  // namespace

bool darkTheme() { return QSettings().value(kThemeKey, false).toBool(); }

void setDarkTheme(bool dark) {
  QSettings().setValue(kThemeKey, dark);
  applyTheme(dark);
}

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
  applyTheme(darkTheme());
  application.setWindowIcon(QIcon(":/icons/falciform.png"));
}

}  // namespace falciform

#pragma once

class QApplication;

namespace falciform {

/// Names, number format, style, font and colours of the application, in the theme that the user chose last.
void dressApplication(QApplication& application);

/// Light or dark, from now on and at the next start.
[[nodiscard]] bool darkTheme();
void setDarkTheme(bool dark);

}  // namespace falciform

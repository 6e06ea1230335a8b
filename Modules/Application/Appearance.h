#pragma once

class QApplication;

namespace falciform {

/// Names, number format, style, font and colours of the application.
void dressApplication(QApplication& application);

}  // namespace falciform

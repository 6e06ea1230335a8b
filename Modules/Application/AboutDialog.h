#pragma once

class QWidget;

namespace falciform {

/// Version, purpose, notice, and the licences of what the program is built from.
void showAbout(QWidget* parent);

}  // namespace falciform

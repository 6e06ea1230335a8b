#pragma once
#include <QString>

class QLabel;
class QToolButton;
class QWidget;

namespace falciform {

/// A label that wraps, whose text can be selected; `name` is its objectName.
[[nodiscard]] QLabel* wrappedLabel(const QString& name, QWidget* parent);

/// A button as wide as its row allows, reached by Tab, that shows plainly, also in the dark theme, when it is
/// pressed.
[[nodiscard]] QToolButton* wideToolButton(const QString& name, const QString& text, const QString& tip,
                                          QWidget* parent);

}  // namespace falciform

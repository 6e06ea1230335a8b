#pragma once
#include <QWidget>
#include <functional>
#include <optional>

#include "Widgets/Rendering/CameraViews.h"

class QToolButton;

namespace falciform {

/// The row of buttons above a 3D view: the standard views, and one that fits all (which calls `turn` with
/// none).
class StandardViewBar : public QWidget {
  Q_OBJECT

 public:
  StandardViewBar(std::function<void(std::optional<StandardView>)> turn, QWidget* parent);

  /// A button at the right end.
  QToolButton* addAtEnd(const QString& name, const QString& label, const QString& tip);

 private:
  QToolButton* add(const QString& name, const QString& label, const QString& tip);
};

}  // namespace falciform

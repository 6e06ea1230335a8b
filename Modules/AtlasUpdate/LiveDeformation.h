#pragma once
#include <QObject>

#include "Logic/Biomechanics/SupportLogic.h"
#include "Widgets/Jobs/LatestRunner.h"
#include "Widgets/Views/ViewState.h"

namespace falciform {

/// Keeps the liver in the view where the case's supports put it: every change is computed away from the
/// window, the newest wins, and what was computed for older ones is used again where it still holds.
class LiveDeformation : public QObject {
  Q_OBJECT

 public:
  LiveDeformation(const SupportLogic& logic, ViewState& view, JobRunner::Mode mode,
                  QObject* parent = nullptr);

  /// Computes anew and shows it; without a model shows the liver at rest.
  void update();
  /// The liver at rest, and nothing computed that is still under way is shown.
  void hide();
  /// What is shown; its response is nullptr where nothing is.
  [[nodiscard]] const SupportLogic::Answer* shown() const { return shown_.get(); }
  /// What must be done before anything can be shown, in words, or empty.
  [[nodiscard]] const QString& missing() const { return missing_; }

 Q_SIGNALS:
  void changed();

 private:
  void take(SupportLogic::Answer answer);
  void showAtRest(const QString& missing);

  const SupportLogic& logic_;
  ViewState& view_;
  LatestRunner runner_;
  std::shared_ptr<const SupportLogic::Answer> known_, shown_;
  QString missing_;
};

}  // namespace falciform

#pragma once
#include <QString>

#include "Widgets/Views/ViewState.h"

namespace falciform {

/// The pose that is on screen without being stored, and for what reason: one at a time.
class PosePreview {
 public:
  enum class Reason { None, Running, Replay, Basin, Hand };

  explicit PosePreview(ViewState& view) : view_(view) {}

  [[nodiscard]] Reason reason() const { return reason_; }

  void show(Reason reason, const Isometry3d& preopFromScan, const QString& caption) {
    reason_ = reason;
    view_.edit([&](ViewOptions& options) {
      options.livePreopFromScan = preopFromScan.matrix();
      options.liveCaption = caption.toStdString();
      options.moving = reason == Reason::Hand;
    });
  }
  void end() {
    reason_ = Reason::None;
    view_.edit([](ViewOptions& options) {
      options.livePreopFromScan.reset();
      options.liveCaption.clear();
      options.moving = false;
    });
  }
  void endIf(Reason reason) {
    if (reason_ == reason) end();
  }

 private:
  ViewState& view_;
  Reason reason_ = Reason::None;
};

}  // namespace falciform

#pragma once
#include <QWidget>
#include <optional>

#include "Logic/Core/Landmarks.h"
#include "Logic/Registration/PointRegistration.h"

class QCheckBox;
class QLabel;
class QTableWidget;

namespace falciform {

/// Whether to start from landmarks, and how well they fit each other: worst first.
class LandmarkStart : public QWidget {
  Q_OBJECT

 public:
  explicit LandmarkStart(QWidget* parent = nullptr);

  /// `fit` of preop onto scan; without one `missing` says why.
  void show(const Landmarks& preop, const std::optional<PointRegistrationResult>& fit,
            const std::string& missing);

 Q_SIGNALS:
  void toggled(bool wanted);

 private:
  QCheckBox* wanted_;
  QLabel* words_;
  QTableWidget* table_;
};

}  // namespace falciform

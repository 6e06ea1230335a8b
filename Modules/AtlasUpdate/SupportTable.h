#pragma once
#include <QTableWidget>
#include <map>

#include "Logic/Core/SupportPainting.h"

class QComboBox;

namespace falciform {

class SliderBox;

/// The supports of a painting, a row each: name, kind, and how far a pushed one is pushed. The chosen row is
/// what the brush paints. Announces edits as a whole new painting.
class SupportTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit SupportTable(QWidget* parent = nullptr);

  /// nullptr empties it. Rows are made anew only where regions or kinds are others.
  void show(const std::shared_ptr<const SupportPainting>& painting);
  void choose(int label);
  /// 0 without a row.
  [[nodiscard]] int chosen() const;

 Q_SIGNALS:
  void edited(const SupportPainting& painting);
  void choiceMade(int label);

 private:
  void addRow(int label, const SupportRegion& region);
  void edit(int label, const std::function<void(SupportRegion&)>& change);

  std::shared_ptr<const SupportPainting> painting_;
  std::map<int, SupportRegion> rows_;  ///< what stands there, distances aside
  std::map<int, SliderBox*> sliders_;
};

}  // namespace falciform

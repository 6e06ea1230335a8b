#pragma once
#include <QTableWidget>
#include <map>

#include "Logic/Core/SupportPainting.h"

namespace falciform {

/// The supports of a painting, a row each: name, kind, and how far a pushed one is pushed. The chosen row is
/// what the brush paints and the slider pushes.
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
  void kindChosen(int label, SupportRegionKind kind);
  void choiceMade(int label);

 private:
  void addRow(int label, const SupportRegion& region);

  std::shared_ptr<const SupportPainting> painting_;
  std::map<int, SupportRegion> rows_;  ///< what stands there, distances aside
};

}  // namespace falciform

#pragma once
#include <QTableWidget>

#include "Logic/Segmentation/SurfaceImport.h"

namespace falciform {

/// What an imported surface is worth: closed, genus, pieces, volumes, edges, crossings, distance to the mask.
class QualityTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit QualityTable(QWidget* parent = nullptr);

  void setResult(const SurfaceImportResult& result);
  /// Empties and hides it.
  void clearResult();

 private:
  void addRow(const QString& what, const QString& value, bool good = true);
};

}  // namespace falciform

#include "Widgets/Forms/TableHeight.h"

#include <QHeaderView>
#include <QTableWidget>

namespace falciform {

void showAllRows(QTableWidget* table) {
  table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  int height = table->horizontalHeader()->sizeHint().height() + 2 * table->frameWidth();
  for (int row = 0; row < table->rowCount(); ++row) height += table->rowHeight(row);
  table->setFixedHeight(height +
                        (table->rowCount() == 0 ? table->verticalHeader()->defaultSectionSize() : 0));
}

}  // namespace falciform

#pragma once

class QTableWidget;

namespace falciform {

/// Makes the table as high as its rows, so that it is read by scrolling the panel and not within itself.
void showAllRows(QTableWidget* table);

}  // namespace falciform

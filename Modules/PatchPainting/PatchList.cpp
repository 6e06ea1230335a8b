#include "Modules/PatchPainting/PatchList.h"

#include <QColorDialog>
#include <QHeaderView>
#include <set>

#include "Logic/Patches/PatchStatistics.h"
#include "Widgets/Forms/TableHeight.h"

namespace falciform {
namespace {

QColor toQColor(const std::array<double, 3>& rgb) { return QColor::fromRgbF(rgb[0], rgb[1], rgb[2]); }

QIcon swatch(const std::array<double, 3>& rgb) {
  QPixmap picture(12, 12);
  picture.fill(toQColor(rgb));
  return picture;
}

/// Points, area, length and pieces in words, by label.
std::map<int, QStringList> figuresOf(const Surface& surface) {
  std::map<int, QStringList> figures;
  for (const PatchStatistics& patch : patchStatistics(surface))
    figures[patch.label] = QStringList{
        QString("%L1").arg(patch.points),
        surface.triangles.rows() > 0 ? QString::number(patch.areaMm2, 'f', 0) : QString::fromUtf8("–"),
        QString::number(patch.lengthMm, 'f', 0), QString::number(patch.pieces)};
  return figures;
}

/// Label and name of all that is painted or named on either surface; the two that every case has always.
std::map<int, std::string> patchesOf(const Case& document) {
  std::map<int, std::string> names{{patch::kFalciform, patchName({}, patch::kFalciform)},
                                   {patch::kInferiorRidge, patchName({}, patch::kInferiorRidge)}};
  for (const auto& surface : {document.scan(), document.preop()}) {  // the pre-operative names win
    if (!surface) continue;
    for (const int label : patchLabels(*surface))
      if (!names.count(label) || surface->patchNames.count(label)) names[label] = patchName(*surface, label);
    for (const auto& [label, name] : surface->patchNames) names[label] = patchName(*surface, label);
  }
  return names;
}

}  // namespace

PatchList::PatchList(Workbench& bench, QWidget* parent) : QTableWidget(0, 6, parent), bench_(bench) {
  setObjectName("patchTable");
  setHorizontalHeaderLabels({tr("Patch"), tr("Points"), tr("mm²"), tr("mm"), tr("Pcs"), tr("Lock")});
  horizontalHeader()->setHighlightSections(false);
  const QStringList tips{tr("Tick to show; double click a name of your own to change it"),
                         tr("Points painted on the chosen surface"),
                         tr("Area on the chosen surface, mm²"),
                         tr("Length along its longest axis, mm"),
                         tr("Connected pieces: more than one is often a slip of the brush"),
                         tr("Tick, and nothing changes this patch any more, on either surface")};
  for (int column = 0; column < columnCount(); ++column)
    horizontalHeaderItem(column)->setToolTip(tips[column]);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(kName, QHeaderView::Stretch);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  setTabKeyNavigation(false);
  setToolTip(
      tr("The patches: the marked one is painted (keys 1 to 9 over the view). Tick to show, lock to keep.\n"
         "Points, area in mm², length in mm and pieces are of the chosen surface"));
  showAllRows(this);
  connect(this, &QTableWidget::itemChanged, this, &PatchList::takeEdit);
  connect(this, &QTableWidget::currentCellChanged, this, [this](int row, int, int before) {
    if (!filling_ && row >= 0 && row != before) Q_EMIT picked(labelAt(row));
  });
}

int PatchList::labelAt(int row) const {
  const QTableWidgetItem* name = item(row, kName);
  return name ? name->data(Qt::UserRole).toInt() : patch::kNone;
}

int PatchList::chosen() const { return currentRow() < 0 ? patch::kFalciform : labelAt(currentRow()); }

void PatchList::follow(const std::shared_ptr<const Surface>& surface, int chosen) {
  if (state() == QAbstractItemView::EditingState) return;  // a name is being typed
  if (surface != measured_) {
    measured_ = surface;
    figures_ = surface ? figuresOf(*surface) : std::map<int, QStringList>();
  }
  filling_ = true;
  std::map<int, std::string> names = patchesOf(bench_.document);
  if (chosen > 0 && !names.count(chosen)) names[chosen] = patchName({}, chosen);  // a key has picked it
  setRowCount(static_cast<int>(names.size()));
  int row = 0, current = 0;
  for (const auto& [label, name] : names) {
    const PatchLook look = bench_.view.patchLook(label);
    auto* first = new QTableWidgetItem(swatch(look.colour), QString::fromStdString(name));
    first->setData(Qt::UserRole, label);
    const Qt::ItemFlags base = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    first->setFlags(base | Qt::ItemIsUserCheckable |
                    (label >= patch::kFirstNamed ? Qt::ItemIsEditable : Qt::NoItemFlags));
    first->setCheckState(look.visible ? Qt::Checked : Qt::Unchecked);
    first->setToolTip(QString::fromStdString(name));
    setItem(row, kName, first);
    const auto figures = figures_.find(label);
    for (int column = kPoints; column <= kPieces; ++column) {
      auto* figure = new QTableWidgetItem(figures == figures_.end() ? QString(column == kPoints ? "0" : "")
                                                                    : figures->second[column - kPoints]);
      figure->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      figure->setFlags(base);
      setItem(row, column, figure);
    }
    auto* lock = new QTableWidgetItem;
    lock->setFlags(base | Qt::ItemIsUserCheckable);
    lock->setCheckState(bench_.painting.locked().count(label) ? Qt::Checked : Qt::Unchecked);
    lock->setToolTip(tr("Ticked, nothing changes this patch, on either surface"));
    setItem(row, kLock, lock);
    if (label == chosen) current = row;
    ++row;
  }
  setCurrentCell(current, kName);
  showAllRows(this);
  filling_ = false;
}

void PatchList::takeEdit(QTableWidgetItem* changed) {
  if (filling_) return;
  const int label = labelAt(changed->row());
  if (changed->column() == kLock) {
    bench_.painting.setLocked(label, changed->checkState() == Qt::Checked);
    Q_EMIT edited();
  } else if (changed->column() == kName) {
    PatchLook look = bench_.view.patchLook(label);
    const bool visible = changed->checkState() == Qt::Checked;
    if (visible != look.visible) {
      look.visible = visible;
      bench_.view.setPatchLook(label, look);
      return;
    }
    const std::string name = changed->text().trimmed().toStdString();
    if (label >= patch::kFirstNamed && !name.empty()) rename(label, name);
    Q_EMIT edited();
  }
}

void PatchList::rename(int label, const std::string& name) {
  const auto named = [&](const std::shared_ptr<const Surface>& surface) {
    auto copy = std::make_shared<Surface>(*surface);
    copy->patchNames[label] = name;
    return copy;
  };
  Case& document = bench_.document;
  if (document.preop()) document.setPreop(named(document.preop()));
  if (document.scan()) document.setScan(named(document.scan()));
}

int PatchList::addNamed(const QString& name) {
  const std::map<int, std::string> taken = patchesOf(bench_.document);
  int next = patch::kFirstNamed;
  while (next <= patch::kMax && taken.count(next)) ++next;
  if (next > patch::kMax) return patch::kNone;
  rename(next, name.toStdString());
  return next;
}

void PatchList::askColour() {
  const int label = chosen();
  PatchLook look = bench_.view.patchLook(label);
  const QColor colour = QColorDialog::getColor(toQColor(look.colour), this,
                                               tr("Colour of %1").arg(item(currentRow(), kName)->text()));
  if (!colour.isValid()) return;
  look.colour = {colour.redF(), colour.greenF(), colour.blueF()};
  bench_.view.setPatchLook(label, look);
}

}  // namespace falciform

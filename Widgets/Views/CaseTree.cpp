#include "Widgets/Views/CaseTree.h"

#include <QColorDialog>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QSpinBox>

namespace falciform {
namespace {

constexpr int kPart = Qt::UserRole;

QColor toQColor(const std::array<double, 3>& rgb) { return QColor::fromRgbF(rgb[0], rgb[1], rgb[2]); }

QString surfaceFacts(const Surface& surface) {
  return surface.triangles.rows() > 0 ? QObject::tr("%L1 vertices, %L2 triangles, frame %3")
                                            .arg(surface.size())
                                            .arg(surface.triangles.rows())
                                            .arg(QString::fromStdString(surface.frame))
                                      : QObject::tr("%L1 points, frame %2")
                                            .arg(surface.size())
                                            .arg(QString::fromStdString(surface.frame));
}

std::string partOf(const QTreeWidgetItem* item) { return item->data(0, kPart).toString().toStdString(); }

}  // namespace

CaseTree::CaseTree(Case& document, ViewState& view, QWidget* parent)
    : QTreeWidget(parent), case_(document), view_(view) {
  setObjectName("caseTree");
  setColumnCount(3);
  setHeaderLabels({tr("Part"), QString(), tr("Opacity")});
  headerItem()->setToolTip(kColour, tr("Colour: click to change it"));
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(kName, QHeaderView::Stretch);
  header()->setSectionResizeMode(kColour, QHeaderView::Fixed);
  header()->resizeSection(kColour, 34);
  header()->setSectionResizeMode(kOpacity, QHeaderView::ResizeToContents);
  setRootIsDecorated(false);
  setSelectionMode(QAbstractItemView::NoSelection);
  header()->setMinimumSectionSize(24);
  setToolTip(tr("What the case holds: tick to show, click the colour to change it, opacity in %"));
  connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
    if (filling_ || column != kName || partOf(item).empty()) return;
    PartLook look = view_.look(partOf(item));
    look.visible = item->checkState(kName) == Qt::Checked;
    view_.setLook(partOf(item), look);
  });
  connect(this, &QTreeWidget::itemClicked, this, &CaseTree::chooseColour);
  caseChanged_ = case_.changed.connect([this](Case::Part part) {
    // A slider changes supports many times a second; the tree only tells whether there are any.
    if (part == Case::Part::Supports && hadSupports_ == (case_.supports() != nullptr)) return;
    rebuild();
  });
  viewChanged_ = view_.changed.connect([this] { showLooks(); });
  rebuild();
}

void CaseTree::addFact(const QString& name, const QString& facts) {
  auto* item = new QTreeWidgetItem(this, {name});
  item->setFlags(Qt::ItemIsEnabled);
  item->setFirstColumnSpanned(true);
  item->setToolTip(kName, facts);
}

QTreeWidgetItem* CaseTree::addPart(const QString& name, const std::string& part, const QString& facts) {
  auto* item = new QTreeWidgetItem(this, {name});
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
  item->setData(0, kPart, QString::fromStdString(part));
  item->setToolTip(kName, name + "\n" + facts);
  item->setToolTip(kColour, tr("Click to choose another colour"));
  auto* opacity = new QSpinBox(this);
  opacity->setObjectName("opacity_" + QString::fromStdString(part));
  opacity->setRange(0, 100);
  opacity->setSingleStep(10);
  opacity->setSuffix(" %");
  opacity->setToolTip(tr("Opacity, 0 % (clear) to 100 % (solid)"));
  connect(opacity, qOverload<int>(&QSpinBox::valueChanged), this, [this, part](int percent) {
    PartLook look = view_.look(part);
    look.opacity = percent / 100.0;
    view_.setLook(part, look);
  });
  setItemWidget(item, kOpacity, opacity);
  return item;
}

void CaseTree::rebuild() {
  filling_ = true;
  hadSupports_ = case_.supports() != nullptr;
  // Qt deletes them later; until then nobody shall find two of one name.
  for (QSpinBox* old : findChildren<QSpinBox*>()) old->setObjectName({});
  clear();
  if (const auto& labels = case_.labels())
    addFact(tr("Label map"),
            tr("%1 x %2 x %3 voxels").arg(labels->size.x()).arg(labels->size.y()).arg(labels->size.z()));
  if (const auto& ct = case_.ct())
    addFact(tr("CT"), tr("%1 x %2 x %3 voxels; View > CT slices shows it")
                          .arg(ct->size.x())
                          .arg(ct->size.y())
                          .arg(ct->size.z()));
  if (case_.preop()) addPart(tr("Pre-op liver"), part::kPreop, surfaceFacts(*case_.preop()));
  for (const auto& [name, surface] : case_.structures())
    addPart(QString::fromStdString(name), part::structure(name), surfaceFacts(*surface));
  if (case_.scan()) addPart(tr("Scan"), part::kScan, surfaceFacts(*case_.scan()));
  if (!case_.preopLandmarks().points.empty())
    addPart(tr("Pre-op landmarks"), part::kPreopLandmarks,
            tr("%1 points").arg(case_.preopLandmarks().points.size()));
  if (!case_.scanLandmarks().points.empty())
    addPart(tr("Scan landmarks"), part::kScanLandmarks,
            tr("%1 points").arg(case_.scanLandmarks().points.size()));
  if (!case_.targets().points.empty())
    addPart(tr("Targets"), part::kTargets,
            tr("%1 places inside the liver%2")
                .arg(case_.targets().points.size())
                .arg(case_.truthTargets().points.empty() ? QString() : tr(", and where they truly are")));
  if (case_.registration())
    addFact(case_.registrationStale() ? tr("Registration (out of date)") : tr("Registration"),
            tr("%1 mm weighted RMS, fit").arg(case_.registration()->weightedRmsMm, 0, 'f', 2));
  if (case_.supports())
    addFact(tr("Supports"), tr("What holds and pushes the liver, painted on its surface"));
  if (case_.distance())
    addFact(tr("Distance map"), tr("Signed distance between scan and pre-op surface, mm"));
  if (case_.update())
    addFact(case_.updateStale() ? tr("Model update (out of date)") : tr("Model update"),
            tr("Expected error %1 mm on average").arg(case_.update()->expectedErrorMeanMm, 0, 'f', 1));
  if (topLevelItemCount() == 0) {
    addFact(tr("(empty: open or drop a file)"), tr("Open a label map, a surface, a scan or a case"));
    topLevelItem(0)->setFlags(Qt::NoItemFlags);
  }
  filling_ = false;
  showLooks();
}

void CaseTree::showLooks() {
  filling_ = true;
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = topLevelItem(i);
    if (partOf(item).empty()) continue;
    const PartLook look = view_.look(partOf(item));
    item->setCheckState(kName, look.visible ? Qt::Checked : Qt::Unchecked);
    QPixmap swatch(28, 14);
    swatch.fill(toQColor(look.colour));
    item->setData(kColour, Qt::DecorationRole, swatch);
    if (auto* opacity = qobject_cast<QSpinBox*>(itemWidget(item, kOpacity))) {
      const QSignalBlocker quiet(opacity);
      opacity->setValue(static_cast<int>(std::lround(100 * look.opacity)));
    }
  }
  filling_ = false;
}

void CaseTree::chooseColour(QTreeWidgetItem* item, int column) {
  if (column != kColour || partOf(item).empty()) return;
  const std::string part = partOf(item);
  PartLook look = view_.look(part);
  const QColor chosen =
      QColorDialog::getColor(toQColor(look.colour), this, tr("Colour of %1").arg(item->text(kName)));
  if (!chosen.isValid()) return;
  look.colour = {chosen.redF(), chosen.greenF(), chosen.blueF()};
  view_.setLook(part, look);
}

}  // namespace falciform

#include "Testing/Gui/ImportFixture.h"

#include <QMouseEvent>
#include <QTableWidget>
#include <QtTest/QTest>

namespace falciform::test {

double dice(const LabelMap& a, const LabelMap& b) {
  std::size_t both = 0, sum = 0;
  for (std::size_t i = 0; i < a.voxels.size(); ++i) {
    both += a.voxels[i] > 0 && b.voxels[i] > 0;
    sum += static_cast<std::size_t>(a.voxels[i] > 0) + static_cast<std::size_t>(b.voxels[i] > 0);
  }
  return 2 * static_cast<double>(both) / static_cast<double>(sum);
}

void ImportFixture::SetUp() {
  SmoothFixture::SetUp();
  if (IsSkipped()) return;
  live_ = bench->view.changed.connect([this] {
    if (const auto& front = bench->view.options().previewSurface) fronts.insert(front);
  });
}

void ImportFixture::goTo(const Vector3d& mm) {
  for (const char* plane : {"sliceCoronal", "sliceSagittal"}) {
    SliceView& view = slice(plane);
    QTest::mouseClick(&view, Qt::LeftButton, Qt::ControlModifier, view.positionOf(mm).toPoint());
  }
  handleEvents(10);
}

void ImportFixture::clickAxial(const Vector3d& mm) {
  SliceView& axial = slice("sliceAxial");
  QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.positionOf(mm).toPoint());
  handleEvents(10);
}

void ImportFixture::seed(const std::vector<Vector3d>& places) {
  click("addSeed");
  for (const Vector3d& place : places) {
    goTo(place);
    clickAxial(place);
  }
  EXPECT_EQ(control<QTableWidget>("seedTable").rowCount(), static_cast<int>(places.size()));
}

void ImportFixture::dragIn(SliceView& view, Qt::MouseButton button, const std::vector<QPoint>& way) {
  QTest::mousePress(&view, button, {}, way.front());
  for (const QPoint& at : way) {
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, button, Qt::NoModifier);
    QApplication::sendEvent(&view, &move);
  }
  QTest::mouseRelease(&view, button, {}, way.back());
  handleEvents(30);
}

double ImportFixture::volumeMl() const {
  const LabelMap& labels = *bench->document.labels();
  const auto inside = std::count_if(labels.voxels.begin(), labels.voxels.end(),
                                    [](std::uint16_t label) { return label > 0; });
  return static_cast<double>(inside) * labels.voxelVolume() / 1000;
}

bool ImportFixture::isLabelled(const Vector3d& mm) const {
  const LabelMap& map = *bench->document.labels();
  const Vector3i at = (map.worldFromIndex.inverse() * mm.homogeneous()).head<3>().array().round().cast<int>();
  return map.at(at.x(), at.y(), at.z()) > 0;
}

QString ImportFixture::quality(const QString& row) {
  auto& table = control<QTableWidget>("qualityTable");
  for (int r = 0; r < table.rowCount(); ++r)
    if (table.item(r, 0)->text().startsWith(row)) return table.item(r, 1)->text();
  return "no such row";
}

}  // namespace falciform::test

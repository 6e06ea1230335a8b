#include "Modules/CommandLine/ScanPicture.h"

#include <memory>

#include "Modules/CommandLine/PictureTiles.h"
#include "Widgets/Rendering/LegendPresenter.h"
#include "Widgets/Rendering/PatchColours.h"
#include "Widgets/Rendering/ScanView.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform::commandline {

namespace {

constexpr ScanMark kMarks[] = {ScanMark::Outlier, ScanMark::Grazing, ScanMark::SmallPiece,
                               ScanMark::OtherTissue, ScanMark::ByHand};

std::shared_ptr<const Surface> paintedByMarks(const MarkedScan& marked) {
  auto painted = std::make_shared<Surface>(marked.scan);
  painted->texture.reset();
  painted->patch.clear();
  if (painted->colours.rows() == 0)
    painted->colours = (255 * kLiverColour).cast<std::uint8_t>().transpose().replicate(painted->size(), 1);
  for (Index i = 0; i < painted->size(); ++i)
    if (const ScanMark mark = marked.marks[static_cast<std::size_t>(i)]; mark != ScanMark::Kept)
      painted->colours.row(i) = (255 * scanMarkColour(mark)).cast<std::uint8_t>().transpose();
  return painted;
}

}  // namespace

RenderedImage scanPicture(const MarkedScan& marked, const Surface& prepared) {
  const Vector3d from = marked.towardsScanner, up = uprightFor(prepared, from);
  const auto tile = [&](const std::string& title, const std::shared_ptr<const Surface>& surface,
                        const std::vector<LegendEntry>& entries) {
    const auto scene = titledScene(title);
    auto& presenter = scene->add<SurfacePresenter>();
    presenter.setStyle({.pointPx = 3});
    presenter.show(surface);
    if (!entries.empty())
      scene->add<LegendPresenter>(scene->style().textPx, scene->style().text).show(entries);
    return drawnTile(*scene, surface->points, {from, up}, {entries.empty() ? 0.04 : 0.3, 0.04, 0.08, 0.1});
  };
  std::vector<LegendEntry> entries;
  for (const ScanMark mark : kMarks)
    if (const Index count = marked.count(mark); count > 0)
      entries.push_back({scanMarkColour(mark), enumToString(mark) + ": " + std::to_string(count)});
  return sheetOf({tile("As scanned", std::make_shared<const Surface>(marked.scan), {}),
                  tile("", paintedByMarks(marked), entries),
                  tile("Prepared", std::make_shared<const Surface>(prepared), {})},
                 3);
}

}  // namespace falciform::commandline

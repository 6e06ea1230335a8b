#include "Modules/CommandLine/MeshPicture.h"

#include <array>
#include <limits>
#include <map>
#include <memory>
#include <set>

#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Widgets/Rendering/CameraViews.h"
#include "Widgets/Rendering/LegendPresenter.h"
#include "Widgets/Rendering/OffscreenWindow.h"
#include "Widgets/Rendering/Scene.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform::commandline {

namespace {

constexpr int kWidth = 1200, kHeight = 900;

Vector3d middleOf(const TetrahedralMesh& mesh, Index element) {
  return mesh.points(mesh.elements.row(element).head(4).transpose().eval(), Eigen::all)
      .colwise()
      .mean()
      .transpose();
}

/// Mean y of each region's elements: from front to back in LPS.
std::map<int, double> depthOfRegions(const TetrahedralMesh& mesh) {
  std::map<int, std::pair<double, double>> sums;
  for (Index e = 0; e < mesh.size(); ++e) {
    auto& [sum, count] = sums[mesh.regionOf(e)];
    sum += middleOf(mesh, e).y();
    ++count;
  }
  std::map<int, double> depths;
  for (const auto& [region, sum] : sums) depths[region] = sum.first / sum.second;
  return depths;
}

/// Cut through the rearmost tumour, or the middle; tumours before the cut stay whole.
TetrahedralMesh cutOpen(const TetrahedralMesh& mesh) {
  std::map<int, double> depths = depthOfRegions(mesh);
  double cut = depths.begin()->second;
  if (depths.size() > 1) {
    depths.erase(0);
    cut = -std::numeric_limits<double>::infinity();
    for (const auto& [region, depth] : depths) cut = std::max(cut, depth);
  }
  TetrahedralMesh kept{.points = mesh.points, .elements = {}, .regions = {}, .frame = mesh.frame};
  std::vector<Index> rows;
  for (Index e = 0; e < mesh.size(); ++e) {
    const int region = mesh.regionOf(e);
    if (middleOf(mesh, e).y() < cut && (region == 0 || depths[region] >= cut)) continue;
    rows.push_back(e);
    kept.regions.push_back(region);
  }
  kept.elements = mesh.elements(rows, Eigen::all);
  return kept;
}

Vector3d colourOf(int region) {
  return region == 0 ? Vector3d(0.72, 0.36, 0.30) : patchColour(patch::kFirstNamed + region - 1);
}

std::set<std::array<int, 3>> facesOf(const BoundaryFaces& faces) {
  std::set<std::array<int, 3>> result;
  for (Index f = 0; f < faces.size(); ++f)
    result.insert({faces.nodes(f, 0), faces.nodes(f, 1), faces.nodes(f, 2)});
  return result;
}

/// Triangle by triangle, so that each has a colour of its own.
Surface drawn(const TetrahedralMesh& kept, const TetrahedralMesh& whole) {
  const BoundaryFaces faces = boundaryFaces(kept);
  const auto outside = facesOf(boundaryFaces(whole));
  Surface surface;
  surface.points.resize(3 * faces.size(), 3);
  surface.triangles.resize(faces.size(), 3);
  surface.colours.resize(3 * faces.size(), 3);
  for (Index f = 0; f < faces.size(); ++f) {
    const bool outer = outside.contains({faces.nodes(f, 0), faces.nodes(f, 1), faces.nodes(f, 2)});
    const Vector3d base = colourOf(kept.regionOf(faces.elements[static_cast<std::size_t>(f)]));
    const Vector3d colour = outer ? base : Vector3d(base * 0.45 + Vector3d::Constant(0.55));
    for (Index k = 0; k < 3; ++k) {
      surface.points.row(3 * f + k) = kept.points.row(faces.nodes(f, static_cast<int>(k)));
      surface.triangles(f, k) = static_cast<int>(3 * f + k);
      surface.colours.row(3 * f + k) = (255 * colour).cast<std::uint8_t>().transpose();
    }
  }
  return surface;
}

}  // namespace

void saveMeshPicture(const TetrahedralMesh& mesh, const std::filesystem::path& file, Overwrite overwrite) {
  const TetrahedralMesh whole = linearMesh(mesh);
  const TetrahedralMesh kept = cutOpen(whole);
  SceneStyle look;
  look.textPx = 2 * kHeight / 45;
  Scene scene(look);
  SurfaceStyle style;
  style.edges = true;
  auto& presenter = scene.add<SurfacePresenter>();
  presenter.setStyle(style);
  presenter.show(std::make_shared<const Surface>(drawn(kept, whole)));
  std::vector<LegendEntry> legend{{colourOf(0), "parenchyma"}};
  const std::set<int> regions(whole.regions.begin(), whole.regions.end());
  for (const int region : regions)
    if (region > 0) legend.push_back({colourOf(region), "tumour " + std::to_string(region)});
  scene.add<LegendPresenter>(look.textPx, look.text).show(legend);
  fitView(scene.renderer(), whole.points, {-Vector3d::UnitY(), Vector3d::UnitZ()},
          static_cast<double>(kWidth) / kHeight, {0.05, 0.05, 0.06, 0.09});
  OffscreenWindow window(2 * kWidth, 2 * kHeight);
  window.show(scene);
  savePng(halved(window.image()), file, overwrite);
}

}  // namespace falciform::commandline

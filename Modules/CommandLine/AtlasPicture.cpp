#include "Modules/CommandLine/AtlasPicture.h"

#include <algorithm>
#include <memory>

#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Core/Errors.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/PictureTiles.h"
#include "Widgets/Rendering/CameraViews.h"
#include "Widgets/Rendering/ColourBarPresenter.h"
#include "Widgets/Rendering/LegendPresenter.h"
#include "Widgets/Rendering/Scene.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform::commandline {

namespace {

constexpr int kColumns = 3, kShown = 5;
constexpr char kArray[] = "displacement_mm";
constexpr double kLittleFolded = 1e-3;  // share of the volume

// The thesis's Fig. V.6: free, fixed, sliding, pushed.
const Vector3d kFree{0.45, 0.70, 0.45}, kFixed{0.55, 0.80, 0.95}, kSliding{0.10, 0.20, 0.60},
    kPushed{0.95, 0.80, 0.15};

const ViewDirection kFront{Vector3d(0, -0.95, -0.31).normalized(), Vector3d::UnitZ()};
const ViewDirection kBelowBehind{Vector3d(0.35, 0.55, -0.76).normalized(), Vector3d::UnitZ()};

/// The boundary with every node that lies on it: four triangles a quadratic face.
struct Skin {
  Surface surface;
  std::vector<int> nodes;  ///< of each of its points
};

Skin skinOf(const TetrahedralMesh& mesh, const BoundaryFaces& faces) {
  static constexpr int kQuarters[4][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
  Skin skin;
  std::vector<int> place(static_cast<std::size_t>(mesh.nodes()), -1);
  const auto placeOf = [&](int node) {
    int& at = place[static_cast<std::size_t>(node)];
    if (at < 0) {
      at = static_cast<int>(skin.nodes.size());
      skin.nodes.push_back(node);
    }
    return at;
  };
  const Index each = faces.quadratic ? 4 : 1;
  skin.surface.triangles.resize(each * faces.size(), 3);
  for (Index f = 0; f < faces.size(); ++f)
    for (Index q = 0; q < each; ++q)
      for (int k = 0; k < 3; ++k)
        skin.surface.triangles(each * f + q, k) =
            placeOf(faces.nodes(f, faces.quadratic ? kQuarters[q][k] : k));
  skin.surface.points = mesh.points(skin.nodes, Eigen::all);
  return skin;
}

/// Triangle by triangle, so that each has a colour of its own.
RenderedImage supportsTile(const TetrahedralMesh& mesh, const BoundaryFaces& faces, const AtlasSetup& setup,
                           std::size_t number) {
  std::vector<Vector3d> colours(static_cast<std::size_t>(faces.size()), kFree);
  for (const Support& support : setup.supports)
    for (const int face : support.faces)
      colours.at(static_cast<std::size_t>(face)) = support.kind == SupportKind::Fixed     ? kFixed
                                                   : support.kind == SupportKind::Sliding ? kSliding
                                                                                          : kPushed;
  auto surface = std::make_shared<Surface>();
  surface->points.resize(3 * faces.size(), 3);
  surface->triangles.resize(faces.size(), 3);
  surface->colours.resize(3 * faces.size(), 3);
  for (Index f = 0; f < faces.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      surface->points.row(3 * f + k) = mesh.points.row(faces.nodes(f, k));
      surface->triangles(f, k) = static_cast<int>(3 * f + k);
      surface->colours.row(3 * f + k) =
          (255 * colours[static_cast<std::size_t>(f)]).cast<std::uint8_t>().transpose();
    }
  const auto scene = titledScene("Supports of setup " + std::to_string(number) + ", from below and behind",
                                 TextPlace::TopCentre);
  SurfaceStyle style;
  style.edges = true;
  auto& presenter = scene->add<SurfacePresenter>();
  presenter.setStyle(style);
  presenter.show(surface);
  std::vector<LegendEntry> legend{{kFree, "free"}};
  const auto has = [&](SupportKind kind) {
    return std::any_of(setup.supports.begin(), setup.supports.end(),
                       [&](const Support& support) { return support.kind == kind; });
  };
  if (has(SupportKind::Fixed)) legend.push_back({kFixed, "fixed"});
  if (has(SupportKind::Sliding)) legend.push_back({kSliding, "sliding"});
  if (has(SupportKind::Pushed)) legend.push_back({kPushed, "pushed"});
  scene->add<LegendPresenter>(scene->style().textPx, scene->style().text).show(legend);
  return drawnTile(*scene, mesh.points, kBelowBehind, {0.18, 0.05, 0.12, 0.1});
}

std::string titleOf(const Atlas& atlas, Index m) {
  const AtlasMember& member = atlas.members[static_cast<std::size_t>(m)];
  std::string title = "Member " + std::to_string(m);
  if (atlas.setups[static_cast<std::size_t>(member.setup)].pushed >= 0)
    title += ": pushed " + fixed(member.pushMm, 0) + " mm";
  if (member.gravityMPerS2.norm() > 0) {
    const Vector3d before = member.gravityMPerS2 - member.gravityChangeMPerS2;
    const double cosine = before.norm() > 0 ? before.normalized().dot(member.gravityMPerS2.normalized()) : 1;
    title +=
        ", gravity turned " + fixed(std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / EIGEN_PI, 0) + " deg";
  }
  return title;
}

}  // namespace

std::vector<Index> telling(const Atlas& atlas) {
  std::vector<Index> candidates;
  const auto better = [&](std::size_t m, std::size_t than) {
    const MemberFigures &a = atlas.figures[m], &b = atlas.figures[than];
    const bool good = a.foldedShare <= kLittleFolded, otherGood = b.foldedShare <= kLittleFolded;
    if (good != otherGood) return good;
    return good ? a.rmsMm > b.rmsMm : a.foldedShare < b.foldedShare;
  };
  if (atlas.setups.size() > 1) {
    std::vector<Index> best(atlas.setups.size(), -1);
    for (std::size_t m = 0; m < atlas.members.size(); ++m) {
      Index& kept = best[static_cast<std::size_t>(atlas.members[m].setup)];
      if (kept < 0 || better(m, static_cast<std::size_t>(kept))) kept = static_cast<Index>(m);
    }
    std::copy_if(best.begin(), best.end(), std::back_inserter(candidates), [](Index m) { return m >= 0; });
  } else {
    for (std::size_t m = 0; m < atlas.members.size(); ++m) candidates.push_back(static_cast<Index>(m));
  }
  const auto count = static_cast<Index>(candidates.size());
  if (count <= kShown) return candidates;
  std::vector<Index> chosen;
  for (Index k = 0; k < kShown; ++k)
    chosen.push_back(candidates[static_cast<std::size_t>(k * (count - 1) / (kShown - 1))]);
  return chosen;
}

void saveAtlasPicture(const Atlas& atlas, const std::vector<Index>& members,
                      const std::filesystem::path& file, Overwrite overwrite) {
  for (const Index m : members)
    if (m < 0 || m >= static_cast<Index>(atlas.members.size()))
      throw InputError("there is no member " + std::to_string(m) + " in an atlas of " +
                       std::to_string(atlas.members.size()) + " (from 0)");
  if (members.empty()) throw InputError("no member to draw is named; give one or more");
  const BoundaryFaces faces = boundaryFaces(atlas.mesh);
  const Skin skin = skinOf(atlas.mesh, faces);
  std::vector<std::shared_ptr<const Surface>> moved;
  double most = 0;
  Points all = skin.surface.points;
  for (const Index m : members) {
    const Points u = memberDisplacements(atlas, m)(skin.nodes, Eigen::all);
    Surface surface = skin.surface;
    surface.points += u;
    surface.arrays[kArray] = u.rowwise().norm();
    most = std::max(most, surface.arrays[kArray].maxCoeff());
    Points both(all.rows() + surface.points.rows(), 3);
    both << all, surface.points;
    all = std::move(both);
    moved.push_back(std::make_shared<const Surface>(std::move(surface)));
  }
  const ScalarMap map = magnitudeMap(kArray, "Displacement", "mm", most);
  // Inside out, so that only its far side is drawn: it shows where the moved liver is not before it.
  auto rest = std::make_shared<Surface>(skin.surface);
  rest->triangles.col(1).swap(rest->triangles.col(2));
  const int setup = atlas.members[static_cast<std::size_t>(members.front())].setup;
  std::vector<RenderedImage> tiles{supportsTile(
      atlas.mesh, faces, atlas.setups[static_cast<std::size_t>(setup)], static_cast<std::size_t>(setup))};
  for (std::size_t k = 0; k < members.size(); ++k) {
    const auto scene = titledScene(titleOf(atlas, members[k]), TextPlace::TopLeft);
    auto& presenter = scene->add<SurfacePresenter>();
    presenter.show(moved[k]);
    presenter.setScalarMap(map);
    SurfaceStyle shadow;
    shadow.colour = Vector3d::Constant(0.6);
    shadow.opacity = 0.5;
    shadow.frontOnly = true;
    auto& atRest = scene->add<SurfacePresenter>();
    atRest.setStyle(shadow);
    atRest.show(rest);
    scene->add<ColourBarPresenter>(scene->style().textPx, scene->style().text).show(map);
    tiles.push_back(drawnTile(*scene, all, kFront, {0.04, 0.2, 0.12, 0.1}));
  }
  savePng(sheetOf(tiles, kColumns), file, overwrite);
}

}  // namespace falciform::commandline

#include "Testing/Logic/Acquisition/OperatingScene.h"

#include <algorithm>
#include <cmath>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Acquisition/VirtualScanner.h"
#include "Logic/Core/Draws.h"
#include "Logic/Geometry/Measures.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {

namespace {

enum Label { kGauze = 100, kFat, kSteel, kTeflon };

/// x to the right, y up, z towards the scanner, from the liver's middle.
struct Table {
  Vector3d origin, x, y, z;
  [[nodiscard]] Vector3d at(double u, double v, double w) const { return origin + u * x + v * y + w * z; }
};

void append(Surface& scene, const Surface& part, int label) {
  const Index points = scene.size(), triangles = scene.triangles.rows();
  scene.points.conservativeResize(points + part.size(), 3);
  scene.points.bottomRows(part.size()) = part.points;
  scene.triangles.conservativeResize(triangles + part.triangles.rows(), 3);
  scene.triangles.bottomRows(part.triangles.rows()) = part.triangles.array() + static_cast<int>(points);
  scene.patch.insert(scene.patch.end(), static_cast<std::size_t>(part.size()), label);
}

Surface placed(Surface part, const Table& table) {
  for (Index i = 0; i < part.size(); ++i) {
    const Vector3d p = part.points.row(i);
    part.points.row(i) = table.at(p.x(), p.y(), p.z()).transpose();
  }
  return part;
}

/// Folds of gauze, 15 mm high, in which the liver lies.
Surface gauze() {
  Surface sheet = grid(340, 110);
  for (Index i = 0; i < sheet.size(); ++i) {
    sheet.points.row(i).head<2>().array() -= 170;
    const double x = sheet.points(i, 0), y = sheet.points(i, 1);
    sheet.points(i, 2) = -12 + 5 * std::sin(x / 17) + 4 * std::sin(y / 13 + x / 40);
  }
  return sheet;
}

/// A blade of 24 mm, 4 mm thick, with an edge length that the scanner's nearest corner can tell labels by.
Surface blade(const Vector3d& corner, const Vector3d& size) {
  Surface body = box(size);
  body.points.rowwise() += corner.transpose();
  return body;
}

Eigen::RowVector3d colourOf(int label, const Eigen::RowVector3d& tissue) {
  switch (label) {
    case kGauze:
      return {214, 190, 182};
    case kFat:
      return {220, 184, 98};
    case kSteel:
      return {150, 154, 160};
    case kTeflon:
      return {236, 236, 230};
    default:
      return tissue;
  }
}

/// Lambert's light from the scanner, and the camera's noise.
void shade(Surface& scan, const Vector3d& towards, Draws& draws) {
  const Points normals = vertexNormals(scan);
  for (Index i = 0; i < scan.size(); ++i) {
    const double light = 0.55 + 0.45 * std::max(normals.row(i).dot(towards), 0.0);
    const Eigen::RowVector3d base = colourOf(scan.patchAt(i), scan.colours.row(i).cast<double>()) * light;
    for (int k = 0; k < 3; ++k)
      scan.colours(i, k) =
          static_cast<std::uint8_t>(std::lround(std::clamp(base[k] + 5 * draws.normal(), 0.0, 255.0)));
  }
}

/// Spikes: points of the mesh moved along their rays, by far enough to be no noise.
void addSpikes(OperatingScene& scene, double share, const Vector3d& towards, Draws& draws) {
  for (Index i = 0; i < scene.scan.size(); ++i)
    if (draws.uniform(0, 1) < share) {
      const double by = draws.uniform(8, 60) * (draws.uniform(0, 1) < 0.8 ? 1 : -1);
      scene.scan.points.row(i) += by * towards.transpose();
      scene.outlier[static_cast<std::size_t>(i)] = 1;
      scene.liver[static_cast<std::size_t>(i)] = 0;
    }
}

/// Smoke: returns in the air, joined to nothing.
void addSmoke(OperatingScene& scene, double share, const Vector3d& towards, Draws& draws) {
  Surface& scan = scene.scan;
  const Index old = scan.size();
  const auto count = static_cast<Index>(std::lround(share * static_cast<double>(old)));
  scan.points.conservativeResize(old + count, 3);
  scan.colours.conservativeResize(old + count, 3);
  scan.normals.conservativeResize(old + count, 3);
  for (Index i = old; i < old + count; ++i) {
    const auto from = static_cast<Index>(draws.uniform(0, 1) * static_cast<double>(old - 1));
    scan.points.row(i) = scan.points.row(from) + draws.uniform(15, 120) * towards.transpose();
    scan.normals.row(i) = towards.transpose();
    scan.colours.row(i) << 180, 180, 185;
    scan.patch.push_back(patch::kNone);
    scene.outlier.push_back(1);
    scene.liver.push_back(0);
  }
}

/// The place of the label that lies nearest to the label's middle.
Vector3d clickOn(const Surface& scan, const std::vector<char>& liver, int label) {
  Points of(0, 3);
  std::vector<Index> ids;
  for (Index i = 0; i < scan.size(); ++i)
    if (liver[static_cast<std::size_t>(i)] && scan.patchAt(i) == label) ids.push_back(i);
  of = scan.points(ids, Eigen::all);
  Index nearest = 0;
  (of.rowwise() - centroid(of).transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  return of.row(nearest);
}

}  // namespace

OperatingScene makeOperatingScene(const OperatingScenePlan& plan) {
  VirtualScannerSettings scanner;
  scanner.noiseMm = plan.noiseMm;
  scanner.stride = plan.stride;
  scanner.seed = plan.seed;
  scanner.fieldOfViewDeg = 45;
  scanner.windowShare = 1;
  SyntheticLiverSettings shape;
  Surface whole = makeSyntheticLiver(shape).surface;
  Surface scene;
  scene.points = whole.points;
  scene.triangles = whole.triangles;
  scene.patch = whole.patch;
  scene.patch.resize(static_cast<std::size_t>(whole.size()), patch::kNone);
  Table table;
  table.z = towardsScanner(scanner);
  table.x = Vector3d::UnitZ().cross(table.z).normalized();
  table.y = table.z.cross(table.x);
  table.origin = centroid(whole.points);
  append(scene, placed(gauze(), table), kGauze);
  append(scene, placed(sphere(34, 4, {-62, 62, -18}), table), kFat);
  append(scene, placed(blade({20, 30, 62}, {24, 150, 4}), table), kSteel);
  append(scene, placed(sphere(12, 3, {140, -80, 4}), table), kTeflon);
  append(scene, placed(sphere(12, 3, {-140, -90, 4}), table), kTeflon);

  const VirtualScan seen = scanSurface(scene, table.origin, scanner, ScanFaultSettings{});
  OperatingScene result;
  result.scan = seen.scan;
  result.outlier.assign(static_cast<std::size_t>(seen.scan.size()), 0);
  for (Index i = 0; i < seen.scan.size(); ++i) result.liver.push_back(seen.scan.patchAt(i) < kGauze);
  const Vector3d towards = seen.scanFromPreop.linear() * table.z;
  Draws draws(static_cast<std::uint64_t>(plan.seed), 77);
  shade(result.scan, towards, draws);
  result.onLiver = clickOn(result.scan, result.liver, patch::kNone);
  result.onLigament = clickOn(result.scan, result.liver, patch::kFalciform);
  addSpikes(result, plan.outlierShare / 2, towards, draws);
  addSmoke(result, plan.outlierShare / 2, towards, draws);
  for (int& label : result.scan.patch)
    if (label >= kGauze) label = patch::kNone;
  return result;
}

double diceOf(const std::vector<char>& a, const std::vector<char>& b) {
  double both = 0, sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    both += a[i] && b[i];
    sum += (a[i] != 0) + (b[i] != 0);
  }
  return sum > 0 ? 2 * both / sum : 1;
}

}  // namespace falciform::test

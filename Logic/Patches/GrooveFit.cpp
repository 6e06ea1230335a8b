#include "Logic/Patches/GrooveFit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Logic/Patches/CrestLines.h"

namespace falciform {

namespace {

// Lengths over the liver's size, as FeatureGround::sizeMm.
constexpr double kPeak = 0.35;  ///< radius in which the likeliest place is looked for
constexpr double kReach = 0.9;  ///< radius of what makes the line
constexpr double kHalfLength = 0.6;
constexpr double kShift = 1;     ///< of the log-odds: examples are rare, so the likeliest are seldom above 0
constexpr double kNowhere = -8;  ///< log-odds below which there is nothing
constexpr std::size_t kMostPlaces = 1500;
constexpr int kSteps = 10;  ///< of the mean that moves to where most is
constexpr double kSmoothingMm = 3;
constexpr double kMostAside = 0.6;  ///< mm to the side a mm upwards
constexpr double kAcross = 0.7;     ///< a line runs across if so much of its way is from right to left
constexpr double kFacing =
    0;  ///< of a normal towards the front and the head together: the front of the liver

/// The vertices that count most, and what they weigh: mm^2 of likely groove.
struct Mass {
  Points places;  ///< (right, front, head), mm
  VectorXd weight;
};

Mass massOf(const FeatureGround& ground, const VectorXd& logOdds) {
  const VectorXd weight = vertexAreas(ground.surface).array() / (1 + (-(logOdds.array() + kShift)).exp());
  std::vector<int> order(static_cast<std::size_t>(weight.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return weight[a] > weight[b]; });
  order.resize(std::min(order.size(), std::max(kMostPlaces, order.size() / 8)));
  Mass mass{Points(static_cast<Index>(order.size()), 3), VectorXd(static_cast<Index>(order.size()))};
  for (std::size_t i = 0; i < order.size(); ++i) {
    mass.places.row(static_cast<Index>(i)) = ground.turned.row(order[i]);
    mass.weight[static_cast<Index>(i)] = weight[order[i]];
  }
  return mass;
}

/// Where most of it lies within the radius.
Eigen::RowVector3d peakOf(const Mass& mass, double radius) {
  const KdTree tree(mass.places);
  double most = -1;
  Index best = 0;
  for (Index i = 0; i < mass.places.rows(); ++i) {
    double sum = 0;
    for (const int j : tree.within(mass.places.row(i), radius)) sum += mass.weight[j];
    if (sum > most) most = sum, best = i;
  }
  return mass.places.row(best);
}

VectorXd weightWithin(const Mass& mass, const Eigen::RowVector3d& middle, double radius) {
  return ((mass.places.rowwise() - middle).rowwise().norm().array() < radius).select(mass.weight, 0.0);
}

/// The place along the axis that halves the weight.
double medianAlong(const VectorXd& along, const VectorXd& weight) {
  std::vector<Index> order(static_cast<std::size_t>(along.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return along[a] < along[b]; });
  double sum = 0;
  for (const Index i : order)
    if ((sum += weight[i]) >= 0.5 * weight.sum()) return along[i];
  return 0;
}

/// The longest direction in the plane of front and head, and how the place to the right changes along it,
/// which is little: what is likely is as wide as it is long where there is nothing to see, and a groove never
/// runs across.
Vector3d climbingAxis(const Matrix3d& spread) {
  const Eigen::Matrix2d sagittal = spread.bottomRightCorner<2, 2>();
  Eigen::Vector2d up = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(sagittal).eigenvectors().col(1);
  if (up.y() < 0) up = -up;  // towards the head
  const double slope = spread.row(0).tail<2>().dot(up) / up.dot(sagittal * up);
  return Vector3d(std::clamp(slope, -kMostAside, kMostAside), up.x(), up.y()).normalized();
}

TracedLine tracedLine(const FeatureGround& ground, const VectorXd& logOdds, const Points& corners) {
  TracedLine line;
  line.points = smoothedLine(corners, kSmoothingMm);
  line.standard.resize(line.points.rows(), 3);
  line.logOdds.resize(line.points.rows());
  const KdTree vertices(ground.surface.points);
  for (Index i = 0; i < line.points.rows(); ++i) {
    const int v = vertices.nearest(line.points.row(i)).index;
    line.standard.row(i) = ground.standard.row(v);
    line.logOdds[i] = logOdds[v];
  }
  return line;
}

/// Grooves are shallow: blunter and weaker than what crestLines takes by itself.
CrestLineSettings shallow() {
  CrestLineSettings settings;
  settings.lowPerMm = 0.01;
  settings.highPerMm = 0.02;
  settings.leastStrength = 0.4;
  settings.leastLengthMm = 25;
  return settings;
}

/// The parts of a crest line that lie on the front of the liver: a groove's valley may go on around the
/// margin and along the underside.
std::vector<CrestLine> partsInFront(const FeatureGround& ground, const KdTree& vertices,
                                    const CrestLine& line) {
  std::vector<CrestLine> parts;
  Index first = -1;
  const Index count = line.points.rows();
  for (Index i = 0; i <= count; ++i) {
    const bool inFront =
        i < count &&
        ground.descriptors.row(vertices.nearest(line.points.row(i)).index).segment(4, 2).sum() > kFacing;
    if (inFront && first < 0) first = i;
    if (inFront || first < 0) continue;
    CrestLine part;
    part.points = line.points.middleRows(first, i - first);
    for (Index k = 1; k < part.points.rows(); ++k)
      part.lengthMm += (part.points.row(k) - part.points.row(k - 1)).norm();
    parts.push_back(std::move(part));
    first = -1;
  }
  return parts;
}

}  // namespace

bool climbs(const FeatureGround& ground, const Points& line) {
  if (line.rows() < 2) return false;
  const Eigen::RowVector3d way = (line.row(line.rows() - 1) - line.row(0)) * ground.axes.rows.transpose();
  return std::abs(way.x()) < kAcross * way.norm();
}

Points valleysInFront(const FeatureGround& ground) {
  const CrestLineSettings settings = shallow();
  const KdTree vertices(ground.surface.points);
  std::vector<Points> parts;
  Index count = 0;
  for (const CrestLine& whole : crestLines(ground.surface, CrestKind::Valley, settings))
    for (CrestLine& valley : partsInFront(ground, vertices, whole)) {
      if (valley.lengthMm < settings.leastLengthMm || !climbs(ground, valley.points)) continue;
      count += valley.points.rows();
      parts.push_back(std::move(valley.points));
    }
  Points all(count, 3);
  Index at = 0;
  for (const Points& part : parts) {
    all.middleRows(at, part.rows()) = part;
    at += part.rows();
  }
  return all;
}

TracedLine fitGroove(const FeatureGround& ground, const VectorXd& logOdds) {
  if (logOdds.maxCoeff() < kNowhere) return {};
  const Mass mass = massOf(ground, logOdds);
  Eigen::RowVector3d middle = peakOf(mass, kPeak * ground.sizeMm);
  VectorXd weight;
  for (int step = 0; step < kSteps; ++step) {
    weight = weightWithin(mass, middle, kReach * ground.sizeMm);
    middle = weight.transpose() * mass.places / weight.sum();
  }
  weight = weightWithin(mass, middle, kReach * ground.sizeMm);
  const Points offset = mass.places.rowwise() - middle;
  const Matrix3d spread = offset.transpose() * weight.asDiagonal() * offset / weight.sum();
  const Vector3d axis = climbingAxis(spread);
  const double centre = medianAlong(offset * axis, weight), half = kHalfLength * ground.sizeMm;

  const TriangleTree tree(ground.surface);
  const auto count = static_cast<Index>(2 * half) + 1;
  Points on(count, 3);
  for (Index i = 0; i < count; ++i) {
    const Vector3d turned = middle.transpose() + (centre - half + static_cast<double>(i)) * axis;
    on.row(i) = tree.closest(ground.axes.rows.transpose() * turned).point;
  }
  return tracedLine(ground, logOdds, on);
}

}  // namespace falciform

#include "Logic/Geometry/RbfFit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/PointSpacing.h"
#include "Logic/Geometry/RbfSystem.h"

namespace falciform {

namespace {

constexpr Index kFewest = 30;
constexpr double kFinestPerSpacing = 2.5;  ///< fewer than about six points a function would fit their noise
constexpr double kCentreBand = 2,
                 kFineCentreBand = 1.5;  ///< functions stand within so many steps of the points they explain
constexpr double kSlopeWeight = 0.5;     ///< steps: a slope wrong by 1 counts like a distance of so much
constexpr double kBandSteps = 2.5;       ///< thickness of the cells charged with third derivatives
constexpr double kTolerance = 1e-3;      ///< the next level takes up what is left
constexpr int kMostIterations = 500;
/// Levels with steps below so many of the finest's correct what is small: their sums may ripple.
constexpr double kFineSteps = 3;
constexpr double kSlack = 1.1;  ///< the noise's variance may be so much larger than thought
constexpr double kSigmas = 7;   ///< of chance: more residual than that is shape
constexpr int kWindow = 2;      ///< cells around that are judged together
constexpr double kMostNodes = 3e7;
constexpr std::size_t kChunk = 512;

void checkPoints(const Points& points, const Points& normals) {
  if (points.rows() < kFewest)
    throw InputError("a surface of radial basis functions needs at least " + std::to_string(kFewest) +
                     " points, and there are " + std::to_string(points.rows()));
  if (!points.allFinite() || !normals.allFinite())
    throw InputError("some points or normals are not finite numbers; export the surface again");
  if (normals.rows() != points.rows())
    throw InputError("there are " + std::to_string(normals.rows()) + " normals for " +
                     std::to_string(points.rows()) + " points; give one each");
}

/// The general quadric nearest to value 0 and slope 1 along the normals.
RbfFunction::Quadric fitQuadric(const Points& points, const Points& normals) {
  RbfFunction::Quadric quadric;
  quadric.centre = centroid(points);
  quadric.scaleMm = std::sqrt((points.rowwise() - quadric.centre.transpose()).rowwise().squaredNorm().mean());
  using Row = Eigen::Matrix<double, 10, 1>;
  Eigen::Matrix<double, 10, 10> normal = Eigen::Matrix<double, 10, 10>::Zero();
  Row right = Row::Zero();
  for (Index i = 0; i < points.rows(); ++i) {
    const Vector3d x = (points.row(i).transpose() - quadric.centre) / quadric.scaleMm, n = normals.row(i);
    Row value, slope;
    value << 1, x, x.cwiseProduct(x), x.x() * x.y(), x.y() * x.z(), x.z() * x.x();
    slope << 0, n, 2 * n.cwiseProduct(x), n.x() * x.y() + x.x() * n.y(), n.y() * x.z() + x.y() * n.z(),
        n.z() * x.x() + x.z() * n.x();
    // Slopes are by scaled length and weigh as much as values: a quarter of the size for each.
    normal += value * value.transpose() + slope * slope.transpose() / 16;
    right += slope * quadric.scaleMm / 16;
  }
  normal.diagonal().array() += 1e-12 * normal.trace();
  quadric.a = normal.ldlt().solve(right);
  return quadric;
}

/// Which cells of the next lattice hold more residual than the noise explains, over windows of cells.
std::vector<char> cellsToRefine(const RbfLattice& next, const Points& feet, const VectorXd& residual,
                                double noiseMm) {
  std::vector<double> sum(next.nodes(), 0.0);
  std::vector<int> count(next.nodes(), 0);
  std::vector<int> filled;
  for (Index i = 0; i < feet.rows(); ++i) {
    const Vector3i c = next.coordinates(feet.row(i)).array().floor().cast<int>();
    const auto cell = static_cast<std::size_t>(next.node(c.x(), c.y(), c.z()));
    if (count[cell]++ == 0) filled.push_back(static_cast<int>(cell));
    sum[cell] += residual[i];
  }
  std::vector<char> flags(next.nodes(), 0);
  const double variance = noiseMm * noiseMm;
  forEachChunk(filled.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      double energy = 0, cells = 0;
      for (int z = -kWindow; z <= kWindow; ++z)
        for (int y = -kWindow; y <= kWindow; ++y)
          for (int x = -kWindow; x <= kWindow; ++x) {
            const auto cell = static_cast<std::size_t>(filled[k] + next.node(x, y, z));
            if (count[cell] == 0) continue;
            energy += sum[cell] * sum[cell] / count[cell];
            ++cells;
          }
      if (energy > variance * (kSlack * cells + kSigmas * std::sqrt(2 * cells)))
        flags[static_cast<std::size_t>(filled[k])] = 1;
    }
  });
  return flags;
}

/// Nodes near the points in flagged cells and in the cells beside those; all points' where `flags` is empty.
std::vector<char> nodesNear(const RbfLattice& lattice, const Points& points, const std::vector<char>& flags,
                            double band) {
  std::vector<char> nodes(lattice.nodes(), 0);
  for (Index i = 0; i < points.rows(); ++i) {
    const Vector3d place = lattice.coordinates(points.row(i));
    const Vector3i cell = place.array().floor().cast<int>();
    bool wanted = flags.empty();
    for (int z = -1; z <= 1 && !wanted; ++z)
      for (int y = -1; y <= 1 && !wanted; ++y)
        for (int x = -1; x <= 1 && !wanted; ++x)
          wanted =
              flags[static_cast<std::size_t>(lattice.node(cell.x() + x, cell.y() + y, cell.z() + z))] != 0;
    if (!wanted) continue;
    for (int z = -2; z <= 3; ++z)
      for (int y = -2; y <= 3; ++y)
        for (int x = -2; x <= 3; ++x) {
          const Vector3i at = cell + Vector3i(x, y, z);
          if ((place - at.cast<double>()).squaredNorm() <= band * band)
            nodes[static_cast<std::size_t>(lattice.node(at.x(), at.y(), at.z()))] = 1;
        }
  }
  return nodes;
}

/// The function so far at each point.
struct Fitted {
  VectorXd value;
  Points gradient;

  /// The function's own normals, or the given ones where it has turned away from them.
  [[nodiscard]] Points normals(const Points& given) const {
    constexpr double kTurned = 0.5;  // cosine
    Points result = given;
    for (Index i = 0; i < given.rows(); ++i) {
      const Vector3d own = gradient.row(i).transpose().stableNormalized();
      if (own.dot(given.row(i).transpose()) > kTurned) result.row(i) = own.transpose();
    }
    return result;
  }
  /// Nearest places of the zero, to first order.
  [[nodiscard]] Points feet(const Points& points) const {
    return points -
           (gradient.array().colwise() * (value.array() / gradient.rowwise().squaredNorm().array().max(0.06)))
               .matrix();
  }
  /// Of the points from the zero, to first order, mm.
  [[nodiscard]] VectorXd distances() const {
    constexpr double kFlattest = 0.25;
    return value.cwiseQuotient(gradient.rowwise().norm().cwiseMax(kFlattest));
  }
};

Fitted evaluate(const RbfFunction::Quadric& quadric, const Points& points) {
  Fitted fitted{VectorXd(points.rows()), Points(points.rows(), 3)};
  for (Index i = 0; i < points.rows(); ++i) {
    const Jet jet = quadric.jet(points.row(i));
    fitted.value[i] = jet.value;
    fitted.gradient.row(i) = jet.gradient.transpose();
  }
  return fitted;
}

void add(const RbfLattice& level, const Points& points, Fitted& fitted) {
  forEachChunk(static_cast<std::size_t>(points.rows()), kChunk, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) {
      Vector3d gradient = fitted.gradient.row(i);
      level.addSlope(points.row(i), fitted.value[i], gradient);
      fitted.gradient.row(i) = gradient.transpose();
    }
  });
}

/// Solves for a level's coefficients and adds the level to what there is. What the penalty has kept from the
/// residual is given to it again ("twicing", Tukey 1977): long waves come through whole, the noise's short
/// ones hardly more than before.
RbfLevelReport fitLevel(RbfLattice& lattice, const Points& points, const Points& normals, Fitted& fitted,
                        const RbfLevelPlan& plan) {
  const RbfSystem system(lattice, points, normals, plan);
  RbfLevelReport report{lattice.step(), std::ssize(lattice.centres())};
  VectorXd coefficients = VectorXd::Zero(report.functions);
  constexpr int kPasses = 2;
  for (int pass = 0; pass < kPasses; ++pass) {
    RbfWanted missing{-fitted.value, VectorXd(points.rows())};
    for (Index i = 0; i < points.rows(); ++i)
      missing.slope[i] = 1 - normals.row(i).dot(fitted.gradient.row(i));
    const RbfSystem::Solution solution = system.solve(missing, kTolerance, kMostIterations);
    report.iterations += solution.iterations;
    report.converged = report.converged && solution.converged;
    lattice.setCoefficients(solution.coefficients);
    add(lattice, points, fitted);
    coefficients += solution.coefficients;
  }
  lattice.setCoefficients(coefficients);
  return report;
}

double rms(const VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

}  // namespace

RbfFitResult fitRbf(const Points& points, const Points& normals, const RbfFitPlan& plan,
                    const Progress& progress) {
  checkPoints(points, normals);
  RbfFitResult result;
  progress.report(0, "Spacing and noise of the points");
  const KdTree tree(points);
  result.spacingMm = pointSpacing(points, tree);
  if (!(result.spacingMm > 0))
    throw InputError("more than half of the points lie in the same places; remove the copies");
  result.noiseMm = plan.noiseMm > 0 ? plan.noiseMm : pointNoise(points, tree);

  const auto box = boundingBox(points);
  const Vector3d low = box.row(0), high = box.row(1);
  const double extent = (high - low).maxCoeff();
  double finest = plan.finestMm > 0 ? plan.finestMm : kFinestPerSpacing * result.spacingMm;
  finest = std::max(finest, std::cbrt((high - low).array().max(finest).prod() / kMostNodes));
  const double coarsest = plan.coarsestMm > 0 ? plan.coarsestMm : extent / 8;
  const int levels = std::max(1, 1 + static_cast<int>(std::ceil(std::log2(coarsest / finest) - 0.01)));

  // The given normals say where outside is; along the function's own ones its slope is to be 1.
  RbfFunction::Quadric quadric = fitQuadric(points, normals);
  quadric = fitQuadric(points, evaluate(quadric, points).normals(normals));
  Fitted fitted = evaluate(quadric, points);
  std::vector<RbfLattice> lattices;
  for (int l = 0; l < levels; ++l) {
    const double step = finest * std::exp2(levels - 1 - l);
    progress.report((l + 0.1) / (levels + 0.1), "Fitting radial basis functions");
    const bool fine = step < kFineSteps * finest;
    RbfLattice lattice(low, high, step, RbfKernel{fine ? 0 : RbfKernel::kEvenShare});
    const std::vector<char> flags =
        l == 0 ? std::vector<char>{}
               : cellsToRefine(lattice, fitted.feet(points), fitted.distances(), result.noiseMm);
    lattice.use(nodesNear(lattice, points, flags, fine ? kFineCentreBand : kCentreBand));
    if (lattice.centres().empty()) break;
    // Waves of `cutoff` steps are halved: one unit of area has 1 / spacing^2 points and a band of
    // kBandSteps steps of charged cells.
    const double wave = plan.cutoff * step / (2 * std::numbers::pi);
    const double penalty = std::pow(wave, 6) / (result.spacingMm * result.spacingMm * kBandSteps * step);
    result.levels.push_back(
        fitLevel(lattice, points, fitted.normals(normals), fitted, {kSlopeWeight * step, penalty}));
    result.levels.back().rmsMm = rms(fitted.distances());
    lattices.push_back(std::move(lattice));
  }
  result.residual = fitted.distances();
  result.function = RbfFunction(quadric, std::move(lattices));
  progress.report(1, "Fitting radial basis functions");
  return result;
}

}  // namespace falciform

#include "Logic/Geometry/RbfSystem.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/RbfKernel.h"
#include "Logic/Geometry/RbfStiffness.h"

namespace falciform {

namespace {

constexpr int kReach = RbfLattice::kReach;
constexpr std::size_t kChunk = 512;
/// Third derivatives are charged in cells whose middle is within so many steps of a point.
constexpr double kBand = 1.25;
/// Added to the diagonal, as a share of its mean: functions that nothing holds.
constexpr double kRidge = 1e-7;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

RbfSystem::RbfSystem(const RbfLattice& lattice, const Points& points, const Points& normals,
                     const RbfLevelPlan& plan)
    : lattice_(lattice), slopeWeight2_(plan.slopeWeightMm * plan.slopeWeightMm) {
  constexpr int overlap = 2 * kReach - 1;
  const Vector3i counts = lattice.counts();
  largestShift_ = lattice.node(overlap, overlap, overlap);
  slotOf_.assign(at(2 * largestShift_ + 1), -1);
  for (int z = -overlap; z <= overlap; ++z)
    for (int y = -overlap; y <= overlap; ++y) {
      const double left = 4 * kReach * kReach - y * y - z * z;
      if (!(left > 0)) continue;
      const int half = std::min(overlap, static_cast<int>(std::ceil(std::sqrt(left))) - 1);
      const int first = y * counts.x() + z * counts.x() * counts.y() - half;
      runs_.push_back({first, 2 * half + 1, width_});
      for (int x = 0; x <= 2 * half; ++x) slotOf_[at(first + x + largestShift_)] = width_++;
    }
  rowOf_.assign(lattice.nodes(), -1);
  planeRow_.assign(at(counts.z()) + 1, 0);
  const std::vector<int>& centres = lattice.centres();
  for (std::size_t k = 0; k < centres.size(); ++k) {
    rowOf_[at(centres[k])] = static_cast<int>(k);
    ++planeRow_[at(lattice.coordinatesOf(centres[k]).z()) + 1];
  }
  for (std::size_t z = 1; z < planeRow_.size(); ++z) planeRow_[z] += planeRow_[z - 1];
  matrix_.assign(centres.size() * at(width_), 0.0);

  listEntries(points, normals);
  listPlanes(points);
  const double h = lattice.step();
  listStencils(plan.penalty / (h * h * h));  // third derivatives squared, times a cell
  forEachChunk(at(counts.z()), 1, [&](std::size_t plane, std::size_t) {
    if (planeRow_[plane] == planeRow_[plane + 1]) return;
    addSamples(static_cast<int>(plane));
    addCells(static_cast<int>(plane));
  });
  mirror();
}

/// Which functions reach each point, with value and slope there.
void RbfSystem::listEntries(const Points& points, const Points& normals) {
  const auto count = static_cast<std::size_t>(points.rows());
  const RbfKernel& kernel = lattice_.kernel();
  const double perStep = 1 / lattice_.step();
  std::vector<std::vector<Entry>> chunks((count + kChunk - 1) / kChunk);
  entryBegin_.assign(count + 1, 0);
  forEachChunk(count, kChunk, [&](std::size_t begin, std::size_t end) {
    std::vector<Entry>& list = chunks[begin / kChunk];
    for (std::size_t i = begin; i < end; ++i) {
      const Vector3d place = lattice_.coordinates(points.row(static_cast<Index>(i)));
      const Vector3d normal = normals.row(static_cast<Index>(i));
      const std::size_t before = list.size();
      if (lattice_.holds(place)) {
        const Vector3i cell = place.array().floor().cast<int>();
        for (int z = cell.z() + 1 - kReach; z <= cell.z() + kReach; ++z)
          for (int y = cell.y() + 1 - kReach; y <= cell.y() + kReach; ++y)
            for (int x = cell.x() + 1 - kReach; x <= cell.x() + kReach; ++x) {
              const int node = lattice_.node(x, y, z);
              if (rowOf_[at(node)] < 0) continue;
              const Vector3d offset = place - Vector3d(x, y, z);
              const double r = offset.norm();
              if (r >= kReach) continue;
              list.push_back({node, static_cast<float>(kernel.value(r)),
                              static_cast<float>(2 * kernel.first(r) * perStep * offset.dot(normal))});
            }
      }
      entryBegin_[i + 1] = list.size() - before;
    }
  });
  for (std::size_t i = 0; i < count; ++i) entryBegin_[i + 1] += entryBegin_[i];
  entries_.reserve(entryBegin_.back());
  for (const auto& list : chunks) entries_.insert(entries_.end(), list.begin(), list.end());
}

/// The points that something reaches, by plane of the lattice, and the cells near them.
void RbfSystem::listPlanes(const Points& points) {
  const auto count = static_cast<std::size_t>(points.rows());
  const Vector3i counts = lattice_.counts();
  pointsInPlane_.assign(at(counts.z()), {});
  charged_.assign(lattice_.nodes(), 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (entryBegin_[i] == entryBegin_[i + 1]) continue;
    const Vector3d place = lattice_.coordinates(points.row(static_cast<Index>(i)));
    const Vector3i cell = place.array().floor().cast<int>();
    pointsInPlane_[at(cell.z())].push_back(static_cast<int>(i));
    for (int z = cell.z() - 1; z <= cell.z() + 1; ++z)
      for (int y = cell.y() - 1; y <= cell.y() + 1; ++y)
        for (int x = cell.x() - 1; x <= cell.x() + 1; ++x)
          if ((place - Vector3d(x + 0.5, y + 0.5, z + 0.5)).squaredNorm() <= kBand * kBand)
            charged_[at(lattice_.node(x, y, z))] = 1;
  }
}

void RbfSystem::listStencils(double penalty) {
  const RbfCellStiffness cell = rbfCellStiffness(lattice_.kernel());
  const int middle = slotOf_[at(largestShift_)];
  for (const Vector3i& node : cell.nodes) cellShift_.push_back(lattice_.node(node.x(), node.y(), node.z()));
  for (std::size_t a = 0; a < cellShift_.size(); ++a) {
    stencil_.emplace_back(VectorXd::Zero(width_ - middle));
    for (std::size_t b = a; b < cellShift_.size(); ++b)
      if (const int slot = slotOf_[at(cellShift_[b] - cellShift_[a] + largestShift_)]; slot >= 0)
        stencil_[a][slot - middle] = penalty * cell.matrix(static_cast<Index>(a), static_cast<Index>(b));
  }
}

/// Calls body(point, first, end, last) for the points whose functions first to end stand in the plane.
template <class Body>
void RbfSystem::forPointsOf(int plane, Body&& body) const {
  const int perPlane = lattice_.node(0, 0, 1), last = lattice_.counts().z() - 1;
  for (int z = std::max(0, plane - kReach); z <= std::min(last, plane + kReach - 1); ++z)
    for (const int i : pointsInPlane_[at(z)]) {
      const Entry *begin = entries_.data() + entryBegin_[at(i)],
                  *end = entries_.data() + entryBegin_[at(i) + 1];
      const auto before = [](const Entry& e, int node) { return e.node < node; };
      const Entry* first = std::lower_bound(begin, end, plane * perPlane, before);
      body(i, first, std::lower_bound(first, end, (plane + 1) * perPlane, before), end);
    }
}

/// The rows of one plane, entries at and right of the diagonal.
void RbfSystem::addSamples(int plane) {
  forPointsOf(plane, [&](int, const Entry* a, const Entry* end, const Entry* last) {
    for (; a != end; ++a) {
      double* values = &matrix_[at(rowOf_[at(a->node)]) * at(width_)];
      const int* slot = &slotOf_[at(largestShift_ - a->node)];
      const double v = a->value, s = slopeWeight2_ * a->slope;
      for (const Entry* b = a; b != last; ++b) values[slot[b->node]] += v * b->value + s * b->slope;
    }
  });
}

VectorXd RbfSystem::rightSide(const RbfWanted& wanted) const {
  VectorXd right = VectorXd::Zero(std::ssize(lattice_.centres()));
  forEachChunk(pointsInPlane_.size(), 1, [&](std::size_t plane, std::size_t) {
    if (planeRow_[plane] == planeRow_[plane + 1]) return;
    forPointsOf(static_cast<int>(plane), [&](int i, const Entry* a, const Entry* end, const Entry*) {
      for (; a != end; ++a)
        right[rowOf_[at(a->node)]] += a->value * wanted.value[i] + slopeWeight2_ * a->slope * wanted.slope[i];
    });
  });
  return right;
}

/// The charge of the cells around each node of a plane.
void RbfSystem::addCells(int plane) {
  const int middle = slotOf_[at(largestShift_)];
  for (int row = planeRow_[at(plane)]; row < planeRow_[at(plane) + 1]; ++row) {
    const int node = lattice_.centres()[at(row)];
    Eigen::Map<VectorXd> values(&matrix_[at(row) * at(width_) + at(middle)], width_ - middle);
    for (std::size_t a = 0; a < cellShift_.size(); ++a)
      if (charged_[at(node - cellShift_[a])] != 0) values += stencil_[a];
  }
}

void RbfSystem::mirror() {
  const std::vector<int>& centres = lattice_.centres();
  double trace = 0;
  const int middle = slotOf_[at(largestShift_)];
  for (std::size_t k = 0; k < centres.size(); ++k) trace += matrix_[k * at(width_) + at(middle)];
  const double ridge = kRidge * trace / std::max(1.0, static_cast<double>(centres.size()));
  forEachChunk(centres.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      double* row = &matrix_[k * at(width_)];
      for (const Run& run : runs_)
        for (int x = 0; x < run.length && run.shift + x < 0; ++x) {
          const int other = rowOf_[at(centres[k] + run.shift + x)];
          const int opposite = slotOf_[at(largestShift_ - run.shift - x)];
          row[run.begin + x] = other < 0 ? 0 : matrix_[at(other) * at(width_) + at(opposite)];
        }
      row[middle] += ridge;
    }
  });
}

VectorXd RbfSystem::times(const VectorXd& x, std::vector<double>& onNodes) const {
  const std::vector<int>& centres = lattice_.centres();
  for (std::size_t k = 0; k < centres.size(); ++k) onNodes[at(centres[k])] = x[static_cast<Index>(k)];
  VectorXd y(x.size());
  forEachChunk(centres.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const double* row = &matrix_[k * at(width_)];
      double sum = 0;
      for (const Run& run : runs_) {
        const double *a = row + run.begin, *b = &onNodes[at(centres[k] + run.shift)];
        for (int n = 0; n < run.length; ++n) sum += a[n] * b[n];
      }
      y[static_cast<Index>(k)] = sum;
    }
  });
  return y;
}

RbfSystem::Solution RbfSystem::solve(const RbfWanted& wanted, double tolerance, int mostIterations) const {
  Solution solution;
  VectorXd residual = rightSide(wanted);
  const Index n = residual.size();
  solution.coefficients = VectorXd::Zero(n);
  VectorXd inverse(n);
  const int middle = slotOf_[at(largestShift_)];
  for (Index k = 0; k < n; ++k)
    inverse[k] = 1 / std::max(matrix_[static_cast<std::size_t>(k) * at(width_) + at(middle)], 1e-300);
  std::vector<double> onNodes(lattice_.nodes(), 0.0);
  VectorXd z = inverse.cwiseProduct(residual), direction = z;
  double rho = residual.dot(z);
  const double enough = tolerance * tolerance * rho;
  solution.converged = !(rho > 0);
  while (!solution.converged && solution.iterations < mostIterations) {
    const VectorXd image = times(direction, onNodes);
    const double step = rho / direction.dot(image);
    solution.coefficients += step * direction;
    residual -= step * image;
    z = inverse.cwiseProduct(residual);
    const double next = residual.dot(z);
    direction = z + (next / rho) * direction;
    rho = next;
    ++solution.iterations;
    solution.converged = rho <= enough;
  }
  return solution;
}

}  // namespace falciform

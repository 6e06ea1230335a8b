#include "Logic/Deformation/Normalisation/LevelFit.h"

#include <array>
#include <cmath>
#include <vector>

#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

using Row = Similarity::Row;
using Rows = std::vector<Row>;

/// Sums over samples are made in this many parts, whatever the number of threads, and added up in order.
constexpr std::size_t kParts = 16;

class Level {
 public:
  Level(const Similarity& similarity, const Points& places, BasisWarp& warp, const LevelPlan& plan)
      : similarity_(similarity),
        places_(places),
        warp_(warp),
        plan_(plan),
        count_(static_cast<std::size_t>(places.rows())) {}

  void fit(const Progress& progress) {
    double cost = similarity_.linearise(places_, off_, slope_);
    chooseCentres();
    if (active_.empty()) return;
    weigh();
    for (int step = 0; step < plan_.steps; ++step) {
      progress.report(static_cast<double>(step) / plan_.steps);
      const Points before = warp_.coefficients;
      const Rows change = solve();
      double share = 1, now = cost;
      for (int attempt = 0; attempt < 3; ++attempt, share /= 2) {
        warp_.coefficients = before;
        for (std::size_t k = 0; k < active_.size(); ++k)
          warp_.coefficients.row(active_[k]) += share * change[k].head<3>().transpose().cast<double>();
        warp_.limitCompression(plan_.compressionLimit);
        now = similarity_.linearise(moved(), off_, slope_);
        if (now < cost) break;
      }
      if (now >= cost) {
        warp_.coefficients = before;
        break;
      }
      if (cost - now < plan_.leastGain * std::abs(cost)) break;
      cost = now;
    }
  }

 private:
  [[nodiscard]] Points moved() const {
    Points places = places_;
    Rows c(active_.size(), Row::Zero());
    for (std::size_t k = 0; k < active_.size(); ++k)
      c[k].head<3>() = warp_.coefficients.row(active_[k]).transpose().cast<float>();
    forEachPart([&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Row shift = Row::Zero();
        for (std::size_t e = start_[i]; e < start_[i + 1]; ++e)
          shift += weight_[e] * c[static_cast<std::size_t>(column_[e])];
        places.row(static_cast<Index>(i)) += shift.head<3>().transpose().cast<double>();
      }
    });
    return places;
  }

  template <class Body>
  void forEachPart(Body&& body) const {
    forEachChunk(kParts, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t part = first; part < last; ++part)
        body(part, count_ * part / kParts, count_ * (part + 1) / kParts);
    });
  }

  void chooseCentres() {
    const auto centres = static_cast<std::size_t>(warp_.centres());
    std::vector<std::vector<std::array<float, 2>>> parts(kParts);
    forEachPart([&](std::size_t part, std::size_t begin, std::size_t end) {
      parts[part].assign(centres, {0, 0});
      for (std::size_t i = begin; i < end; ++i) {
        const bool seen = !slope_[i].isZero(0);
        if (!seen) continue;
        warp_.forEachBasis(places_.row(static_cast<Index>(i)).transpose(),
                           [&](Index centre, const Vector3d& away) {
                             const auto w = static_cast<float>(wu(away.norm()));
                             auto& sums = parts[part][static_cast<std::size_t>(centre)];
                             sums[0] += w;
                             sums[1] += w * off_[i] * off_[i];
                           });
      }
    });
    double all = 0;
    for (const float off : off_) all += double(off) * off;
    const double least = std::max(
        plan_.idle, plan_.idleShare * std::sqrt(all / std::max<double>(1, static_cast<double>(count_))));
    numberOf_.assign(centres, -1);
    for (std::size_t c = 0; c < centres; ++c) {
      double weight = 0, squares = 0;
      for (const auto& part : parts) {
        weight += part[c][0];
        squares += part[c][1];
      }
      if (weight < 0.5 || squares < least * least * weight) continue;
      numberOf_[c] = static_cast<int>(active_.size());
      active_.push_back(static_cast<Index>(c));
    }
  }

  void weigh() {
    start_.assign(count_ + 1, 0);
    const auto visit = [&](std::size_t i, auto&& use) {
      warp_.forEachBasis(places_.row(static_cast<Index>(i)).transpose(),
                         [&](Index centre, const Vector3d& away) {
                           const int column = numberOf_[static_cast<std::size_t>(centre)];
                           if (column >= 0) use(column, away);
                         });
    };
    forEachPart([&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) visit(i, [&](int, const Vector3d&) { ++start_[i + 1]; });
    });
    for (std::size_t i = 0; i < count_; ++i) start_[i + 1] += start_[i];
    column_.resize(start_.back());
    weight_.resize(start_.back());
    forEachPart([&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        std::size_t e = start_[i];
        visit(i, [&](int column, const Vector3d& away) {
          column_[e] = column;
          weight_[e++] = static_cast<float>(wu(away.norm()));
        });
      }
    });
  }

  /// sum_i W_ik slope_i a_i, a_i from `factor`.
  template <class Factor>
  [[nodiscard]] Rows gather(Factor&& factor) const {
    std::vector<Rows> parts(kParts);
    forEachPart([&](std::size_t part, std::size_t begin, std::size_t end) {
      Rows& sum = parts[part];
      sum.assign(active_.size(), Row::Zero());
      for (std::size_t i = begin; i < end; ++i) {
        const Row pull = factor(i) * slope_[i];
        for (std::size_t e = start_[i]; e < start_[i + 1]; ++e)
          sum[static_cast<std::size_t>(column_[e])] += weight_[e] * pull;
      }
    });
    for (std::size_t part = 1; part < kParts; ++part)
      for (std::size_t k = 0; k < active_.size(); ++k) parts[0][k] += parts[part][k];
    return parts[0];
  }

  [[nodiscard]] std::vector<float> diagonal() const {
    std::vector<std::vector<float>> parts(kParts);
    forEachPart([&](std::size_t part, std::size_t begin, std::size_t end) {
      parts[part].assign(active_.size(), 0);
      for (std::size_t i = begin; i < end; ++i) {
        const float slope = slope_[i].squaredNorm() / 3;
        for (std::size_t e = start_[i]; e < start_[i + 1]; ++e)
          parts[part][static_cast<std::size_t>(column_[e])] += slope * weight_[e] * weight_[e];
      }
    });
    for (std::size_t part = 1; part < kParts; ++part)
      for (std::size_t k = 0; k < active_.size(); ++k) parts[0][k] += parts[part][k];
    return parts[0];
  }

  /// Conjugate gradients on (J^T J + price) x = -J^T off - price c.
  [[nodiscard]] Rows solve() const {
    const std::vector<float> diagonal = this->diagonal();
    const std::size_t n = active_.size();
    double mean = 0;
    for (const float d : diagonal) mean += d / static_cast<double>(n);
    const auto price = static_cast<float>(plan_.damping * mean);
    Rows rest = gather([&](std::size_t i) { return -off_[i]; });
    for (std::size_t k = 0; k < n; ++k)
      rest[k].head<3>() -= price * warp_.coefficients.row(active_[k]).transpose().cast<float>();
    Rows x(n, Row::Zero()), direction(n);
    const auto energyOf = [&] {
      double energy = 0;
      for (std::size_t k = 0; k < n; ++k) energy += double(rest[k].squaredNorm()) / (diagonal[k] + price);
      return energy;
    };
    for (std::size_t k = 0; k < n; ++k) direction[k] = rest[k] / (diagonal[k] + price);
    double energy = energyOf();
    const double enough = plan_.innerTolerance * energy;
    std::vector<float> along(count_);
    for (int step = 0; step < plan_.innerSteps && energy > enough; ++step) {
      forEachPart([&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          Row sum = Row::Zero();
          for (std::size_t e = start_[i]; e < start_[i + 1]; ++e)
            sum += weight_[e] * direction[static_cast<std::size_t>(column_[e])];
          along[i] = sum.dot(slope_[i]);
        }
      });
      Rows product = gather([&](std::size_t i) { return along[i]; });
      double curvature = 0;
      for (std::size_t k = 0; k < n; ++k) {
        product[k] += price * direction[k];
        curvature += double(direction[k].dot(product[k]));
      }
      const auto share = static_cast<float>(energy / curvature);
      for (std::size_t k = 0; k < n; ++k) {
        x[k] += share * direction[k];
        rest[k] -= share * product[k];
      }
      const double next = energyOf();
      const auto keep = static_cast<float>(next / energy);
      for (std::size_t k = 0; k < n; ++k)
        direction[k] = rest[k] / (diagonal[k] + price) + keep * direction[k];
      energy = next;
    }
    return x;
  }

  const Similarity& similarity_;
  const Points& places_;
  BasisWarp& warp_;
  const LevelPlan& plan_;
  std::size_t count_;
  std::vector<float> off_;
  Rows slope_;
  std::vector<int> numberOf_;
  std::vector<Index> active_;
  std::vector<std::size_t> start_;
  std::vector<int> column_;
  std::vector<float> weight_;
};

}  // namespace

BasisWarp fitLevel(const Similarity& similarity, const Points& places, BasisWarp lattice,
                   const LevelPlan& plan, const Progress& progress) {
  Level(similarity, places, lattice, plan).fit(progress);
  return lattice;
}

}  // namespace falciform

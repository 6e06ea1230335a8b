#include "Logic/Deformation/Cohort/GroupComparison.h"

#include <algorithm>
#include <map>

namespace falciform {

namespace {

/// Which pairs count as out-group.
enum class Against {
  Members,  ///< those with one case of the labelled group
  All       ///< all that are not of one label
};

/// The correlations in and out of the labelled groups. Labels below 0: in no group.
struct Pairs {
  std::vector<double> in, out;
};

Pairs pairsOf(const Eigen::MatrixXd& c, const std::vector<int>& labels, Against against) {
  Pairs pairs;
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double value = c(static_cast<Index>(i), static_cast<Index>(j));
      if (labels[i] >= 0 && labels[i] == labels[j])
        pairs.in.push_back(value);
      else if (against == Against::All || labels[i] >= 0 || labels[j] >= 0)
        pairs.out.push_back(value);
    }
  return pairs;
}

/// In-group mean less out-group mean, in as many steps as there are cases times those in groups: the sums of
/// the rows are taken once.
class MeanDifference {
 public:
  MeanDifference(const Eigen::MatrixXd& correlation, Against against, const Pairs& pairs)
      : c_(correlation),
        rows_(correlation.rowwise().sum() - correlation.diagonal()),
        all_(rows_.sum() / 2),
        against_(against),
        in_(static_cast<double>(pairs.in.size())),
        out_(static_cast<double>(pairs.out.size())) {}

  double operator()(const std::vector<int>& labels) const {
    double in = 0, members = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (labels[i] < 0) continue;
      members += rows_[static_cast<Index>(i)];
      for (std::size_t j = 0; j < i; ++j)
        if (labels[j] == labels[i]) in += c_(static_cast<Index>(i), static_cast<Index>(j));
    }
    // A row of a member holds each pair in the group a second time.
    const double out = against_ == Against::All ? all_ - in : members - 2 * in;
    return in / in_ - out / out_;
  }

 private:
  const Eigen::MatrixXd& c_;
  VectorXd rows_;
  double all_;
  Against against_;
  double in_, out_;
};

/// Arrangements that give the same pairs: groups of one size may change names.
double renamings(const std::vector<int>& labels) {
  std::map<int, int> sizes, groupsOfSize;
  for (const int label : labels)
    if (label >= 0) ++sizes[label];
  double product = 1;
  for (const auto& [label, size] : sizes) product *= ++groupsOfSize[size];
  return product;
}

GroupComparison compare(const Cohort& cohort, const std::vector<int>& labels, Against against,
                        const PermutationSettings& settings, const Progress& progress) {
  const Pairs pairs = pairsOf(cohort.correlation, labels, against);
  GroupComparison result;
  result.cases = std::count_if(labels.begin(), labels.end(), [](int label) { return label >= 0; });
  result.inGroup = sampleMoments(pairs.in);
  result.outGroup = sampleMoments(pairs.out);
  result.pooled = pooledTTest(result.inGroup, result.outGroup);
  result.welch = welchTTest(result.inGroup, result.outGroup);
  if (pairs.in.empty() || pairs.out.empty()) return result;
  result.permutation =
      permuteLabels(labels, MeanDifference(cohort.correlation, against, pairs), settings, progress);
  result.leastP = result.permutation.exact ? renamings(labels) / result.permutation.arrangements
                                           : 1 / static_cast<double>(result.permutation.tried);
  return result;
}

}  // namespace

GroupComparison compareGroup(const Cohort& cohort, int group, const PermutationSettings& settings,
                             const Progress& progress) {
  std::vector<int> labels;
  for (const int label : cohort.groupOf) labels.push_back(label == group ? 0 : -1);
  return compare(cohort, labels, Against::Members, settings, progress);
}

GroupComparison compareAllGroups(const Cohort& cohort, const PermutationSettings& settings,
                                 const Progress& progress) {
  return compare(cohort, cohort.groupOf, Against::All, settings, progress);
}

}  // namespace falciform

#include "Logic/Biomechanics/ReducedStiffness.h"

#include <algorithm>

#include "Logic/Core/Errors.h"

namespace falciform {

ReducedStiffness::ReducedStiffness(const StiffnessMatrix& stiffness, std::vector<NodeConstraint> constraints)
    : nodes_(stiffness.graph.nodes()),
      constraints_(std::move(constraints)),
      constraintOf_(static_cast<std::size_t>(nodes_), -1) {
  for (std::size_t c = 0; c < constraints_.size(); ++c)
    constraintOf_[static_cast<std::size_t>(constraints_[c].node)] = static_cast<int>(c);
  for (std::size_t n = 0; n < constraintOf_.size(); ++n) {
    const int held =
        constraintOf_[n] < 0 ? 0 : constraints_[static_cast<std::size_t>(constraintOf_[n])].count;
    for (int axis = held; axis < 3; ++axis) directions_.push_back(static_cast<std::int64_t>(3 * n) + axis);
  }
  if (directions_.empty())
    throw InputError("the supports hold every node, so nothing can deform; leave some surface free");
  assemble(stiffness);
}

const Matrix3d* ReducedStiffness::frameOf(std::int64_t node) const {
  const int c = constraintOf_[static_cast<std::size_t>(node)];
  return c < 0 ? nullptr : &constraints_[static_cast<std::size_t>(c)].frame;
}

void ReducedStiffness::assemble(const StiffnessMatrix& stiffness) {
  const NodeGraph& graph = stiffness.graph;
  std::vector<std::int64_t> number(static_cast<std::size_t>(3 * nodes_), -1);
  for (std::size_t k = 0; k < directions_.size(); ++k)
    number[static_cast<std::size_t>(directions_[k])] = static_cast<std::int64_t>(k);
  matrix_.begin.reserve(directions_.size() + 1);
  matrix_.begin.push_back(0);
  for (const std::int64_t direction : directions_) {
    const auto i = static_cast<std::size_t>(direction / 3);
    const Index axis = direction % 3;
    const Matrix3d* frameI = frameOf(direction / 3);
    for (std::size_t at = graph.begin[i]; at < graph.begin[i + 1]; ++at) {
      const auto j = static_cast<std::size_t>(graph.neighbours[at]);
      if (j < i) continue;
      // K_ij: this column of the lower triangle holds K_ji, its transpose.
      Eigen::RowVector3d row = frameI == nullptr
                                   ? Eigen::RowVector3d(stiffness.blocks[at].row(axis))
                                   : Eigen::RowVector3d(frameI->row(axis) * stiffness.blocks[at]);
      if (const Matrix3d* frameJ = frameOf(static_cast<std::int64_t>(j)))
        row = (row * frameJ->transpose()).eval();
      for (Index other = j == i ? axis : 0; other < 3; ++other) {
        const std::int64_t place = number[3 * j + static_cast<std::size_t>(other)];
        if (place < 0) continue;
        matrix_.rows.push_back(place);
        matrix_.values.push_back(row[other]);
      }
    }
    matrix_.begin.push_back(static_cast<std::int64_t>(matrix_.rows.size()));
  }
}

std::vector<std::int64_t> ReducedStiffness::order(const NodeGraph& graph,
                                                  const std::vector<char>& last) const {
  std::vector<std::vector<std::int64_t>> ofNode(static_cast<std::size_t>(nodes_));
  std::vector<char> kept(ofNode.size(), 0);
  std::vector<std::int64_t> order, tail;
  for (std::size_t k = 0; k < directions_.size(); ++k) {
    if (!last.empty() && last[k] != 0) {
      tail.push_back(static_cast<std::int64_t>(k));
      continue;
    }
    const auto node = static_cast<std::size_t>(directions_[k] / 3);
    ofNode[node].push_back(static_cast<std::int64_t>(k));
    kept[node] = 1;
  }
  order.reserve(directions_.size());
  for (const int node : nestedDissection(graph, kept))
    for (const std::int64_t k : ofNode[static_cast<std::size_t>(node)]) order.push_back(k);
  order.insert(order.end(), tail.begin(), tail.end());
  return order;
}

void ReducedStiffness::gather(const Points& nodal, Eigen::Ref<VectorXd> variables) const {
  for (std::size_t k = 0; k < directions_.size(); ++k) {
    const std::int64_t node = directions_[k] / 3, axis = directions_[k] % 3;
    const Matrix3d* frame = frameOf(node);
    variables[static_cast<Index>(k)] =
        frame == nullptr ? nodal(node, axis) : frame->row(axis).dot(nodal.row(node));
  }
}

Points ReducedStiffness::scatter(const Eigen::Ref<const VectorXd>& variables) const {
  Points nodal = Points::Zero(nodes_, 3);
  for (std::size_t k = 0; k < directions_.size(); ++k) {
    const std::int64_t node = directions_[k] / 3, axis = directions_[k] % 3;
    const double value = variables[static_cast<Index>(k)];
    const Matrix3d* frame = frameOf(node);
    if (frame == nullptr)
      nodal(node, axis) += value;
    else
      nodal.row(node) += value * frame->row(axis);
  }
  return nodal;
}

Points ReducedStiffness::prescribed() const {
  Points field = Points::Zero(nodes_, 3);
  for (const NodeConstraint& constraint : constraints_)
    for (int k = 0; k < constraint.count; ++k)
      field.row(constraint.node) += constraint.valuesMm[k] * constraint.frame.row(k);
  return field;
}

SparseLower withPlaces(const SparseLower& matrix, std::vector<std::pair<std::int64_t, std::int64_t>> places) {
  std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second < b.second : a.first < b.first;
  });
  SparseLower result{.begin = {0}, .rows = {}, .values = {}};
  auto next = places.begin();
  for (std::int64_t column = 0; column < matrix.size(); ++column) {
    auto at = static_cast<std::size_t>(matrix.begin[static_cast<std::size_t>(column)]);
    const auto end = static_cast<std::size_t>(matrix.begin[static_cast<std::size_t>(column) + 1]);
    const auto zerosBefore = [&](std::int64_t row) {
      for (; next != places.end() && next->second == column && next->first <= row; ++next) {
        if (next->first == row ||
            (!result.rows.empty() && result.begin.back() < static_cast<std::int64_t>(result.rows.size()) &&
             result.rows.back() == next->first))
          continue;
        result.rows.push_back(next->first);
        result.values.push_back(0);
      }
    };
    for (; at < end; ++at) {
      zerosBefore(matrix.rows[at]);
      result.rows.push_back(matrix.rows[at]);
      result.values.push_back(matrix.values[at]);
    }
    zerosBefore(matrix.size());
    result.begin.push_back(static_cast<std::int64_t>(result.rows.size()));
  }
  return result;
}

}  // namespace falciform

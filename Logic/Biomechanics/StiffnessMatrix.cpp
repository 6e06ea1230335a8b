#include "Logic/Biomechanics/StiffnessMatrix.h"

#include <algorithm>
#include <array>
#include <string>

#include "Logic/Biomechanics/ReferenceTetrahedron.h"
#include "Logic/Core/Parallel.h"

namespace falciform {
namespace {

constexpr std::size_t kChunk = 256;

/// Elements around each node, ascending, with the node's place in the element.
struct ElementsOfNodes {
  struct Use {
    int element, place;
  };
  std::vector<std::size_t> begin;
  std::vector<Use> uses;

  explicit ElementsOfNodes(const TetrahedralMesh& mesh)
      : begin(static_cast<std::size_t>(mesh.nodes()) + 1, 0) {
    for (Index e = 0; e < mesh.size(); ++e)
      for (Index k = 0; k < mesh.elements.cols(); ++k)
        ++begin[static_cast<std::size_t>(mesh.elements(e, k)) + 1];
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    uses.resize(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (Index e = 0; e < mesh.size(); ++e)
      for (Index k = 0; k < mesh.elements.cols(); ++k)
        uses[next[static_cast<std::size_t>(mesh.elements(e, k))]++] = {static_cast<int>(e),
                                                                       static_cast<int>(k)};
  }
};

NodeGraph graphFrom(const TetrahedralMesh& mesh, const ElementsOfNodes& around) {
  const auto count = static_cast<std::size_t>(mesh.nodes());
  std::vector<std::vector<int>> lists(count);
  forEachChunk(count, kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      std::vector<int>& list = lists[i];
      for (std::size_t u = around.begin[i]; u < around.begin[i + 1]; ++u)
        for (Index k = 0; k < mesh.elements.cols(); ++k)
          list.push_back(mesh.elements(around.uses[u].element, k));
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
  });
  NodeGraph graph;
  graph.begin.assign(count + 1, 0);
  for (std::size_t i = 0; i < count; ++i) graph.begin[i + 1] = graph.begin[i] + lists[i].size();
  graph.neighbours.reserve(graph.begin.back());
  for (const auto& list : lists) graph.neighbours.insert(graph.neighbours.end(), list.begin(), list.end());
  return graph;
}

/// What an element brings to every block: its shape functions' gradients at the quadrature places.
struct ElementShape {
  std::array<Eigen::Matrix<double, 10, 3, Eigen::RowMajor>, 4> gradients;
  double weight = 0;  ///< mm3 of one quadrature place
  double lambda = 0, mu = 0;
};

std::vector<ElementShape> elementShapes(const TetrahedralMesh& mesh, const std::vector<Material>& materials) {
  std::vector<ElementShape> shapes(static_cast<std::size_t>(mesh.size()));
  const auto& places = quadraturePlaces(mesh.quadratic());
  const int nodes = static_cast<int>(mesh.elements.cols());
  forEachChunk(shapes.size(), kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t e = first; e < last; ++e) {
      ElementShape& shape = shapes[e];
      const auto gradients = barycentricGradients(mesh, static_cast<Index>(e));
      for (std::size_t q = 0; q < places.size(); ++q)
        shape.gradients[q].topRows(nodes) = shapeGradients(places[q], gradients, nodes);
      shape.weight = cornerVolume(mesh, static_cast<Index>(e)) / static_cast<double>(places.size());
      const Material& material = materialOf(materials, mesh.regionOf(static_cast<Index>(e)));
      shape.lambda = lameLambdaMPa(material);
      shape.mu = shearModulusMPa(material);
    }
  });
  return shapes;
}

/// The 3 x 3 block of nodes a and b: the integral of lambda g_a g_b' + mu (g_b g_a' + g_a.g_b I).
Matrix3d block(const ElementShape& shape, std::size_t places, int a, int b) {
  Matrix3d sum = Matrix3d::Zero();
  for (std::size_t q = 0; q < places; ++q)
    sum.noalias() += shape.gradients[q].row(a).transpose() * shape.gradients[q].row(b);
  Matrix3d result = shape.lambda * sum + shape.mu * sum.transpose();
  result.diagonal().array() += shape.mu * sum.trace();
  return shape.weight * result;
}

}  // namespace

NodeGraph nodeGraph(const TetrahedralMesh& mesh) { return graphFrom(mesh, ElementsOfNodes(mesh)); }

StiffnessMatrix assembleStiffness(const TetrahedralMesh& mesh, const std::vector<Material>& materials,
                                  const Progress& progress) {
  checkMesh(mesh, "the mesh");
  for (std::size_t r = 0; r < materials.size(); ++r)
    checkMaterial(materials[r], "region " + std::to_string(r));
  progress.report(0, "Assembling the stiffness");
  const ElementsOfNodes around(mesh);
  StiffnessMatrix stiffness;
  stiffness.graph = graphFrom(mesh, around);
  progress.report(0.4);
  const std::vector<ElementShape> shapes = elementShapes(mesh, materials);
  const std::size_t places = quadraturePlaces(mesh.quadratic()).size();
  const NodeGraph& graph = stiffness.graph;
  stiffness.blocks.assign(graph.neighbours.size(), Matrix3d::Zero());
  // Row by row, each over its elements in order: no two threads write one block, and the sums' order is
  // fixed.
  forEachChunk(static_cast<std::size_t>(mesh.nodes()), kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto from = graph.neighbours.begin() + static_cast<std::ptrdiff_t>(graph.begin[i]);
      const auto to = graph.neighbours.begin() + static_cast<std::ptrdiff_t>(graph.begin[i + 1]);
      for (std::size_t u = around.begin[i]; u < around.begin[i + 1]; ++u) {
        const auto [element, place] = around.uses[u];
        for (int k = 0; k < mesh.elements.cols(); ++k) {
          const int j = mesh.elements(element, k);
          if (j < static_cast<int>(i)) continue;
          const auto slot = std::lower_bound(from, to, j) - graph.neighbours.begin();
          stiffness.blocks[static_cast<std::size_t>(slot)] +=
              block(shapes[static_cast<std::size_t>(element)], places, place, k);
        }
      }
    }
  });
  progress.report(1);
  return stiffness;
}

Matrix3d& StiffnessMatrix::blockOf(int i, int j) {
  const auto row = graph.neighbours.begin();
  const auto from = row + static_cast<std::ptrdiff_t>(graph.begin[static_cast<std::size_t>(i)]);
  const auto to = row + static_cast<std::ptrdiff_t>(graph.begin[static_cast<std::size_t>(i) + 1]);
  return blocks[static_cast<std::size_t>(std::lower_bound(from, to, j) - row)];
}

Points StiffnessMatrix::times(const Points& displacements) const {
  Points forces = Points::Zero(displacements.rows(), 3);
  for (Index i = 0; i < graph.nodes(); ++i)
    for (std::size_t at = graph.begin[static_cast<std::size_t>(i)];
         at < graph.begin[static_cast<std::size_t>(i) + 1]; ++at) {
      const Index j = graph.neighbours[at];
      if (j < i) continue;
      forces.row(i) += displacements.row(j) * blocks[at].transpose();
      if (j > i) forces.row(j) += displacements.row(i) * blocks[at];
    }
  return forces;
}

Points weightForces(const TetrahedralMesh& mesh, const std::vector<Material>& materials,
                    const Vector3d& accelerationMPerS2) {
  Points forces = Points::Zero(mesh.nodes(), 3);
  const bool quadratic = mesh.quadratic();
  for (Index e = 0; e < mesh.size(); ++e) {
    const Vector3d weight =
        cornerVolume(mesh, e) * bodyForce(materialOf(materials, mesh.regionOf(e)), accelerationMPerS2);
    for (int k = 0; k < mesh.elements.cols(); ++k) {
      const double share = !quadratic ? 0.25 : (k < 4 ? -0.05 : 0.2);  // the integral of N_k by the volume
      forces.row(mesh.elements(e, k)) += share * weight.transpose();
    }
  }
  return forces;
}

VectorXd nodalVolumes(const TetrahedralMesh& mesh) {
  VectorXd volumes = VectorXd::Zero(mesh.nodes());
  const auto nodes = mesh.elements.cols();
  for (Index e = 0; e < mesh.size(); ++e)
    for (Index k = 0; k < nodes; ++k)
      volumes[mesh.elements(e, k)] += cornerVolume(mesh, e) / static_cast<double>(nodes);
  return volumes;
}

}  // namespace falciform

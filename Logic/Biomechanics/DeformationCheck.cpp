#include "Logic/Biomechanics/DeformationCheck.h"

#include <algorithm>
#include <limits>

#include "Logic/Biomechanics/ReferenceTetrahedron.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"

namespace falciform {
namespace {

constexpr std::size_t kChunk = 256;  // elements

/// Where the gradient is looked at: quadrature points, and the corners, where a quadratic field is extreme.
std::vector<Eigen::Vector4d> places(bool quadratic) {
  std::vector<Eigen::Vector4d> result = quadraturePlaces(quadratic);
  if (quadratic)
    for (int k = 0; k < 4; ++k) result.push_back(Eigen::Vector4d::Unit(k));
  return result;
}

/// Column-major 3 x 3 blocks, one a field: entry (i, j) is the derivative of displacement j along i.
using Gradients = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;

double determinantOf(const Gradients& gradients, const FieldSum& sum) {
  Matrix3d f = Matrix3d::Identity();
  for (const auto& [field, factor] : sum)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) f(i, j) += factor * gradients(i, 3 * field + j);
  return f.determinant();
}

/// One chunk's answers; `volume` mm3 seen and folded in `foldedShare` until all are put together.
struct Part {
  std::vector<DeformationCheck> checks;
  double volume = 0;
};

Part checkElements(const TetrahedralMesh& mesh, const std::vector<Points>& fields,
                   const std::vector<FieldSum>& sums, std::size_t first, std::size_t last) {
  const std::vector<Eigen::Vector4d> where = places(mesh.quadratic());
  const auto nodes = static_cast<int>(mesh.elements.cols());
  Part part{.checks = std::vector<DeformationCheck>(sums.size(),
                                                    {.minDetJ = std::numeric_limits<double>::infinity()})};
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> local(
      nodes, 3 * static_cast<Index>(fields.size()));
  Gradients gradients(3, local.cols());
  for (auto e = static_cast<Index>(first); e < static_cast<Index>(last); ++e) {
    for (int n = 0; n < nodes; ++n)
      for (std::size_t k = 0; k < fields.size(); ++k)
        local.block<1, 3>(n, 3 * static_cast<Index>(k)) = fields[k].row(mesh.elements(e, n));
    const Eigen::Matrix<double, 4, 3> barycentric = barycentricGradients(mesh, e);
    const double volume = cornerVolume(mesh, e) / static_cast<double>(where.size());
    part.volume += cornerVolume(mesh, e);
    for (const Eigen::Vector4d& place : where) {
      const auto shape = shapeGradients(place, barycentric, nodes);
      gradients.setZero();
      for (int n = 0; n < nodes; ++n)
        for (int i = 0; i < 3; ++i) gradients.row(i) += shape(n, i) * local.row(n);
      for (std::size_t s = 0; s < sums.size(); ++s) {
        const double determinant = determinantOf(gradients, sums[s]);
        DeformationCheck& check = part.checks[s];
        if (determinant <= 0) check.foldedShare += volume;
        if (determinant < check.minDetJ) {
          check.minDetJ = determinant;
          check.worstElement = static_cast<int>(e);
        }
      }
    }
  }
  return part;
}

void needNodes(const TetrahedralMesh& mesh, const Points& field) {
  if (field.rows() != mesh.nodes())
    throw InputError("a deformation has " + std::to_string(field.rows()) + " displacements but the mesh " +
                     std::to_string(mesh.nodes()) + " nodes; they must be of the same mesh");
}

}  // namespace

VectorXd leastDetJ(const TetrahedralMesh& mesh, const Points& displacements) {
  needNodes(mesh, displacements);
  const std::vector<Points> fields{displacements};
  const std::vector<FieldSum> sums{{{0, 1.0}}};
  VectorXd least(mesh.size());
  forEachChunk(static_cast<std::size_t>(mesh.size()), kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t e = first; e < last; ++e)
      least[static_cast<Index>(e)] = checkElements(mesh, fields, sums, e, e + 1).checks.front().minDetJ;
  });
  return least;
}

std::vector<DeformationCheck> checkDeformations(const TetrahedralMesh& mesh,
                                                const std::vector<Points>& fields,
                                                const std::vector<FieldSum>& sums) {
  for (const Points& field : fields) needNodes(mesh, field);
  const auto elements = static_cast<std::size_t>(mesh.size());
  std::vector<Part> parts((elements + kChunk - 1) / kChunk);
  forEachChunk(elements, kChunk, [&](std::size_t first, std::size_t last) {
    parts[first / kChunk] = checkElements(mesh, fields, sums, first, last);
  });
  std::vector<DeformationCheck> result(sums.size(), {.minDetJ = std::numeric_limits<double>::infinity()});
  double volume = 0;
  for (const Part& part : parts) {
    volume += part.volume;
    for (std::size_t s = 0; s < sums.size(); ++s) {
      result[s].foldedShare += part.checks[s].foldedShare;
      if (part.checks[s].minDetJ >= result[s].minDetJ) continue;
      result[s].minDetJ = part.checks[s].minDetJ;
      result[s].worstElement = part.checks[s].worstElement;
    }
  }
  for (DeformationCheck& check : result) check.foldedShare /= volume;
  return result;
}

DeformationCheck checkDeformation(const TetrahedralMesh& mesh, const Points& displacements) {
  return checkDeformations(mesh, {displacements}, {{{0, 1.0}}}).front();
}

}  // namespace falciform

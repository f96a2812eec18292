#include "fem/assembly.h"

#include <vector>

#include "fem/elasticity.h"

namespace fem {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

// Adds the lower triangle of an element matrix with `per_node` unknowns a node.
void scatter(const Eigen::MatrixXd& block, const int* node, int per_node, Triplets& triplets) {
  for (Eigen::Index j = 0; j < block.cols(); ++j)
    for (Eigen::Index i = 0; i < block.rows(); ++i) {
      const int row = per_node * node[i / per_node] + static_cast<int>(i % per_node);
      const int column = per_node * node[j / per_node] + static_cast<int>(j % per_node);
      if (row >= column) triplets.emplace_back(row, column, block(i, j));
    }
}

Eigen::SparseMatrix<double> compress(Eigen::Index size, const Triplets& triplets) {
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

}  // namespace

Eigen::SparseMatrix<double> assemble_stiffness(const Elements& elements, const Steel& steel) {
  const ElasticityMatrix elasticity = elasticity_matrix(steel);
  const GaussPoints& gauss = elements.elastic;
  const int nodes = elements.nodes_per_element();
  const std::size_t entries = 3 * nodes * (3 * nodes + 1) / 2;
  Triplets triplets;
  triplets.reserve(entries * elements.count());
  Eigen::MatrixXd block(3 * nodes, 3 * nodes);
  for (int e = 0; e < elements.count(); ++e) {
    block.setZero();
    for (int q = 0; q < gauss.per_element; ++q) {
      const StrainOperator strain = strain_operator(gauss.gradient_at(e, q));
      const StrainOperator stress = gauss.weight[e * gauss.per_element + q] * elasticity * strain;
      block.noalias() += strain.transpose() * stress;
    }
    scatter(block, &elements.node[static_cast<std::size_t>(e) * nodes], 3, triplets);
  }
  return compress(3 * elements.nodes.cols(), triplets);
}

Eigen::SparseMatrix<double> assemble_mass(const Elements& elements, const Steel& steel) {
  const GaussPoints& gauss = elements.inertial;
  const int nodes = elements.nodes_per_element();
  Triplets triplets;
  for (int e = 0; e < elements.count(); ++e) {
    const auto weight = gauss.weight.segment(e * gauss.per_element, gauss.per_element);
    const Eigen::MatrixXd block =
        steel.density * gauss.value * weight.asDiagonal() * gauss.value.transpose();
    scatter(block, &elements.node[static_cast<std::size_t>(e) * nodes], 1, triplets);
  }
  return compress(elements.nodes.cols(), triplets);
}

}  // namespace fem

#include "fem/stress_recovery.h"

#include <cmath>

#include "fem/elasticity.h"

namespace fem {
namespace {

// Weights (Gauss points a side, nodes a side) of the polynomial through the Gauss points of [0, 1].
Eigen::MatrixXd extrapolation(int degree) {
  if (degree == 1) return Eigen::RowVector2d::Ones();
  const double gauss =
      std::sqrt(3.0);  // nodes at 0, 1/2, 1 lie at -sqrt(3), 0, sqrt(3) of the points
  Eigen::MatrixXd weights(2, 3);
  weights << (1 + gauss) / 2, 0.5, (1 - gauss) / 2,  //
      (1 - gauss) / 2, 0.5, (1 + gauss) / 2;
  return weights;
}

// The same in three directions, first local coordinate fastest.
Eigen::MatrixXd extrapolation_in_space(int degree) {
  const Eigen::MatrixXd line = extrapolation(degree);
  const auto points = line.rows(), nodes = line.cols();
  Eigen::MatrixXd weights(points * points * points, nodes * nodes * nodes);
  for (Eigen::Index p = 0; p < weights.rows(); ++p)
    for (Eigen::Index n = 0; n < weights.cols(); ++n)
      weights(p, n) = line(p % points, n % nodes) * line(p / points % points, n / nodes % nodes) *
                      line(p / (points * points), n / (nodes * nodes));
  return weights;
}

}  // namespace

StressField recover_stress(const Elements& elements, const Steel& steel,
                           const Eigen::VectorXd& displacement) {
  const ElasticityMatrix elasticity = elasticity_matrix(steel);
  const Eigen::MatrixXd to_nodes = extrapolation_in_space(elements.degree);
  const GaussPoints& gauss = elements.superconvergent;
  const int nodes = elements.nodes_per_element();

  StressField sum = StressField::Zero(6, elements.nodes.cols());
  Eigen::VectorXi meeting = Eigen::VectorXi::Zero(elements.nodes.cols());
  Eigen::VectorXd local(3 * nodes);
  StressField at_points(6, gauss.per_element);
  for (int e = 0; e < elements.count(); ++e) {
    const int* node = &elements.node[static_cast<std::size_t>(e) * nodes];
    for (int a = 0; a < nodes; ++a) local.segment<3>(3 * a) = displacement.segment<3>(3 * node[a]);
    for (int q = 0; q < gauss.per_element; ++q)
      at_points.col(q) = elasticity * (strain_operator(gauss.gradient_at(e, q)) * local);
    const StressField at_nodes = at_points * to_nodes;
    for (int a = 0; a < nodes; ++a) {
      sum.col(node[a]) += at_nodes.col(a);
      ++meeting[node[a]];
    }
  }
  return sum * meeting.cast<double>().cwiseInverse().asDiagonal();
}

}  // namespace fem

#include "fem/stress_recovery.h"

#include <cmath>

#include "fem/elasticity.h"

namespace fem {
namespace {

// Gauss points of [-1, 1].
Eigen::VectorXd gauss_points(int count) {
  if (count == 1) return Eigen::VectorXd::Zero(1);
  if (count == 2) return Eigen::Vector2d(-1, 1) / std::sqrt(3.0);
  return Eigen::Vector3d(-1, 0, 1) * std::sqrt(0.6);
}

// Weights (Gauss points, places) of the polynomial through the Gauss points, at places in [-1, 1].
Eigen::MatrixXd interpolation(int count, const Eigen::VectorXd& places) {
  const Eigen::VectorXd gauss = gauss_points(count);
  Eigen::MatrixXd weights = Eigen::MatrixXd::Ones(count, places.size());
  for (int n = 0; n < places.size(); ++n)
    for (int p = 0; p < count; ++p)
      for (int other = 0; other < count; ++other)
        if (other != p) weights(p, n) *= (places[n] - gauss[other]) / (gauss[p] - gauss[other]);
  return weights;
}

// The same from Gauss points to nodes, in three directions, first local coordinate fastest: `first`
// (Gauss points, nodes) along that one, `degree` Gauss points along the others.
Eigen::MatrixXd extrapolation_in_space(const Eigen::MatrixXd& first, int degree) {
  const int across = static_cast<int>(first.rows()), nodes = degree + 1;
  const Eigen::MatrixXd other = interpolation(degree, Eigen::VectorXd::LinSpaced(nodes, -1, 1));
  Eigen::MatrixXd weights(across * degree * degree, nodes * nodes * nodes);
  for (int p = 0; p < weights.rows(); ++p)
    for (int n = 0; n < weights.cols(); ++n)
      weights(p, n) = first(p % across, n % nodes) * other(p / across % degree, n / nodes % nodes) *
                      other(p / (across * degree), n / (nodes * nodes));
  return weights;
}

}  // namespace

StressField recover_stress(const Elements& elements, const Steel& steel,
                           const Eigen::VectorXd& displacement) {
  const ElasticityMatrix elasticity = elasticity_matrix(steel);
  const GaussPoints& gauss = elements.superconvergent;
  const int degree = elements.degree, across = gauss.per_element / (degree * degree);
  const Eigen::VectorXd side = Eigen::VectorXd::LinSpaced(degree + 1, -1, 1);
  const Eigen::MatrixXd to_nodes = extrapolation_in_space(interpolation(across, side), degree);
  const Eigen::MatrixXd pressure_to_nodes = extrapolation_in_space(
      interpolation(across, gauss_points(degree)) * interpolation(degree, side), degree);
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
    const Eigen::RowVectorXd mean = at_points.topRows<3>().colwise().mean();
    at_points.topRows<3>().rowwise() -= mean;
    StressField at_nodes = at_points * to_nodes;
    at_nodes.topRows<3>().rowwise() += mean * pressure_to_nodes;
    for (int a = 0; a < nodes; ++a) {
      sum.col(node[a]) += at_nodes.col(a);
      ++meeting[node[a]];
    }
  }
  return sum * meeting.cast<double>().cwiseInverse().asDiagonal();
}

}  // namespace fem

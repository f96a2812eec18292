#include "fem/loaded_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fem {
namespace {

using Eigen::Index;

// Lagrange polynomials on equidistant points of [0, 1], and their slopes.
Eigen::VectorXd lagrange(int degree, double x) {
  if (degree == 1) return Eigen::Vector2d(1 - x, x);
  return Eigen::Vector3d((1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1));
}
Eigen::VectorXd lagrange_slope(int degree, double x) {
  if (degree == 1) return Eigen::Vector2d(-1, 1);
  return Eigen::Vector3d(4 * x - 3, 4 - 8 * x, 4 * x - 1);
}

// Products first(x) second(y), x fastest.
Eigen::VectorXd products(const Eigen::VectorXd& first, const Eigen::VectorXd& second) {
  const Eigen::MatrixXd table = first * second.transpose();
  return table.reshaped();
}
Eigen::VectorXd shapes(int degree, const Eigen::Vector2d& at) {
  return products(lagrange(degree, at[0]), lagrange(degree, at[1]));
}
Eigen::Matrix<double, 9, 2> geometry_slopes(const Eigen::Vector2d& at) {
  Eigen::Matrix<double, 9, 2> slopes;
  slopes << products(lagrange_slope(2, at[0]), lagrange(2, at[1])),
      products(lagrange(2, at[0]), lagrange_slope(2, at[1]));
  return slopes;
}

// Four-point Gauss rule on [0, 1]: exact to degree 7, so that curvature costs nothing.
struct Gauss {
  double at, weight;
};
std::array<Gauss, 4> gauss_rule() {
  const double root = 2.0 / 7 * std::sqrt(6.0 / 5);
  const double near = std::sqrt(3.0 / 7 - root) / 2, far = std::sqrt(3.0 / 7 + root) / 2;
  const double heavy = (18 + std::sqrt(30.0)) / 72, light = (18 - std::sqrt(30.0)) / 72;
  return {{{0.5 - far, light}, {0.5 - near, heavy}, {0.5 + near, heavy}, {0.5 + far, light}}};
}

}  // namespace

// visit(first face node entry of the quadrilateral, shape functions, place [m], area [m2])
template <typename Visit>
void LoadedFace::for_each_gauss_point(Visit visit) const {
  const auto rule = gauss_rule();
  for (Index k = 0; k < centre_.cols(); ++k)
    for (const Gauss& x : rule)
      for (const Gauss& y : rule) {
        const Eigen::Vector2d at(x.at, y.at);
        const Eigen::Matrix<double, 3, 2> tangents = geometry(k) * geometry_slopes(at);
        const double area = tangents.col(0).cross(tangents.col(1)).norm() * x.weight * y.weight;
        const Eigen::Vector3d place = geometry(k) * shapes(2, at);
        visit(&face_node_[k * per_quadrilateral_], shapes(degree_, at), place, area);
      }
}

LoadedFace::LoadedFace(const FaceTable& table)
    : degree_(table.degree),
      per_quadrilateral_((table.degree + 1) * (table.degree + 1)),
      nodes_(table.node),
      geometry_(table.geometry) {
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  for (const int node : table.node)
    face_node_.push_back(
        static_cast<int>(std::lower_bound(nodes_.begin(), nodes_.end(), node) - nodes_.begin()));

  // Nodes of degree 1 are every other point of the geometry, in both directions.
  const int skip = 2 / degree_;
  places_.resize(3, nodes_.size());
  for (std::size_t i = 0; i < face_node_.size(); ++i) {
    const int local = static_cast<int>(i) % per_quadrilateral_, side = degree_ + 1;
    const int point = skip * (local % side + 3 * (local / side));
    places_.col(face_node_[i]) = geometry(i / per_quadrilateral_).col(point);
  }

  const Index count = geometry_.cols() / 9;
  centre_.resize(3, count);
  reach_.resize(count);
  for (Index k = 0; k < count; ++k) {
    centre_.col(k) = geometry(k).col(4);
    // The corners lie farthest; a tenth more covers the bulge of a quadratic edge.
    reach_[k] = 1.1 * (geometry(k).colwise() - centre_.col(k)).colwise().norm().maxCoeff();
  }

  std::vector<Eigen::Triplet<double>> triplets;
  for_each_gauss_point(
      [&](const int* node, const Eigen::VectorXd& shape, const auto&, double area) {
        for (Index j = 0; j < shape.size(); ++j)
          for (Index i = 0; i < shape.size(); ++i)
            triplets.emplace_back(node[i], node[j], area * (shape[i] * shape[j]));
      });
  mass_.resize(nodes_.size(), nodes_.size());
  mass_.setFromTriplets(triplets.begin(), triplets.end());
}

// The shape functions sum to one. mass_.sum() would do, but it depends in its last bits on where in
// memory the entries begin.
double LoadedFace::area() const {
  double area = 0;
  for (Index column = 0; column < mass_.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(mass_, column); entry; ++entry)
      area += entry.value();
  return area;
}

Eigen::Matrix3Xd LoadedFace::load(
    const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& traction) const {
  Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, nodes_.size());
  for_each_gauss_point([&](const int* node, const Eigen::VectorXd& shape,
                           const Eigen::Vector3d& place, double area) {
    const Eigen::Vector3d share = traction(place) * area;
    for (Index i = 0; i < shape.size(); ++i) force.col(node[i]) += shape[i] * share;
  });
  return force;
}

Eigen::Matrix3Xd LoadedFace::of_body(const Eigen::VectorXd& body) const {
  return body.reshaped(3, body.size() / 3)(Eigen::all, nodes_);
}

Eigen::VectorXd LoadedFace::on_body(const Eigen::Matrix3Xd& face, Index unknowns) const {
  Eigen::VectorXd body = Eigen::VectorXd::Zero(unknowns);
  body.reshaped(3, unknowns / 3)(Eigen::all, nodes_) = face;
  return body;
}

// Gauss-Newton for the least distance; a local coordinate that leaves [0, 1] is held at the end.
LoadedFace::Place LoadedFace::nearest_in(Index quadrilateral, const Eigen::Vector3d& point) const {
  constexpr int most_iterations = 50;
  constexpr double converged = 1e-13;  // change of a local coordinate [-]
  const Geometry surface = geometry(quadrilateral);
  Eigen::Vector2d at(0.5, 0.5);
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Eigen::Vector3d gap = point - surface * shapes(2, at);
    const Eigen::Matrix<double, 3, 2> tangents = surface * geometry_slopes(at);
    Eigen::Matrix2d metric = tangents.transpose() * tangents;
    Eigen::Vector2d pull = tangents.transpose() * gap;
    for (int i = 0; i < 2; ++i)
      if ((at[i] == 0 && pull[i] < 0) || (at[i] == 1 && pull[i] > 0)) {
        metric(0, 1) = metric(1, 0) = 0;
        pull[i] = 0;
      }
    const Eigen::Vector2d step = metric.inverse() * pull;
    const Eigen::Vector2d next = (at + step).cwiseMax(0.0).cwiseMin(1.0);
    const double change = (next - at).cwiseAbs().maxCoeff();
    at = next;
    if (change < converged) break;
  }
  return {quadrilateral, at, (point - surface * shapes(2, at)).norm()};
}

LoadedFace::Place LoadedFace::nearest(const Eigen::Vector3d& point) const {
  Place best{0, {0, 0}, std::numeric_limits<double>::infinity()};
  const Eigen::VectorXd to_centre = (centre_.colwise() - point).colwise().norm();
  Index closest;
  to_centre.minCoeff(&closest);
  best = nearest_in(closest, point);
  for (Index k = 0; k < centre_.cols(); ++k) {
    if (k == closest || to_centre[k] - reach_[k] >= best.distance) continue;
    const Place place = nearest_in(k, point);
    if (place.distance < best.distance) best = place;
  }
  return best;
}

Eigen::SparseMatrix<double> LoadedFace::interpolation(const Eigen::Matrix3Xd& points) const {
  std::vector<Eigen::Triplet<double>> triplets;
  for (Index p = 0; p < points.cols(); ++p) {
    const Place place = nearest(points.col(p));
    const Eigen::VectorXd shape = shapes(degree_, place.at);
    for (Index i = 0; i < shape.size(); ++i)
      triplets.emplace_back(face_node_[place.quadrilateral * per_quadrilateral_ + i], p, shape[i]);
  }
  Eigen::SparseMatrix<double> weights(nodes_.size(), points.cols());
  weights.setFromTriplets(triplets.begin(), triplets.end());
  return weights;
}

}  // namespace fem

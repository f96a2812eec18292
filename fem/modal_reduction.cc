#include "fem/modal_reduction.h"

#include <cmath>
#include <vector>

namespace fem {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

// A matrix per direction, applied to all three: unknown = 3 node + direction.
Sparse in_three_directions(const Sparse& matrix) {
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(3 * matrix.nonZeros());
  for (Index column = 0; column < matrix.outerSize(); ++column)
    for (Sparse::InnerIterator entry(matrix, column); entry; ++entry)
      for (Index direction = 0; direction < 3; ++direction)
        triplets.emplace_back(3 * entry.row() + direction, 3 * column + direction, entry.value());
  Sparse wide(3 * matrix.rows(), 3 * matrix.cols());
  wide.setFromTriplets(triplets.begin(), triplets.end());
  return wide;
}

// Directions x and z of the face nodes farthest along +x, as positions in a vector over the face: a
// shape that mirrors in the plane y = 0 moves there, its partner, which is odd in y, does not.
std::vector<Index> unknowns_on_x(const LoadedFace& face) {
  constexpr double same_place = 1e-6;  // of the distance; far below any element
  const double farthest = face.places().row(0).maxCoeff();
  std::vector<Index> unknowns;
  for (Index node = 0; node < face.places().cols(); ++node)
    if (face.places()(0, node) > (1 - same_place) * farthest)
      unknowns.insert(unknowns.end(), {3 * node, 3 * node + 2});
  return unknowns;
}

// The sign in which the first of the (nearly) most moving unknowns moves forwards. "Nearly" keeps
// rounding from choosing between opposite sides of a symmetric shape.
double deterministic_sign(const VectorXd& shape) {
  constexpr double nearly = 0.99;
  const double most = shape.cwiseAbs().maxCoeff();
  Index i = 0;
  while (std::abs(shape[i]) < nearly * most) ++i;
  return shape[i] > 0 ? 1 : -1;
}

}  // namespace

ReducedBody modal_reduction(const LoadedFace& face, const Sparse& mass, const StaticSolution& solve,
                            Truncation truncation, const Matrix3Xd& points) {
  const Index unknowns = 3 * mass.rows();
  const Sparse face_mass = in_three_directions(face.mass());
  const auto body_loads = [&](const MatrixXd& forces) {
    MatrixXd loads(unknowns, forces.cols());
    for (Index m = 0; m < forces.cols(); ++m)
      loads.col(m) = face.on_body(forces.col(m).reshaped(3, forces.rows() / 3), unknowns);
    return loads;
  };
  const auto on_face = [&](const MatrixXd& displacements) {
    MatrixXd part(face_mass.rows(), displacements.cols());
    for (Index m = 0; m < part.cols(); ++m)
      part.col(m) = face.of_body(displacements.col(m)).reshaped();
    return part;
  };
  const std::vector<Index> reference = unknowns_on_x(face);

  const SteklovModes steklov =
      steklov_modes([&](const MatrixXd& forces) { return on_face(solve(body_loads(forces))); },
                    face_mass, truncation, reference);
  const Index modes = steklov.shape.cols();
  const VectorXd kept = steklov.compliance.head(modes);

  // The whole body's displacement that belongs to each face shape: s K^-1 M_G shape.
  const MatrixXd lifted =
      solve(body_loads(face_mass * steklov.shape)) * kept.cwiseInverse().asDiagonal();
  // In these shapes the stiffness is diagonal already.
  const MatrixXd ritz_stiffness = kept.cwiseInverse().asDiagonal();
  const Sparse body_mass = in_three_directions(mass);
  const MatrixXd ritz_mass =
      lifted.transpose() * (body_mass.selfadjointView<Eigen::Lower>() * lifted);
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> ritz(
      ritz_stiffness, (ritz_mass + ritz_mass.transpose()) / 2);
  ReducedBody reduced;
  reduced.compliance = steklov.compliance;
  reduced.truncation_error = steklov.compliance[modes] / steklov.compliance[0];
  const VectorXd ones = VectorXd::Ones(mass.rows());
  reduced.body_mass = ones.dot(mass.selfadjointView<Eigen::Lower>() * ones);

  // Unit modal mass so far; then every mode is scaled to a root mean square of one on the face.
  const VectorXd squared_frequency = ritz.eigenvalues();
  reduced.full_shape = lifted * ritz.eigenvectors();
  std::vector<Index> body_reference;
  for (const Index i : reference) body_reference.push_back(3 * face.nodes()[i / 3] + i % 3);
  orient_equal_modes(squared_frequency, body_reference, reduced.full_shape);
  const MatrixXd on_loaded_face = on_face(reduced.full_shape);
  VectorXd scale(modes);
  for (Index m = 0; m < modes; ++m) {
    const auto shape = on_loaded_face.col(m);
    scale[m] = deterministic_sign(shape) / std::sqrt(shape.dot(face_mass * shape) / face.area());
  }
  reduced.mass = scale.cwiseAbs2();
  reduced.stiffness = squared_frequency.cwiseProduct(reduced.mass);
  reduced.full_shape *= scale.asDiagonal();

  const Sparse weights = face.interpolation(points);
  reduced.shape.resize(3 * points.cols(), modes);
  for (Index m = 0; m < modes; ++m)
    reduced.shape.col(m) = (face.of_body(reduced.full_shape.col(m)) * weights).reshaped();
  return reduced;
}

}  // namespace fem

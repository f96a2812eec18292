#include "fem/steklov.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace fem {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index block_size = 8;
constexpr double converged = 1e-8;   // residual over compliance [-]
constexpr double dependent = 1e-14;  // squared length left of a unit direction that is none [-]

// Starting directions without symmetry, so that no mode is missed: fractional parts of multiples of
// irrational numbers (Weyl sequences), the same in every run.
MatrixXd starting_block(Index unknowns, Index columns) {
  MatrixXd block(unknowns, columns);
  for (Index j = 0; j < columns; ++j)
    for (Index i = 0; i < unknowns; ++i) {
      const double multiple = (i + 1.0) * std::sqrt(2.0 + j * (j + 1.0) + 1.0 / (j + 3.0));
      block(i, j) = multiple - std::floor(multiple) - 0.5;
    }
  return block;
}

// The growing M-orthonormal basis and the compliance operator projected on it.
class Krylov {
 public:
  Krylov(const FaceCompliance& compliance, const Eigen::SparseMatrix<double>& mass)
      : compliance_(compliance), mass_(mass) {}

  // Adds what `block` holds beyond the basis; false if that is nothing.
  bool extend(const MatrixXd& block) {
    MatrixXd fresh = orthonormal(block);
    if (fresh.cols() == 0) return false;
    const Index old = basis_.cols(), now = old + fresh.cols();
    basis_.conservativeResize(mass_.rows(), now);
    mass_basis_.conservativeResize(mass_.rows(), now);
    basis_.rightCols(fresh.cols()) = fresh;
    mass_basis_.rightCols(fresh.cols()) = mass_ * fresh;

    image_ = compliance_(mass_basis_.rightCols(fresh.cols()));
    const MatrixXd column = mass_basis_.transpose() * image_;
    projected_.conservativeResize(now, now);
    projected_.rightCols(fresh.cols()) = column;
    projected_.bottomRows(fresh.cols()) = column.transpose();
    image_ -= basis_ * column;  // what the operator adds to the basis
    return true;
  }

  // Ritz values, largest first, the vectors' coordinates, and their residuals' lengths.
  void solve() {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen((projected_ + projected_.transpose()) / 2);
    value = eigen.eigenvalues().reverse();
    coordinates = eigen.eigenvectors().rowwise().reverse();
    const MatrixXd gram = image_.transpose() * (mass_ * image_);
    const MatrixXd last = coordinates.bottomRows(image_.cols());
    residual = (last.array() * (gram * last).array()).colwise().sum().cwiseMax(0.0).sqrt();
  }

  const MatrixXd& remainder() const { return image_; }
  MatrixXd vectors(Index count) const { return basis_ * coordinates.leftCols(count); }

  VectorXd value, residual;
  MatrixXd coordinates;

 private:
  MatrixXd orthonormal(MatrixXd block) const {
    for (int pass = 0; pass < 3; ++pass) {
      if (basis_.cols() > 0) block -= basis_ * (mass_basis_.transpose() * block);
      const VectorXd length = (block.array() * (mass_ * block).array()).colwise().sum().sqrt();
      for (Index j = 0; j < block.cols(); ++j)
        if (length[j] > 0) block.col(j) /= length[j];
      const Eigen::SelfAdjointEigenSolver<MatrixXd> gram(block.transpose() * (mass_ * block));
      const Index kept = (gram.eigenvalues().array() > dependent).count();
      block = block * gram.eigenvectors().rightCols(kept) *
              gram.eigenvalues().tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
    }
    return block;
  }

  const FaceCompliance& compliance_;
  const Eigen::SparseMatrix<double>& mass_;
  MatrixXd basis_, mass_basis_;  // (unknowns, basis)
  MatrixXd projected_;           // (basis, basis) [m3/N]
  MatrixXd image_;               // of the newest block, less its part in the basis
};

// Modes to keep of compliances `value`; the one after them is wanted, too.
Index kept_modes(const VectorXd& value, Truncation truncation) {
  Index kept = 0;
  while (kept < value.size() && kept < truncation.modes &&
         value[kept] >= truncation.tolerance * value[0])
    ++kept;
  return kept;
}

}  // namespace

void orient_equal_modes(const VectorXd& value, const std::vector<Index>& reference,
                        MatrixXd& shape) {
  constexpr double equal =
      1e-8;  // relative; above rounding, below differences that a shape notices
  for (Index first = 0, last; first < shape.cols(); first = last) {
    last = first + 1;
    while (last < shape.cols() &&
           std::abs(value[last] - value[first]) < equal * std::abs(value[first]))
      ++last;
    if (last - first == 1) continue;
    auto cluster = shape.middleCols(first, last - first);
    const Index mover = *std::max_element(
        reference.begin(), reference.end(),
        [&](Index a, Index b) { return cluster.row(a).norm() < cluster.row(b).norm(); });
    const VectorXd motion = cluster.row(mover).transpose();
    const Eigen::HouseholderQR<MatrixXd> turn(motion);
    cluster = (cluster * MatrixXd(turn.householderQ())).eval();
  }
}

SteklovModes steklov_modes(const FaceCompliance& compliance,
                           const Eigen::SparseMatrix<double>& mass, Truncation truncation,
                           const std::vector<Index>& reference) {
  const Index unknowns = mass.rows();
  if (truncation.modes < 1 || truncation.modes >= unknowns)
    throw std::invalid_argument("modes must be at least 1 and below the loaded face's unknowns");

  Krylov krylov(compliance, mass);
  MatrixXd next = starting_block(unknowns, std::min(block_size, unknowns));
  Index kept = 0;
  bool found = false;
  while (!found) {
    if (!krylov.extend(next)) throw std::runtime_error("modes: the basis cannot grow");
    krylov.solve();
    next = krylov.remainder();
    kept = kept_modes(krylov.value, truncation);
    const Index wanted = kept + 1;
    found = wanted <= krylov.value.size() &&
            (krylov.residual.head(wanted).array() < converged * krylov.value.head(wanted).array())
                .all();
  }
  SteklovModes modes{krylov.value.head(kept + 1), krylov.vectors(kept + 1)};
  orient_equal_modes(modes.compliance, reference, modes.shape);
  modes.shape.conservativeResize(Eigen::NoChange, kept);
  return modes;
}

}  // namespace fem

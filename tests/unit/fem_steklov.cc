// The block Lanczos solver against a dense eigenvalue solver.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/steklov.h"

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A compliance with known eigenvalues, many of them in pairs, in an uneven mass.
struct Problem {
  MatrixXd compliance;
  Eigen::SparseMatrix<double> mass;
};

Problem paired_problem(Index size) {
  VectorXd mass(size);
  for (Index i = 0; i < size; ++i) mass[i] = 1 + 0.5 * std::sin(1.0 + i);
  MatrixXd noise(size, size);
  for (Index j = 0; j < size; ++j)
    for (Index i = 0; i < size; ++i) noise(i, j) = std::sin(1.0 + 7 * i + 3.3 * i * j);
  const MatrixXd basis = Eigen::HouseholderQR<MatrixXd>(noise).householderQ();
  VectorXd value(size);
  for (Index i = 0; i < size; ++i) value[i] = 1 / std::pow(1.0 + i / 2, 2);
  // C = M^-1/2 Q diag(value) Q^T M^-1/2 has C M v = s v with the values chosen.
  const MatrixXd scaled = mass.cwiseSqrt().cwiseInverse().asDiagonal() * basis;
  Eigen::SparseMatrix<double> diagonal(size, size);
  for (Index i = 0; i < size; ++i) diagonal.insert(i, i) = mass[i];
  return {scaled * value.asDiagonal() * scaled.transpose(), diagonal};
}

// 1e-8 is the precision that steklov.h promises.
TEST(steklov_modes, find_the_largest_compliances_pairs_included) {
  const Index size = 300, kept = 21;
  const Problem problem = paired_problem(size);
  const auto modes = fem::steklov_modes(
      [&](const MatrixXd& forces) -> MatrixXd { return problem.compliance * forces; }, problem.mass,
      {kept, 0}, {0});
  ASSERT_EQ(modes.compliance.size(), kept + 1);
  for (Index i = 0; i <= kept; ++i) {
    const double exact = 1 / std::pow(1.0 + i / 2, 2);
    EXPECT_NEAR(modes.compliance[i], exact, 1e-8 * exact) << i;
  }
  const MatrixXd gram = modes.shape.transpose() * (problem.mass * modes.shape);
  EXPECT_LT((gram - MatrixXd::Identity(kept, kept)).cwiseAbs().maxCoeff(), 1e-10);
  const MatrixXd image = problem.compliance * (problem.mass * modes.shape);
  const MatrixXd residual = image - modes.shape * modes.compliance.head(kept).asDiagonal();
  EXPECT_LT(residual.cwiseAbs().maxCoeff(), 1e-7 * modes.compliance[kept]);
}

// Of two equal modes only the first moves the reference unknown.
TEST(steklov_modes, orients_equal_modes) {
  const Problem problem = paired_problem(100);
  const auto modes = fem::steklov_modes(
      [&](const MatrixXd& forces) -> MatrixXd { return problem.compliance * forces; }, problem.mass,
      {8, 0}, {5});
  for (Index first = 0; first < 8; first += 2) {
    EXPECT_GT(std::abs(modes.shape(5, first)), 1e-4);
    EXPECT_NEAR(modes.shape(5, first + 1), 0, 1e-12);
  }
}

// The whole space may be asked for, but one: the basis then holds everything.
TEST(steklov_modes, reach_the_end_of_a_small_space) {
  const Index size = 13;
  const Problem problem = paired_problem(size);
  const auto modes = fem::steklov_modes(
      [&](const MatrixXd& forces) -> MatrixXd { return problem.compliance * forces; }, problem.mass,
      {size - 1, 0}, {0});
  EXPECT_NEAR(modes.compliance[size - 1], 1 / 49.0, 1e-10);
}

}  // namespace

// The shapes in which a loaded face yields most: the largest compliances s of C M v = s v, where
// M is the face's mass (its area matrix) and C maps nodal forces to displacements on the face.
// Found by a block Lanczos method with full reorthogonalisation in M (Golub & Van Loan 2013, 10.3);
// a block is needed because round bodies have pairs of equal compliance.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <functional>
#include <vector>

namespace fem {

// How many modes to keep: at most `modes`, and none more compliant modes than needed to leave out
// nothing above `tolerance` times the largest compliance.
struct Truncation {
  Eigen::Index modes;
  double tolerance;  // [-]
};

struct SteklovModes {
  Eigen::VectorXd compliance;  // (kept + 1) largest first [m3/N]; the last belongs to no kept mode
  Eigen::MatrixXd shape;       // (face unknowns, kept), M-orthonormal [1/m]
};

// Maps forces on the face unknowns (one column per case) [N] to their displacements [m].
using FaceCompliance = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

// Every compliance returned has a residual below 1e-8 of itself, so it is right to 1e-8.
// `mass` acts on all face unknowns; among equal compliances, only the first mode moves the unknowns
// `reference` (the one of them that moves most).
SteklovModes steklov_modes(const FaceCompliance& compliance,
                           const Eigen::SparseMatrix<double>& mass, Truncation truncation,
                           const std::vector<Eigen::Index>& reference);

// Turns shapes of equal `value` (sorted) among themselves so that only the first of them moves the
// most moving one of the `reference` unknowns: equal bodies give equal modes.
void orient_equal_modes(const Eigen::VectorXd& value, const std::vector<Eigen::Index>& reference,
                        Eigen::MatrixXd& shape);

}  // namespace fem

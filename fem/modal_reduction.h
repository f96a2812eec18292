// From an elastic body to its reduced form (internal to this room; see reduced_body.h).
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <functional>

#include "fem/loaded_face.h"
#include "fem/reduced_body.h"
#include "fem/steklov.h"

namespace fem {

// Static displacements [m] of the whole body under nodal loads [N], one column per case.
using StaticSolution = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

// `mass`: consistent mass per direction, lower triangle [kg]; `points` on the loaded face [m].
ReducedBody modal_reduction(const LoadedFace& face, const Eigen::SparseMatrix<double>& mass,
                            const StaticSolution& solve, Truncation truncation,
                            const Eigen::Matrix3Xd& points);

}  // namespace fem

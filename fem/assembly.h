// Stiffness and mass of a body (internal to this room).
#pragma once

#include <Eigen/Sparse>

#include "fem/body.h"
#include "fem/elements.h"

namespace fem {

// Lower triangle of the stiffness of the free (unclamped) body, unknown = 3 node + direction [N/m].
Eigen::SparseMatrix<double> assemble_stiffness(const Elements& elements, const Steel& steel);

// Consistent mass per direction, (nodes, nodes), lower triangle [kg].
Eigen::SparseMatrix<double> assemble_mass(const Elements& elements, const Steel& steel);

}  // namespace fem

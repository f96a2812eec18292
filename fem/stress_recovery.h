// Stresses of a displacement field at the nodes (internal to this room).
//
// Strains are taken where Lagrange elements give them best, at the degree^3 Gauss points (Barlow
// 1976), carried to the element's nodes by the polynomial through these points (trilinear for
// quadratic elements) and averaged over the elements that meet at a node (Hinton & Campbell 1974).
// On the default mould, Lame's hoop stress is met at both surfaces to 1 % on average and 2 % at the
// worst node. At clamped edges and at the re-entrant corner of plate and shaft the exact stress is
// infinite and values depend on the mesh.
#pragma once

#include "fem/body.h"
#include "fem/elements.h"

namespace fem {

StressField recover_stress(const Elements& elements, const Steel& steel,
                           const Eigen::VectorXd& displacement);

}  // namespace fem

// Stresses of a displacement field at the nodes (internal to this room).
//
// Strains are taken where Lagrange elements give them best, at the degree^3 Gauss points (Barlow
// 1976), carried to the element's nodes by the polynomial through these points (trilinear for
// quadratic elements) and averaged over the elements that meet at a node (Hinton & Campbell 1974).
// Across a mould's wall there is one point more: the hoop strain there is the displacement over the
// radius, which a quadratic element knows better than a line through two points does. The mean
// stress is carried from degree points there, too: it holds the change of volume, which is right at
// these and which a nearly incompressible solid multiplies.
// On the default mould, Lame's hoop stress is met at both surfaces to 1 %. At clamped edges and at
// the re-entrant corner of plate and shaft the exact stress is infinite and values depend on the
// mesh.
#pragma once

#include "fem/body.h"
#include "fem/elements.h"

namespace fem {

StressField recover_stress(const Elements& elements, const Steel& steel,
                           const Eigen::VectorXd& displacement);

}  // namespace fem

// What the full body of an elastic mould answers, statically, to forces at its letterbox.
#pragma once

#include <vector>

#include "apps/scene.h"
#include "dem/surface_field.h"
#include "fem/elastic_body.h"

namespace apps {

// How forces at the nodes of a mould's letterbox (3, nodes) strain a gauge [1/N]: the full body, by
// Maxwell's reciprocity one solution per gauge.
Eigen::Matrix3Xd gauge_influence(const fem::ElasticBody& body, const dem::SurfaceField& field,
                                 const GaugeScene& gauge, double outer_radius);

// Hoop stress at each node of a mould (nodes) [Pa], tension positive.
Eigen::VectorXd hoop_stress(const fem::ElasticBody& body, const Eigen::VectorXd& displacement);

// Hoop stress of a mould's inner face at the nodes of its letterbox, by the full body [Pa], under
// forces at these nodes (3 each) [N] that stand for a traction between them.
std::vector<double> hoop_stress_at_nodes(const fem::ElasticBody& body,
                                         const dem::SurfaceField& field,
                                         const Eigen::VectorXd& forces);

}  // namespace apps

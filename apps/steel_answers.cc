#include "apps/steel_answers.h"

#include <cmath>

namespace apps {

std::vector<double> hoop_stress_at_nodes(const fem::ElasticBody& body,
                                         const dem::SurfaceField& field,
                                         const Eigen::VectorXd& forces) {
  // Spread between the nodes: steel is compressed below a force that stands on a point, where the
  // same force as a pressure stretches it.
  const auto traction = [&](const Eigen::Vector3d& x) {
    const dem::Stencil near = field.stencil({x.x(), x.y(), x.z()});
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < near.node.size(); ++k)
      sum += near.weight[k] / field.area[near.node[k]] * forces.segment<3>(3 * near.node[k]);
    return sum;
  };
  const fem::StressField stress = body.stress(body.solve(body.face_load(traction)).col(0));
  std::vector<double> hoop;
  for (const dem::Vec3d& x : field.node) {
    Eigen::Index nearest;
    (body.nodes().colwise() - Eigen::Vector3d(x.x, x.y, x.z))
        .colwise()
        .squaredNorm()
        .minCoeff(&nearest);
    const double r = std::hypot(x.x, x.y), c = x.x / r, s = x.y / r;
    hoop.push_back(s * s * stress(0, nearest) + c * c * stress(1, nearest) -
                   2 * s * c * stress(5, nearest));
  }
  return hoop;
}

Eigen::Matrix3Xd gauge_influence(const fem::ElasticBody& body, const dem::SurfaceField& field,
                                 const GaugeScene& gauge, double outer_radius) {
  const double half = 0.5 * gauge.length / outer_radius;
  const auto place = [&](double angle) {
    return Eigen::Vector3d(outer_radius * std::cos(angle), outer_radius * std::sin(angle),
                           gauge.height);
  };
  const Eigen::VectorXd answer =
      body.solve(body.gauge(place(gauge.angle - half), place(gauge.angle + half))).col(0);
  Eigen::Matrix3Xd nodes(3, field.size());
  for (std::size_t n = 0; n < field.size(); ++n)
    nodes.col(static_cast<Eigen::Index>(n)) << field.node[n].x, field.node[n].y, field.node[n].z;
  return body.face_displacement(answer, nodes);
}

}  // namespace apps

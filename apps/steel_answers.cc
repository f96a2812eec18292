#include "apps/steel_answers.h"

#include <cmath>

namespace apps {
namespace {

Eigen::Matrix3Xd places_of(const dem::SurfaceField& field) {
  Eigen::Matrix3Xd places(3, field.size());
  for (std::size_t n = 0; n < field.size(); ++n)
    places.col(static_cast<Eigen::Index>(n)) << field.node[n].x, field.node[n].y, field.node[n].z;
  return places;
}

}  // namespace

Eigen::VectorXd hoop_stress(const fem::ElasticBody& body, const Eigen::VectorXd& displacement) {
  const fem::StressField stress = body.stress(displacement);
  Eigen::VectorXd hoop(body.nodes().cols());
  for (Eigen::Index i = 0; i < hoop.size(); ++i) {
    const Eigen::Vector2d out = body.nodes().col(i).head<2>().normalized();
    const double c = out[0], s = out[1];
    hoop[i] = s * s * stress(0, i) + c * c * stress(1, i) - 2 * s * c * stress(5, i);
  }
  return hoop;
}

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
  const Eigen::VectorXd answer = body.solve(body.face_load(traction)).col(0);
  const Eigen::VectorXd hoop = body.face_values(hoop_stress(body, answer), places_of(field));
  return {hoop.begin(), hoop.end()};
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
  return body.face_displacement(answer, places_of(field));
}

}  // namespace apps

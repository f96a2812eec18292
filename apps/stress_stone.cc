#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "apps/errors.h"
#include "apps/laws.h"
#include "apps/steel_answers.h"
#include "apps/stress_cases.h"
#include "coupling/elastic_wall.h"

namespace apps {
namespace {

constexpr int sectors = 32;  // of the letterbox

// d of a stone pressed with a force on a wall of compliance C: Hertz (1882) + C F [m].
double approach(double modulus, double radius, double force, double compliance) {
  const double hertz = std::pow(force / (4.0 / 3 * modulus * std::sqrt(radius)), 2.0 / 3);
  return hertz + compliance * force;
}

}  // namespace

fem::ReducedBody reduced_mould(const fem::ElasticBody& body, int modes,
                               const Eigen::Matrix3Xd& points) try {
  return body.reduce(modes, points);
} catch (const std::invalid_argument&) {
  throw InputError(
      {fmt::format("stones.modes: expected fewer than the degrees of freedom of the mould's face, "
                   "found {}; take fewer",
                   modes)});
}

// A stone is pressed on the mould at mid-height, towards +x, by a force that stands in for its
// weight: gravity along +x. It meets the reduced body through the letterbox, as in a run.
StressReport press_one_stone(const StressCase& given) {
  const ColumnOfStones& stone = given.stones;
  const fem::Mould& mould = given.mould;
  const double force = given.load.force;
  const double inner = mould.inner_diameter / 2, radius = stone.largest / 2;
  fem::Mould held = mould;
  held.base = fem::BaseSupport::clamped;  // the force is not in balance
  const fem::ElasticBody body(held, given.mesh);

  dem::Wall wall;
  wall.name = "mould";
  wall.surface = dem::CylinderInside{inner};
  // The laboratory's -z, where gravity pulls, is the mould's +x.
  wall.frame.ex = {0, 0, -1};
  wall.frame.ey = {0, 1, 0};
  wall.frame.ez = {1, 0, 0};
  const double cell = 2 * std::numbers::pi * inner / sectors;
  const int rows = 2 * std::max(2, static_cast<int>(std::lround(mould.height / cell / 2)));
  wall.field.emplace(dem::CylinderGrid{inner, mould.height, rows, sectors});
  fem::ReducedBody modes = reduced_mould(body, stone.modes, coupling::letterbox_points(wall));

  const int node = rows / 2 * sectors, opposite = node + sectors / 2;
  const Eigen::VectorXd amplitude =  // under a unit force along +x
      modes.shape.row(3 * node).transpose().cwiseQuotient(modes.stiffness);
  const double compliance = modes.shape.row(3 * node).dot(amplitude);

  const double volume = 4.0 / 3 * std::numbers::pi * std::pow(radius, 3);
  dem::ParticleStore stones = dem::make_stones({{mould.height / 2, 0, -inner + radius}}, {radius},
                                               {stone.density}, stone.mass_scale);
  const dem::Material of_stone = {stone.young, stone.poisson};
  const dem::Material of_wall = {mould.steel.young, mould.steel.poisson};
  const double modulus = 1 / (dem::normal_compliance(of_stone) + dem::normal_compliance(of_wall));
  const DampedDry law = {{modulus, dem::damping_ratio(stone.restitution)},
                         1 / (dem::shear_compliance(of_stone) + dem::shear_compliance(of_wall)),
                         stone.wall_friction};
  dem::Settings settings;
  settings.gravity = force / (stone.density * volume);
  const double hertz = approach(modulus, radius, force, 0);
  settings.largest_step =
      0.05 * std::sqrt(stone.density * volume * stone.mass_scale * hertz / given.load.force);
  settings.skin = 0.1 * radius;
  dem::Simulation<DampedDry> press(std::move(stones), law, settings);
  press.add_wall(std::move(wall), law);
  dem::Wall& ring = press.walls().front();
  coupling::ExchangeSettings exchange;
  exchange.interval = 1;
  exchange.inertia_scale = stone.mass_scale;
  coupling::ElasticWall elastic(modes, ring, exchange);
  const double period = 20 * settings.largest_step * 2 * std::numbers::pi;
  press.set_drag(1 / period);
  constexpr double at_rest = 1e-4;  // of the slowest mode's swing, what may be left of it
  const double slowest = std::sqrt(modes.stiffness[0] / (stone.mass_scale * modes.mass[0]));
  const double end = std::max(60 * period, -std::log(at_rest) / (exchange.damping * slowest));
  while (press.time() < end) {
    press.step();
    elastic.exchange(ring, {press.last_step(), press.time_step()});
  }
  const double moved = -press.stones().position[0].z - (inner - radius);
  const Eigen::Vector3d place(inner, 0, mould.height / 2), behind(-inner, 0, mould.height / 2);
  const Eigen::VectorXd full = body.solve(body.point_load(place, Eigen::Vector3d(force, 0, 0)));
  StressReport report{
      {{"approach", "m", moved, approach(modulus, radius, force, compliance),
        "Hertz + C F of the reduced wall in series", 1e-3},
       {"wall_force", "N", -ring.force.z, force, "balance", 1e-3},
       {"displacement_opposite", "m", modes.shape.row(3 * opposite).dot(amplitude) * force,
        body.face_displacement(full, behind)(0), "the full body, far from the stone", 0.02}},
      loaded_body(body, full),
      {}};
  const Eigen::VectorXd hoop = hoop_stress(body, full);
  for (Eigen::Index i = 0; i < body.nodes().cols(); ++i) {
    const Eigen::Vector3d x = body.nodes().col(i);
    if (std::abs(std::hypot(x[0], x[1]) - inner) < 1e-3 * mould.wall_thickness)
      report.map.push_back({std::atan2(x[1], x[0]), x[2], 0, hoop[i]});
  }
  return report;
}

}  // namespace apps

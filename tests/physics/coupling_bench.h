// One stone above an elastic plate: the smallest coupled system, for tests with exact answers.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "apps/laws.h"
#include "coupling/elastic_wall.h"

namespace bench {

using Law = apps::DampedDry;

constexpr double plate_radius = 0.075;  // [m]
constexpr double gravity = 9.81;        // [m/s2]

struct Stone {
  double radius = 6e-3;      // [m]
  double density = 2650;     // [kg/m3]
  double mass_scale = 1;     // inertia / true inertia [-]
  double load = 100;         // weight, by a gravity that is made to fit [N]
  double modulus = 50e9;     // E0 of its contact with the plate [Pa]
  double restitution = 0.5;  // [-]
  double x = 0, height = 0;  // of its lowest point [m]
  double friction = 0.3;     // [-]

  double mass() const {
    return density * 4.0 / 3 * std::numbers::pi * std::pow(radius, 3);
  }                                                                       // [kg]
  double hertz() const { return 4.0 / 3 * modulus * std::sqrt(radius); }  // K of F = K d^1.5
  double overlap() const { return std::pow(load / hertz(), 2.0 / 3); }    // under its load [m]
  double stiffness() const { return 1.5 * load / overlap(); }  // dF/dd under its load [N/m]
};

// A plate of one mode: it sinks as a whole.
inline fem::ReducedBody sinking_plate(double stiffness, double mass, std::size_t nodes) {
  fem::ReducedBody body;
  body.stiffness = Eigen::VectorXd::Constant(1, stiffness);
  body.mass = Eigen::VectorXd::Constant(1, mass);
  body.shape = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(nodes), 1);
  for (std::size_t n = 0; n < nodes; ++n) body.shape(3 * static_cast<Eigen::Index>(n) + 2, 0) = 1;
  return body;
}

inline dem::Wall plate() {
  dem::Wall wall;
  wall.name = "plate";
  wall.surface = dem::Plane{};
  wall.field.emplace(dem::DiscGrid{plate_radius, 6, 32});
  return wall;
}

// `fineness` time steps in the time sqrt(m / k) of the loaded contact.
inline dem::Simulation<Law> above(dem::Wall wall, const Stone& stone, double fineness = 20) {
  dem::ParticleStore stones = dem::make_stones({{stone.x, 0, stone.radius + stone.height}},
                                               {stone.radius}, {stone.density}, stone.mass_scale);
  const Law law = {
      {stone.modulus, dem::damping_ratio(stone.restitution)}, 0.8 * stone.modulus, stone.friction};
  dem::Settings settings;
  settings.gravity = stone.load / stone.mass();
  settings.safety = 1;  // the step stays at its largest
  settings.largest_step = std::sqrt(stone.mass() * stone.mass_scale / stone.stiffness()) / fineness;
  settings.skin = 0.1 * stone.radius;
  dem::Simulation<Law> simulation(std::move(stones), law, settings);
  simulation.add_wall(std::move(wall), law);
  return simulation;
}

}  // namespace bench

// One impact of dry stones, integrated by the simulation itself: two spheres, or one and a plane.
#pragma once

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "dem/laws/mindlin.h"
#include "dem/laws/slip_rings.h"
#include "dem/material.h"
#include "dem/simulation.h"

namespace dem {

using Normal = Hertz<Damping::restitution>;
using ImpactLaw = Mindlin<Normal>;

struct Sphere {
  double radius;           // [m]
  Vec3d velocity, spin{};  // before the impact [m/s], [rad/s]
};

struct ImpactCase {
  Material material;  // of both bodies, of the sphere alone at a rigid plane
  double density;     // [kg/m3]
  double restitution, friction;
  std::vector<Sphere>
      spheres;       // one meets the plane z = 0; two meet each other along z, the first above
  int steps = 2000;  // per contact duration of Hertz
};

struct Outcome {
  double force = 0;                             // largest normal force [N]
  double overlap = 0;                           // largest [m]
  double duration = 0;                          // of the contact [s]
  std::vector<std::pair<double, double>> path;  // overlap [m] and normal force [N], step by step
  std::vector<Vec3d> velocity, spin;            // afterwards, by sphere [m/s], [rad/s]
};

inline double sphere_mass(const ImpactCase& impact, int k) {
  const double r = impact.spheres[k].radius;
  return impact.density * 4.0 / 3 * std::numbers::pi * r * r * r;
}

template <class Law = ImpactLaw>
Law law_of(const ImpactCase& impact) {
  const double bodies = static_cast<double>(impact.spheres.size());  // that yield
  return {{1 / (bodies * normal_compliance(impact.material)), damping_ratio(impact.restitution)},
          1 / (bodies * shear_compliance(impact.material)),
          impact.friction};
}

// Hertz (1882), undamped: of an impact at the relative normal speed v [m/s].
struct HertzImpact {
  double force, overlap, duration;  // [N], [m], [s]
};
inline HertzImpact hertz_impact(const ImpactCase& impact, double v) {
  const bool pair = impact.spheres.size() == 2;
  const double r1 = impact.spheres[0].radius, r2 = pair ? impact.spheres[1].radius : 0;
  const double r0 = pair ? r1 * r2 / (r1 + r2) : r1;
  const double m1 = sphere_mass(impact, 0), m2 = pair ? sphere_mass(impact, 1) : 0;
  const double mass = pair ? m1 * m2 / (m1 + m2) : m1;
  const double k = 4.0 / 3 * law_of(impact).normal.modulus * std::sqrt(r0);
  const double overlap = std::pow(1.25 * mass * v * v / k, 0.4);
  const double duration = 2 * std::sqrt(std::numbers::pi) * std::tgamma(1.4) / std::tgamma(0.9);
  return {k * std::pow(overlap, 1.5), overlap, duration * overlap / v};
}

template <class Law = ImpactLaw>
Outcome collide(const ImpactCase& impact) {
  omp_set_num_threads(1);  // more would only wait for each other
  const bool pair = impact.spheres.size() == 2;
  const auto& spheres = impact.spheres;
  const double v = pair ? spheres[1].velocity.z - spheres[0].velocity.z : -spheres[0].velocity.z;
  const HertzImpact hertz = hertz_impact(impact, v);

  std::vector<Vec3d> position = {{0, 0, spheres[0].radius}};
  std::vector<double> radius = {spheres[0].radius};
  if (pair) {
    position.push_back({0, 0, -spheres[1].radius});
    radius.push_back(spheres[1].radius);
  }
  ParticleStore stones = make_stones(position, radius, {impact.density}, 1);
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    stones.velocity[k] = spheres[k].velocity;
    stones.spin[k] = spheres[k].spin;
  }
  Settings settings;
  settings.gravity = 0;
  settings.safety = 1;  // the step stays at its largest
  settings.largest_step = hertz.duration / impact.steps;
  settings.skin = 0.1 * radius.back();
  const Law law = law_of<Law>(impact);
  Simulation<Law> simulation(stones, law, settings);
  if (!pair) simulation.add_wall({"plane", Plane{}, {}}, law);

  Outcome outcome;
  bool touched = false;
  while (simulation.time() < 20 * hertz.duration) {
    simulation.step();
    const ParticleStore& now = simulation.stones();
    double overlap = now.radius[0] - now.position[0].z;
    if (pair) overlap = radius[0] + radius[1] - norm(now.position[0] - now.position[1]);
    if (overlap <= 0 && touched) break;
    if (overlap > 0) touched = true;
    if (touched) outcome.path.emplace_back(overlap, std::abs(now.load[0].force.z));
    outcome.overlap = std::max(outcome.overlap, overlap);
    outcome.force = std::max(outcome.force, std::abs(now.load[0].force.z));
  }
  outcome.duration = simulation.time();
  const ParticleStore& after = simulation.stones();
  outcome.velocity.resize(spheres.size());
  outcome.spin.resize(spheres.size());
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    outcome.velocity[after.id[k]] = after.velocity[k];
    outcome.spin[after.id[k]] = after.spin[k];
  }
  return outcome;
}

}  // namespace dem

// The stones: one contiguous array per quantity, in spatial order (see
// Simulation::refresh_neighbors).
#pragma once

#include <cstdint>
#include <vector>

#include "dem/vectors.h"

namespace dem {

// What acts on a stone, or on T of them: a line of the cache, which is added up as a whole.
template <class T>
struct LoadOf {
  Vec3<T> force;   // [N]
  T spare;         // always 0
  Vec3<T> torque;  // [N m]
  T crush;         // largest F / R0^2 of its stone contacts [Pa]; kept where stones may break
};
struct alignas(64) Load : LoadOf<double> {};

// What a stone is made of: of one stuff, with a shell of binder around it unless that has no
// thickness.
struct Layers {
  double density;            // of the stone [kg/m3]
  double shell = 0;          // thickness of the shell [m]
  double shell_density = 0;  // [kg/m3]

  double mass(double stone_radius) const;     // with the shell [kg]
  double turning(double stone_radius) const;  // moment of inertia / mass [m2]
};

struct ParticleStore {
  double shell = 0;  // thickness of the binder shell, the same for all stones [m]

  // Written once, when the stones are made.
  std::vector<std::uint32_t> id;
  std::vector<double> radius;   // of the bare stone [m]
  std::vector<double> mass;     // with the shell: what weighs [kg]
  std::vector<double> turning;  // moment of inertia / inertia [m2]

  // Written once more where a scene scales inertia or lets stones break.
  std::vector<double> inertia;   // what resists acceleration: mass, or more where it is scaled [kg]
  std::vector<double> strength;  // Weibull strength [Pa]; empty when stones do not break

  // Written by the integrator.
  Vectors position;  // [m]
  Vectors velocity;  // [m/s]
  Vectors spin;      // angular velocity [rad/s]

  // Set to the weight by the integrator, added to by the pair and the wall stage. Behind those of
  // the stones are parts of the pair stage (see tallies.h), empty between steps.
  std::vector<Load> load;

  // Written by the fracture stage; empty when stones do not break.
  std::vector<double> softness;  // stone compliance / that of the whole stone, >= 1 [-]

  std::size_t size() const { return id.size(); }
  double outer_radius(std::size_t i) const { return radius[i] + shell; }
  std::size_t bytes() const;  // of all arrays
};

// Stones at rest at the given places, with ids 0, 1, ...
ParticleStore make_stones(const std::vector<Vec3d>& position, std::vector<double> radius,
                          const Layers& layers, double inertia_scale);

// The same stones stored in another order: place k holds the stone that was at order[k].
void reorder(ParticleStore& stones, const std::vector<std::uint32_t>& order);

}  // namespace dem

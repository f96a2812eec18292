// Motion of the stones: leapfrog, velocities half a step behind positions, of second order also
// where the step changes. Inertia is scaled, weight is not: a = (F + m g) / (s m).
#pragma once

#include <span>

#include "dem/particle_store.h"
#include "dem/time_step.h"

namespace dem {

struct Travel {
  double farthest;  // largest distance of a stone from its reference position [m]
  bool finite;      // false: some position or velocity is not a number
};

// Advances velocity, spin and position. drag: rate at which motion dies out besides the
// contact forces [1/s], to settle a bed. Writes position, velocity, spin.
Travel advance_stones(ParticleStore& stones, Steps steps, double drag,
                      std::span<const Vec3d> reference);

}  // namespace dem

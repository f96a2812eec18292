// Motion of the stones: leapfrog, velocities half a step behind positions, of second order also
// where the step changes. Inertia is scaled, weight is not: a = (F + m g) / (s m).
#pragma once

#include <span>

#include "dem/particle_store.h"
#include "dem/time_step.h"

namespace dem {

struct Travel {
  double farthest = 0;  // largest distance of a stone from its reference position [m]
  double next = 0;      // and that of the stone after it [m]
  bool finite = true;   // false: some position or velocity is not a number

  // How much closer two stones can have come [m].
  double closing() const { return farthest + next; }
};

// Sets the stones' loads to their weight; gravity [m/s2], downwards along z.
void weigh(ParticleStore& stones, double gravity);

// Advances velocity, spin and position, and leaves the weight as load. drag: rate at which motion
// dies out besides the contact forces [1/s], to settle a bed.
Travel advance_stones(ParticleStore& stones, Steps steps, double drag, double gravity,
                      std::span<const Vec3d> reference);

}  // namespace dem

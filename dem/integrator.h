// Motion of the stones: leapfrog, velocities half a step behind positions, of second order also
// where the step changes. Inertia is scaled, weight is not: a = (F + m g) / (s m).
#pragma once

#include <span>
#include <vector>

#include "dem/particle_store.h"
#include "dem/time_step.h"

namespace dem {

// How far from the place where the lists were made a stone may be before they must be made anew.
struct Leash {
  Vec3d from;     // [m]
  double length;  // [m]
};

// What fast stones widen the skin [m] of the lists by, so that they alone do not make them stale:
// the way of a number of steps of dt [s] within some skins, more for the very fastest.
std::vector<double> extra_skin(const ParticleStore& stones, double skin, double dt);

// Of lists with that skin and these extras; the other half of the skin is for the other stone or
// the wall.
std::vector<Leash> leashes(const ParticleStore& stones, double skin, std::span<const double> extra);

struct Travel {
  bool strayed = false;  // some stone is at the end of its leash
  bool finite = true;    // false: some position or velocity is not a number
};

inline constexpr double earth_gravity = 9.81;  // [m/s2]

// Sets the stones' loads to their weight; gravity [m/s2], downwards along z.
void weigh(ParticleStore& stones, double gravity);

// Advances velocity, spin and position, and leaves the weight as load. drag: rate at which motion
// dies out besides the contact forces [1/s], to settle a bed.
Travel advance_stones(ParticleStore& stones, Steps steps, double drag, double gravity,
                      std::span<const Leash> leash);

// Throws NumericalTrouble naming the first stone whose position, velocity or spin is not finite.
void stop_at_first_not_finite(const ParticleStore& stones, double time);

}  // namespace dem

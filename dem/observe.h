// What one reads off a bed of stones.
#pragma once

#include <vector>

#include "dem/pair_contacts.h"
#include "dem/particle_store.h"
#include "dem/wall.h"

namespace dem {

double kinetic_energy(const ParticleStore& stones);  // with scaled inertia, spin included [J]

double mean_inertia_scale(const ParticleStore& stones);  // sum of inertia / sum of mass [-]

// How many stones touch each stone, by place.
template <ContactLaw Law>
std::vector<int> coordination(const PairContacts<Law>& pairs, const ParticleStore& stones) {
  std::vector<int> touching(stones.size(), 0);
  for (std::int64_t s = 0; s < pairs.slots(); ++s) {
    if (!pairs.touches(stones, s)) continue;
    ++touching[pairs.first(s)];
    ++touching[pairs.second(s)];
  }
  return touching;
}

// Mean height of the `count` highest stone tops (bare stones) [m].
double mean_of_highest(const ParticleStore& stones, int count);

// The loaded face of a plate as it is now, bent or not: the plane fitted to its letterbox by least
// squares over the area.
struct PlateFace {
  Vec3d normal;        // unit normal away from the stones, laboratory axes [-]
  double mean_height;  // [m]
  double angle;        // of the normal against the z axis [rad]
};
PlateFace plate_face(const Wall& plate);

}  // namespace dem

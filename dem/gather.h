// The gather stage: every stone adds up its weight and the forces of its slots, in slot order.
#pragma once

#include <span>

#include "dem/neighbor_list.h"
#include "dem/particle_store.h"
#include "dem/slot_force.h"

namespace dem {

// gravity [m/s2], downwards along z. Writes force, torque and, if stones may break, crush.
void gather_forces(ParticleStore& stones, const NeighborList& list,
                   std::span<const SlotForce> slots, double gravity);

}  // namespace dem

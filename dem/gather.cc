#include "dem/gather.h"

#include <cstdint>

#include "dem/pack.h"

namespace dem {

void gather_forces(ParticleStore& stones, const NeighborList& list,
                   std::span<const SlotForce> slots, double gravity) {
  const auto count = static_cast<std::int64_t>(stones.size());
  const bool breakable = !stones.crush.empty();
#pragma omp parallel for schedule(static) if (count > 64)
  for (std::int64_t i = 0; i < count; ++i) {
    const double radius = stones.outer_radius(i);
    Vec3d force = {0, 0, -gravity * stones.mass[i]};
    Vec3d torque = {0, 0, 0};
    double crush = 0;
    for (std::uint32_t s = list.row_start[i]; s < list.row_start[i + 1]; ++s) {
      const SlotForce& slot = slots[s];
      force += slot.force;
      torque += slot.moment * (radius - slot.half_overlap);
      crush = larger(crush, slot.crush);
    }
    for (std::uint32_t k = list.reverse_start[i]; k < list.reverse_start[i + 1]; ++k) {
      const SlotForce& slot = slots[list.reverse_slot[k]];
      force -= slot.force;
      torque += slot.moment * (radius - slot.half_overlap);
      crush = larger(crush, slot.crush);
    }
    stones.force[i] = force;
    stones.torque[i] = torque;
    if (breakable) stones.crush[i] = crush;
  }
}

}  // namespace dem

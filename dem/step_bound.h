// What bounds the next steps, as a look at all contacts finds it: the stiffest of them, what a ram
// bears, and how fast it may come.
#pragma once

#include <string>
#include <utility>

#include "dem/pair_contacts.h"
#include "dem/wall.h"
#include "dem/wall_contacts.h"

namespace dem {

// The step is at most safety / sqrt(rate).
struct StepBound {
  double rate = 0;  // stiffness / inertia [1/s2]
  std::string by;   // whom

  void meet(StepBound other) {
    if (other.rate > rate) *this = std::move(other);
  }
};

template <ContactLaw Law>
StepBound bound_by_stones(const PairContacts<Law>& pairs, const Extremes& found,
                          const ParticleStore& stones) {
  if (found.rate_slot < 0) return {};
  const auto name = [&](std::int32_t place) { return std::to_string(stones.id[place]); };
  return {found.rate, "stones " + name(pairs.first(found.rate_slot)) + " and " +
                          name(pairs.second(found.rate_slot))};
}

template <ContactLaw Law>
StepBound bound_by_stones(const WallContacts<Law>& contacts, const Extremes& found,
                          const ParticleStore& stones, const Wall& wall) {
  if (found.rate_slot < 0) return {};
  const std::uint32_t stone = stones.id[contacts.stones[found.rate_slot]];
  return {found.rate, "stone " + std::to_string(stone) + " at wall " + wall.name};
}

// Of a ram on contacts of that stiffness together [N/m]; none of another wall.
StepBound bound_by_load(const Wall& wall, double stiffness);

// Of a ram with a valve, at the speed that it may have within a time [s]: with that safety it comes
// two skins [m] in a step; none of another wall.
StepBound bound_by_speed(const Wall& wall, double within, double skin, double safety);

}  // namespace dem

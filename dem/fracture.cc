#include "dem/fracture.h"

#include <algorithm>

namespace dem {

void make_breakable(ParticleStore& stones, std::vector<double> strength_by_id) {
  stones.strength.resize(stones.size());
  for (std::size_t k = 0; k < stones.size(); ++k) stones.strength[k] = strength_by_id[stones.id[k]];
  stones.softness.assign(stones.size(), 1.0);
}

std::vector<std::int32_t> overloaded(const ParticleStore& stones) {
  const auto count = static_cast<std::int32_t>(stones.size());
  const auto breaks = [&](std::int32_t k) {
    return (stones.load[k].crush > stones.strength[k]) & (stones.softness[k] == 1.0);
  };
  // Mostly none is, and each thread asks those whose loads it has at hand.
  bool any = false;
#pragma omp parallel for schedule(static) reduction(|| : any) if (count > 64)
  for (std::int32_t k = 0; k < count; ++k) any |= breaks(k);
  std::vector<std::int32_t> found;
  for (std::int32_t k = 0; any && k < count; ++k)
    if (breaks(k)) found.push_back(k);
  return found;
}

Crack crack_of(std::uint32_t stone, double time, const std::vector<StoneLoad>& loads) {
  const auto most =
      std::max_element(loads.begin(), loads.end(),
                       [](const StoneLoad& a, const StoneLoad& b) { return a.crush < b.crush; });
  return {stone, time, most->crush, most->direction, most->force};
}

double stiffness_share(const FractureRule& rule, const Crack& crack,
                       const std::vector<StoneLoad>& loads) {
  double clamp = 0;
  for (const StoneLoad& load : loads) {
    const double along = dot(load.direction, crack.direction);
    clamp += 0.5 * load.force * (1 - along * along);
  }
  return rule.residual + (1 - rule.residual) * clamp / (clamp + crack.force);
}

}  // namespace dem

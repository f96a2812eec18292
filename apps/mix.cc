#include "apps/mix.h"

#include <algorithm>
#include <numbers>

#include "dem/mix_design.h"
#include "dem/strength.h"

namespace apps {

double Mix::smallest_radius() const {
  return *std::min_element(radius.begin(), radius.end());
}
double Mix::largest_radius() const {
  return *std::max_element(radius.begin(), radius.end());
}
dem::Layers Mix::layers(const StonesScene& stones) const {
  return {stones.density, shell, shell_density};
}

Mix prepare_mix(const StonesScene& stones, const std::optional<BinderScene>& binder, int seed) {
  const dem::SizeDistribution sizes =
      stones.distribution == "log_linear"
          ? dem::log_linear(stones.sieves, stones.smallest)
          : dem::truncated_normal(dem::fit_truncated_normal(stones.sieves, stones.smallest));
  Mix mix;
  const std::vector<double> diameters = dem::draw_diameters(sizes, stones.count, seed);
  mix.fitted = dem::largest_departure(stones.sieves, sizes);
  mix.drawn = dem::largest_departure(stones.sieves, stones.smallest, diameters);
  for (double d : diameters) mix.radius.push_back(d / 2);
  for (double r : mix.radius) mix.stone_volume += 4.0 / 3.0 * std::numbers::pi * r * r * r;
  if (binder) {
    const dem::BinderPhase phase =
        dem::binder_phase({binder->content, binder->density, stones.density,
                           dem::passing_at(stones.sieves, stones.smallest)});
    mix.shell = dem::shell_thickness(mix.radius, phase.volume_ratio);
    mix.shell_density = phase.density;
    mix.bitumen_fraction = phase.bitumen_fraction;
    mix.binder_volume = phase.volume_ratio * mix.stone_volume;
  }
  if (stones.fracture) {
    const dem::Weibull weibull = {stones.fracture->scale, stones.fracture->exponent,
                                  stones.fracture->reference_volume};
    for (std::uint32_t id = 0; id < mix.radius.size(); ++id)
      mix.strength.push_back(dem::strength(weibull, mix.radius[id], seed, id));
  }
  return mix;
}

}  // namespace apps

#include "dem/mix_design.h"

#include <cassert>
#include <cmath>

namespace dem {

BinderPhase binder_phase(const MixDesign& mix) {
  assert(0 <= mix.binder_content && mix.binder_content < 1);
  assert(0 <= mix.fines && mix.fines < 1);
  // Volumes per mass of mix [m3/kg].
  const double bitumen = mix.binder_content / mix.bitumen_density;
  const double all_stones = (1 - mix.binder_content) / mix.stone_density;
  const double fines = mix.fines * all_stones;
  const double phase = bitumen + fines;
  const double share = phase > 0 ? bitumen / phase : 0;
  return {phase / (all_stones - fines), share,
          share * mix.bitumen_density + (1 - share) * mix.stone_density};
}

double shell_thickness(std::span<const double> stone_radius, double volume_ratio) {
  assert(!stone_radius.empty() && volume_ratio >= 0);
  const double count = static_cast<double>(stone_radius.size());
  double sum1 = 0, sum2 = 0, sum3 = 0;  // of R, R^2, R^3
  for (const double r : stone_radius) {
    sum1 += r;
    sum2 += r * r;
    sum3 += r * r * r;
  }
  // f(t) = 3 sum2 t + 3 sum1 t^2 + count t^3 - volume_ratio sum3 is convex for t > 0, so Newton
  // from the root of its linear part, which lies above its own, comes down without overshoot.
  double t = volume_ratio * sum3 / (3 * sum2);
  for (double step = t; step > 1e-12 * t;) {
    const double f = ((count * t + 3 * sum1) * t + 3 * sum2) * t - volume_ratio * sum3;
    const double slope = 3 * ((count * t + 2 * sum1) * t + sum2);
    step = f / slope;
    t -= step;
  }
  return t;
}

}  // namespace dem

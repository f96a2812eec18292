// Adhesion of two binder shells that were pressed together: the pull-off force of Johnson, Kendall
// & Roberts (1971), F_min = 3/2 pi w R0, used as a limit on tension.
#pragma once

#include <cmath>
#include <numbers>

namespace dem {

struct Bond {
  double energy = 0;  // w, work of separation per area [J/m2]; 0: shells part as soon as they pull

  // R0: effective radius of the outer surfaces [m]. Returns F_min >= 0 [N].
  template <class T>
  T pull_off(T outer_radius) const {
    return T(1.5 * std::numbers::pi * energy) * outer_radius;
  }

  // Between two stones: how far it stretches before it parts, where 8/3 sqrt(R0) G stretch^1.5 is
  // F_min, G: modulus after the time that takes [Pa]. [m], infinite for a fluid.
  double stretch(double modulus, double outer_radius) const {
    return std::pow(pull_off(outer_radius) / (8.0 / 3.0 * std::sqrt(outer_radius) * modulus),
                    2.0 / 3.0);
  }
};

}  // namespace dem

// The laws and settings with which the energy ledger is tested.
#pragma once

#include <omp.h>

#include "apps/ledger.h"

namespace bench {

using apps::DampedDry;
using apps::Dry;

constexpr dem::Material granite = {74e9, 0.15};
constexpr double radius = 3e-3;  // [m]

// The law of contacts in which so many bodies yield.
inline Dry dry(double bodies, double friction) {
  return {{1 / (bodies * dem::normal_compliance(granite))},
          1 / (bodies * dem::shear_compliance(granite)),
          friction};
}

inline DampedDry damped(double bodies, double friction, double restitution) {
  const Dry law = dry(bodies, friction);
  return {{law.normal.modulus, dem::damping_ratio(restitution)}, law.shear_modulus, friction};
}

inline dem::Settings settings(double time_step, double gravity) {
  omp_set_num_threads(1);  // more would only wait for each other
  dem::Settings settings;
  settings.gravity = gravity;
  settings.safety = 1;  // the step stays at its largest
  settings.largest_step = time_step;
  settings.skin = 0.1 * radius;
  return settings;
}

}  // namespace bench

// A sphere that meets a rigid plane obliquely, integrated without the simulation: the exact answer
// of Cattaneo and Mindlin.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/physics/impact.h"

namespace dem {

// Tangential contact with partial slip under any history of overlap and sliding, as Maw, Barber &
// Fawcett (1976) solved it on rings: a row of springs that meet the plane where d > x^2 / R and
// slip one by one at friction x their own push. Exact for Cattaneo and Mindlin's assumptions
// (Popov & Hess 2015, Method of Dimensionality Reduction, ch. 5).
class PartialSlip {
 public:
  // modulus: E0; shear_modulus: G*, 8 G* a the stiffness in full stick; widest: largest a [m].
  PartialSlip(double modulus, double shear_modulus, double friction, double radius, double widest)
      : push_(2 * modulus * widest / springs),
        shear_(8 * shear_modulus * widest / springs),
        friction_(friction),
        slid_(springs) {
    for (int k = 0; k < springs; ++k) {
      const double x = widest * (k + 0.5) / springs;
      gap_.push_back(x * x / radius);
    }
  }

  // The shear force [N] after sliding on; damping: push / that of the springs alone [-].
  double slide(double overlap, double sliding, double damping) {
    double sum = 0;
    for (int k = 0; k < springs; ++k) {
      if (gap_[k] >= overlap) {
        slid_[k] = 0;
        continue;
      }
      const double limit = friction_ * damping * push_ * (overlap - gap_[k]) / shear_;
      slid_[k] = std::clamp(slid_[k] + sliding, -limit, limit);
      sum -= shear_ * slid_[k];
    }
    return sum;
  }

 private:
  static constexpr int springs = 1000;
  double push_, shear_;  // stiffness of the two springs that lie at -x and x [N/m]
  double friction_;
  std::vector<double> gap_, slid_;  // [m]
};

// What the tangential motion is after the impact.
struct Rebound {
  double velocity;  // of the centre along the plane [m/s]
  double surface;   // spin x radius, counted against the velocity: slip = velocity + surface [m/s]
};

// Impact of the only sphere of `impact`; shear(overlap, sliding, push, damping) is the force along
// the plane [N].
template <class Shear>
Rebound rebound(const ImpactCase& impact, Shear shear) {
  const ImpactLaw law = law_of(impact);
  const Sphere& sphere = impact.spheres.front();
  const double mass = sphere_mass(impact, 0), r = sphere.radius;
  const double dt = hertz_impact(impact, -sphere.velocity.z).duration / 4000;
  double overlap = 0, v = sphere.velocity.z;
  Rebound now = {sphere.velocity.x, 0};
  while (overlap >= 0) {
    overlap -= v * dt;
    const double a = std::sqrt(r * std::max(overlap, 1e-30));
    const double elastic = 4.0 / 3 * law.normal.modulus * a * overlap;
    const double damped = elastic - 2 * std::sqrt(5.0 / 6) * law.normal.damping_ratio *
                                        std::sqrt(mass * 2 * law.normal.modulus * a) * v;
    if (overlap <= 0) break;
    const double push = std::max(damped, 0.0);
    const double force = shear(overlap, (now.velocity + now.surface) * dt, push, push / elastic);
    v += push / mass * dt;
    now.velocity += force / mass * dt;
    now.surface += 2.5 * force / mass * dt;
  }
  return now;
}

inline Rebound rebound_with_partial_slip(const ImpactCase& impact) {
  const ImpactLaw law = law_of(impact);
  const Sphere& sphere = impact.spheres.front();
  const double deepest = hertz_impact(impact, -sphere.velocity.z).overlap;
  PartialSlip slip(law.normal.modulus, law.shear_modulus, impact.friction, sphere.radius,
                   1.02 * std::sqrt(sphere.radius * deepest));
  return rebound(impact, [&](double overlap, double sliding, double, double damping) {
    return slip.slide(overlap, sliding, damping);
  });
}

}  // namespace dem

// One contact driven by hand: a law and its memory, moved step by step along a prescribed path.
#pragma once

#include "dem/contact_law.h"

namespace dem {

template <ContactLaw Law>
class OneContact {
 public:
  // Outer radius and stone radius: R0 of shells and of stones [m]; mass: reduced [kg].
  OneContact(const Law& law, double outer_radius, double stone_radius, double mass = 1e-3)
      : law_(law) {
    contact_.outer_radius = outer_radius;
    contact_.stone_radius = stone_radius;
    contact_.mass = mass;
    contact_.softness = 1;
    contact_.normal = {0, 0, 1};
  }

  // The answer to a step of dt [s] that ends at this overlap [m], sliding by `sliding` [m].
  Response<double> move(double overlap, double dt, const Vec3d& sliding = {0, 0, 0}) {
    contact_.closing = dt > 0 ? (overlap - contact_.overlap) / dt : 0;
    contact_.overlap = overlap;
    contact_.sliding = sliding;
    law_.set_time_step(dt);
    return law_(contact_, memory_);
  }

  // Stone compliance / that of whole stones, from here on [-].
  void soften(double softness) { contact_.softness = softness; }

  bool held() const { return Law::template holds<double>(memory_); }

 private:
  Law law_;
  Contact<double> contact_ = {};
  typename Law::template Memory<double> memory_ = {};
};

}  // namespace dem

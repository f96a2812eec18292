// Stone contact whose stones may break: the contact law of `Stone`, made softer by what fracture
// has done to either stone (see dem/fracture.h for when a stone breaks and how soft it becomes).
// Softness only grows: at the same overlap the force falls, and no load is lifted.
#pragma once

#include "dem/contact.h"

namespace dem {

template <class Stone>
struct Fracture {
  Stone stone;
  double stone_share =
      1;  // stone's part of the contact compliance: 1 for a pair, less at a wall [-]

  static constexpr bool breaks = true;

  template <class T>
  using Memory = typename Stone::template Memory<T>;

  template <class T>
  static auto holds(const Memory<T>& memory) {
    return Stone::template holds<T>(memory);
  }

  void set_time_step(double dt) { stone.set_time_step(dt); }

  // Contact compliance / that of whole stones [-].
  template <class T>
  T weakness(const Contact<T>& contact) const {
    return T(1.0) + T(stone_share) * (contact.softness - T(1.0));
  }

  template <class T>
  Response<T> operator()(const Contact<T>& contact, Memory<T>& memory) const {
    return stone.respond(contact, memory, weakness(contact));
  }
};

}  // namespace dem

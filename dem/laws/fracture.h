// Stone contact whose stones may break: the contact law of `Stone`, made softer by what fracture
// has done to either stone (see dem/fracture.h for when a stone breaks and how soft it becomes).
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

  template <class T>
  Response<T> operator()(const Contact<T>& contact, Memory<T>& memory) const {
    const T weakness = T(1.0) + T(stone_share) * (contact.softness - T(1.0));
    return stone.respond(contact, memory, weakness);
  }
};

}  // namespace dem

// Stone contact whose stones may break: the contact law of `Stone`, made softer by what fracture
// has done to either stone (see dem/fracture.h for when a stone breaks and how soft it becomes).
//
// Stiffness that clamping gives back to a broken stone bears what is loaded from then on: the
// contact keeps its force, and its spring is shorter by what that takes. Given back at the same
// overlap, it would lift the load by itself, with energy from nowhere.
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
  struct Memory {
    typename Stone::template Memory<T> stone;
    T weakness;   // of the previous step, 0 if stones did not touch [-]
    T shortened;  // overlap of the stones that their spring does not feel any more [m]
  };

  template <class T>
  static auto holds(const Memory<T>& memory) {
    return Stone::template holds<T>(memory.stone);
  }

  void set_time_step(double dt) { stone.set_time_step(dt); }

  // Contact compliance / that of whole stones [-].
  template <class T>
  T weakness(const Contact<T>& contact) const {
    return T(1.0) + T(stone_share) * (contact.softness - T(1.0));
  }

  template <class T>
  Response<T> operator()(const Contact<T>& contact, Memory<T>& memory) const {
    const T d = contact.overlap - T(stone.gap), weak = weakness(contact);
    const auto apart = d <= T(0.0);
    memory.shortened = select(apart, T(0.0), memory.shortened);
    if (any(weak < memory.weakness)) {
      const T root = cube_root(weak / larger(weak, memory.weakness));
      memory.shortened += larger(d - memory.shortened, T(0.0)) * (T(1.0) - root * root);
    }
    memory.weakness = select(apart, T(0.0), weak);
    Contact<T> felt = contact;
    felt.overlap = contact.overlap - memory.shortened;
    return stone.respond(felt, memory.stone, weak);
  }
};

}  // namespace dem

// What a look at all contacts finds: the stiffest, and the deepest.
#pragma once

#include <cstdint>

#include "dem/pack.h"

namespace dem {

template <class T>
struct LaneExtremes;

// The extreme contacts of one list, found while their forces are evaluated.
struct Extremes {
  double rate = 0;  // largest stiffness / inertia of the lighter body [1/s2]
  std::int64_t rate_slot = -1;
  double overlap = 0;  // largest stone overlap / radius of the smaller stone [-]
  std::int64_t overlap_slot = -1;

  // Keeps the larger; the lower slot where equal, so that the order of asking does not matter.
  void merge(const Extremes& other) {
    keep(rate, rate_slot, other.rate, other.rate_slot);
    keep(overlap, overlap_slot, other.overlap, other.overlap_slot);
  }
  template <class T>
  void merge(const LaneExtremes<T>& lanes);

 private:
  static void keep(double& most, std::int64_t& slot, double value, std::int64_t at) {
    if (at < 0 || value < most || (value == most && slot >= 0 && slot < at)) return;
    most = value;
    slot = at;
  }
};

// The same while T contacts are looked at at once, in rising order of their slots.
template <class T>
struct LaneExtremes {
  T rate = T(0.0), rate_slot = T(-1.0), overlap = T(0.0), overlap_slot = T(-1.0);

  // Of the slots from `slot` on.
  void look(std::int64_t slot, T rates, T overlaps) {
    const T number = T(static_cast<double>(slot)) + lane_numbers<T>();
    rate_slot = select(rates > rate, number, rate_slot);
    rate = larger(rates, rate);
    overlap_slot = select(overlaps > overlap, number, overlap_slot);
    overlap = larger(overlaps, overlap);
  }
};

template <class T>
void Extremes::merge(const LaneExtremes<T>& lanes) {
  for (int k = 0; k < width<T>; ++k)
    merge({lane(lanes.rate, k), static_cast<std::int64_t>(lane(lanes.rate_slot, k)),
           lane(lanes.overlap, k), static_cast<std::int64_t>(lane(lanes.overlap_slot, k))});
}

// At a wall.
struct WallExtremes : Extremes {
  double stiffness = 0;  // of all contacts together [N/m]
};

}  // namespace dem

// The contact stage: one force per slot of the neighbour list.
//
// Every slot is evaluated by the same text, eight at a time (T = Pack) or one at a time (T =
// double, the slow and obvious reference). Slots do not see each other, so threads and their number
// do not matter.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "dem/contact_history.h"
#include "dem/neighbor_list.h"
#include "dem/particle_store.h"
#include "dem/slot_force.h"

namespace dem {

// Three consecutive doubles of each indexed Vec3d.
template <class T>
Vec3<T> gather(const std::vector<Vec3d>& vectors, const std::int32_t* index) {
  const double* base = &vectors.front().x;
  return {gather<T>(base, index, 3), gather<T>(base + 1, index, 3), gather<T>(base + 2, index, 3)};
}

// Steps between two looks at stiffness, overlap and finiteness.
inline constexpr int check_interval = 16;

template <ContactLaw Law>
class PairContacts {
 public:
  Law law;
  ContactHistory<Law> history;
  std::vector<SlotForce> forces;  // one per slot (padded), written by evaluate()

  // Takes over a rebuilt list, old memories included.
  void take(const NeighborList& list) {
    const std::size_t slots = list.first.size();
    const std::size_t padded = (slots + lanes - 1) / lanes * lanes;
    history.carry(list.previous);
    first_.assign(padded, 0);
    second_.assign(padded, 0);
    std::copy(list.first.begin(), list.first.end(), first_.begin());
    std::copy(list.second.begin(), list.second.end(), second_.begin());
    forces.assign(padded, SlotForce{});
    slots_ = static_cast<std::int64_t>(slots);
  }

  // Forces of all contacts after a step of dt [s], 0 before the first; with a horizon above 0 [s],
  // the extreme contacts until then too.
  template <class T = Pack>
  Extremes evaluate(const ParticleStore& stones, double dt, double horizon = 0) {
    Extremes found;
#pragma omp parallel if (slots_ > 64)
    {
      Extremes mine;
#pragma omp for schedule(static) nowait
      for (std::int64_t s = 0; s < slots_; s += width<T>) {
        if (horizon > 0)
          evaluate_at<T, true>(stones, dt, horizon, s, mine);
        else
          evaluate_at<T, false>(stones, dt, 0, s, mine);
      }
      if (horizon > 0) {
#pragma omp critical
        found.merge(mine);
      }
    }
    return found;
  }

  std::int64_t slots() const {
    return slots_;
  }
  std::int64_t touching() const;  // slots whose outer surfaces overlap
  std::int64_t held() const;      // slots whose contact would outlive a gap: bonds
  std::int32_t first(std::int64_t slot) const {
    return first_[slot];
  }
  std::int32_t second(std::int64_t slot) const {
    return second_[slot];
  }

 private:
  template <class T, bool check>
  void evaluate_at(const ParticleStore& stones, double dt, double horizon, std::int64_t slot,
                   Extremes& extremes);

  std::vector<std::int32_t> first_, second_;
  std::int64_t slots_ = 0;
};

template <ContactLaw Law>
std::int64_t PairContacts<Law>::touching() const {
  return std::count_if(forces.begin(), forces.begin() + slots_,
                       [](const SlotForce& slot) { return slot.half_overlap > 0; });
}

template <ContactLaw Law>
std::int64_t PairContacts<Law>::held() const {
  std::int64_t count = 0;
  for (std::int64_t s = 0; s < slots_; ++s) count += history.holds(s);
  return count;
}

template <ContactLaw Law>
template <class T, bool check>
void PairContacts<Law>::evaluate_at(const ParticleStore& stones, double dt, double horizon,
                                    std::int64_t slot, Extremes& extremes) {
  using std::sqrt;
  const std::int32_t* i = &first_[slot];
  const std::int32_t* j = &second_[slot];
  SlotForce* out = &forces[slot];

  const Vec3<T> apart = gather<T>(stones.position, i) - gather<T>(stones.position, j);
  const T stone_i = gather<T>(stones.radius.data(), i, 1);
  const T stone_j = gather<T>(stones.radius.data(), j, 1);
  const T radius_i = stone_i + T(stones.shell), radius_j = stone_j + T(stones.shell);
  const T distance = sqrt(dot(apart, apart));
  const T overlap = radius_i + radius_j - distance;

  MemoryOf<Law, T> memory(history, slot);
  const auto listed = lanes_below<T>(slots_ - slot);
  const auto alive = listed & ((overlap > T(0.0)) | Law::template holds<T>(memory.value));
  if (!check && !any(alive)) {
    for (int k = 0; k < width<T>; ++k) out[k] = SlotForce{};
    return;
  }

  const T inverse = T(1.0) / larger(distance, T(1e-300));
  const Vec3<T> spin_i = gather<T>(stones.spin, i), spin_j = gather<T>(stones.spin, j);
  const Vec3<T> rate = gather<T>(stones.velocity, i) - gather<T>(stones.velocity, j);
  const T half = T(0.5) * overlap;

  Contact<T> contact;
  contact.overlap = overlap;
  contact.outer_radius = radius_i * radius_j / (radius_i + radius_j);
  contact.stone_radius = stone_i * stone_j / (stone_i + stone_j);
  const T mass_i = gather<T>(stones.mass.data(), i, 1),
          mass_j = gather<T>(stones.mass.data(), j, 1);
  contact.mass = T(stones.inertia_scale) * mass_i * mass_j / (mass_i + mass_j);
  contact.softness = T(1.0);
  if constexpr (Law::breaks)
    contact.softness = T(0.5) * (gather<T>(stones.softness.data(), i, 1) +
                                 gather<T>(stones.softness.data(), j, 1));
  contact.normal = apart * inverse;
  const Vec3<T>& normal = contact.normal;
  contact.closing = -dot(rate, normal);
  // Velocities are of the middle of the step: so is the normal that spins are taken about.
  const Vec3<T> middle = normal - (rate + normal * contact.closing) * (T(0.5 * dt) * inverse);
  const Vec3<T> surface =
      rate - cross((radius_i - half) * spin_i + (radius_j - half) * spin_j, middle);
  contact.sliding = (surface - normal * dot(surface, normal)) * T(dt);
  contact.turn =
      (cross(normal, rate) * inverse + normal * (T(0.5) * dot(spin_i + spin_j, normal))) * T(dt);
  contact.horizon = T(horizon);

  const Response<T> response = law(contact, memory.value);
  forget<T>(!alive, memory.value);
  memory.keep(history, slot);

  const T zero(0.0);
  const Vec3<T> force =
      select(alive, normal * response.push + response.shear, Vec3<T>{zero, zero, zero});
  const Vec3<T> moment = select(alive, cross(response.shear, normal), Vec3<T>{zero, zero, zero});
  T crush = zero;
  if constexpr (Law::breaks)
    crush = select(alive, response.stone / (contact.stone_radius * contact.stone_radius), zero);
  for (int k = 0; k < width<T>; ++k)
    out[k] = {{lane(force.x, k), lane(force.y, k), lane(force.z, k)},
              lane(half, k),
              {lane(moment.x, k), lane(moment.y, k), lane(moment.z, k)},
              lane(crush, k)};

  if constexpr (check) {
    const T stiffest = select(
        listed, response.stiffness / (T(stones.inertia_scale) * smaller(mass_i, mass_j)), zero);
    const T deepest =
        select(alive, (overlap - T(2.0 * stones.shell)) / smaller(stone_i, stone_j), zero);
    for (int k = 0; k < width<T>; ++k)
      extremes.merge({lane(stiffest, k), slot + k, lane(deepest, k), slot + k});
  }
}

}  // namespace dem

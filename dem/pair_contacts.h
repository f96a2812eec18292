// The contact stage: forces of all slots of the neighbour list, added up by stone.
//
// Every slot is evaluated by the same text, eight at a time (T = Pack) or one at a time (T =
// double, the slow and obvious reference).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "dem/contact_history.h"
#include "dem/neighbor_list.h"
#include "dem/particle_store.h"
#include "dem/records.h"
#include "dem/slot_force.h"
#include "dem/tallies.h"

namespace dem {

// Steps between two looks at stiffness, overlap and finiteness.
inline constexpr int check_interval = 16;

template <ContactLaw Law>
class PairContacts {
 public:
  Law law;
  ContactHistory<Law> history;
  Tallies tallies;  // of the stones' loads, written by evaluate()

  // Takes over a rebuilt list, old memories included.
  void take(const NeighborList& list, const ParticleStore& stones) {
    const std::size_t slots = list.first.size();
    const std::size_t padded = (slots + lanes - 1) / lanes * lanes;
    history.carry(list.previous);
    first_.assign(padded, 0);
    second_.assign(padded, 0);
    std::copy(list.first.begin(), list.first.end(), first_.begin());
    std::copy(list.second.begin(), list.second.end(), second_.begin());
    tallies.take(first_, second_, stones.size());
    slots_ = static_cast<std::int64_t>(slots);
    couple(stones);
  }

  // Forces of all contacts after a step of dt [s], 0 before the first; with a horizon above 0 [s],
  // the extreme contacts until then too.
  template <class T = Pack>
  Extremes evaluate(const ParticleStore& stones, double dt, double horizon = 0) {
    return horizon > 0 ? evaluate_blocks<T, true>(stones, dt, horizon)
                       : evaluate_blocks<T, false>(stones, dt, 0);
  }

  // What evaluate() found at each slot, found once more: for those who look on.
  std::vector<SlotForce> forces(const ParticleStore& stones) const;

  std::int64_t slots() const { return slots_; }
  bool touches(const ParticleStore& stones, std::int64_t slot) const;  // outer surfaces overlap
  std::int64_t touching(const ParticleStore& stones) const;
  std::int64_t held() const;  // slots whose contact would outlive a gap: bonds
  std::int32_t first(std::int64_t slot) const { return first_[slot]; }
  std::int32_t second(std::int64_t slot) const { return second_[slot]; }

  // See dem/state.h. What follows from the rest is made again.
  template <class Visit>
  void visit_state(Visit& visit, const std::string& in, const ParticleStore& stones) {
    history.visit_state(visit, in);
    visit(in + "first", first_);
    visit(in + "second", second_);
    visit(in + "slots", slots_);
    tallies.take(first_, second_, stones.size());
    couple(stones);
  }

 private:
  // What stays of two stones until the next rebuild. All 0 in the lanes that only fill up the last
  // block: such stones never touch.
  template <class T>
  struct Couple {
    T radius_i, radius_j;          // of the outer surfaces [m]
    T outer_radius, stone_radius;  // see Contact [m]
    T mass;                        // reduced inertia [kg]
  };
  // What changes in every step, of the first stone against the second or of both.
  template <class T>
  struct Passing {
    Vec3<T> apart;           // [m]
    Vec3<T> rate;            // [m/s]
    Vec3<T> spin_i, spin_j;  // [rad/s]
  };
  template <class T>
  struct Meeting {
    Contact<T> contact;
    T arm_i, arm_j;  // from the centres to the middle of the overlap [m]
  };

  void couple(const ParticleStore& stones);
  template <class T, bool check>
  Extremes evaluate_blocks(const ParticleStore& stones, double dt, double horizon);
  template <class T, bool check>
  void evaluate_at(const Law& law, const ParticleStore& stones, double dt, double horizon,
                   std::int64_t slot, Tallies::Batch& batch, int in_batch,
                   LaneExtremes<T>& extremes);
  Couple<double> couple_of(const ParticleStore& stones, std::int64_t slot) const;
  template <class T>
  Couple<T> couple_at(const ParticleStore& stones, std::int64_t slot) const;
  template <class T>
  Passing<T> passing_at(const ParticleStore& stones, std::int64_t slot) const;
  template <class T>
  T softness_at(const ParticleStore& stones, std::int64_t slot) const;
  template <class T>
  static Meeting<T> meet(const Couple<T>& couple, const Passing<T>& passing, double dt);

  std::vector<std::int32_t> first_, second_;
  std::vector<Couple<Pack>> couples_;  // by block of slots
  std::int64_t slots_ = 0;
};

template <ContactLaw Law>
template <class T, bool check>
Extremes PairContacts<Law>::evaluate_blocks(const ParticleStore& stones, double dt,
                                            double horizon) {
  Extremes found;
#pragma omp parallel if (tallies.blocks() > 1)
  {
    const Law mine = law;  // not changed by what the loop writes, as the compiler can see
    LaneExtremes<T> extremes;
    Tallies::Batch batch;
#pragma omp for schedule(static) nowait
    for (std::int64_t block = 0; block < tallies.blocks(); ++block) {
      tallies.clear(block);
      const std::int64_t begin = block * Tallies::slots_per_block;
      const std::int64_t end = std::min(slots_, begin + Tallies::slots_per_block);
      for (std::int64_t s = begin; s < end; s += Tallies::Batch::slots) {
        const int count = static_cast<int>(std::min<std::int64_t>(end - s, Tallies::Batch::slots));
        for (int k = 0; k < count; k += width<T>)
          evaluate_at<T, check>(mine, stones, dt, horizon, s + k, batch, k, extremes);
        tallies.template add<Law::breaks>(s, count, batch);
      }
    }
    if constexpr (check) {
#pragma omp critical
      found.merge(extremes);
    }
  }
  return found;
}

template <ContactLaw Law>
auto PairContacts<Law>::couple_of(const ParticleStore& stones, std::int64_t slot) const
    -> Couple<double> {
  const std::int32_t i = first_[slot], j = second_[slot];
  const double stone_i = stones.radius[i], stone_j = stones.radius[j];
  const double radius_i = stones.outer_radius(i), radius_j = stones.outer_radius(j);
  const double mass_i = stones.mass[i], mass_j = stones.mass[j];
  return {radius_i, radius_j, radius_i * radius_j / (radius_i + radius_j),
          stone_i * stone_j / (stone_i + stone_j),
          stones.inertia_scale * mass_i * mass_j / (mass_i + mass_j)};
}

template <ContactLaw Law>
void PairContacts<Law>::couple(const ParticleStore& stones) {
  couples_.assign(first_.size() / lanes, Couple<Pack>{});
  for (std::int64_t s = 0; s < slots_; ++s) {
    const Couple<double> of = couple_of(stones, s);
    Couple<Pack>& to = couples_[s / lanes];
    const int k = s % lanes;
    set_lane(to.radius_i, k, of.radius_i);
    set_lane(to.radius_j, k, of.radius_j);
    set_lane(to.outer_radius, k, of.outer_radius);
    set_lane(to.stone_radius, k, of.stone_radius);
    set_lane(to.mass, k, of.mass);
  }
}

template <ContactLaw Law>
template <class T>
auto PairContacts<Law>::couple_at(const ParticleStore& stones, std::int64_t slot) const
    -> Couple<T> {
  if constexpr (width<T> == 1)
    return couple_of(stones, slot);
  else
    return couples_[slot / lanes];
}

// Two stones as the last step left them.
template <ContactLaw Law>
template <class T>
auto PairContacts<Law>::passing_at(const ParticleStore& stones, std::int64_t slot) const
    -> Passing<T> {
  const std::int32_t* i = &first_[slot];
  const std::int32_t* j = &second_[slot];
  return {gather_difference<T>(stones.position, i, j), gather_difference<T>(stones.velocity, i, j),
          gather<T>(stones.spin, i), gather<T>(stones.spin, j)};
}

template <ContactLaw Law>
template <class T>
T PairContacts<Law>::softness_at(const ParticleStore& stones, std::int64_t slot) const {
  if constexpr (!Law::breaks) return T(1.0);
  return T(0.5) * (gather<T>(stones.softness.data(), &first_[slot], 1) +
                   gather<T>(stones.softness.data(), &second_[slot], 1));
}

// All of a contact but its softness.
template <ContactLaw Law>
template <class T>
auto PairContacts<Law>::meet(const Couple<T>& couple, const Passing<T>& passing, double dt)
    -> Meeting<T> {
  const auto& [apart, rate, spin_i, spin_j] = passing;
  const T square = larger(dot(apart, apart), T(1e-300));
  const T inverse = reciprocal_root(square);

  Meeting<T> pair;
  Contact<T>& contact = pair.contact;
  contact.overlap = couple.radius_i + couple.radius_j - square * inverse;
  contact.outer_radius = couple.outer_radius;
  contact.stone_radius = couple.stone_radius;
  contact.mass = couple.mass;
  contact.normal = apart * inverse;
  const Vec3<T>& normal = contact.normal;
  contact.closing = -dot(rate, normal);
  pair.arm_i = couple.radius_i - T(0.5) * contact.overlap;
  pair.arm_j = couple.radius_j - T(0.5) * contact.overlap;
  const Vec3<T> swing = cross(normal, rate) * inverse;  // angular velocity of the normal
  const Vec3<T> rolling = pair.arm_i * spin_i + pair.arm_j * spin_j;
  // Velocities are of the middle of the step: so is the normal that spins are taken about, as much
  // of it as lies in the contact plane.
  contact.sliding = (rate + normal * contact.closing - cross(rolling, normal) +
                     swing * (T(0.5 * dt) * dot(rolling, normal))) *
                    T(dt);
  contact.turn = (swing + normal * (T(0.5) * dot(spin_i + spin_j, normal))) * T(dt);
  contact.horizon = T(0.0);
  return pair;
}

template <ContactLaw Law>
template <class T, bool check>
[[gnu::flatten]] void PairContacts<Law>::evaluate_at(const Law& law, const ParticleStore& stones,
                                                     double dt, double horizon, std::int64_t slot,
                                                     Tallies::Batch& batch, int in_batch,
                                                     LaneExtremes<T>& extremes) {
  MemoryOf<Law, T> memory(history, slot);
  Meeting<T> pair = meet<T>(couple_at<T>(stones, slot), passing_at<T>(stones, slot), dt);
  Contact<T>& contact = pair.contact;
  contact.softness = softness_at<T>(stones, slot);
  if constexpr (check) contact.horizon = T(horizon);
  const auto alive = (contact.overlap > T(0.0)) | Law::template holds<T>(memory.value);

  const Response<T> response = law(contact, memory.value);
  forget<T>(!alive, memory.value);
  memory.keep(history, slot);

  const T zero(0.0);
  const Vec3<T> none = {zero, zero, zero};
  const Vec3<T> force = select(alive, contact.normal * response.push + response.shear, none);
  const Vec3<T> moment = select(alive, cross(response.shear, contact.normal), none);
  T crush = zero;
  if constexpr (Law::breaks)
    crush = select(alive, response.stone / (contact.stone_radius * contact.stone_radius), zero);
  batch.put<T>(in_batch, force, moment * pair.arm_i, moment * pair.arm_j, crush);

  if constexpr (check) {
    const std::int32_t *i = &first_[slot], *j = &second_[slot];
    const T lighter = smaller(gather<T>(stones.mass.data(), i, 1),
                              gather<T>(stones.mass.data(), j, 1));
    const T thinner = smaller(gather<T>(stones.radius.data(), i, 1),
                              gather<T>(stones.radius.data(), j, 1));
    const T deep = (contact.overlap - T(2.0 * stones.shell)) / thinner;
    extremes.look(slot, response.stiffness / (T(stones.inertia_scale) * lighter),
                  select(alive, deep, zero));
  }
}

template <ContactLaw Law>
std::vector<SlotForce> PairContacts<Law>::forces(const ParticleStore& stones) const {
  Law still = law;
  still.set_time_step(0);
  std::vector<SlotForce> forces(slots_, SlotForce{});
  for (std::int64_t s = 0; s < slots_; ++s) {
    Contact<double> contact = meet(couple_of(stones, s), passing_at<double>(stones, s), 0).contact;
    contact.softness = softness_at<double>(stones, s);
    auto memory = history.slot(s);
    if (contact.overlap <= 0 && !Law::template holds<double>(memory)) continue;
    const Response<double> response = still(contact, memory);
    forces[s] = {contact.normal * response.push + response.shear, contact.overlap / 2,
                 cross(response.shear, contact.normal), 0};
    if constexpr (Law::breaks)
      forces[s].crush = response.stone / (contact.stone_radius * contact.stone_radius);
  }
  return forces;
}

template <ContactLaw Law>
bool PairContacts<Law>::touches(const ParticleStore& stones, std::int64_t slot) const {
  const std::int32_t i = first_[slot], j = second_[slot];
  return norm(stones.position[i] - stones.position[j]) <
         stones.outer_radius(i) + stones.outer_radius(j);
}

template <ContactLaw Law>
std::int64_t PairContacts<Law>::touching(const ParticleStore& stones) const {
  std::int64_t count = 0;
  for (std::int64_t s = 0; s < slots_; ++s) count += touches(stones, s);
  return count;
}

template <ContactLaw Law>
std::int64_t PairContacts<Law>::held() const {
  std::int64_t count = 0;
  for (std::int64_t s = 0; s < slots_; ++s) count += history.holds(s);
  return count;
}

}  // namespace dem

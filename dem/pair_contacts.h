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
  void take(const NeighborList& list) {
    const std::size_t slots = list.first.size();
    const std::size_t padded = (slots + lanes - 1) / lanes * lanes;
    history.carry(list.previous);
    first_.assign(padded, 0);
    second_.assign(padded, 0);
    std::copy(list.first.begin(), list.first.end(), first_.begin());
    std::copy(list.second.begin(), list.second.end(), second_.begin());
    tallies.take(first_, second_, list.row_start.size() - 1);
    slots_ = static_cast<std::int64_t>(slots);
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

  // See dem/state.h. The tallies, emptied in every step, are laid out again.
  template <class Visit>
  void visit_state(Visit& visit, const std::string& in, std::size_t stones) {
    history.visit_state(visit, in);
    visit(in + "first", first_);
    visit(in + "second", second_);
    visit(in + "slots", slots_);
    tallies.take(first_, second_, stones);
  }

 private:
  template <class T>
  struct Meeting {
    Contact<T> contact;
    T arm_i, arm_j;      // from the centres to the middle of the overlap [m]
    T lighter, smaller;  // true mass [kg] and radius of the bare stone [m]
  };

  template <class T, bool check>
  Extremes evaluate_blocks(const ParticleStore& stones, double dt, double horizon);
  template <class T, bool check>
  void evaluate_at(const ParticleStore& stones, double dt, double horizon, std::int64_t slot,
                   Tallies::Batch& batch, int in_batch, LaneExtremes<T>& extremes);
  template <class T>
  Meeting<T> meet(const ParticleStore& stones, double dt, std::int64_t slot) const;

  std::vector<std::int32_t> first_, second_;
  std::int64_t slots_ = 0;
};

template <ContactLaw Law>
template <class T, bool check>
Extremes PairContacts<Law>::evaluate_blocks(const ParticleStore& stones, double dt,
                                            double horizon) {
  Extremes found;
#pragma omp parallel if (tallies.blocks() > 1)
  {
    LaneExtremes<T> mine;
    Tallies::Batch batch;
#pragma omp for schedule(static) nowait
    for (std::int64_t block = 0; block < tallies.blocks(); ++block) {
      tallies.clear(block);
      const std::int64_t begin = block * Tallies::slots_per_block;
      const std::int64_t end = std::min(slots_, begin + Tallies::slots_per_block);
      for (std::int64_t s = begin; s < end; s += Tallies::Batch::slots) {
        const int count = static_cast<int>(std::min<std::int64_t>(end - s, Tallies::Batch::slots));
        for (int k = 0; k < count; k += width<T>)
          evaluate_at<T, check>(stones, dt, horizon, s + k, batch, k, mine);
        tallies.template add<Law::breaks>(s, count, batch);
      }
    }
    if constexpr (check) {
#pragma omp critical
      found.merge(mine);
    }
  }
  return found;
}

// Two stones at the places and with the velocities that the last step left.
template <ContactLaw Law>
template <class T>
auto PairContacts<Law>::meet(const ParticleStore& stones, double dt, std::int64_t slot) const
    -> Meeting<T> {
  const std::int32_t* i = &first_[slot];
  const std::int32_t* j = &second_[slot];
  const Vec3<T> apart = gather<T>(stones.position, i) - gather<T>(stones.position, j);
  const Vec3<T> rate = gather<T>(stones.velocity, i) - gather<T>(stones.velocity, j);
  const Vec3<T> spin_i = gather<T>(stones.spin, i), spin_j = gather<T>(stones.spin, j);
  const T stone_i = gather<T>(stones.radius.data(), i, 1);
  const T stone_j = gather<T>(stones.radius.data(), j, 1);
  const T mass_i = gather<T>(stones.mass.data(), i, 1);
  const T mass_j = gather<T>(stones.mass.data(), j, 1);
  const T radius_i = stone_i + T(stones.shell), radius_j = stone_j + T(stones.shell);
  const T square = larger(dot(apart, apart), T(1e-300));
  const T inverse = reciprocal_root(square);

  Meeting<T> pair;
  Contact<T>& contact = pair.contact;
  contact.overlap = radius_i + radius_j - square * inverse;
  contact.outer_radius = radius_i * radius_j / (radius_i + radius_j);
  contact.stone_radius = stone_i * stone_j / (stone_i + stone_j);
  contact.mass = T(stones.inertia_scale) * mass_i * mass_j / (mass_i + mass_j);
  contact.softness = T(1.0);
  if constexpr (Law::breaks)
    contact.softness = T(0.5) * (gather<T>(stones.softness.data(), i, 1) +
                                 gather<T>(stones.softness.data(), j, 1));
  contact.normal = apart * inverse;
  const Vec3<T>& normal = contact.normal;
  contact.closing = -dot(rate, normal);
  pair.arm_i = radius_i - T(0.5) * contact.overlap;
  pair.arm_j = radius_j - T(0.5) * contact.overlap;
  // Velocities are of the middle of the step: so is the normal that spins are taken about.
  const Vec3<T> middle = normal - (rate + normal * contact.closing) * (T(0.5 * dt) * inverse);
  const Vec3<T> surface = rate - cross(pair.arm_i * spin_i + pair.arm_j * spin_j, middle);
  contact.sliding = (surface - normal * dot(surface, normal)) * T(dt);
  contact.turn =
      (cross(normal, rate) * inverse + normal * (T(0.5) * dot(spin_i + spin_j, normal))) * T(dt);
  contact.horizon = T(0.0);
  pair.lighter = smaller(mass_i, mass_j);
  pair.smaller = smaller(stone_i, stone_j);
  return pair;
}

template <ContactLaw Law>
template <class T, bool check>
[[gnu::flatten]] void PairContacts<Law>::evaluate_at(const ParticleStore& stones, double dt,
                                                     double horizon, std::int64_t slot,
                                                     Tallies::Batch& batch, int in_batch,
                                                     LaneExtremes<T>& extremes) {
  MemoryOf<Law, T> memory(history, slot);
  Meeting<T> pair = meet<T>(stones, dt, slot);
  Contact<T>& contact = pair.contact;
  const auto listed = lanes_below<T>(slots_ - slot);
  const auto alive = listed & ((contact.overlap > T(0.0)) | Law::template holds<T>(memory.value));
  if constexpr (check) contact.horizon = T(horizon);

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
  batch.put<T>(in_batch, {force, zero, moment * pair.arm_i, crush},
               {-force, zero, moment * pair.arm_j, crush});

  if constexpr (check) {
    const T inertia = T(stones.inertia_scale) * pair.lighter;
    const T deep = (contact.overlap - T(2.0 * stones.shell)) / pair.smaller;
    extremes.look(slot, select(listed, response.stiffness / inertia, zero),
                  select(alive, deep, zero));
  }
}

template <ContactLaw Law>
std::vector<SlotForce> PairContacts<Law>::forces(const ParticleStore& stones) const {
  Law still = law;
  still.set_time_step(0);
  std::vector<SlotForce> forces(slots_, SlotForce{});
  for (std::int64_t s = 0; s < slots_; ++s) {
    const Contact<double> contact = meet<double>(stones, 0, s).contact;
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

// The contact stage: forces of all slots of the neighbour list, added to the stones' loads.
//
// Every slot is evaluated by the same text, eight at a time (T = Pack) or one at a time (T =
// double, the slow and obvious reference).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "dem/bytes.h"
#include "dem/contact_history.h"
#include "dem/extremes.h"
#include "dem/meeting.h"
#include "dem/neighbor_list.h"
#include "dem/particle_store.h"
#include "dem/records.h"
#include "dem/slot_force.h"
#include "dem/slots.h"
#include "dem/tallies.h"

namespace dem {

// A bed of more stones lies outside of the caches (measured, tests/speed/README.md).
inline constexpr std::size_t stones_in_cache = 20000;

// Steps between two looks at stiffness and overlap, at most.
inline constexpr int check_interval = 16;

template <ContactLaw Law>
class PairContacts {
 public:
  Law law;
  ContactHistory<Law> history;

  // Takes over a rebuilt list, old memories included.
  void take(const NeighborList& list, ParticleStore& stones);

  // Adds the forces of all contacts after a step of dt [s], 0 before the first, to the stones'
  // loads; with a horizon above 0 [s], finds the extreme contacts until then too.
  template <class T = Pack>
  Extremes evaluate(ParticleStore& stones, double dt, double horizon = 0) {
    return horizon > 0 ? evaluate_blocks<T, true>(stones, dt, horizon)
                       : evaluate_blocks<T, false>(stones, dt, 0);
  }

  // What evaluate() found at each slot, found once more: for those who look on.
  std::vector<SlotForce> forces(const ParticleStore& stones) const;

  std::int64_t slots() const { return slots_.count(); }
  std::size_t bytes() const;  // of all arrays
  bool touches(const ParticleStore& stones, std::int64_t slot) const {
    return touch(stones, first(slot), second(slot));
  }
  std::int64_t touching(const ParticleStore& stones) const;
  std::int64_t held() const;  // slots whose law holds on to them beyond touch (`holds`)
  std::int32_t first(std::int64_t slot) const { return slots_.first[slot]; }
  std::int32_t second(std::int64_t slot) const { return slots_.second[slot]; }

  // See dem/state.h. What follows from the rest is made again.
  template <class Visit>
  void visit_state(Visit& visit, const std::string& in, ParticleStore& stones) {
    history.visit_state(visit, in);
    slots_.visit_state(visit, in);
    prepare(stones);
  }

 private:
  void prepare(ParticleStore& stones);
  void couple(const ParticleStore& stones);
  template <class T, bool check>
  Extremes evaluate_blocks(ParticleStore& stones, double dt, double horizon);
  template <class T, bool check>
  void evaluate_at(const Law& law, const ParticleStore& stones, double dt, double horizon,
                   std::int64_t slot, Tallies::Batch& batch, int in_batch,
                   LaneExtremes<T>& extremes);
  void fetch(const ParticleStore& stones, std::int64_t slot) const;
  template <class T>
  bool dozes(const ParticleStore& stones, std::int64_t slot) const;
  template <class T>
  Couple<T> couple_at(const ParticleStore& stones, std::int64_t slot) const;
  template <class T>
  Passing<T> passing_at(const ParticleStore& stones, std::int64_t slot) const;
  template <class T>
  T softness_at(const ParticleStore& stones, std::int64_t slot) const;

  Slots slots_;
  Tallies tallies_;
  std::vector<Couple<Pack>> couples_;  // by block of slots
  std::vector<std::int32_t> awake_;    // by block: 0 where none lived in the last step
};

template <ContactLaw Law>
void PairContacts<Law>::take(const NeighborList& list, ParticleStore& stones) {
  history.carry(slots_.take(list, [&](std::int32_t i, std::int32_t j, std::int32_t before) {
    return touch(stones, i, j) || (before >= 0 && history.holds(before));
  }));
  prepare(stones);
}

// What follows from the stones of the slots.
template <ContactLaw Law>
void PairContacts<Law>::prepare(ParticleStore& stones) {
  tallies_.take(slots_.first, slots_.second, stones);
  couple(stones);
  awake_.assign(couples_.size(), 1);
}

template <ContactLaw Law>
template <class T, bool check>
Extremes PairContacts<Law>::evaluate_blocks(ParticleStore& stones, double dt, double horizon) {
  Extremes found;
  const bool far = stones.size() > stones_in_cache;
#pragma omp parallel if (tallies_.blocks() > 1)
  {
    const Law mine = law;  // not changed by what the loop writes, as the compiler can see
    LaneExtremes<T> extremes;
    Tallies::Batch batch;
#pragma omp for schedule(static)
    for (std::int64_t block = 0; block < tallies_.blocks(); ++block) {
      const std::int64_t begin = block * tallies_.slots_per_block();
      const std::int64_t end = std::min(slots(), begin + tallies_.slots_per_block());
      for (std::int64_t s = begin; s < end; s += Tallies::Batch::slots) {
        const int count = static_cast<int>(std::min<std::int64_t>(end - s, Tallies::Batch::slots));
        batch.clear();
        if (far) fetch(stones, s + Tallies::Batch::slots);
        for (int k = 0; k < count; k += width<T>) {
          if (!check && dozes<T>(stones, s + k)) continue;
          evaluate_at<T, check>(mine, stones, dt, horizon, s + k, batch, k, extremes);
        }
        batch.end(count);
        tallies_.template add<Law::breaks>(s, count, batch, stones.load);
      }
    }
#pragma omp for schedule(static) nowait
    for (std::int64_t chunk = 0; chunk < tallies_.chunks(); ++chunk)
      tallies_.template add_up<Law::breaks>(chunk, stones.load);
    if constexpr (check) {
#pragma omp critical
      found.merge(extremes);
    }
  }
  return found;
}

// Asks for the stones of the batch that begins at a slot before they are needed. Inlined, or GCC
// takes it for a function that does nothing.
template <ContactLaw Law>
[[gnu::always_inline]] inline void PairContacts<Law>::fetch(const ParticleStore& stones,
                                                            std::int64_t slot) const {
  const std::int64_t end = std::min(slots(), slot + Tallies::Batch::slots);
  for (; slot < end; ++slot) {
    for (const std::int32_t stone : {first(slot), second(slot)}) {
      __builtin_prefetch(&stones.position[stone]);
      __builtin_prefetch(&stones.velocity[stone]);
      __builtin_prefetch(&stones.spin[stone]);
    }
    tallies_.fetch(slot, stones.load);
  }
}

template <ContactLaw Law>
void PairContacts<Law>::couple(const ParticleStore& stones) {
  couples_.resize(slots_.first.size() / lanes);
#pragma omp parallel for schedule(static) if (tallies_.blocks() > 1)
  for (std::int64_t b = 0; b < std::ssize(couples_); ++b) {
    Couple<Pack> block = {};
    for (int k = 0; k < lanes && lanes * b + k < slots(); ++k) {
      const Couple<double> of =
          couple_of(stones, slots_.first[lanes * b + k], slots_.second[lanes * b + k]);
      set_lane(block.radius_i, k, of.radius_i);
      set_lane(block.radius_j, k, of.radius_j);
      set_lane(block.outer_radius, k, of.outer_radius);
      set_lane(block.stone_radius, k, of.stone_radius);
      set_lane(block.mass, k, of.mass);
    }
    couples_[b] = block;
  }
}

template <ContactLaw Law>
template <class T>
Couple<T> PairContacts<Law>::couple_at(const ParticleStore& stones, std::int64_t slot) const {
  if constexpr (width<T> == 1)
    return couple_of(stones, slots_.first[slot], slots_.second[slot]);
  else
    return couples_[slot / lanes];
}

// Two stones as the last step left them.
template <ContactLaw Law>
template <class T>
Passing<T> PairContacts<Law>::passing_at(const ParticleStore& stones, std::int64_t slot) const {
  const std::int32_t *i = &slots_.first[slot], *j = &slots_.second[slot];
  return {gather_difference<T>(stones.position, i, j), gather_difference<T>(stones.velocity, i, j),
          gather<T>(stones.spin, i), gather<T>(stones.spin, j)};
}

template <ContactLaw Law>
template <class T>
T PairContacts<Law>::softness_at(const ParticleStore& stones, std::int64_t slot) const {
  if constexpr (!Law::breaks) return T(1.0);
  return T(0.5) * (gather<T>(stones.softness.data(), &slots_.first[slot], 1) +
                   gather<T>(stones.softness.data(), &slots_.second[slot], 1));
}

// Is there nothing to do for a pack, which had no living contact in the last step?
template <ContactLaw Law>
template <class T>
bool PairContacts<Law>::dozes(const ParticleStore& stones, std::int64_t slot) const {
  if (width<T> == 1 || awake_[slot / lanes]) return false;
  const Vec3<T> apart =
      gather_difference<T>(stones.position, &slots_.first[slot], &slots_.second[slot]);
  return !any(overlap_of(couple_at<T>(stones, slot), apart) > T(0.0));
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
  if constexpr (width<T> == lanes) {
    std::int32_t& awake = awake_[slot / lanes];
    if (awake != any(alive)) awake = any(alive);
  }

  const T zero(0.0);
  const Vec3<T> none = {zero, zero, zero};
  const Vec3<T> force = select(alive, contact.normal * response.push + response.shear, none);
  const Vec3<T> moment = select(alive, cross(response.shear, contact.normal), none);
  T crush = zero;
  if constexpr (Law::breaks)
    crush = select(alive, response.stone / (contact.stone_radius * contact.stone_radius), zero);
  batch.put<T>(in_batch, force, moment, pair.arm_i, pair.arm_j, crush);

  if constexpr (check) {
    const std::int32_t *i = &slots_.first[slot], *j = &slots_.second[slot];
    const T lighter =
        smaller(gather<T>(stones.inertia.data(), i, 1), gather<T>(stones.inertia.data(), j, 1));
    const T thinner =
        smaller(gather<T>(stones.radius.data(), i, 1), gather<T>(stones.radius.data(), j, 1));
    const T deep = (contact.overlap - T(2.0 * stones.shell)) / thinner;
    extremes.look(slot, response.stiffness / lighter, select(alive, deep, zero));
  }
}

template <ContactLaw Law>
std::vector<SlotForce> PairContacts<Law>::forces(const ParticleStore& stones) const {
  Law still = law;
  still.set_time_step(0);
  std::vector<SlotForce> forces(slots(), SlotForce{});
  for (std::int64_t s = 0; s < slots(); ++s) {
    Contact<double> contact =
        meet(couple_at<double>(stones, s), passing_at<double>(stones, s), 0).contact;
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
std::size_t PairContacts<Law>::bytes() const {
  return slots_.bytes() + tallies_.bytes() + bytes_of(history.raw(), couples_, awake_);
}

template <ContactLaw Law>
std::int64_t PairContacts<Law>::touching(const ParticleStore& stones) const {
  std::int64_t count = 0;
  for (std::int64_t s = 0; s < slots(); ++s) count += touches(stones, s);
  return count;
}

template <ContactLaw Law>
std::int64_t PairContacts<Law>::held() const {
  std::int64_t count = 0;
  for (std::int64_t s = 0; s < slots(); ++s) count += history.holds(s);
  return count;
}

}  // namespace dem

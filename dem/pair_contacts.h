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

#include "dem/contact_history.h"
#include "dem/meeting.h"
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

  // Takes over a rebuilt list, old memories included. Every few slots, pairs that touch or live on
  // come before those that do not, so that whole packs of the latter are passed over.
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

  std::int64_t slots() const { return slots_; }
  std::size_t bytes() const;                                           // of all arrays
  bool touches(const ParticleStore& stones, std::int64_t slot) const;  // outer surfaces overlap
  std::int64_t touching(const ParticleStore& stones) const;
  std::int64_t held() const;  // slots whose contact would outlive a gap: bonds
  std::int32_t first(std::int64_t slot) const { return first_[slot]; }
  std::int32_t second(std::int64_t slot) const { return second_[slot]; }

  // See dem/state.h. What follows from the rest is made again.
  template <class Visit>
  void visit_state(Visit& visit, const std::string& in, ParticleStore& stones) {
    history.visit_state(visit, in);
    visit(in + "first", first_);
    visit(in + "second", second_);
    visit(in + "slots", slots_);
    visit(in + "slot_of", slot_of_);
    prepare(stones);
  }

 private:
  bool lives(const NeighborList& list, std::int64_t pair, const ParticleStore& stones) const;
  void prepare(ParticleStore& stones);
  void couple(const ParticleStore& stones);
  template <class T, bool check>
  Extremes evaluate_blocks(ParticleStore& stones, double dt, double horizon);
  template <class T, bool check>
  void evaluate_at(const Law& law, const ParticleStore& stones, double dt, double horizon,
                   std::int64_t slot, Tallies::Batch& batch, int in_batch,
                   LaneExtremes<T>& extremes);
  template <class T>
  bool dozes(const ParticleStore& stones, std::int64_t slot) const;
  template <class T>
  Couple<T> couple_at(const ParticleStore& stones, std::int64_t slot) const;
  template <class T>
  Passing<T> passing_at(const ParticleStore& stones, std::int64_t slot) const;
  template <class T>
  T softness_at(const ParticleStore& stones, std::int64_t slot) const;

  std::vector<std::int32_t> first_, second_;
  Tallies tallies_;
  std::vector<std::int32_t> slot_of_;  // of each pair of the list
  std::vector<Couple<Pack>> couples_;  // by block of slots
  std::vector<std::int32_t> awake_;    // by block: 0 if no contact of it lived in the last step
  std::int64_t slots_ = 0;
};

template <ContactLaw Law>
void PairContacts<Law>::take(const NeighborList& list, ParticleStore& stones) {
  constexpr std::int64_t stretch = 256;  // pairs whose slots are sorted among themselves
  slots_ = std::ssize(list.first);
  first_.assign((slots_ + lanes - 1) / lanes * lanes, 0);
  second_.assign(first_.size(), 0);
  std::vector<std::int32_t> slot_of(slots_), previous(slots_);
#pragma omp parallel for schedule(static)
  for (std::int64_t begin = 0; begin < slots_; begin += stretch) {
    const std::int64_t count = std::min(stretch, slots_ - begin);
    std::array<bool, stretch> lively;
    for (std::int64_t k = 0; k < count; ++k) lively[k] = lives(list, begin + k, stones);
    std::int64_t next = begin;
    for (const bool of : {true, false})
      for (std::int64_t k = 0; k < count; ++k) {
        if (lively[k] != of) continue;
        const std::int64_t pair = begin + k;
        const std::int32_t before = list.previous[pair];
        first_[next] = static_cast<std::int32_t>(list.first[pair]);
        second_[next] = static_cast<std::int32_t>(list.second[pair]);
        previous[next] = before < 0 ? -1 : slot_of_[before];
        slot_of[pair] = static_cast<std::int32_t>(next++);
      }
  }
  slot_of_ = std::move(slot_of);
  history.carry(previous);
  prepare(stones);
}

// Does a pair of a rebuilt list touch, or hold on to a contact?
template <ContactLaw Law>
bool PairContacts<Law>::lives(const NeighborList& list, std::int64_t pair,
                              const ParticleStore& stones) const {
  const std::uint32_t i = list.first[pair], j = list.second[pair];
  const Vec3d apart = stones.position[i] - stones.position[j];
  const double reach = stones.outer_radius(i) + stones.outer_radius(j);
  if (dot(apart, apart) < reach * reach) return true;
  return list.previous[pair] >= 0 && history.holds(slot_of_[list.previous[pair]]);
}

// What follows from the stones of the slots.
template <ContactLaw Law>
void PairContacts<Law>::prepare(ParticleStore& stones) {
  tallies_.take(first_, second_, stones);
  couple(stones);
  awake_.assign(couples_.size(), 1);
}

template <ContactLaw Law>
template <class T, bool check>
Extremes PairContacts<Law>::evaluate_blocks(ParticleStore& stones, double dt, double horizon) {
  Extremes found;
#pragma omp parallel if (tallies_.blocks() > 1)
  {
    const Law mine = law;  // not changed by what the loop writes, as the compiler can see
    LaneExtremes<T> extremes;
    Tallies::Batch batch;
#pragma omp for schedule(static)
    for (std::int64_t block = 0; block < tallies_.blocks(); ++block) {
      const std::int64_t begin = block * tallies_.slots_per_block();
      const std::int64_t end = std::min(slots_, begin + tallies_.slots_per_block());
      for (std::int64_t s = begin; s < end; s += Tallies::Batch::slots) {
        const int count = static_cast<int>(std::min<std::int64_t>(end - s, Tallies::Batch::slots));
        batch.clear();
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

template <ContactLaw Law>
void PairContacts<Law>::couple(const ParticleStore& stones) {
  couples_.resize(first_.size() / lanes);
#pragma omp parallel for schedule(static) if (tallies_.blocks() > 1)
  for (std::int64_t b = 0; b < std::ssize(couples_); ++b) {
    Couple<Pack> block = {};
    for (int k = 0; k < lanes && lanes * b + k < slots_; ++k) {
      const Couple<double> of = couple_of(stones, first_[lanes * b + k], second_[lanes * b + k]);
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
    return couple_of(stones, first_[slot], second_[slot]);
  else
    return couples_[slot / lanes];
}

// Two stones as the last step left them.
template <ContactLaw Law>
template <class T>
Passing<T> PairContacts<Law>::passing_at(const ParticleStore& stones, std::int64_t slot) const {
  const std::int32_t *i = &first_[slot], *j = &second_[slot];
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

// Is there nothing to do for a pack, which had no living contact in the last step?
template <ContactLaw Law>
template <class T>
bool PairContacts<Law>::dozes(const ParticleStore& stones, std::int64_t slot) const {
  if (width<T> == 1 || awake_[slot / lanes]) return false;
  const Vec3<T> apart = gather_difference<T>(stones.position, &first_[slot], &second_[slot]);
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
    const std::int32_t *i = &first_[slot], *j = &second_[slot];
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
  std::vector<SlotForce> forces(slots_, SlotForce{});
  for (std::int64_t s = 0; s < slots_; ++s) {
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
  return tallies_.bytes() + history.raw().size_bytes() +
         couples_.size() * (sizeof(Couple<Pack>) + sizeof(std::int32_t)) +
         (first_.size() + second_.size() + slot_of_.size()) * sizeof(std::int32_t);
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

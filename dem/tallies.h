// From forces of slots to loads of stones, with the same bits for any number of threads.
//
// Slots come in blocks of fixed size. Each block adds up, slot after slot, in tallies of its own,
// one per stone that it meets; then every stone adds up its weight and its tallies, in block order.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dem/groups.h"
#include "dem/particle_store.h"
#include "dem/records.h"

namespace dem {

class Tallies {
 public:
  static constexpr std::int64_t slots_per_block = 1024;  // a multiple of the lanes

  // For slots between the stones first[s] and second[s] of `stones` stones.
  void take(std::span<const std::int32_t> first, std::span<const std::int32_t> second,
            std::size_t stones);

  std::int64_t blocks() const { return static_cast<std::int64_t>(block_start_.size()) - 1; }
  void clear(std::int64_t block);
  // The loads on both stones of a few slots, to be added to the tallies in one go: the processor
  // sees far enough ahead in such a plain loop not to wait for the sum before.
  class Batch {
   public:
    static constexpr int slots = 64;

    // Of the T slots from number `at` of the batch on.
    template <class T>
    void put(int at, const LoadOf<T>& on_first, const LoadOf<T>& on_second);

   private:
    friend class Tallies;
    alignas(64) std::array<Pack, slots> on_first_, on_second_;
  };
  // Adds a batch of `count` slots from `slot` on, slot after slot.
  template <bool breaks>
  void add(std::int64_t slot, int count, const Batch& batch);

  // gravity [m/s2], downwards along z. Writes the stones' loads; crush only if they may break.
  void add_up(ParticleStore& stones, double gravity, bool breaks) const;

  std::size_t bytes() const;

 private:
  template <bool breaks>
  void add_up(ParticleStore& stones, double gravity) const;

  std::vector<std::uint32_t> first_, second_;  // by slot
  std::vector<std::uint32_t> block_start_;     // first tally of each block, and their number
  std::vector<Load> load_;                     // of each tally
  Groups of_stone_;
  std::vector<std::uint32_t> stone_;  // of each item of these
};

template <class T>
void Tallies::Batch::put(int at, const LoadOf<T>& on_first, const LoadOf<T>& on_second) {
  std::ranges::copy(records(on_first), on_first_.begin() + at);
  std::ranges::copy(records(on_second), on_second_.begin() + at);
}

template <bool breaks>
void Tallies::add(std::int64_t slot, int count, const Batch& batch) {
  for (int k = 0; k < count; ++k) {
    add_load<breaks>(batch.on_first_[k], load_[first_[slot + k]]);
    add_load<breaks>(batch.on_second_[k], load_[second_[slot + k]]);
  }
}

}  // namespace dem

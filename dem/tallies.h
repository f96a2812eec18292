// From forces of slots to loads of stones, with the same bits for any number of threads.
//
// Slots come in blocks of equal size, whatever the number of threads, each the work of one thread,
// that adds up slot after slot.
// The first block that meets a stone adds to the stone's load itself, further blocks each to a part
// of its load behind those of the stones; at last every stone adds up its parts in block order.
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
  // For slots between the stones first[s] and second[s]; their number is a multiple of the lanes.
  // Makes room for the parts in stones.load.
  void take(std::span<const std::int32_t> first, std::span<const std::int32_t> second,
            ParticleStore& stones);

  std::int64_t blocks() const { return blocks_; }
  std::int64_t slots_per_block() const { return slots_per_block_; }  // a multiple of the lanes

  // The forces of a few slots, to be added to the tallies in one go: the processor sees far enough
  // ahead in such a plain loop not to wait for the sum before.
  class Batch {
   public:
    static constexpr int slots = 64;

    void clear() { put_ = 0; }

    // Of the T slots from number `at` of the batch on: the force on the first stone, its opposite
    // on the second, the moment that times its arm is the torque on either, and what either is
    // crushed by.
    template <class T>
    void put(int at, const Vec3<T>& force, const Vec3<T>& moment, T arm_i, T arm_j, T crush);

    // What fills up the last eight behind `count` slots is without force.
    void end(int count) {
      if (!holds(count)) return;
      for (int k = count; k % lanes != 0; ++k) put<double>(k, {0, 0, 0}, {0, 0, 0}, 0, 0, 0);
    }

   private:
    friend class Tallies;
    bool holds(int slot) const { return put_ >> slot / lanes & 1; }

    std::uint32_t put_ = 0;  // a bit for every eight slots, of which all or none are put
    alignas(64) std::array<Quad, slots> force_, moment_;
    alignas(64) std::array<double, slots> arm_i_, arm_j_;
  };
  // Asks for the loads that a slot adds to before they are needed.
  [[gnu::always_inline]] void fetch(std::int64_t slot, const std::vector<Load>& load) const {
    constexpr int to_write = 1;
    __builtin_prefetch(&load[first_load_[slot]], to_write);
    __builtin_prefetch(&load[second_load_[slot]], to_write);
  }
  // Adds a batch of `count` slots from `slot` on, slot after slot.
  template <bool breaks>
  void add(std::int64_t slot, int count, const Batch& batch, std::vector<Load>& load) const;

  // The same work for any number of threads: chunk of chunks() adds up the parts of some stones and
  // leaves them empty. Of crush, which counts only if stones may break, the largest stays.
  std::int64_t chunks() const { return (std::ssize(of_stone_.start) - 2) / stones_per_chunk + 1; }
  template <bool breaks>
  void add_up(std::int64_t chunk, std::vector<Load>& load) const;

  std::size_t bytes() const;

 private:
  static constexpr std::int64_t stones_per_chunk = 512;

  std::int64_t blocks_ = 0, slots_per_block_ = 0;
  std::vector<std::uint32_t> first_load_, second_load_;  // place of the load that each slot adds to
  Groups of_stone_;                                      // the parts, by the stones
  std::vector<std::uint32_t> stone_;                     // of each item of these
};

template <class T>
void Tallies::Batch::put(int at, const Vec3<T>& force, const Vec3<T>& moment, T arm_i, T arm_j,
                         T crush) {
  put_ |= 1u << at / lanes;
  store(arm_i, &arm_i_[at]);
  store(arm_j, &arm_j_[at]);
  if constexpr (width<T> == 1) at += quad_place(at % lanes) - at % lanes;
  quads(force, T(0.0), &force_[at]);
  quads(moment, crush, &moment_[at]);
}

template <bool breaks>
void Tallies::add(std::int64_t slot, int count, const Batch& batch, std::vector<Load>& load) const {
  Load* const loads = load.data();
  const std::uint32_t* const first = &first_load_[slot];
  const std::uint32_t* const second = &second_load_[slot];
  for (int pack = 0; pack < count; pack += lanes) {
    if (!batch.holds(pack)) continue;
    for (int k = 0; k < lanes; ++k) {
      const int at = pack + quad_place(k);
      double* const i = &loads[first[pack + k]].force.x;
      store_quad(load_quad(i) + batch.force_[at], i);
      store_quad(joined<breaks>(load_quad(i + 4), batch.moment_[at], batch.arm_i_[pack + k]),
                 i + 4);
      double* const j = &loads[second[pack + k]].force.x;
      store_quad(load_quad(j) - batch.force_[at], j);
      store_quad(joined<breaks>(load_quad(j + 4), batch.moment_[at], batch.arm_j_[pack + k]),
                 j + 4);
    }
  }
}

template <bool breaks>
void Tallies::add_up(std::int64_t chunk, std::vector<Load>& load) const {
  const std::size_t stones = of_stone_.start.size() - 1;
  const std::size_t begin = chunk * stones_per_chunk;
  const std::size_t end = std::min<std::size_t>(stones, begin + stones_per_chunk);
  for (std::uint32_t k = of_stone_.start[begin]; k < of_stone_.start[end]; ++k) {
    Load& part = load[stones + of_stone_.item[k]];
    double* const sum = &load[stone_[k]].force.x;
    store_quad(load_quad(sum) + load_quad(&part.force.x), sum);
    store_quad(joined<breaks>(load_quad(sum + 4), load_quad(&part.torque.x)), sum + 4);
    part = Load{};
  }
}

}  // namespace dem

// From forces of slots to loads of stones, with the same bits for any number of threads.
//
// Slots come in blocks of fixed size. Each block adds up, slot after slot, in tallies of its own,
// one per stone that it meets. The first block that meets a stone does so in the tally of the
// stone's own number, further blocks in tallies behind those. At last every stone adds up its
// weight and its tallies, in block order.
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

  // For slots between the stones first[s] and second[s] of `stones` stones; their number is a
  // multiple of the lanes.
  void take(std::span<const std::int32_t> first, std::span<const std::int32_t> second,
            std::size_t stones);

  std::int64_t blocks() const { return static_cast<std::int64_t>(home_start_.size()) - 1; }
  void clear(std::int64_t block);
  // The forces of a few slots, to be added to the tallies in one go: the processor sees far enough
  // ahead in such a plain loop not to wait for the sum before.
  class Batch {
   public:
    static constexpr int slots = 64;

    // Of the T slots from number `at` of the batch on: the force on the first stone, its opposite
    // on the second, the torques on both, and what either stone is crushed by.
    template <class T>
    void put(int at, const Vec3<T>& force, const Vec3<T>& torque_i, const Vec3<T>& torque_j,
             T crush);

   private:
    friend class Tallies;
    alignas(64) std::array<Quad, slots> force_, torque_i_, torque_j_;
  };
  // Adds a batch of `count` slots from `slot` on, slot after slot; what fills up the last eight must
  // be without force.
  template <bool breaks>
  void add(std::int64_t slot, int count, const Batch& batch);

  // gravity [m/s2], downwards along z. Writes the stones' loads; crush only if they may break.
  void add_up(ParticleStore& stones, double gravity, bool breaks) const;

  std::size_t bytes() const;

 private:
  template <bool breaks>
  void add_up(ParticleStore& stones, double gravity) const;

  std::vector<std::uint32_t> first_, second_;  // place in load_ of the tally of each slot
  std::vector<std::uint32_t> home_;            // stones, by the block that met them first
  std::vector<std::uint32_t> home_start_, away_start_;  // of each block, and the number of all
  std::vector<Load> load_;                              // the tallies
  Groups of_stone_;                                     // of those behind the stones' own
  std::vector<std::uint32_t> stone_;                    // of each item of these
  std::size_t stones_ = 0;
};

template <class T>
void Tallies::Batch::put(int at, const Vec3<T>& force, const Vec3<T>& torque_i,
                         const Vec3<T>& torque_j, T crush) {
  if constexpr (width<T> == 1) {
    at += quad_place(at % lanes) - at % lanes;
    force_[at] = Quad{force.x, force.y, force.z, 0};
    torque_i_[at] = Quad{torque_i.x, torque_i.y, torque_i.z, crush};
    torque_j_[at] = Quad{torque_j.x, torque_j.y, torque_j.z, crush};
  } else {
    quads(force, T(0.0), &force_[at]);
    quads(torque_i, crush, &torque_i_[at]);
    quads(torque_j, crush, &torque_j_[at]);
  }
}

template <bool breaks>
void Tallies::add(std::int64_t slot, int count, const Batch& batch) {
  Load* const tallies = load_.data();
  const std::uint32_t* const first = &first_[slot];
  const std::uint32_t* const second = &second_[slot];
  for (int pack = 0; pack < count; pack += lanes)
    for (int k = 0; k < lanes; ++k) {
      const int at = pack + quad_place(k);
      double* const i = &tallies[first[pack + k]].force.x;
      store_quad(load_quad(i) + batch.force_[at], i);
      store_quad(joined<breaks>(load_quad(i + 4), batch.torque_i_[at]), i + 4);
      double* const j = &tallies[second[pack + k]].force.x;
      store_quad(load_quad(j) - batch.force_[at], j);
      store_quad(joined<breaks>(load_quad(j + 4), batch.torque_j_[at]), j + 4);
    }
}

}  // namespace dem

// Which slot works on which pair of a neighbour list.
//
// Of every few pairs those that live come before those that do not, so that whole packs of the
// latter can be passed over.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "dem/bytes.h"
#include "dem/neighbor_list.h"
#include "dem/pack.h"

namespace dem {

class Slots {
 public:
  // Places of the two stones of each slot; 0 in the slots that only fill up the last eight.
  std::vector<std::int32_t> first, second;

  std::int64_t count() const { return std::ssize(slot_of_); }

  // Takes over a rebuilt list, every one since the first. A pair lives if lives(i, j, slot) says
  // so, slot being that of the pair before, or -1. Returns for each slot the slot before, or -1.
  template <class Lives>
  std::vector<std::int32_t> take(const NeighborList& list, Lives lives);

  std::size_t bytes() const { return bytes_of(first, second, slot_of_); }

  // See dem/state.h.
  template <class Visit>
  void visit_state(Visit& visit, const std::string& in) {
    visit(in + "first", first);
    visit(in + "second", second);
    visit(in + "slot_of", slot_of_);
  }

 private:
  static constexpr std::int64_t few = 256;

  std::vector<std::int32_t> slot_of_;  // of each pair of the list
};

template <class Lives>
std::vector<std::int32_t> Slots::take(const NeighborList& list, Lives lives) {
  const std::int64_t pairs = std::ssize(list.first);
  first.assign((pairs + lanes - 1) / lanes * lanes, 0);
  second.assign(first.size(), 0);
  std::vector<std::int32_t> slot_of(pairs), previous(pairs);
#pragma omp parallel for schedule(static) if (pairs > 4 * few)
  for (std::int64_t begin = 0; begin < pairs; begin += few) {
    const std::int64_t end = std::min(pairs, begin + few);
    std::array<bool, few> lively;
    std::int64_t next_lively = begin, next = begin;
    for (std::int64_t pair = begin; pair < end; ++pair) {
      const std::int32_t before = list.previous[pair];
      const bool yes =
          lives(list.first[pair], list.second[pair], before < 0 ? -1 : slot_of_[before]);
      lively[pair - begin] = yes;
      next += yes;
    }
    for (std::int64_t pair = begin; pair < end; ++pair) {
      const std::int64_t slot = lively[pair - begin] ? next_lively++ : next++;
      const std::int32_t before = list.previous[pair];
      first[slot] = static_cast<std::int32_t>(list.first[pair]);
      second[slot] = static_cast<std::int32_t>(list.second[pair]);
      previous[slot] = before < 0 ? -1 : slot_of_[before];
      slot_of[pair] = static_cast<std::int32_t>(slot);
    }
  }
  slot_of_ = std::move(slot_of);
  return previous;
}

}  // namespace dem

// One Memory per slot of a contact list, eight slots to a block: member m of slot 8 b + k is number
// [m][k] of block b, so that a pack of contacts reads its memory in straight lines.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "dem/contact_law.h"

namespace dem {

template <ContactLaw Law>
class ContactHistory {
 public:
  using Block = typename Law::template Memory<Pack>;
  using Slot = typename Law::template Memory<double>;
  static constexpr int numbers = sizeof(Slot) / sizeof(double);

  void resize(std::size_t slots) { blocks_.assign((slots + lanes - 1) / lanes, Block{}); }

  Block& block(std::size_t b) { return blocks_[b]; }
  const Block& block(std::size_t b) const { return blocks_[b]; }

  Slot slot(std::size_t s) const {
    Slot memory;
    const double* from = reinterpret_cast<const double*>(&blocks_[s / lanes]) + s % lanes;
    double* to = reinterpret_cast<double*>(&memory);
    for (int m = 0; m < numbers; ++m) to[m] = from[m * lanes];
    return memory;
  }

  void set(std::size_t s, const Slot& memory) {
    double* to = reinterpret_cast<double*>(&blocks_[s / lanes]) + s % lanes;
    const double* from = reinterpret_cast<const double*>(&memory);
    for (int m = 0; m < numbers; ++m) to[m * lanes] = from[m];
  }

  bool holds(std::size_t s) const { return Law::template holds<double>(slot(s)); }

  // The memories of a rebuilt list: new slot s takes over those of old slot previous[s], -1 for
  // none.
  void carry(std::span<const std::int32_t> previous) {
    const ContactHistory old = std::move(*this);
    resize(previous.size());
    const std::int64_t slots = std::ssize(previous);
    constexpr std::int64_t few = 1024;  // not worth a second thread
#pragma omp parallel for schedule(static) if (slots > few)
    for (std::int64_t begin = 0; begin < slots; begin += lanes)
      for (std::int64_t s = begin; s < std::min(slots, begin + lanes); ++s)
        if (previous[s] >= 0) set(s, old.slot(previous[s]));
  }

  // Everything, as plain numbers, for a checkpoint.
  std::span<const double> raw() const {
    return {reinterpret_cast<const double*>(blocks_.data()), blocks_.size() * numbers * lanes};
  }
  std::span<double> raw() {
    return {reinterpret_cast<double*>(blocks_.data()), blocks_.size() * numbers * lanes};
  }

  // See dem/state.h.
  template <class Visit>
  void visit_state(Visit& visit, const std::string& in) {
    visit(in + "history", blocks_);
  }

 private:
  std::vector<Block> blocks_;
};

// The memory of the contacts that start at a slot, as a law wants it: a block in place for a Pack,
// a copy that is put back for a double.
template <class Law, class T>
struct MemoryOf {
  using Value = typename Law::template Memory<T>;
  std::conditional_t<width<T> == 1, Value, Value&> value;

  MemoryOf(ContactHistory<Law>& history, std::int64_t slot) : value(of(history, slot)) {}
  void keep(ContactHistory<Law>& history, std::int64_t slot) const {
    if constexpr (width<T> == 1) history.set(slot, value);
  }

 private:
  static decltype(auto) of(ContactHistory<Law>& history, std::int64_t slot) {
    if constexpr (width<T> == 1)
      return history.slot(slot);
    else
      return history.block(slot / lanes);
  }
};

}  // namespace dem

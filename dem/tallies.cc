#include "dem/tallies.h"

#include <algorithm>

#include "dem/pack.h"

namespace dem {

static_assert(Tallies::slots_per_block % lanes == 0);

void Tallies::take(std::span<const std::int32_t> first, std::span<const std::int32_t> second,
                   std::size_t stones) {
  const std::int64_t slots = std::ssize(first);
  stones_ = stones;
  first_.resize(slots);
  second_.resize(slots);
  home_.clear();
  home_start_.assign(1, 0);
  away_start_.assign(1, 0);
  std::vector<std::uint32_t> stone_of;             // of each tally away from home
  std::vector<std::uint32_t> tally_of(stones);     // by stone, in the newest block that met it
  std::vector<std::uint32_t> block_of(stones, 0);  // that one, counted from 1
  for (std::int64_t begin = 0; begin < slots; begin += slots_per_block) {
    const auto block = static_cast<std::uint32_t>(home_start_.size());
    const auto tally = [&](std::uint32_t stone) {
      if (block_of[stone] == block) return tally_of[stone];
      tally_of[stone] = stone;
      if (block_of[stone] == 0) {
        home_.push_back(stone);
      } else {
        tally_of[stone] = static_cast<std::uint32_t>(stones + stone_of.size());
        stone_of.push_back(stone);
      }
      block_of[stone] = block;
      return tally_of[stone];
    };
    for (std::int64_t s = begin; s < std::min(slots, begin + slots_per_block); ++s) {
      first_[s] = tally(static_cast<std::uint32_t>(first[s]));
      second_[s] = tally(static_cast<std::uint32_t>(second[s]));
    }
    home_start_.push_back(static_cast<std::uint32_t>(home_.size()));
    away_start_.push_back(static_cast<std::uint32_t>(stone_of.size()));
  }
  load_.assign(stones + stone_of.size(), Load{});
  of_stone_ = group_by(stone_of, stones);
  stone_.resize(stone_of.size());
  for (std::size_t k = 0; k < stone_.size(); ++k) stone_[k] = stone_of[of_stone_.item[k]];
}

void Tallies::clear(std::int64_t block) {
  for (std::uint32_t k = home_start_[block]; k < home_start_[block + 1]; ++k)
    load_[home_[k]] = Load{};
  const auto away = load_.begin() + static_cast<std::ptrdiff_t>(stones_);
  std::fill(away + away_start_[block], away + away_start_[block + 1], Load{});
}

void Tallies::add_up(ParticleStore& stones, double gravity, bool breaks) const {
  if (breaks)
    add_up<true>(stones, gravity);
  else
    add_up<false>(stones, gravity);
}

template <bool breaks>
void Tallies::add_up(ParticleStore& stones, double gravity) const {
  constexpr std::int64_t stones_per_chunk = 256;
  const std::int64_t count = std::ssize(stones.id);
#pragma omp parallel for schedule(static) if (count > stones_per_chunk)
  for (std::int64_t begin = 0; begin < count; begin += stones_per_chunk) {
    const std::int64_t end = std::min(count, begin + stones_per_chunk);
    for (std::int64_t i = begin; i < end; ++i) {
      stones.load[i] = load_[i];
      stones.load[i].force.z -= gravity * stones.mass[i];
    }
    for (std::uint32_t k = of_stone_.start[begin]; k < of_stone_.start[end]; ++k) {
      const double* part = &load_[stones_ + of_stone_.item[k]].force.x;
      double* sum = &stones.load[stone_[k]].force.x;
      store_quad(load_quad(sum) + load_quad(part), sum);
      store_quad(joined<breaks>(load_quad(sum + 4), load_quad(part + 4)), sum + 4);
    }
  }
}

std::size_t Tallies::bytes() const {
  return sizeof(Load) * load_.size() +
         sizeof(std::uint32_t) *
             (first_.size() + second_.size() + home_.size() + home_start_.size() +
              away_start_.size() + of_stone_.start.size() + of_stone_.item.size() + stone_.size());
}

}  // namespace dem

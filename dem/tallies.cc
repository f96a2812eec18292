#include "dem/tallies.h"

#include <algorithm>

#include "dem/bytes.h"
#include "dem/pack.h"

namespace dem {

void Tallies::take(std::span<const std::int32_t> first, std::span<const std::int32_t> second,
                   ParticleStore& stones) {
  const std::int64_t slots = std::ssize(first);
  constexpr std::int64_t enough = 1024, shares = 8;  // even for two, four or eight threads
  constexpr std::int64_t most = 16 * shares;         // the larger a block, the fewer the parts
  blocks_ = slots <= enough ? 1 : (slots - 1) / (shares * enough) * shares + shares;
  blocks_ = std::min(blocks_, most);
  slots_per_block_ = (slots / blocks_ + lanes) / lanes * lanes;
  first_load_.resize(slots);
  second_load_.resize(slots);
  std::vector<std::uint32_t> stone_of;                    // by part
  std::vector<std::uint32_t> place_of(stones.size());     // in the newest block that met the stone
  std::vector<std::uint32_t> block_of(stones.size(), 0);  // that one, counted from 1
  for (std::uint32_t block = 1; block <= blocks_; ++block) {
    const auto place = [&](std::uint32_t stone) {
      if (block_of[stone] == block) return place_of[stone];
      place_of[stone] = stone;
      if (block_of[stone] != 0) {
        place_of[stone] = static_cast<std::uint32_t>(stones.size() + stone_of.size());
        stone_of.push_back(stone);
      }
      block_of[stone] = block;
      return place_of[stone];
    };
    const std::int64_t begin = (block - 1) * slots_per_block_;
    for (std::int64_t s = begin; s < std::min(slots, begin + slots_per_block_); ++s) {
      first_load_[s] = place(static_cast<std::uint32_t>(first[s]));
      second_load_[s] = place(static_cast<std::uint32_t>(second[s]));
    }
  }
  of_stone_ = group_by(stone_of, stones.size());
  stone_.resize(stone_of.size());
  for (std::size_t k = 0; k < stone_.size(); ++k) stone_[k] = stone_of[of_stone_.item[k]];
  stones.load.resize(stones.size());
  stones.load.resize(stones.size() + stone_of.size(), Load{});
}

std::size_t Tallies::bytes() const {
  return bytes_of(first_load_, second_load_, of_stone_.start, of_stone_.item, stone_);
}

}  // namespace dem

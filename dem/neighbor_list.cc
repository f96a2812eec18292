#include "dem/neighbor_list.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

namespace dem {
namespace {

struct Level {
  int exponent;           // of two, of the radii
  double largest_radius;  // [m]
  CellGrid grid;
};

// From the finest to the coarsest; a cell is as wide as the widest gap-free pair of its level.
std::vector<Level> sort_into_levels(const Spheres& spheres, double skin) {
  std::map<int, std::vector<std::uint32_t>> places;
  for (std::uint32_t k = 0; k < spheres.radius.size(); ++k) {
    places[std::ilogb(spheres.radius[k])].push_back(k);
  }
  std::vector<Level> levels;
  for (const auto& [exponent, members] : places) {
    double largest = 0;
    for (const std::uint32_t k : members) largest = std::max(largest, spheres.radius[k]);
    levels.push_back({exponent, largest, {}});
    levels.back().grid.fill(spheres, members, 2 * largest + skin);
  }
  return levels;
}

// Puts the places of all stones that are close to stone i and come second to it at the front of
// `found`, which only ever grows, and returns how many they are.
std::size_t find_seconds(const Spheres& spheres, const std::vector<Level>& levels, double skin,
                         std::size_t i, std::vector<std::uint32_t>& found) {
  std::size_t end = 0;
  const Vec3d position = spheres.position[i];
  const double radius = spheres.radius[i];
  const std::uint32_t id = spheres.id[i];
  const int exponent = std::ilogb(radius);
  for (const Level& level : levels) {
    if (level.exponent < exponent) continue;
    const bool coarser = level.exponent > exponent;
    level.grid.near(position, radius + level.largest_radius + skin, [&](auto run) {
      // Every entry is written, and only a hit moves the end: a branch here is guessed wrong often.
      if (found.size() < end + run.size()) found.resize(2 * (end + run.size()));
      for (const CellGrid::Entry& other : run) {
        const Vec3d apart = position - other.position;
        const double reach = radius + other.radius + skin;
        found[end] = other.place;
        end += (dot(apart, apart) < reach * reach) & (coarser | (id < other.id));
      }
    });
  }
  return end;
}

// The numbers 0, 1, ... of `keys` grouped by key: those of key k, rising, are
// item[start[k]] to item[start[k + 1]].
struct Groups {
  std::vector<std::uint32_t> start, item;
};

Groups group_by(std::span<const std::uint32_t> keys, std::size_t key_count) {
  Groups groups{std::vector<std::uint32_t>(key_count + 1, 0),
                std::vector<std::uint32_t>(keys.size())};
  for (const std::uint32_t key : keys) ++groups.start[key];
  for (std::size_t k = 1; k <= key_count; ++k) groups.start[k] += groups.start[k - 1];
  for (std::size_t n = keys.size(); n-- > 0;) {
    groups.item[--groups.start[keys[n]]] = static_cast<std::uint32_t>(n);
  }
  return groups;
}

constexpr std::int64_t rows_per_chunk = 128;  // searched by one thread in one go

}  // namespace

void NeighborList::build(const Spheres& spheres, double skin, std::span<const StonePair> keep,
                         std::span<const std::uint32_t> old_index) {
  const std::int64_t count = static_cast<std::int64_t>(spheres.position.size());
  assert(spheres.radius.size() == spheres.position.size());
  assert(spheres.id.size() == spheres.position.size());
  assert(old_index.empty() || old_index.size() == spheres.position.size());

  const NeighborList old = std::move(*this);
  std::vector<std::uint32_t> kept_first;
  for (const StonePair& pair : keep) kept_first.push_back(pair.first);
  const Groups kept = group_by(kept_first, count);
  const std::vector<Level> levels = sort_into_levels(spheres, skin);

  // Of each chunk, the seconds of one row after the other.
  std::vector<std::vector<std::uint32_t>> chunks((count + rows_per_chunk - 1) / rows_per_chunk);
  row_start.assign(count + 1, 0);
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t c = 0; c < std::ssize(chunks); ++c) {
    std::vector<std::uint32_t>& seconds = chunks[c];
    std::vector<std::uint32_t> found;
    const std::int64_t end = std::min(count, (c + 1) * rows_per_chunk);
    for (std::int64_t i = c * rows_per_chunk; i < end; ++i) {
      const auto row = std::ssize(seconds);
      const std::size_t near = find_seconds(spheres, levels, skin, i, found);
      seconds.insert(seconds.end(), found.begin(), found.begin() + near);
      for (std::uint32_t k = kept.start[i]; k < kept.start[i + 1]; ++k) {
        const std::uint32_t j = keep[kept.item[k]].second;
        assert(comes_first(spheres.radius[i], spheres.id[i], spheres.radius[j], spheres.id[j]));
        seconds.push_back(j);
      }
      std::sort(seconds.begin() + row, seconds.end());
      seconds.erase(std::unique(seconds.begin() + row, seconds.end()), seconds.end());
      row_start[i + 1] = static_cast<std::uint32_t>(std::ssize(seconds) - row);
    }
  }
  for (std::int64_t i = 0; i < count; ++i) row_start[i + 1] += row_start[i];
  assert(row_start.back() <= std::uint32_t(std::numeric_limits<std::int32_t>::max()));

  first.resize(row_start.back());
  second.resize(row_start.back());
  previous.resize(row_start.back());
  const auto was = [&](std::uint32_t place) {
    return old_index.empty() ? place : old_index[place];
  };
#pragma omp parallel for schedule(static)
  for (std::int64_t c = 0; c < std::ssize(chunks); ++c) {
    const std::int64_t begin = c * rows_per_chunk, end = std::min(count, begin + rows_per_chunk);
    std::ranges::copy(chunks[c], second.begin() + row_start[begin]);
    for (std::int64_t i = begin; i < end; ++i) {
      for (std::uint32_t slot = row_start[i]; slot < row_start[i + 1]; ++slot) {
        first[slot] = static_cast<std::uint32_t>(i);
        previous[slot] = old.slot_of(was(i), was(second[slot]));
      }
    }
  }

  Groups reverse = group_by(second, count);
  reverse_start = std::move(reverse.start);
  reverse_slot = std::move(reverse.item);
}

std::int32_t NeighborList::slot_of(std::uint32_t i, std::uint32_t j) const {
  if (i + 1 >= row_start.size()) return -1;
  const auto begin = second.begin() + row_start[i], end = second.begin() + row_start[i + 1];
  const auto found = std::lower_bound(begin, end, j);
  return found != end && *found == j ? static_cast<std::int32_t>(found - second.begin()) : -1;
}

}  // namespace dem

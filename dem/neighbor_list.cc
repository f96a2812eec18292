#include "dem/neighbor_list.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "dem/bytes.h"
#include "dem/groups.h"

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

constexpr std::int64_t rows_per_chunk = 128;    // searched by one thread in one go
constexpr std::int64_t stones_per_stray = 128;  // up to so few, only theirs are searched

// Of the candidates, for a list with the given one [m]: wide enough to last for many builds, and
// not so wide that they are many more than the neighbours.
double wide_skin(const Spheres& spheres, double skin) {
  double mean = 0;
  for (const double r : spheres.radius) mean += r / static_cast<double>(spheres.radius.size());
  return std::max(12 * skin, 0.3 * mean);
}

bool closer(const Spheres& spheres, std::uint32_t i, std::uint32_t j, double skin) {
  const Vec3d apart = spheres.position[i] - spheres.position[j];
  const double reach =
      spheres.radius[i] + spheres.radius[j] + skin + spheres.extra_of(i) + spheres.extra_of(j);
  return dot(apart, apart) < reach * reach;
}

// Adds every pair of one of these stones with any other; a pair of two of them twice.
void add_pairs_of(std::span<const std::uint32_t> stones, const Spheres& spheres, double skin,
                  std::vector<StonePair>& pairs) {
  if (stones.empty()) return;
  double reach = 0, largest = 0;
  for (const std::uint32_t i : stones) {
    largest = std::max(largest, spheres.radius[i]);
    reach = std::max(reach, spheres.radius[i] + skin + spheres.extra_of(i));
  }
  CellGrid grid;
  grid.fill(spheres, stones, 2 * largest + skin);
  for (std::uint32_t k = 0; k < spheres.position.size(); ++k) {
    const double radius = spheres.radius[k];
    grid.near(spheres.position[k], radius + spheres.extra_of(k) + reach, [&](auto run) {
      for (const CellGrid::Entry& stone : run) {
        const std::uint32_t i = stone.place;
        if (i == k || !closer(spheres, i, k, skin)) continue;
        const bool first = comes_first(stone.radius, stone.id, radius, spheres.id[k]);
        pairs.push_back(first ? StonePair{i, k} : StonePair{k, i});
      }
    });
  }
}

// Calls row(i, chunk) for all rows, those of a chunk in order; chunks side by side.
template <class Chunk, class Row>
std::vector<Chunk> in_chunks(std::int64_t rows, Row row) {
  std::vector<Chunk> chunks((rows + rows_per_chunk - 1) / rows_per_chunk);
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t c = 0; c < std::ssize(chunks); ++c) {
    const std::int64_t end = std::min(rows, (c + 1) * rows_per_chunk);
    for (std::int64_t i = c * rows_per_chunk; i < end; ++i) row(i, chunks[c]);
  }
  return chunks;
}

void add_up(std::vector<std::uint32_t>& row_start) {
  for (std::size_t i = 1; i < row_start.size(); ++i) row_start[i] += row_start[i - 1];
  assert(row_start.back() <= std::uint32_t(std::numeric_limits<std::int32_t>::max()));
}

}  // namespace

void Candidates::search(const Spheres& spheres, double wide_skin) {
  skin = wide_skin;
  position.assign(spheres.position.begin(), spheres.position.end());
  radius.assign(spheres.radius.begin(), spheres.radius.end());
  id.assign(spheres.id.begin(), spheres.id.end());
  const std::vector<Level> levels = sort_into_levels(spheres, skin);
  const std::int64_t count = std::ssize(spheres.position);
  row_start.assign(count + 1, 0);
  struct Chunk {
    std::vector<std::uint32_t> seconds, found;
  };
  const auto chunks = in_chunks<Chunk>(count, [&](std::int64_t i, Chunk& chunk) {
    const std::size_t near = find_seconds(spheres, levels, skin, i, chunk.found);
    std::sort(chunk.found.begin(), chunk.found.begin() + near);
    chunk.seconds.insert(chunk.seconds.end(), chunk.found.begin(), chunk.found.begin() + near);
    row_start[i + 1] = static_cast<std::uint32_t>(near);
  });
  add_up(row_start);
  second.clear();
  second.reserve(row_start.back());
  for (const Chunk& chunk : chunks)
    second.insert(second.end(), chunk.seconds.begin(), chunk.seconds.end());
}

bool Candidates::are_of(const Spheres& spheres) const {
  return std::ranges::equal(spheres.id, id) && std::ranges::equal(spheres.radius, radius);
}

std::vector<std::uint32_t> Candidates::strays(const Spheres& spheres, double wanted) const {
  std::vector<std::uint32_t> found;
  for (std::uint32_t k = 0; k < position.size(); ++k) {
    const double way = norm(spheres.position[k] - position[k]) + spheres.extra_of(k);
    if (wanted + 2 * way > skin) found.push_back(k);
  }
  return found;
}

void NeighborList::build(const Spheres& spheres, double skin, std::span<const StonePair> keep,
                         std::span<const std::uint32_t> old_index) {
  const std::int64_t count = std::ssize(spheres.position);
  assert(spheres.radius.size() == spheres.position.size());
  assert(spheres.id.size() == spheres.position.size());
  assert(old_index.empty() || old_index.size() == spheres.position.size());

  NeighborList old = std::move(*this);
  candidates = std::move(old.candidates);
  std::vector<StonePair> beside(keep.begin(), keep.end());
  const bool known = candidates.are_of(spheres);
  auto strays = known ? candidates.strays(spheres, skin) : std::vector<std::uint32_t>();
  if (!known || std::ssize(strays) > 1 + count / stones_per_stray) {
    candidates.search(spheres, wide_skin(spheres, skin));
    strays = candidates.strays(spheres, skin);  // the few whose extra is wider than the stock
  }
  add_pairs_of(strays, spheres, skin, beside);

  std::vector<std::uint32_t> kept_first;
  for (const StonePair& pair : beside) kept_first.push_back(pair.first);
  const Groups kept = group_by(kept_first, count);
  row_start.assign(count + 1, 0);
  const auto chunks = in_chunks<std::vector<std::uint32_t>>(
      count, [&](std::int64_t i, std::vector<std::uint32_t>& seconds) {
        const std::size_t begin = seconds.size();
        std::size_t end = begin;
        seconds.resize(begin + candidates.row_start[i + 1] - candidates.row_start[i]);
        for (std::uint32_t k = candidates.row_start[i]; k < candidates.row_start[i + 1]; ++k) {
          const std::uint32_t j = candidates.second[k];
          // Every candidate is written, and only a hit moves the end: a branch is guessed wrong.
          seconds[end] = j;
          end += closer(spheres, i, j, skin);
        }
        seconds.resize(end);
        if (kept.start[i] < kept.start[i + 1]) {
          for (std::uint32_t k = kept.start[i]; k < kept.start[i + 1]; ++k) {
            const std::uint32_t j = beside[kept.item[k]].second;
            assert(comes_first(spheres.radius[i], spheres.id[i], spheres.radius[j], spheres.id[j]));
            seconds.push_back(j);
          }
          std::sort(seconds.begin() + begin, seconds.end());
          seconds.erase(std::unique(seconds.begin() + begin, seconds.end()), seconds.end());
        }
        row_start[i + 1] = static_cast<std::uint32_t>(seconds.size() - begin);
      });
  add_up(row_start);

  first.resize(row_start.back());
  second.resize(row_start.back());
  previous.resize(row_start.back());
#pragma omp parallel for schedule(static)
  for (std::int64_t c = 0; c < std::ssize(chunks); ++c) {
    const std::int64_t begin = c * rows_per_chunk, end = std::min(count, begin + rows_per_chunk);
    std::ranges::copy(chunks[c], second.begin() + row_start[begin]);
    for (std::int64_t i = begin; i < end; ++i) {
      std::fill(first.begin() + row_start[i], first.begin() + row_start[i + 1],
                static_cast<std::uint32_t>(i));
      find_previous(i, old, old_index);
    }
  }
}

void NeighborList::find_previous(std::uint32_t i, const NeighborList& old,
                                 std::span<const std::uint32_t> old_index) {
  if (!old_index.empty()) {
    for (std::uint32_t slot = row_start[i]; slot < row_start[i + 1]; ++slot)
      previous[slot] = old.slot_of(old_index[i], old_index[second[slot]]);
    return;
  }
  const bool listed = i + 1 < old.row_start.size();
  std::uint32_t at = listed ? old.row_start[i] : 0;
  const std::uint32_t end = listed ? old.row_start[i + 1] : 0;
  for (std::uint32_t slot = row_start[i]; slot < row_start[i + 1]; ++slot) {
    while (at < end && old.second[at] < second[slot]) ++at;
    previous[slot] =
        at < end && old.second[at] == second[slot] ? static_cast<std::int32_t>(at) : -1;
  }
}

std::int32_t NeighborList::slot_of(std::uint32_t i, std::uint32_t j) const {
  if (i + 1 >= row_start.size()) return -1;
  const auto begin = second.begin() + row_start[i], end = second.begin() + row_start[i + 1];
  const auto found = std::lower_bound(begin, end, j);
  return found != end && *found == j ? static_cast<std::int32_t>(found - second.begin()) : -1;
}

std::size_t NeighborList::bytes() const {
  return bytes_of(row_start, first, second, previous, candidates.position, candidates.radius,
                  candidates.id, candidates.row_start, candidates.second);
}

}  // namespace dem

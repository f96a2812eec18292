// All pairs of spheres closer than a skin, each pair once: the slots in which contacts live.
//
// A pair belongs to the row of its first stone, and which stone is first depends only on the radii
// and the ids of the two (see `comes_first`), never on where the store holds them. So a slot keeps
// its orientation, and with it the sign of its history, over every rebuild and reordering.
//
// Most builds only sift a stock of candidates, pairs closer than a much wider skin, and let all
// stones look into a grid of the few that have moved too far for it. The stock is searched anew
// when these are no longer few or stones were reordered, by levels of radius (after Ogarko, Luding
// (2012)): each level spans a factor of two and has a grid of its own, and a stone looks for
// partners in its own and the coarser levels, so that small stones do not pay for large ones.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "dem/cell_grid.h"

namespace dem {

struct StonePair {
  std::uint32_t first, second;  // places in the store
};

// Whether a stone of outer radius r [m] is the first of its pair with another stone: the one of the
// lower level of radius, of the lower id where the levels are the same.
inline bool comes_first(double r, std::uint32_t id, double other_r, std::uint32_t other_id) {
  const int level = std::ilogb(r), other_level = std::ilogb(other_r);
  return level != other_level ? level < other_level : id < other_id;
}

// Pairs closer than `skin` [m] when the stones were at `position`: row i, rising, is
// second[row_start[i]] to second[row_start[i + 1]].
struct Candidates {
  double skin = 0;
  std::vector<Vec3d> position;  // [m]
  std::vector<double> radius;   // [m]
  std::vector<std::uint32_t> id;
  std::vector<std::uint32_t> row_start, second;

  void search(const Spheres& spheres, double wide_skin);
  // Whether they were searched among these very spheres, in this order.
  bool are_of(const Spheres& spheres) const;
  // Every pair that is closer than `wanted` [m] now, their extras added, is among them, unless one
  // of these stones is in it: those that have moved farthest.
  std::vector<std::uint32_t> strays(const Spheres& spheres, double wanted) const;
};

struct NeighborList {
  // All arrays are written by build() alone, and are the same for any number of threads.
  // Row i, the slots row_start[i] to row_start[i + 1], holds the pairs of which i is the first.
  std::vector<std::uint32_t> row_start;
  std::vector<std::uint32_t> first;    // place of the first stone of each slot
  std::vector<std::uint32_t> second;   // place of the second, rising within a row
  std::vector<std::int32_t> previous;  // slot of the same pair before the build, or -1

  // Lists every pair whose spheres are less than `skin` [m] and their extras apart, and the pairs
  // to `keep`, however far apart; those must be oriented (see comes_first). If the store was
  // reordered since the last build, old_index[i] is the place where stone i was then.
  void build(const Spheres& spheres, double skin, std::span<const StonePair> keep = {},
             std::span<const std::uint32_t> old_index = {});

  // The slot of the pair (i, j), i coming first; -1 if it is not listed.
  std::int32_t slot_of(std::uint32_t i, std::uint32_t j) const;

  std::size_t bytes() const;  // of all arrays, the candidates included

  Candidates candidates;

 private:
  // Writes `previous` of row i.
  void find_previous(std::uint32_t i, const NeighborList& old,
                     std::span<const std::uint32_t> old_index);
};

}  // namespace dem

// Spheres sorted into cubic cells, so that those near a point lie in a few runs of memory.
//
// The grid covers the middle of the spheres; what lies outside is counted in the border cells. That
// is exact, because clamping a cell number never moves two of them further apart, and it keeps the
// grid small when single stones fly far away.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "dem/vec3.h"

namespace dem {

// The spheres of a search: one entry per place of the store.
struct Spheres {
  std::span<const Vec3d> position;    // [m]
  std::span<const double> radius;     // out to the skin of the shell [m]
  std::span<const std::uint32_t> id;  // unique, and the same however the store is ordered
  std::span<const double> extra;      // what each sphere widens the skin by [m]; empty: nothing

  double extra_of(std::size_t k) const { return extra.empty() ? 0 : extra[k]; }
};

class CellGrid {
 public:
  struct Entry {
    Vec3d position;       // [m]
    double radius;        // [m]
    std::uint32_t id;     // of the stone
    std::uint32_t place;  // in the store
  };

  // Sorts the spheres at the given places; `cell` is the wanted width of the cells [m], which grow
  // if there would be far more cells than spheres.
  void fill(const Spheres& spheres, std::span<const std::uint32_t> places, double cell);

  // Calls visit(run), run being a std::span<const Entry>, for entries that together hold every
  // sphere whose centre lies within `reach` [m] of p along each axis.
  template <class Visit>
  void near(const Vec3d& p, double reach, Visit visit) const {
    const Vec3d offset = p - low_;
    const int x_low = cell_of(offset.x - reach, 0), x_high = cell_of(offset.x + reach, 0);
    const int y_low = cell_of(offset.y - reach, 1), y_high = cell_of(offset.y + reach, 1);
    const int z_low = cell_of(offset.z - reach, 2), z_high = cell_of(offset.z + reach, 2);
    for (int z = z_low; z <= z_high; ++z) {
      for (int y = y_low; y <= y_high; ++y) {
        const std::size_t row = (std::size_t(z) * cells_[1] + y) * cells_[0];
        const std::uint32_t begin = start_[row + x_low], end = start_[row + x_high + 1];
        if (begin < end) visit(std::span(entries_).subspan(begin, end - begin));
      }
    }
  }

 private:
  // Written so that a coordinate that is not a number falls into the first cell.
  int cell_of(double offset, int axis) const {
    const double cell = offset * per_cell_;
    return cell > 0 ? (cell < cells_[axis] ? static_cast<int>(cell) : cells_[axis] - 1) : 0;
  }

  Vec3d low_;                         // corner of the grid [m]
  double per_cell_ = 0;               // 1 / width of a cell [1/m]
  std::array<int, 3> cells_;          // along x, y, z
  std::vector<std::uint32_t> start_;  // first entry of each cell, and the number of entries
  std::vector<Entry> entries_;        // by cell; within a cell in the order of the places
  std::vector<std::uint32_t> cell_;   // of each place, while the grid is filled
};

}  // namespace dem

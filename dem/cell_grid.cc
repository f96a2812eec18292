#include "dem/cell_grid.h"

#include <algorithm>
#include <cassert>

namespace dem {
namespace {

struct Range {
  double low, high;  // [m]
};

// The middle nine tenths of a sample of one coordinate, widened by a fifth of its length either
// way: all of a bed, but not the few that flew out of it.
Range middle(const Spheres& spheres, std::span<const std::uint32_t> places, double Vec3d::*axis) {
  constexpr std::size_t enough = 1000;
  const std::size_t stride = places.size() / enough + 1;
  std::vector<double> sample;
  for (std::size_t k = 0; k < places.size(); k += stride) {
    const double coordinate = spheres.position[places[k]].*axis;
    if (std::isfinite(coordinate)) sample.push_back(coordinate);
  }
  if (sample.empty()) return {0, 0};
  const std::size_t tail = sample.size() / 20;
  std::ranges::sort(sample);
  const double low = sample[tail], high = sample[sample.size() - 1 - tail];
  const double margin = (high - low) / 5;
  return {low - margin, high + margin};
}

}  // namespace

void CellGrid::fill(const Spheres& spheres, std::span<const std::uint32_t> places, double cell) {
  assert(cell > 0);
  const Range x = middle(spheres, places, &Vec3d::x);
  const Range y = middle(spheres, places, &Vec3d::y);
  const Range z = middle(spheres, places, &Vec3d::z);
  const std::array<double, 3> extent = {x.high - x.low, y.high - y.low, z.high - z.low};
  low_ = {x.low, y.low, z.low};
  const double most_cells = 8 * static_cast<double>(places.size()) + 64;
  const auto along = [&](double length) { return std::floor(length / cell) + 1; };
  while (along(extent[0]) * along(extent[1]) * along(extent[2]) > most_cells) cell *= 1.25;
  per_cell_ = 1 / cell;
  for (int axis = 0; axis < 3; ++axis) cells_[axis] = static_cast<int>(along(extent[axis]));

  // Counting sort: count, sum up, and place from behind, which leaves start_ at the first entries.
  start_.assign(std::size_t(cells_[0]) * cells_[1] * cells_[2] + 1, 0);
  cell_.resize(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Vec3d offset = spheres.position[places[k]] - low_;
    const std::size_t row = std::size_t(cell_of(offset.z, 2)) * cells_[1] + cell_of(offset.y, 1);
    cell_[k] = static_cast<std::uint32_t>(row * cells_[0] + cell_of(offset.x, 0));
    ++start_[cell_[k]];
  }
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  entries_.resize(places.size());
  for (std::size_t k = places.size(); k-- > 0;) {
    const std::uint32_t place = places[k];
    entries_[--start_[cell_[k]]] = {spheres.position[place], spheres.radius[place],
                                    spheres.id[place], place};
  }
}

}  // namespace dem

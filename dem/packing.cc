#include "dem/packing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "dem/random.h"

namespace dem {
namespace {

double cross_section(const RoundMould& mould) {
  return std::numbers::pi * mould.radius * mould.radius;
}
double cross_section(const RectangularMould& mould) {
  return mould.length * mould.width;
}

double largest_fit(const RoundMould& mould) {
  return mould.radius;
}
double largest_fit(const RectangularMould& mould) {
  return std::min(mould.length, mould.width) / 2;
}

// A point of the cross section at least r away from its edge, uniform for uniform u, v in (0, 1).
Vec3d inside(const RoundMould& mould, double r, double u, double v) {
  const double distance = (mould.radius - r) * std::sqrt(u), angle = 2 * std::numbers::pi * v;
  return {distance * std::cos(angle), distance * std::sin(angle), 0};
}
Vec3d inside(const RectangularMould& mould, double r, double u, double v) {
  return {r + u * (mould.length - 2 * r), r + v * (mould.width - 2 * r), 0};
}

// The space that the mould bounds: 0 < z < height, and the box around its cross section.
struct Space {
  Vec3d low, high;  // [m]
};

Space space_of(const RoundMould& mould, double height) {
  return {{-mould.radius, -mould.radius, 0}, {mould.radius, mould.radius, height}};
}
Space space_of(const RectangularMould& mould, double height) {
  return {{0, 0, 0}, {mould.length, mould.width, height}};
}

// The stones placed so far whose radii lie within one factor of two, in cells as wide as the
// largest of them, so that a search costs the same for small stones as for large ones. The cells
// grow in a thin gas, to be no more than the stones of the whole gas.
class PlacedStones {
 public:
  PlacedStones(const Space& space, double largest_radius, std::size_t stones)
      : low_(space.low), largest_radius_(largest_radius) {
    const Vec3d extent = space.high - space.low;
    const double volume = extent.x * extent.y * extent.z;
    cell_ = std::max(2 * largest_radius, std::cbrt(volume / static_cast<double>(stones)));
    for (const double length : {extent.x, extent.y, extent.z}) {
      cells_.push_back(static_cast<int>(length / cell_) + 1);
    }
    last_.assign(std::size_t(cells_[0]) * cells_[1] * cells_[2], none);
  }

  void add(const Vec3d& position, double radius) {
    int& last = last_[index(cell_of(position.x - low_.x, 0), cell_of(position.y - low_.y, 1),
                            cell_of(position.z - low_.z, 2))];
    stones_.push_back({position, radius, last});
    last = static_cast<int>(stones_.size()) - 1;
  }

  bool touch(const Vec3d& position, double radius) const {
    const Vec3d p = position - low_;
    const double reach = radius + largest_radius_;
    for (int z = cell_of(p.z - reach, 2); z <= cell_of(p.z + reach, 2); ++z) {
      for (int y = cell_of(p.y - reach, 1); y <= cell_of(p.y + reach, 1); ++y) {
        for (int x = cell_of(p.x - reach, 0); x <= cell_of(p.x + reach, 0); ++x) {
          for (int k = last_[index(x, y, z)]; k != none; k = stones_[k].before) {
            const Vec3d apart = position - stones_[k].position;
            const double touching = radius + stones_[k].radius;
            if (dot(apart, apart) <= touching * touching) return true;
          }
        }
      }
    }
    return false;
  }

 private:
  static constexpr int none = -1;

  struct Stone {
    Vec3d position;  // [m]
    double radius;   // [m]
    int before;      // the stone added to the same cell before this one
  };

  int cell_of(double distance, int axis) const {
    return std::clamp(static_cast<int>(std::floor(distance / cell_)), 0, cells_[axis] - 1);
  }
  std::size_t index(int x, int y, int z) const {
    return (std::size_t(z) * cells_[1] + y) * cells_[0] + x;
  }

  Vec3d low_;               // [m]
  double cell_;             // width of a cell [m]
  double largest_radius_;   // [m]
  std::vector<int> cells_;  // along x, y, z
  std::vector<int> last_;   // of the stones in each cell
  std::vector<Stone> stones_;
};

// Positions in the order of the radii, or nothing if some stone found no place.
std::optional<std::vector<Vec3d>> place(std::span<const double> radius, const Mould& mould,
                                        double height, std::uint64_t seed) {
  constexpr std::uint32_t tries = 20000;  // of one stone
  std::vector<std::uint32_t> order(radius.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, std::greater{}, [&](std::uint32_t k) { return radius[k]; });

  std::vector<Vec3d> position(radius.size());
  std::vector<PlacedStones> levels;
  double level_radius = 0;
  for (const std::uint32_t k : order) {
    const double r = radius[k];
    if (levels.empty() || r < level_radius / 2) {
      level_radius = r;
      levels.emplace_back(std::visit([&](auto& m) { return space_of(m, height); }, mould), r,
                          radius.size());
    }
    const auto number = [&](std::uint32_t draw) {
      return uniform(seed, Purpose::position, k, draw);
    };
    const auto free = [&] {
      return std::ranges::none_of(levels, [&](auto& level) { return level.touch(position[k], r); });
    };
    std::uint32_t attempt = 0;
    do {
      if (attempt == tries) return std::nullopt;
      const double u = number(3 * attempt), v = number(3 * attempt + 1);
      position[k] = std::visit([&](auto& m) { return inside(m, r, u, v); }, mould);
      position[k].z = r + number(3 * attempt + 2) * (height - 2 * r);
      ++attempt;
    } while (!free());
    levels.back().add(position[k], r);
  }
  return position;
}

}  // namespace

Gas pack_gas(std::span<const double> outer_radius, const Mould& mould, double packing_density,
             std::uint64_t seed) {
  assert(!outer_radius.empty() && packing_density > 0);
  const double largest = std::ranges::max(outer_radius);
  if (!(largest < std::visit([](auto& m) { return largest_fit(m); }, mould))) {
    throw std::invalid_argument("the largest stone does not fit between the walls of the mould");
  }
  double volume = 0;
  for (const double r : outer_radius) volume += 4 * std::numbers::pi / 3 * r * r * r;
  const double area = std::visit([](auto& m) { return cross_section(m); }, mould);
  for (double height = std::max(volume / (packing_density * area), 2 * largest);; height *= 1.05) {
    if (auto position = place(outer_radius, mould, height, seed)) {
      return {std::move(*position), height};
    }
  }
}

}  // namespace dem

#include "dem/spatial_order.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <tuple>
#include <utility>

namespace dem {
namespace {

// Bits 0, 1, 2, ... of a cell number moved to places 0, 3, 6, ...
std::uint64_t spread_bits(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  x = (x | x << 2) & 0x1249249249249249;
  return x;
}

}  // namespace

std::vector<std::uint32_t> spatial_order(std::span<const Vec3d> position, double cell) {
  assert(cell > 0);
  constexpr std::size_t slabs = 8;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3d low = {infinity, infinity, infinity};
  for (const Vec3d& p : position) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  }
  constexpr double last_cell = (1 << 21) - 1;
  const auto number = [&](double offset) {
    const double k = offset / cell;
    return static_cast<std::uint64_t>(k > 0 ? std::min(k, last_cell) : 0);
  };
  const auto morton = [&](const Vec3d& p) {
    const Vec3d offset = p - low;
    return spread_bits(number(offset.x)) | spread_bits(number(offset.y)) << 1 |
           spread_bits(number(offset.z)) << 2;
  };
  std::vector<std::pair<double, std::uint32_t>> rising;  // height and place
  for (std::uint32_t k = 0; k < position.size(); ++k) rising.emplace_back(position[k].z, k);
  std::ranges::sort(rising);
  std::vector<std::tuple<std::size_t, std::uint64_t, std::uint32_t>> curve;
  for (std::size_t n = 0; n < rising.size(); ++n) {
    const std::uint32_t place = rising[n].second;
    curve.emplace_back(n * slabs / rising.size(), morton(position[place]), place);
  }
  std::ranges::sort(curve);
  std::vector<std::uint32_t> order;
  order.reserve(curve.size());
  for (const auto& [slab, along, place] : curve) order.push_back(place);
  return order;
}

}  // namespace dem

// The mix before it moves: a gas of stones that do not touch, by random sequential addition
// (Widom (1966)), the largest first.
#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "dem/vec3.h"

namespace dem {

struct RoundMould {
  double radius;  // [m]; the axis is the z axis, the base z = 0
};

struct RectangularMould {
  double length, width;  // [m]; the inside is 0 < x < length, 0 < y < width, the base z = 0
};

using Mould = std::variant<RoundMould, RectangularMould>;

struct Gas {
  std::vector<Vec3d> position;  // of the stone centres, in the order of the radii [m]
  double height;                // every stone lies in 0 < z < height [m]
};

// `outer_radius` is R + t [m]: the shells touch neither each other nor the mould.
// `packing_density` is the volume of the outer spheres / volume of the filled height. It decides
// the height; where it is too dense for random addition, the height is raised by 5 % until all fit.
// Every stone must fit between the side walls; the largest also decides the least height.
Gas pack_gas(std::span<const double> outer_radius, const Mould& mould, double packing_density,
             std::uint64_t seed);

}  // namespace dem

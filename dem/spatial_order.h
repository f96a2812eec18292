// In which order stones are stored.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem/vec3.h"

namespace dem {

// An order of the places in which neighbours in space are neighbours in memory, and threads that
// take equal shares of it meet along horizontal planes: slab by slab of equal numbers, in each
// along a Morton curve of cells of the given width [m], Morton (1966); within a cell in the order
// of the places.
std::vector<std::uint32_t> spatial_order(std::span<const Vec3d> position, double cell);

}  // namespace dem

#include "dem/particle_store.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include "dem/bytes.h"

namespace dem {

// A ball of the shell's stuff in which a ball of stone takes the place of as much of it. The moment
// of a ball is 2/5 of its mass x radius^2.
double Layers::mass(double stone_radius) const {
  const double outer = stone_radius + shell;
  return 4.0 / 3.0 * std::numbers::pi *
         (shell_density * std::pow(outer, 3) +
          (density - shell_density) * std::pow(stone_radius, 3));
}

double Layers::turning(double stone_radius) const {
  const double outer = stone_radius + shell;
  const double moment =
      2.0 / 5.0 * 4.0 / 3.0 * std::numbers::pi *
      (shell_density * std::pow(outer, 5) + (density - shell_density) * std::pow(stone_radius, 5));
  return moment / mass(stone_radius);
}

ParticleStore make_stones(const std::vector<Vec3d>& position, std::vector<double> radius,
                          const Layers& layers, double inertia_scale) {
  const std::size_t count = position.size();
  ParticleStore stones;
  stones.shell = layers.shell;
  stones.id.resize(count);
  std::iota(stones.id.begin(), stones.id.end(), 0u);
  stones.mass.reserve(count);
  stones.inertia.reserve(count);
  stones.turning.reserve(count);
  for (const double r : radius) {
    stones.mass.push_back(layers.mass(r));
    stones.inertia.push_back(inertia_scale * layers.mass(r));
    stones.turning.push_back(layers.turning(r));
  }
  stones.radius = std::move(radius);
  stones.position.assign(position.begin(), position.end());
  stones.velocity.assign(count, Vec3d{});
  stones.spin.assign(count, Vec3d{});
  stones.load.assign(count, Load{});
  return stones;
}

std::size_t ParticleStore::bytes() const {
  return bytes_of(id, radius, mass, turning, inertia, strength, position, velocity, spin, load,
                  softness);
}

void reorder(ParticleStore& stones, const std::vector<std::uint32_t>& order) {
  const auto permute = [&order](auto& array) {
    if (array.empty()) return;
    auto moved = array;
    for (std::size_t k = 0; k < order.size(); ++k) moved[k] = array[order[k]];
    array = std::move(moved);
  };
  permute(stones.id);
  permute(stones.radius);
  permute(stones.mass);
  permute(stones.inertia);
  permute(stones.turning);
  permute(stones.strength);
  permute(stones.position);
  permute(stones.velocity);
  permute(stones.spin);
  permute(stones.load);
  permute(stones.softness);
}

}  // namespace dem

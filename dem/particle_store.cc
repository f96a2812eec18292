#include "dem/particle_store.h"

#include <numbers>
#include <numeric>

namespace dem {

ParticleStore make_stones(const std::vector<Vec3d>& position, std::vector<double> radius,
                          double density, double shell, double inertia_scale) {
  const std::size_t count = position.size();
  ParticleStore stones;
  stones.shell = shell;
  stones.id.resize(count);
  std::iota(stones.id.begin(), stones.id.end(), 0u);
  stones.mass.reserve(count);
  for (double r : radius) stones.mass.push_back(density * 4.0 / 3.0 * std::numbers::pi * r * r * r);
  for (double m : stones.mass) stones.inertia.push_back(inertia_scale * m);
  stones.radius = std::move(radius);
  stones.position.assign(position.begin(), position.end());
  stones.velocity.assign(count, Vec3d{});
  stones.spin.assign(count, Vec3d{});
  stones.load.assign(count, Load{});
  return stones;
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
  permute(stones.strength);
  permute(stones.position);
  permute(stones.velocity);
  permute(stones.spin);
  permute(stones.load);
  permute(stones.softness);
}

}  // namespace dem

#include "dem/observe.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace dem {

double kinetic_energy(const ParticleStore& stones) {
  double twice = 0;
  for (std::size_t k = 0; k < stones.size(); ++k) {
    twice += stones.inertia[k] * (dot(stones.velocity[k], stones.velocity[k]) +
                                  stones.turning[k] * dot(stones.spin[k], stones.spin[k]));
  }
  return 0.5 * twice;
}

double mean_inertia_scale(const ParticleStore& stones) {
  const auto sum = [](const std::vector<double>& all) {
    return std::accumulate(all.begin(), all.end(), 0.0);
  };
  return sum(stones.inertia) / sum(stones.mass);
}

double mean_of_highest(const ParticleStore& stones, int count) {
  std::vector<double> top(stones.size());
  for (std::size_t k = 0; k < top.size(); ++k) top[k] = stones.position[k].z + stones.radius[k];
  const auto some = std::min<std::size_t>(count, top.size());
  std::partial_sort(top.begin(), top.begin() + some, top.end(), std::greater<>());
  double sum = 0;
  for (std::size_t k = 0; k < some; ++k) sum += top[k];
  return sum / static_cast<double>(some);
}

PlateFace plate_face(const Wall& plate) {
  // u_z = lift + slope_x x + slope_y y over the face; the grid is symmetric about its centre, so
  // that the three unknowns do not mix.
  double area = 0, moment = 0, lift = 0, slope_x = 0, slope_y = 0;
  if (plate.field) {
    const SurfaceField& field = *plate.field;
    for (std::size_t n = 0; n < field.size(); ++n) {
      const double a = field.area[n], u = field.displacement[n].z;
      area += a;
      moment += a * field.node[n].x * field.node[n].x;
      lift += a * u;
      slope_x += a * u * field.node[n].x;
      slope_y += a * u * field.node[n].y;
    }
    lift /= area;
    slope_x /= moment;
    slope_y /= moment;
  }
  const Vec3d tilted = plate.frame.to_laboratory(Vec3d{-slope_x, -slope_y, 1});
  const Vec3d normal = tilted * (1 / norm(tilted));
  return {normal, plate.frame.origin.z + lift * plate.frame.ez.z,
          std::atan2(std::hypot(normal.x, normal.y), normal.z)};
}

}  // namespace dem

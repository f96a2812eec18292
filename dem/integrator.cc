#include "dem/integrator.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace dem {
namespace {

Load weight(const ParticleStore& stones, std::int64_t i, double gravity) {
  return {{{0, 0, -gravity * stones.mass[i]}, 0, {0, 0, 0}, 0}};
}

}  // namespace

void weigh(ParticleStore& stones, double gravity) {
  for (std::size_t i = 0; i < stones.size(); ++i) stones.load[i] = weight(stones, i, gravity);
}

Travel advance_stones(ParticleStore& stones, Steps steps, double drag, double gravity,
                      std::span<const Vec3d> reference) {
  const auto count = static_cast<std::int64_t>(stones.size());
  const double dt = steps.now, kick = steps.kick();
  const double kept = std::exp(-drag * kick);
  Travel travel;  // distances are squared at first
#pragma omp parallel if (count > 64)
  {
    double farthest = 0, next = 0;
    bool finite = true;
#pragma omp for schedule(static) nowait
    for (std::int64_t i = 0; i < count; ++i) {
      const double inertia = stones.inertia[i];
      const double moment = 0.4 * inertia * stones.radius[i] * stones.radius[i];
      Vec3d& v = stones.velocity[i];
      Vec3d& w = stones.spin[i];
      v = v * kept + stones.load[i].force * (kick / inertia);
      w = w * kept + stones.load[i].torque * (kick / moment);
      stones.load[i] = weight(stones, i, gravity);
      stones.position[i] += v * dt;
      const Vec3d moved = stones.position[i] - reference[i];
      const double distance = dot(moved, moved);
      finite = finite && std::isfinite(distance + dot(w, w));
      next = std::max(next, std::min(farthest, distance));
      farthest = std::max(farthest, distance);
    }
#pragma omp critical
    {
      travel.next = std::max({travel.next, next, std::min(travel.farthest, farthest)});
      travel.farthest = std::max(travel.farthest, farthest);
      travel.finite = travel.finite && finite;
    }
  }
  travel.farthest = std::sqrt(travel.farthest);
  travel.next = std::sqrt(travel.next);
  return travel;
}

}  // namespace dem

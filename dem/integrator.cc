#include "dem/integrator.h"

#include <cmath>
#include <cstdint>

namespace dem {

Travel advance_stones(ParticleStore& stones, Steps steps, double drag,
                      std::span<const Vec3d> reference) {
  const auto count = static_cast<std::int64_t>(stones.size());
  const double dt = steps.now, kick = steps.kick();
  const double kept = std::exp(-drag * kick);
  double farthest = 0;
  bool finite = true;
#pragma omp parallel for schedule(static) if (count > 64) reduction(max : farthest) reduction(&& : finite)
  for (std::int64_t i = 0; i < count; ++i) {
    const double inertia = stones.inertia_scale * stones.mass[i];
    const double moment = 0.4 * inertia * stones.radius[i] * stones.radius[i];
    Vec3d& v = stones.velocity[i];
    Vec3d& w = stones.spin[i];
    v = v * kept + stones.load[i].force * (kick / inertia);
    w = w * kept + stones.load[i].torque * (kick / moment);
    stones.position[i] += v * dt;
    const Vec3d moved = stones.position[i] - reference[i];
    const double distance = dot(moved, moved);
    finite = finite && std::isfinite(distance + dot(w, w));
    farthest = distance > farthest ? distance : farthest;
  }
  return {std::sqrt(farthest), finite};
}

}  // namespace dem

#include "dem/wall.h"

#include <cmath>

#include "dem/trouble.h"

namespace dem {

double distance_to(const Wall& wall, const Vec3d& point) {
  const Vec3d local = wall.frame.to_frame(point - wall.frame.origin);
  const Nearest<double> nearest =
      std::visit([&](const auto& surface) { return surface.nearest(local); }, wall.surface);
  if (!wall.field) return nearest.distance;
  const Stencil foot = wall.field->stencil(local - nearest.normal * nearest.distance);
  return nearest.distance - dot(wall.field->displacement_at(foot), nearest.normal);
}

void stop_if_not_finite(const Wall& wall, std::uint32_t stone, double time) {
  const double force = norm(wall.force);
  if (!std::isfinite(wall.moved))
    throw NumericalTrouble("way that wall " + wall.name + " has moved [m]", stone, time,
                           wall.moved);
  if (!std::isfinite(force))
    throw NumericalTrouble("force on wall " + wall.name + " [N]", stone, time, force);
}

}  // namespace dem

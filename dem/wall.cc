#include "dem/wall.h"

namespace dem {

double distance_to(const Wall& wall, const Vec3d& point) {
  const Vec3d local = wall.frame.to_frame(point - wall.frame.origin);
  const Nearest<double> nearest =
      std::visit([&](const auto& surface) { return surface.nearest(local); }, wall.surface);
  if (!wall.field) return nearest.distance;
  const Stencil foot = wall.field->stencil(local - nearest.normal * nearest.distance);
  return nearest.distance - dot(wall.field->displacement_at(foot), nearest.normal);
}

}  // namespace dem

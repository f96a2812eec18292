// A wall: an analytic surface that moves, optionally with a letterbox through which it bends.
#pragma once

#include <optional>
#include <string>

#include "dem/surface_field.h"
#include "dem/surfaces.h"
#include "dem/wall_motion.h"

namespace dem {

struct Wall {
  std::string name;
  Surface surface;
  Frame frame;
  Motion motion = Fixed{};
  std::optional<SurfaceField> field;

  // Written by the wall contacts every step: action of the stones on the wall, laboratory axes.
  Vec3d force = {0, 0, 0};   // [N]
  Vec3d moment = {0, 0, 0};  // about the frame's origin [N m]
  double push = 0;           // sum of the normal forces, positive pressing on the wall [N]

  double moved = 0;  // bound of its motion since its list of stones was made [m]
};

// Of a point from its face, bent or not [m], negative behind it.
double distance_to(const Wall& wall, const Vec3d& point);

// Throws NumericalTrouble, naming a stone, where the wall's force or way is not finite at `time`
// [s].
void stop_if_not_finite(const Wall& wall, std::uint32_t stone, double time);

}  // namespace dem

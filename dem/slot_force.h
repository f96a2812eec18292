// What one contact hands to its two bodies.
#pragma once

#include "dem/vec3.h"

namespace dem {

// The torque on either body is its arm (outer radius - inset) times `moment`.
struct SlotForce {
  Vec3d force;   // on the first body [N]
  double inset;  // of the contact point; h/2 between stones [m]
  Vec3d moment;  // shear x normal [N]
  double crush;  // F / R0^2 of the stone contact [Pa]; 0 if the law does not break stones
};

}  // namespace dem

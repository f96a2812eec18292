// The steel bodies of a gyratory compactor as plain parameters (SI).
//
// Each body lives in its own frame, in which its mesh and stiffness never change:
//   Head:  z along the ram. The plate's loaded face is the disc z = 0 (the mix lies at z < 0), the
//          shaft's root is the disc z = plate_thickness + shaft_length and is clamped to the frame.
//   Mould: z along the axis, base at z = 0. The loaded face is the inner cylinder.
#pragma once

namespace fem {

struct Steel {
  double young = 210e9;   // [Pa]
  double poisson = 0.3;   // [-]
  double density = 7850;  // [kg/m3]
};

struct Head {
  double plate_diameter;   // [m]
  double plate_thickness;  // [m]
  double shaft_diameter;   // [m], below plate_diameter
  double shaft_length;     // [m], from the plate's back to the root
  Steel steel;
};

enum class BaseSupport {
  clamped,  // the ring's lower edge does not move
  guided,   // the lower edge may slide in its plane (free ends but for rigid motions): for Lame
            // tests
};

struct Mould {
  double inner_diameter;  // [m]
  double wall_thickness;  // [m]
  double height;          // [m]
  BaseSupport base = BaseSupport::clamped;
  Steel steel;
};

}  // namespace fem

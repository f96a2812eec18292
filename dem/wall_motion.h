// How walls move.
#pragma once

#include <limits>
#include <variant>

#include "dem/frame.h"
#include "dem/time_step.h"

namespace dem {

// At rest, whatever moved it before.
struct Fixed {};

// Constant velocity [m/s], no turning.
struct Driven {
  Vec3d velocity;
};

// The root of a gyratory compactor's ram: an axial force and a precessing tilt are imposed, the
// axial position follows from the balance of forces.
//   tilt direction phase = 2 pi speed (time - start of turning), precession without spin unless
//   `spin`.
// Oil reaches the ram through a valve and loses pressure there with the square of its speed, as in
// every orifice: all of it at the valve speed, next to nothing while the ram creeps.
// The frame's origin stays on the mould axis (the laboratory's z axis).
struct Ram {
  double inertia;     // of the head, mass scaling included [kg]
  double weight;      // of the head [N]
  double force;       // ram force at full pressure, downwards [N]
  double ramp_start;  // [s]
  double ramp;        // duration of the linear force ramp [s]
  double angle;       // tilt of the ram root [rad]
  double speed;       // [rev/s]
  bool spin;          // true: the head turns with the tilt direction
  double dwell = 0;   // at full force, before the tilt goes round [s]
  double valve_speed = std::numeric_limits<double>::infinity();  // [m/s]

  double force_at(double time) const;                    // before the valve, downwards [N]
  double fastest(double speed, double within) const;     // from that speed on, within a time [m/s]
  double thrust_at(double time, double velocity) const;  // behind it [N], velocity upwards [m/s]
  double turns_from() const { return ramp_start + ramp + dwell; }  // [s]
  double phase_at(double time) const;                              // [rad]
};

using Motion = std::variant<Fixed, Driven, Ram>;

// Moves the frame from `time` by the step [s]; contact_force: of the stones on the wall at `time`
// [N].
void advance(const Motion& motion, Frame& frame, const Vec3d& contact_force, double time,
             Steps steps);

// Orientation and spin of a ram at `time`, position untouched.
void orient(const Ram& ram, Frame& frame, double time);

}  // namespace dem

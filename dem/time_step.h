// The time step, taken from the stiffest contact of the running scene: dt = safety sqrt(inertia /
// k).
#pragma once

namespace dem {

// The lengths of the step before (0 at the start) and of this one [s]: velocities go from the
// middle of the one to the middle of the other, positions by the whole of this one.
struct Steps {
  double before, now;
  double kick() const { return 0.5 * (before + now); }
};

// Steps on a fixed ladder of ratio 2^(1/4), so that the step changes seldom: down at once when a
// contact stiffens, up one rung at a time when the room is there.
class StepClock {
 public:
  StepClock(double safety, double largest) : safety_(safety), largest_(largest), step_(largest) {}

  double step() const { return step_; }  // [s]

  // rate: largest stiffness / inertia found among the contacts [1/s2]. True if the step changed.
  bool look(double rate);

 private:
  double safety_, largest_, step_;
};

}  // namespace dem

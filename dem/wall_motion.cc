#include "dem/wall_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dem {

double Ram::force_at(double time) const {
  if (ramp <= 0) return time < ramp_start ? 0 : force;
  return force * std::clamp((time - ramp_start) / ramp, 0.0, 1.0);
}

double Ram::thrust_at(double time, double velocity) const {
  const double share = velocity / valve_speed;
  return force_at(time) + force * share * std::abs(share);
}

double Ram::fastest(double speed, double within) const {
  const double on_nothing = valve_speed * std::sqrt(1 + weight / force);
  return std::min(speed + within * (force + weight) / inertia, on_nothing);
}

double Ram::phase_at(double time) const {
  return 2 * std::numbers::pi * speed * std::max(0.0, time - turns_from());
}

void orient(const Ram& ram, Frame& frame, double time) {
  const double phase = ram.phase_at(time);
  const double c = std::cos(phase), s = std::sin(phase);
  const double ca = std::cos(ram.angle), sa = std::sin(ram.angle);
  // Columns of Rz(phase) Ry(angle), then Rz(-phase) from the right unless the head spins.
  const Vec3d x = {c * ca, s * ca, -sa}, y = {-s, c, 0}, z = {c * sa, s * sa, ca};
  frame.ex = ram.spin ? x : x * c - y * s;
  frame.ey = ram.spin ? y : x * s + y * c;
  frame.ez = z;
  const bool turning = time > ram.turns_from();
  const double rate = turning ? 2 * std::numbers::pi * ram.speed : 0;
  const Vec3d axis = {0, 0, 1};
  frame.spin = ram.spin ? axis * rate : (axis - z) * rate;
}

void advance(const Motion& motion, Frame& frame, const Vec3d& contact_force, double time,
             Steps steps) {
  const double dt = steps.now;
  if (std::holds_alternative<Fixed>(motion)) {
    frame.velocity = frame.spin = Vec3d{0, 0, 0};
  } else if (const auto* driven = std::get_if<Driven>(&motion)) {
    frame.velocity = driven->velocity;
    frame.origin += driven->velocity * dt;
  } else if (const auto* ram = std::get_if<Ram>(&motion)) {
    // With the loss in the valve at the speed that is reached: stable for any step.
    const double kick = steps.kick() / ram->inertia;
    const double push = contact_force.z - ram->force_at(time) - ram->weight;
    const double lossless = frame.velocity.z + kick * push;
    const double loss = kick * ram->force / (ram->valve_speed * ram->valve_speed);  // [s/m]
    frame.velocity.z = 2 * lossless / (1 + std::sqrt(1 + 4 * loss * std::abs(lossless)));
    frame.origin.z += dt * frame.velocity.z;
    orient(*ram, frame, time + dt);
  }
}

}  // namespace dem

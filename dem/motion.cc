#include "dem/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dem {

double Ram::force_at(double time) const {
  if (ramp <= 0) return time < ramp_start ? 0 : force;
  return force * std::clamp((time - ramp_start) / ramp, 0.0, 1.0);
}

double Ram::phase_at(double time) const {
  return 2 * std::numbers::pi * speed * std::max(0.0, time - ramp_start - ramp);
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
  const bool turning = time > ram.ramp_start + ram.ramp;
  const double rate = turning ? 2 * std::numbers::pi * ram.speed : 0;
  const Vec3d axis = {0, 0, 1};
  frame.spin = ram.spin ? axis * rate : (axis - z) * rate;
}

void advance(const Motion& motion, Frame& frame, const Vec3d& contact_force, double time,
             Steps steps) {
  const double dt = steps.now;
  if (const auto* driven = std::get_if<Driven>(&motion)) {
    frame.velocity = driven->velocity;
    frame.origin += driven->velocity * dt;
  } else if (const auto* ram = std::get_if<Ram>(&motion)) {
    const double push = contact_force.z - ram->force_at(time) - ram->weight;
    frame.velocity.z += steps.kick() * push / ram->inertia;
    frame.origin.z += dt * frame.velocity.z;
    orient(*ram, frame, time + dt);
  }
}

}  // namespace dem

// Where a wall is and how it moves: its own frame seen from the laboratory.
#pragma once

#include "dem/vec3.h"

namespace dem {

struct Frame {
  Vec3d origin = {0, 0, 0};                              // [m]
  Vec3d ex = {1, 0, 0}, ey = {0, 1, 0}, ez = {0, 0, 1};  // its axes
  Vec3d velocity = {0, 0, 0};                            // of the origin [m/s]
  Vec3d spin = {0, 0, 0};                                // angular velocity [rad/s]

  // A vector given in the frame, seen from the laboratory, and back.
  template <class T>
  Vec3<T> to_laboratory(const Vec3<T>& v) const {
    return wide<T>(ex) * v.x + wide<T>(ey) * v.y + wide<T>(ez) * v.z;
  }
  template <class T>
  Vec3<T> to_frame(const Vec3<T>& v) const {
    return {dot(wide<T>(ex), v), dot(wide<T>(ey), v), dot(wide<T>(ez), v)};
  }
  // Velocity of the frame's material point at x (laboratory).
  template <class T>
  Vec3<T> velocity_at(const Vec3<T>& x) const {
    return wide<T>(velocity) + cross(wide<T>(spin), x - wide<T>(origin));
  }

  template <class T>
  static Vec3<T> wide(const Vec3d& v) {
    return {T(v.x), T(v.y), T(v.z)};
  }
};

}  // namespace dem

// How two stones, or a stone and a wall, meet: what a contact law sees of them.
#pragma once

#include <cstdint>

#include "dem/contact.h"
#include "dem/frame.h"
#include "dem/particle_store.h"

namespace dem {

// What stays of two stones until the lists are made anew. All 0 in the lanes that only fill up the
// last eight slots: such stones never touch.
template <class T>
struct Couple {
  T radius_i, radius_j;          // of the outer surfaces [m]
  T outer_radius, stone_radius;  // see Contact [m]
  T mass;                        // reduced inertia [kg]
};

inline Couple<double> couple_of(const ParticleStore& stones, std::int32_t i, std::int32_t j) {
  const double stone_i = stones.radius[i], stone_j = stones.radius[j];
  const double radius_i = stones.outer_radius(i), radius_j = stones.outer_radius(j);
  const double inertia_i = stones.inertia[i], inertia_j = stones.inertia[j];
  return {radius_i, radius_j, radius_i * radius_j / (radius_i + radius_j),
          stone_i * stone_j / (stone_i + stone_j), inertia_i * inertia_j / (inertia_i + inertia_j)};
}

// Do the outer surfaces overlap?
inline bool touch(const ParticleStore& stones, std::int32_t i, std::int32_t j) {
  return norm(stones.position[i] - stones.position[j]) <
         stones.outer_radius(i) + stones.outer_radius(j);
}

// What changes in every step, of the first stone against the second or of both.
template <class T>
struct Passing {
  Vec3<T> apart;           // [m]
  Vec3<T> rate;            // [m/s]
  Vec3<T> spin_i, spin_j;  // [rad/s]
};

template <class T>
struct Meeting {
  Contact<T> contact;
  T arm_i, arm_j;  // from the centres to the middle of the overlap [m]
};

// Of the outer surfaces [m].
template <class T>
T overlap_of(const Couple<T>& couple, const Vec3<T>& apart) {
  const T square = larger(dot(apart, apart), T(1e-300));
  return couple.radius_i + couple.radius_j - square * reciprocal_root(square);
}

// After a step of dt [s]; leaves the softness to be filled in.
template <class T>
Meeting<T> meet(const Couple<T>& couple, const Passing<T>& passing, double dt) {
  const auto& [apart, rate, spin_i, spin_j] = passing;
  const T square = larger(dot(apart, apart), T(1e-300));
  const T inverse = reciprocal_root(square);

  Meeting<T> pair;
  Contact<T>& contact = pair.contact;
  contact.overlap = overlap_of(couple, apart);
  contact.outer_radius = couple.outer_radius;
  contact.stone_radius = couple.stone_radius;
  contact.mass = couple.mass;
  contact.normal = apart * inverse;
  const Vec3<T>& normal = contact.normal;
  contact.closing = -dot(rate, normal);
  pair.arm_i = couple.radius_i - T(0.5) * contact.overlap;
  pair.arm_j = couple.radius_j - T(0.5) * contact.overlap;
  const Vec3<T> swing = cross(normal, rate) * inverse;  // angular velocity of the normal
  const Vec3<T> rolling = pair.arm_i * spin_i + pair.arm_j * spin_j;
  // Velocities are of the middle of the step: so is the normal that spins are taken about, as much
  // of it as lies in the contact plane.
  contact.sliding = (rate + normal * contact.closing - cross(rolling, normal) +
                     swing * (T(0.5 * dt) * dot(rolling, normal))) *
                    T(dt);
  contact.turn = (swing + normal * (T(0.5) * dot(spin_i + spin_j, normal))) * T(dt);
  contact.horizon = T(0.0);
  return pair;
}

// A stone that comes to a wall, seen from the laboratory.
template <class T>
struct Visitor {
  Vec3<T> position;  // [m]
  Vec3<T> velocity;  // [m/s]
  Vec3<T> spin;      // [rad/s]
  T radius;          // without the shell [m]
  T inertia;         // [kg]
};

// The wall next to it, bent or not.
template <class T>
struct Face {
  T distance;       // of the stone's centre [m]
  Vec3<T> normal;   // towards the stone
  Vec3<T> bending;  // velocity by which the face bends [m/s]
};

template <class T>
struct WallMeeting {
  Contact<T> contact;
  Vec3<T> point;  // of contact [m]
  T arm, inset;   // from the centre to the point, and from there to the outer surface [m]
};

// After a step of dt [s]; leaves the softness to be filled in. A wall has no shell: that of the
// stone [m] yields alone, the stone itself by half as between stones.
template <class T>
WallMeeting<T> meet(const Visitor<T>& stone, const Face<T>& face, const Frame& wall, double shell,
                    double dt) {
  const Vec3<T>& normal = face.normal;
  WallMeeting<T> pair;
  Contact<T>& contact = pair.contact;
  contact.outer_radius = stone.radius + T(shell);
  contact.stone_radius = stone.radius;
  contact.overlap = contact.outer_radius - face.distance;
  contact.mass = stone.inertia;
  contact.normal = normal;
  pair.inset = contact.overlap - T(0.5) * larger(contact.overlap - T(shell), T(0.0));
  pair.arm = contact.outer_radius - pair.inset;
  pair.point = stone.position - normal * pair.arm;

  const Vec3<T> rate = stone.velocity - wall.velocity_at(pair.point) - face.bending;
  contact.closing = -dot(rate, normal);
  const Vec3<T> slip = rate - cross(pair.arm * stone.spin, normal);
  contact.sliding = (slip - normal * dot(slip, normal)) * T(dt);
  // The frame follows the wall and, about the normal, half the stone's own spin.
  const Vec3<T> spin = Frame::wide<T>(wall.spin);
  contact.turn = (spin + normal * (T(0.5) * dot(stone.spin - spin, normal))) * T(dt);
  contact.horizon = T(0.0);
  return pair;
}

}  // namespace dem

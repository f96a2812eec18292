// What a contact law sees of two bodies that meet, and what it answers.
//
// T is a double (one contact) or a Pack (eight contacts). Quantities are of the first body relative
// to the second; for a wall contact the second body is the wall.
#pragma once

#include <cstddef>

#include "dem/pack.h"
#include "dem/vec3.h"

namespace dem {

template <class T>
struct Contact {
  T overlap;        // h of the outer surfaces (shells, or bare stones) [m], positive when pressed
  T outer_radius;   // R0 of the outer surfaces, R1 R2 / (R1 + R2); R at a wall [m]
  T stone_radius;   // R0 of the bare stones [m]
  T mass;           // reduced inertia m1 m2 / (m1 + m2), mass scaling included [kg]
  T softness;       // mean stone compliance / that of whole stones [-]
  Vec3<T> normal;   // unit vector from the second body to the first
  T closing;        // rate of overlap dh/dt [m/s]
  Vec3<T> sliding;  // displacement of the first surface against the second in the contact plane
                    // during this step [m]
  Vec3<T> turn;     // rotation vector of the contact frame during this step [rad]
  T horizon;        // how far ahead the stiffness must hold [s]; 0 if nobody asks for it
};

template <class T>
struct Response {
  T push;         // normal force, positive pushes the bodies apart [N]
  T stone;        // the part of it that stone carries [N]
  Vec3<T> shear;  // tangential force on the first body [N]
  T stiffness;    // largest tangent stiffness, normal or tangential, until the horizon [N/m]
};

// The largest overlap that is expected until the horizon [m].
template <class T>
T overlap_ahead(const Contact<T>& contact) {
  return contact.overlap + larger(contact.closing, T(0.0)) * contact.horizon;
}

// A vector of the contact plane carried along with the contact frame: turned, right to second order
// in the rotation angle, then cleared of what left the plane.
template <class T>
Vec3<T> carried(const Vec3<T>& v, const Contact<T>& contact) {
  const Vec3<T> turned = v + cross(contact.turn, v + T(0.5) * cross(contact.turn, v));
  return turned - contact.normal * dot(contact.normal, turned);
}

template <class Yes, class T>
Vec3<T> select(const Yes& yes, const Vec3<T>& a, const Vec3<T>& b) {
  return {select(yes, a.x, b.x), select(yes, a.y, b.y), select(yes, a.z, b.z)};
}

// A contact's memory is nothing but numbers of type T; those of the lanes that say yes become zero.
template <class T, class Yes, class Memory>
void forget(const Yes& yes, Memory& memory) {
  static_assert(sizeof(Memory) % sizeof(T) == 0);
  T* number = reinterpret_cast<T*>(&memory);
  for (std::size_t k = 0; k < sizeof(Memory) / sizeof(T); ++k)
    number[k] = select(yes, T(0.0), number[k]);
}

}  // namespace dem

// Tangential contact of bare stones that slips from its rim inwards (Cattaneo 1938, Mindlin 1949,
// Mindlin & Deresiewicz 1953): the reference that a single spring is measured against, at
// many times its cost.
//
// The contact is a row of rings that neither touch nor know each other, stiff enough to be
// together as stiff as the contact, each with its own Coulomb limit: exact for Cattaneo and
// Mindlin's assumptions under any path but for the width of a ring (Maw, Barber & Fawcett 1976;
// Popov & Hess 2015, Method of Dimensionality Reduction, ch. 5).
#pragma once

#include <array>
#include <cmath>

#include "dem/contact.h"
#include "dem/laws/hertz.h"

namespace dem {

template <class Normal = Hertz<>, int rings = 16>
struct SlipRings {
  Normal normal;
  double shear_modulus;  // G*, 1/G* = sum of (2 - nu)/G [Pa]
  double friction;       // mu [-]
  double cover = 0;      // overlap of the shells at which the stones touch: 2t, t at a wall [m]

  static constexpr bool breaks = false;

  template <class T>
  struct Memory {
    Vec3<T> slid[rings];  // displacement of the first body that the ring holds by its spring [m]
    T contact_radius;     // of the previous step, 0 if stones did not touch [m]
  };

  template <class T>
  static auto holds(const Memory<T>&) {
    return T(0.0) > T(0.0);
  }

  void set_time_step(double) {}

  template <class T>
  Response<T> operator()(const Contact<T>& contact, Memory<T>& memory) const {
    const T d = larger(contact.overlap - T(cover), T(0.0)), r = contact.stone_radius;
    const auto push = normal(d, contact);
    const T elastic = Hertz<>{normal.modulus}(d, contact).force;
    const T damping = push.force / larger(elastic, T(1e-300));
    const T widest = push.contact_radius, before = memory.contact_radius;
    memory.contact_radius = widest;

    Vec3<T> shear = {T(0.0), T(0.0), T(0.0)};
    T inner = T(0.0);
    for (int k = 0; k < rings; ++k) {
      // The part of the ring that touches: from inner to outer, or nothing.
      const T rim = k + 1 < rings ? r * T(rim_of(k)) : larger(widest, inner);
      const T outer = larger(smaller(rim, widest), inner);
      const T width = outer - inner;
      const T was = larger(smaller(rim, before) - inner, T(0.0));
      const T pressed =
          T(2 * normal.modulus) *
          (d * width - (outer * outer * outer - inner * inner * inner) / (T(3.0) * r));
      const T stiffness = T(8 * shear_modulus) * width;
      const T limit = T(friction) * damping * pressed / larger(stiffness, T(1e-300));
      // What comes to touch anew holds no displacement yet.
      const T left = smaller(was / larger(width, T(1e-300)), T(1.0));
      const Vec3<T> tried = carried(memory.slid[k], contact) * left + contact.sliding;
      const T slip = limit * reciprocal_root(larger(dot(tried, tried), T(1e-300)));
      memory.slid[k] = tried * smaller(slip, T(1.0));
      shear = shear - memory.slid[k] * stiffness;
      inner = smaller(rim, larger(widest, inner));
    }
    const T ahead = larger(overlap_ahead(contact) - T(cover), T(0.0));
    return {push.force, push.force, shear, normal.stiffness(ahead, contact)};
  }

 private:
  // Outer rim of a ring / R0: geometric, from 0.2 % to 25 % of R0; the last ring has no end [-].
  static double rim_of(int ring) {
    constexpr double least = 2e-3, widest = 0.25;
    static const std::array<double, rings> rims = [] {
      std::array<double, rings> r;
      for (int k = 0; k < rings; ++k) r[k] = least * std::pow(widest / least, k / (rings - 1.0));
      return r;
    }();
    return rims[ring];
  }
};

}  // namespace dem

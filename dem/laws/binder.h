// Viscoelastic binder shells, incompressible, relaxation modulus
//   G(t) = G0 [ g + sum A_i exp(-t/tau_i) ],  g = 1 - sum A_i,  A_i = bitumen fraction x alpha_i.
//
// Normal: Lee & Radok (1960), F = K int G(t-s) dH, H = h^1.5, by the recursion that is exact for H
// piecewise linear in time. Once pressed, shells are bonded: below h = 0 the odd extension
// H = -|h|^1.5 carries tension until F = -F_min, where the bond breaks and its history is
// forgotten. While shells are still pressed the tension is limited to F_min without breaking.
//
// Shear: thin film, T = 1/b int G(t-s) A ds with A = pi R0 h, in stick between stones; on a wall it
// may slip at friction x push. History shrinks with area and slip, so that a film that has parted
// carries nothing and a closed cycle creates no energy. The film is remembered in rings of equal
// area, of which a shrinking contact loses the outermost first; one ring takes all of the film to
// be strained alike, so that an area that swings forgets a part of the shear with every swing.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "dem/contact.h"
#include "dem/laws/bond.h"

namespace dem {

// Terms: number of Prony terms.
template <int Terms, int Rings = 1>
struct Binder {
  double modulus;                    // G0 [Pa]
  std::array<double, Terms> weight;  // A_i [-]
  std::array<double, Terms> time;    // tau_i [s]
  double normal_factor;              // K / sqrt(R0): 8/3 for a pair, 16/3 at a rigid wall [-]
  double film;                       // b: 2t for a pair, t at a wall [m]
  Bond bond;
  // At which the film slips; its largest value is never [-].
  double friction = std::numeric_limits<double>::max();

  // Written by set_time_step.
  double relaxed = 1;                     // g [-]
  std::array<double, Terms> decay = {};   // of a transient in one step [-]
  std::array<double, Terms> growth = {};  // of a transient per rise in one step [-]

  static constexpr bool breaks = false;

  template <class T>
  struct Ring {
    Vec3<T> film;                      // int A ds, A: area of the ring [m3]
    std::array<Vec3<T>, Terms> shear;  // its transient part of each term [m3]
  };

  template <class T>
  struct Memory {
    T bonded;                         // 1 since the shells were pressed, 0 otherwise
    T root;                           // sign(h) sqrt|h| of the previous step [m^0.5]
    std::array<T, Terms> push;        // transient part of H of each term [m^1.5]
    std::array<Ring<T>, Rings> ring;  // from the middle outwards
  };

  template <class T>
  static auto holds(const Memory<T>& memory) {
    return memory.bonded > T(0.5);
  }

  // dt: 0 for a jump [s].
  void set_time_step(double dt) {
    relaxed = std::max(0.0, 1 - std::accumulate(weight.begin(), weight.end(), 0.0));
    for (int i = 0; i < Terms; ++i) {
      const double x = dt / time[i];
      decay[i] = std::exp(-x);
      growth[i] = x > 0 ? -std::expm1(-x) / x : 1;
    }
  }

  // Area of a ring at the overlap h = root |root|, 0 without [m2]: pi R0 h in all. The outermost
  // begins short of h = b, where stones touch, and has no end.
  template <class T>
  T ring_area(const Contact<T>& contact, T root, int ring) const {
    T part = larger(root * magnitude(root), T(0.0));
    if constexpr (Rings > 1) {
      const double width = film / Rings;
      part = larger(part - T(ring * width), T(0.0));
      if (ring + 1 < Rings) part = smaller(part, T(width));
    }
    return T(std::numbers::pi) * contact.outer_radius * part;
  }

  template <class T>
  Response<T> operator()(const Contact<T>& contact, Memory<T>& memory) const {
    const T zero(0.0), tiny(1e-300);
    const T h = contact.overlap;
    const auto pulled = h <= zero;
    const auto strange = pulled & (memory.bonded <= T(0.5));  // not pressed, now or before
    const T size = fast_root(magnitude(h));
    const T root = select(pulled, -size, size);
    const T old = memory.root;
    const T rise = root * root * root - old * old * old;

    T sum = T(relaxed) * root * root * root;
    for (int i = 0; i < Terms; ++i) {
      memory.push[i] = T(decay[i]) * memory.push[i] + T(growth[i]) * rise;
      sum += T(weight[i]) * memory.push[i];
    }
    const T factor = T(normal_factor * modulus) * fast_root(contact.outer_radius);
    const T limit = -bond.pull_off(contact.outer_radius);
    const T elastic = factor * sum;
    const auto parted = strange | (pulled & (elastic <= limit));
    const T push = select(parted, zero, larger(elastic, limit));

    Vec3<T> shear = {zero, zero, zero};
    for (int k = 0; k < Rings; ++k)
      shear +=
          strain(memory.ring[k], contact, ring_area(contact, root, k), ring_area(contact, old, k));
    shear = shear * T(-modulus / film);
    if (friction < std::numeric_limits<double>::max()) {
      const T hold = T(friction) * larger(push, zero);
      const T stick = smaller(hold * reciprocal_root(larger(dot(shear, shear), tiny)), T(1.0));
      shear = shear * stick;
      for (Ring<T>& ring : memory.ring) {
        ring.film = ring.film * stick;
        for (Vec3<T>& transient : ring.shear) transient = transient * stick;
      }
    }

    memory.root = root;
    memory.bonded = T(1.0);
    forget<T>(parted, memory);
    const T ahead = larger(overlap_ahead(contact), select(strange, zero, size * size));
    const T stiffness = larger(T(1.5) * factor * fast_root(ahead),
                               T(modulus / film * std::numbers::pi) * contact.outer_radius * ahead);
    return {push, zero, select(parted, Vec3<T>{zero, zero, zero}, shear), stiffness};
  }

 private:
  // A ring slides on; what it carries / (-G0 / b) [m3]. Both areas are of what is remembered, so
  // that none shrinks that does not.
  template <class T>
  Vec3<T> strain(Ring<T>& ring, const Contact<T>& contact, T area, T old_area) const {
    const T kept = smaller(area / larger(old_area, T(1e-300)), T(1.0));
    const Vec3<T> slid = contact.sliding * area;
    ring.film = carried(ring.film, contact) * kept + slid;
    Vec3<T> sum = ring.film * T(relaxed);
    for (int i = 0; i < Terms; ++i) {
      ring.shear[i] = carried(ring.shear[i], contact) * (kept * T(decay[i])) + slid * T(growth[i]);
      sum += ring.shear[i] * T(weight[i]);
    }
    return sum;
  }
};

}  // namespace dem

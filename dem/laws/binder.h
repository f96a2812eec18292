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
// carries nothing and a closed cycle creates no energy.
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
template <int Terms>
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
  struct Memory {
    T bonded;                          // 1 since the shells were pressed, 0 otherwise
    T root;                            // sign(h) sqrt|h| of the previous step [m^0.5]
    std::array<T, Terms> push;         // transient part of H of each term [m^1.5]
    Vec3<T> film;                      // int A ds [m3]
    std::array<Vec3<T>, Terms> shear;  // its transient part of each term [m3]
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

  // pi R0 h of h = root |root|, 0 without overlap [m2].
  template <class T>
  static T film_area(const Contact<T>& contact, T root) {
    return T(std::numbers::pi) * contact.outer_radius * larger(root * magnitude(root), T(0.0));
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

    // Both areas of what is remembered, so that none shrinks that does not.
    const T area = film_area(contact, root), old_area = film_area(contact, old);
    const T kept = smaller(area / larger(old_area, tiny), T(1.0));
    const Vec3<T> slid = contact.sliding * area;
    memory.film = carried(memory.film, contact) * kept + slid;
    Vec3<T> shear = memory.film * T(relaxed);
    for (int i = 0; i < Terms; ++i) {
      memory.shear[i] =
          carried(memory.shear[i], contact) * (kept * T(decay[i])) + slid * T(growth[i]);
      shear += memory.shear[i] * T(weight[i]);
    }
    shear = shear * T(-modulus / film);
    if (friction < std::numeric_limits<double>::max()) {
      const T hold = T(friction) * larger(push, zero);
      const T stick = smaller(hold * reciprocal_root(larger(dot(shear, shear), tiny)), T(1.0));
      shear = shear * stick;
      memory.film = memory.film * stick;
      for (Vec3<T>& transient : memory.shear) transient = transient * stick;
    }

    memory.root = root;
    memory.bonded = T(1.0);
    forget<T>(parted, memory);
    const T ahead = larger(overlap_ahead(contact), select(strange, zero, size * size));
    const T stiffness = larger(T(1.5) * factor * fast_root(ahead),
                               T(modulus / film * std::numbers::pi) * contact.outer_radius * ahead);
    return {push, zero, select(parted, Vec3<T>{zero, zero, zero}, shear), stiffness};
  }
};

}  // namespace dem

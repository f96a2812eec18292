// Tangential contact of bare stones: incremental spring of stiffness 8 G* a (Mindlin 1949), whose
// force falls as its stiffness does, by a shrinking contact or a breaking stone, so that a closed
// cycle creates no energy (Thornton et al. 2013, 2.3), with the Coulomb limit mu F on the stone
// force only.
#pragma once

#include "dem/contact.h"
#include "dem/laws/hertz.h"

namespace dem {

// What the spring carries along while its stiffness grows with the contact: its force, as a spring
// that is extended by what comes to touch anew does, or its displacement, as in LAMMPS, LIGGGHTS
// and the codes of Chung & Ooi (2011). The latter creates energy on closed paths.
enum class Carries { force, displacement };

template <class Normal = Hertz<>, Carries carries = Carries::force>
struct Mindlin {
  Normal normal;
  double shear_modulus;  // G*, 1/G* = sum of (2 - nu)/G [Pa]
  double friction;       // mu [-]
  double cover = 0;      // overlap of the shells at which the stones touch: 2t, t at a wall [m]

  static constexpr bool breaks = false;

  template <class T>
  struct Memory {
    Vec3<T> shear;  // tangential force on the first body [N]
    T compliance;   // 1 / (8 G* a) of the previous step, endless if only shells touched [m/N]
  };

  template <class T>
  static auto holds(const Memory<T>&) {
    return T(0.0) > T(0.0);
  }

  void set_time_step(double) {}

  template <class T>
  Response<T> operator()(const Contact<T>& contact, Memory<T>& memory) const {
    return respond(contact, memory, T(1.0));
  }

  // weakness: contact compliance / that of whole stones [-].
  template <class T>
  Response<T> respond(const Contact<T>& contact, Memory<T>& memory, T weakness) const {
    const T d = larger(contact.overlap - T(cover), T(0.0));
    const auto push = normal(d, contact);
    const T share = T(1.0) / weakness;
    const T force = push.force * share;
    const T stiffness = T(8.0 * shear_modulus) * push.contact_radius * share;

    T left = stiffness * memory.compliance;
    if constexpr (carries == Carries::force) left = smaller(left, T(1.0));
    const Vec3<T> kept = carried(memory.shear, contact) * left;
    const Vec3<T> tried = kept - contact.sliding * stiffness;
    const T limit = T(friction) * force;
    const T slip = limit * reciprocal_root(larger(dot(tried, tried), T(1e-300)));
    const Vec3<T> shear = tried * smaller(slip, T(1.0));

    memory.shear = shear;
    memory.compliance = T(1 / (8.0 * shear_modulus)) * push.inverse_radius * weakness;
    // The shear stiffness is 4 G*/E0 <= 1 of the normal one for every Poisson's ratio >= 0.
    const T ahead = larger(overlap_ahead(contact) - T(cover), T(0.0));
    return {force, force, shear, normal.stiffness(ahead, contact) * share};
  }
};

}  // namespace dem

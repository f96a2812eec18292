// Elastic normal contact of bare stones: Hertz (1882), F = 4/3 E0 sqrt(R0) d^1.5, with the damping of
// Tsuji et al. (1992) if the stones have a restitution (Antypov & Elliott 2011: exact for any speed).
#pragma once

#include <cmath>
#include <numbers>

#include "dem/contact.h"

namespace dem {

enum class Damping { none, restitution };

template <Damping damping = Damping::none>
struct Hertz {
  double modulus;          // E0, 1/E0 = sum of (1 - nu^2)/E [Pa]
  double damping_ratio = 0;  // beta = -ln e / sqrt(pi^2 + ln^2 e) [-]

  template <class T>
  struct Push {
    T force;           // [N]
    T contact_radius;  // a = sqrt(R0 d) [m]
  };

  // d: overlap of the bare stones [m], already clipped at zero.
  template <class T>
  Push<T> operator()(T d, const Contact<T>& contact) const {
    using std::sqrt;
    const T a = sqrt(contact.stone_radius * d);
    T force = T(4.0 / 3.0 * modulus) * a * d;
    if constexpr (damping == Damping::restitution)
      force += T(2.0 * std::sqrt(5.0 / 6.0) * damping_ratio) *
               sqrt(contact.mass * T(2.0 * modulus) * a) * contact.closing;
    return {force, a};
  }

  // Tangent stiffness 2 E0 a at bare-stone overlap d [N/m].
  template <class T>
  T stiffness(T d, const Contact<T>& contact) const {
    using std::sqrt;
    return T(2.0 * modulus) * sqrt(contact.stone_radius * d);
  }
};

// beta of a coefficient of restitution e in (0, 1].
inline double damping_ratio(double restitution) {
  const double log_e = std::log(restitution);
  return -log_e / std::sqrt(std::numbers::pi * std::numbers::pi + log_e * log_e);
}

}  // namespace dem

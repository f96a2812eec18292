// Elastic normal contact of bare stones: Hertz (1882), F = 4/3 E0 sqrt(R0) d^1.5, with the damping
// of Tsuji et al. (1992) if the stones have a restitution. Stones never pull: damping ends an
// impact where it would outweigh the spring.
#pragma once

#include <cmath>

#include "dem/contact.h"

namespace dem {

enum class Damping { none, restitution };

template <Damping damping = Damping::none>
struct Hertz {
  double modulus;            // E0, 1/E0 = sum of (1 - nu^2)/E [Pa]
  double damping_ratio = 0;  // beta, see damping_ratio() [-]

  template <class T>
  struct Push {
    T force;           // [N]
    T contact_radius;  // a = sqrt(R0 d) [m]
    T inverse_radius;  // 1 / a, very large where d = 0 [1/m]
  };

  // d: overlap of the bare stones [m], already clipped at zero.
  template <class T>
  Push<T> operator()(T d, const Contact<T>& contact) const {
    const T square = contact.stone_radius * d;
    const T inverse = reciprocal_root(larger(square, T(1e-300)));
    const T a = square * inverse;
    T force = T(4.0 / 3.0 * modulus) * a * d;
    if constexpr (damping == Damping::restitution)
      force = larger(force + T(2.0 * std::sqrt(5.0 / 6.0) * damping_ratio) *
                                 fast_root(contact.mass * T(2.0 * modulus) * a) * contact.closing,
                     T(0.0));
    return {force, a, inverse};
  }

  // Stiffness at bare-stone overlap d that asks for as small a step as the contact does [N/m]:
  // 2 E0 a, the tangent, of a spring alone. A dashpot that answers half a step late lowers the
  // critical step by sqrt(1 + z^2) - z = 1 / (sqrt(1 + z^2) + z), z its share of critical damping
  // (Belytschko, Liu & Moran, Nonlinear Finite Elements, 2000, 6.2).
  template <class T>
  T stiffness(T d, const Contact<T>& contact) const {
    const T tangent = T(2.0 * modulus) * fast_root(contact.stone_radius * d);
    if constexpr (damping == Damping::none) return tangent;
    const double z = std::sqrt(5.0 / 6.0) * damping_ratio, slower = std::sqrt(1 + z * z) + z;
    return tangent * T(slower * slower);
  }
};

// beta of a coefficient of restitution e in (0, 1], for impacts of any speed: the root of
//   -ln e = 2 beta arccos(beta) / sqrt(1 - beta^2)   (beta < 1; arcosh and beta^2 - 1 beyond).
// Schwager & Poeschel (2007) have it for a linear spring and dashpot that never pull; y = d^(5/4)
// carries it over to Hertz and Tsuji (Antypov & Elliott 2011).
inline double damping_ratio(double restitution) {
  const double wanted = -std::log(restitution);
  const auto loss = [](double beta) {
    const double root = std::sqrt(std::abs(1 - beta * beta));
    if (root == 0) return 2.0;
    return 2 * beta * (beta < 1 ? std::acos(beta) : std::acosh(beta)) / root;
  };
  double low = 0, high = std::cosh(0.5 * wanted);  // 2 arcosh(beta) < loss
  for (double middle = 0.5 * high; middle > low && middle < high; middle = 0.5 * (low + high))
    (loss(middle) < wanted ? low : high) = middle;
  return low;
}

}  // namespace dem

// The strength of a stone: one value for its whole life, drawn from (seed, id) alone.
#pragma once

#include <cstdint>

namespace dem {

// P(strength < s) = 1 - exp(-(V / V_ref) (s / scale)^exponent), Weibull (1939), with V = R^3
// (Olsson, Jelagin, Partl).
struct Weibull {
  double scale;             // sigma0 [Pa]
  double exponent;          // m [-]
  double reference_volume;  // V_ref [m3]
};

// sigma_F [Pa] of the stone `id` of radius R [m]. A contact of effective radius R0 breaks it at the
// force sigma_F R0^2: the stress of Hertz (1882) depends on F / R0^2 alone.
double strength(const Weibull& weibull, double stone_radius, std::uint64_t seed, std::uint32_t id);

}  // namespace dem

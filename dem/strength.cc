#include "dem/strength.h"

#include <cmath>

#include "dem/random.h"

namespace dem {

double strength(const Weibull& weibull, double stone_radius, std::uint64_t seed, std::uint32_t id) {
  const double volume = stone_radius * stone_radius * stone_radius;
  const double u = uniform(seed, Purpose::strength, id);
  return weibull.scale *
         std::pow(weibull.reference_volume / volume * -std::log1p(-u), 1 / weibull.exponent);
}

}  // namespace dem

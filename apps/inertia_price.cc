#include "apps/inertia_price.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace apps {
namespace {

struct Measured {
  double inertial_number, lost;
};

// studies/mass.toml, mass scales 10 and 100 on all, 1e3 (the standard), 3e3, 1e3 on all, 1e4, 1e4
// on all, 1e5, 1e5 on all.
constexpr std::array<Measured, 9> measured = {{{7.0e-5, 0},
                                               {2.2e-4, 0.13},
                                               {3.0e-4, 0.24},
                                               {5.2e-4, 0.41},
                                               {7.0e-4, 0.43},
                                               {9.5e-4, 0.49},
                                               {2.2e-3, 0.58},
                                               {3.0e-3, 0.65},
                                               {7.0e-3, 0.83}}};

}  // namespace

double densification_lost(double inertial_number) {
  const auto above =
      std::ranges::upper_bound(measured, inertial_number, {}, &Measured::inertial_number);
  if (above == measured.begin()) return measured.front().lost;
  if (above == measured.end()) return measured.back().lost;
  const Measured& from = *(above - 1);
  const double way = std::log(inertial_number / from.inertial_number) /
                     std::log(above->inertial_number / from.inertial_number);
  return from.lost + way * (above->lost - from.lost);
}

std::string inertia_line(double inertial_number) {
  if (inertial_number <= measured.front().inertial_number)
    return "inertia          takes less of the densification than was ever measured";
  const bool beyond = inertial_number > measured.back().inertial_number;
  return fmt::format(
      "inertia          takes {} {:.0f} % of the slope of the first two gyrations (trade.md)",
      beyond ? "more than" : "about", 100 * densification_lost(inertial_number));
}

}  // namespace apps

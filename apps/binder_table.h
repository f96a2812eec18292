// Table 1 of Olsson, Jelagin, Partl: the binder phase at the two temperatures of their study,
// a generalised Maxwell model fitted to the contact data of Chen et al. (2012). It is the stiffness
// of a contact in a discrete element model, not that of a bitumen at this temperature.
#pragma once

#include <array>

namespace apps {

struct BinderRow {
  double temperature;           // [K]
  double shear_modulus;         // G0 [Pa]
  std::array<double, 2> alpha;  // [-], before the bitumen fraction is applied
  std::array<double, 2> tau;    // [s]
};

inline constexpr std::array<BinderRow, 2> binder_table{{
    {110 + 273.15, 17.74e6, {0.684, 0.316}, {0.0703, 64.223}},
    {150 + 273.15, 6.65e6, {0.513, 0.487}, {0.0948, 105.9}},
}};

}  // namespace apps

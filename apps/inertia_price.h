// What the inertia of the stones takes of the densification, as measured.
#pragma once

#include <string>

namespace apps {

// Share of the air-void decrease per decade of the first two gyrations that a bed of that inertial
// number [-] lacks against one of ten times the mass: apps/docs/trade.md, "What inertia does", 450
// stones, interpolated over the logarithm. The noise of each is 0.1 to 0.3.
double densification_lost(double inertial_number);

// The same as a line of `--check`.
std::string inertia_line(double inertial_number);

}  // namespace apps

// Closed forms for the steel of a compactor, in the notation of their sources.
#pragma once

#include "fem/body.h"

namespace apps {

// A cylinder with free ends under pressure [Pa] on its inner face: Lame (1852), Timoshenko &
// Goodier (1970), article 28.
struct LameCylinder {
  double hoop_inner, hoop_outer;  // [Pa]
  double growth;                  // radial displacement of the inner face [m]
};
LameCylinder lame(const fem::Mould& mould, double pressure);

// beta of an edge disturbance exp(-beta z) of the cylinder as a thin shell [1/m]: Timoshenko &
// Woinowsky-Krieger (1959), article 114.
double shell_wave_number(const fem::Mould& mould);

// Growth at `z` [m] from the centre of a pressure band of `length` [m] on a long cylinder / growth
// under that pressure everywhere: Timoshenko & Woinowsky-Krieger (1959), article 116.
double band_growth(const fem::Mould& mould, double length, double z);

// Amplitude of the radial displacement [m] of the inner face under the pressure amplitude [Pa] x
// cos(n angle), plane strain: Michell (1899), Timoshenko & Goodier (1970), article 43.
double michell_amplitude(const fem::Mould& mould, int n, double pressure);

// The shaft as a clamped beam and bar.
double beam_rotation(const fem::Head& head, double moment);   // M L / (E I) [rad]
double bar_shortening(const fem::Head& head, double force);   // F L / (E A) [m]
double bending_stress(const fem::Head& head, double moment);  // M b / I at the shaft's surface [Pa]
double axial_stress(const fem::Head& head, double force);     // F / A [Pa]

// Deflection [m] of the rim against the shaft's circle under uniform pressure [Pa], of a plate
// clamped at the shaft, bending and shear (factor 5/6): Timoshenko & Woinowsky-Krieger (1959),
// articles 17-20.
double rim_deflection(const fem::Head& head, double pressure);

}  // namespace apps

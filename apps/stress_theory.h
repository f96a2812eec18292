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

// Growth of the inner face [m/Pa] at `z` [m] from the centre of a unit pressure on a band of
// `length` [m] of a long cylinder: Fourier integral of exact solutions (see the source).
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

// What the joint of plate and shaft adds to the rotation of the shaft's end, as the slope of the
// plane fitted to the plate's face under a pressure that grows linearly across it [rad/(N m)]. Edge
// and rocking overlap: finite elements turn by 0.71 to 0.85 of the sum where the plate is 0.6 to
// 1.6 shaft radii thick, by 1.04 of it at 0.4.
struct JointRotation {
  double plate;  // annular plate, clamped at the shaft, by bending and shear as in rim_deflection
  double edge;   // a plate's built-in edge yields by 16.67 M / (pi E' t^2): O'Donnell (1960), for a
                 // half-plane; from memory
  double rocking;  // disc as wide as the shaft on a half-space: Johnson (1985), section 3.5

  double sum() const { return plate + edge + rocking; }
};
JointRotation joint_rotation(const fem::Head& head);

// Half-space under a force [N] on a point: displacement along the force [m] at a distance [m] on
// the surface and at a depth [m] below the point; Boussinesq (1885), Timoshenko & Goodier (1970),
// article 138.
double boussinesq_deflection(const fem::Steel& steel, double force, double distance);
double boussinesq_sinking(const fem::Steel& steel, double force, double depth);

}  // namespace apps

// From the recipe of a mix to the binder phase around each stone: bitumen and the stones too small
// to be modelled, laid as a shell of one thickness on every modelled stone (Olsson, Jelagin,
// Partl).
#pragma once

#include <span>

namespace dem {

struct MixDesign {
  double binder_content;   // bitumen mass / mix mass [-]
  double bitumen_density;  // [kg/m3]
  double stone_density;    // of stones and fines [kg/m3]
  double fines;  // mass of stones below the smallest modelled one / mass of all stones [-]
};

struct BinderPhase {
  double volume_ratio;      // (V_bitumen + V_fines) / V_stone, V_stone of the modelled stones [-]
  double bitumen_fraction;  // V_bitumen / (V_bitumen + V_fines) [-]; 0 in a dry mix without fines
  double density;           // of the phase: the shells weigh what bitumen and fines weigh [kg/m3]
};

BinderPhase binder_phase(const MixDesign& mix);

// The thickness t [m] that solves sum((R + t)^3 - R^3) = volume_ratio sum(R^3) for the stone radii
// R [m]. Shells of touching stones overlap in space; the sum counts each shell in full.
double shell_thickness(std::span<const double> stone_radius, double volume_ratio);

}  // namespace dem

// The compactor of a scene, sized for its mix.
#pragma once

#include "apps/mix.h"
#include "apps/scene.h"

namespace apps {

// Height / diameter of a specimen that still is a compaction [-].
inline constexpr double highest_specimen = 3;

struct Machine {
  double mould_radius;  // inside [m]
  double plate_radius;  // [m], less than the mould's by the usual clearance
  double section;       // cross section of the mould, on which the pressure is meant [m2]
  double height;        // of the specimen at the air voids by which moulds are sized [m]

  double specimen_volume(double height) const { return section * height; }  // [m3]
};

// The mould as the scene gives it, or scaled to the mix: height / diameter of the specimen at 4 %
// air voids is then mould.aspect_ratio. Throws InputError if stones and mould do not fit each
// other.
Machine size_machine(const GyratoryScene& scene, const Mix& mix);

// Mass of the head of a scene whose head is rigid [kg]: as given, else a steel plate of 20 mm.
double rigid_head_mass(const HeadScene& head, const Machine& machine);

}  // namespace apps

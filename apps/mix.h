// The mix of a scene before it is placed: stones, shells, strengths.
#pragma once

#include <optional>
#include <vector>

#include "apps/scene.h"
#include "dem/gradation.h"
#include "dem/particle_store.h"

namespace apps {

struct Mix {
  std::vector<double> radius;    // of the bare stones, by id [m]
  std::vector<double> strength;  // by id [Pa]; empty if the scene has no fracture
  double shell = 0;              // thickness of the binder shells [m]
  double shell_density = 0;      // of the binder phase [kg/m3]
  double bitumen_fraction = 0;   // of the binder phase [-]
  double stone_volume = 0;       // [m3]
  double binder_volume = 0;      // bitumen and fines [m3]
  dem::Departure fitted, drawn;  // of the size distribution and of the stones from the sieve table

  double smallest_radius() const;  // [m]
  double largest_radius() const;   // [m]
  dem::Layers layers(const StonesScene& stones) const;
};

Mix prepare_mix(const StonesScene& stones, const std::optional<BinderScene>& binder, int seed);

}  // namespace apps

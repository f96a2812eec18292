#include "apps/findings.h"

namespace apps {

std::vector<Finding> bed_findings(const BedReport& bed, const Mix& mix,
                                  const NumericsScene& numerics, int seed, const Spent& spent) {
  return {{"stones", bed.stones},
          {"steps", bed.steps},
          {"time_step_s", bed.time_step},
          {"limiting_contact", bed.limiting_contact},
          {"mass_scale", numerics.mass_scale},
          {"mass_scale_mean", bed.inertia_scale},
          {"wall_seconds", spent.wall},
          {"processor_seconds", spent.processor},
          {"particle_steps_per_second",
           static_cast<double>(bed.stones) * static_cast<double>(bed.steps) / spent.wall},
          {"gradation_sieve_m", mix.drawn.sieve},
          {"gradation_passing_asked", mix.drawn.asked},
          {"gradation_passing", mix.drawn.found},
          {"fractured_stones", bed.cracks},
          {"shell_thickness_m", mix.shell},
          {"bitumen_fraction", mix.bitumen_fraction},
          {"neighbor_rebuilds", bed.rebuilds},
          {"seed", static_cast<std::int64_t>(seed)}};
}

}  // namespace apps

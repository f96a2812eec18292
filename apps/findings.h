// What the summaries of all runs have in common.
#pragma once

#include "apps/clocks.h"
#include "apps/mix.h"
#include "apps/scene.h"
#include "apps/summary.h"
#include "dem/observe.h"
#include "dem/simulation.h"

namespace apps {

// What a bed of any contact law has come to.
struct BedReport {
  std::int64_t stones, steps, rebuilds, cracks;
  double time_step;              // [s]
  double inertia_scale;          // mean over the mass [-]
  std::string limiting_contact;  // of the time step
};

template <class Law>
BedReport report_on(const dem::Simulation<Law>& bed) {
  return {static_cast<std::int64_t>(bed.stones().size()),
          bed.steps(),
          bed.rebuilds(),
          static_cast<std::int64_t>(bed.cracks().size()),
          bed.time_step(),
          dem::mean_inertia_scale(bed.stones()),
          bed.limiting_contact()};
}

std::vector<Finding> bed_findings(const BedReport& bed, const Mix& mix,
                                  const NumericsScene& numerics, int seed, const Spent& spent);

}  // namespace apps

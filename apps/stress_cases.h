// The validation cases of the steel, by what bears the load.
#pragma once

#include "apps/stress_case.h"
#include "apps/stress_report.h"

namespace apps {

StressReport load_mould(const StressCase& given);       // pressure, band, ovalling
StressReport load_head(const StressCase& given);        // plate_pressure, ..., angle_check
StressReport press_one_stone(const StressCase& given);  // stones, count = 1
StressReport settle_column(const StressCase& given);    // stones, count > 1

// As many modes as the stones ask for, sampled at `points` (3, points) [m]. Throws InputError where
// the face has not as many.
fem::ReducedBody reduced_mould(const fem::ElasticBody& body, int modes,
                               const Eigen::Matrix3Xd& points);

inline StressReport run_stress_case(const StressCase& given) {
  if (given.load.kind == "stones")
    return given.stones.count == 1 ? press_one_stone(given) : settle_column(given);
  const bool head = given.load.kind == "plate_pressure" || given.load.kind == "eccentric" ||
                    given.load.kind == "point" || given.load.kind == "angle_check";
  return head ? load_head(given) : load_mould(given);
}

}  // namespace apps

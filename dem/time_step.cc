#include "dem/time_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/trouble.h"

namespace dem {

bool StepClock::look(double rate) {
  const double limit = rate > 0 ? std::min(largest_, safety_ / std::sqrt(rate)) : largest_;
  const double rung = std::pow(2.0, 0.25);
  const double before = step_;
  if (limit < step_)
    step_ = largest_ * std::pow(rung, std::floor(std::log(limit / largest_) / std::log(rung)));
  else if (limit > rung * rung * step_ || (limit == largest_ && step_ < largest_))
    step_ = std::min(largest_, rung * step_);
  return step_ != before;
}

void stop_at_first_not_finite(const ParticleStore& stones, double time) {
  const auto unsound = [](const Vec3d& v) { return !std::isfinite(v.x + v.y + v.z); };
  for (std::size_t k = 0; k < stones.size(); ++k)
    if (unsound(stones.position[k]) || unsound(stones.velocity[k]) || unsound(stones.spin[k]))
      throw NumericalTrouble("stone is not at a finite place", stones.id[k], time,
                             std::numeric_limits<double>::quiet_NaN());
}

}  // namespace dem

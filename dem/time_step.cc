#include "dem/time_step.h"

#include <algorithm>
#include <cmath>

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

}  // namespace dem

#include "apps/time_budget.h"

#include <algorithm>
#include <numeric>

namespace apps {

double TimeBudget::share(Part part) const {
  const double all = std::accumulate(sampled_.begin(), sampled_.end(), 0.0);
  return all > 0 ? sampled_[part] / all : part == stones;
}

std::vector<Finding> TimeBudget::findings() const {
  const double steps = spent_[stepping];
  return {{"seconds_other", spent_[other]},       {"seconds_settling", spent_[settling]},
          {"seconds_steel_setup", spent_[steel_setup]}, {"seconds_stones", steps * share(stones)},
          {"seconds_outputs", steps * share(outputs)},  {"seconds_steel", steps * share(steel)},
          {"seconds_pictures", spent_[pictures]}};
}

}  // namespace apps

#include "apps/laws.h"

template class dem::Simulation<apps::Dry>;
template class dem::Simulation<apps::DampedDry>;
template class dem::Simulation<apps::BreakingDry>;

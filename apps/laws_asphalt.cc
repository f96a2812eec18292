#include "apps/laws.h"

template class dem::Simulation<apps::Asphalt<2>>;
template class dem::Simulation<apps::BreakingAsphalt<2>>;
template class dem::Simulation<apps::Asphalt<apps::most_prony_terms>>;
template class dem::Simulation<apps::BreakingAsphalt<apps::most_prony_terms>>;

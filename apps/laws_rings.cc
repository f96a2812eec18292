#include "apps/laws.h"

template class dem::Simulation<apps::Asphalt<2, apps::film_rings>>;
template class dem::Simulation<apps::BreakingAsphalt<2, apps::film_rings>>;

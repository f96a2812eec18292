// The energy ledger of every law, and its place in the results of a run.
#pragma once

#include <vector>

#include "apps/laws.h"
#include "apps/recorder.h"
#include "apps/summary.h"
#include "dem/energy_ledger.h"

namespace apps {

// One column for each kind of energy, and its values now.
void add_energy_columns(std::vector<Column>& columns);
void add_energies(std::vector<double>& row, const dem::Energies& energies);

// The same for a summary, under the names of the columns with their units.
void add_energies(std::vector<Finding>& findings, const dem::Energies& energies);

}  // namespace apps

// Compiled once, in ledger.cc.
extern template class dem::EnergyLedger<apps::Dry>;
extern template class dem::EnergyLedger<apps::DampedDry>;
extern template class dem::EnergyLedger<apps::BreakingDry>;
extern template class dem::EnergyLedger<apps::Asphalt<2>>;
extern template class dem::EnergyLedger<apps::BreakingAsphalt<2>>;
extern template class dem::EnergyLedger<apps::Asphalt<2, apps::film_rings>>;
extern template class dem::EnergyLedger<apps::BreakingAsphalt<2, apps::film_rings>>;
extern template class dem::EnergyLedger<apps::Asphalt<apps::most_prony_terms>>;
extern template class dem::EnergyLedger<apps::BreakingAsphalt<apps::most_prony_terms>>;

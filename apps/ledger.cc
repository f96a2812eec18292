#include "apps/ledger.h"

namespace apps {
namespace {

struct Entry {
  const char* name;
  double value;
};

// All in J.
std::vector<Entry> entries(const dem::Energies& e) {
  return {{"energy_kinetic", e.kinetic},
          {"energy_kinetic_spin", e.spin},
          {"energy_kinetic_mass_scaling", e.mass_scaling},
          {"energy_stone_elastic", e.stored.stone},
          {"energy_binder_stored", e.stored.binder},
          {"energy_binder_dissipated", e.lost.binder},
          {"energy_friction", e.lost.friction},
          {"energy_stone_area_change", e.lost.stone_area},
          {"energy_film_area_change", e.lost.film_area},
          {"energy_damping", e.lost.damping + e.drag},
          {"energy_bond_breaking", e.lost.bond},
          {"energy_fracture", e.lost.fracture},
          {"energy_work_of_walls", e.walls},
          {"energy_work_of_gravity", e.gravity},
          {"energy_residual", e.residual()}};
}

}  // namespace

void add_energy_columns(std::vector<Column>& columns) {
  for (const Entry& entry : entries({})) columns.push_back({entry.name, "J"});
  columns.push_back({"energy_residual_share", "1"});
}

void add_energies(std::vector<double>& row, const dem::Energies& energies) {
  for (const Entry& entry : entries(energies)) row.push_back(entry.value);
  row.push_back(energies.residual_share());
}

void add_energies(std::vector<Finding>& findings, const dem::Energies& energies) {
  for (const Entry& entry : entries(energies))
    findings.push_back({std::string(entry.name) + "_J", entry.value});
  findings.push_back({"energy_residual_share", energies.residual_share()});
}

}  // namespace apps

template class dem::EnergyLedger<apps::Dry>;
template class dem::EnergyLedger<apps::DampedDry>;
template class dem::EnergyLedger<apps::BreakingDry>;
template class dem::EnergyLedger<apps::Asphalt<2>>;
template class dem::EnergyLedger<apps::BreakingAsphalt<2>>;
template class dem::EnergyLedger<apps::Asphalt<2, apps::film_rings>>;
template class dem::EnergyLedger<apps::BreakingAsphalt<2, apps::film_rings>>;
template class dem::EnergyLedger<apps::Asphalt<apps::most_prony_terms>>;
template class dem::EnergyLedger<apps::BreakingAsphalt<apps::most_prony_terms>>;

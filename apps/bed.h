// A bed of stones as every program begins it: a gas in a rigid container, settled under its weight.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "apps/ledger.h"
#include "dem/observe.h"
#include "dem/packing.h"

namespace apps {

// Material of walls that do not yield: all compliance of the contact is the stone's.
inline constexpr dem::Material rigid = {1e30, 0.3};

// Stones whose mean height stands for the height of a bed (Olsson, Jelagin, Partl, section 3.2).
inline constexpr int highest_points = 10;

// The step for a pair of stones like the one at `place`, with full shells, or a slight overlap of
// dry stones [s].
template <class Law>
double stable_step(const Law& law, const dem::ParticleStore& stones, std::size_t place,
                   double safety) {
  const double radius = stones.radius[place];
  dem::Contact<double> contact = {};
  contact.overlap = stones.shell > 0 ? 2 * stones.shell : 1e-4 * radius;
  contact.outer_radius = (radius + stones.shell) / 2;
  contact.stone_radius = radius / 2;
  contact.mass = stones.inertia[place] / 2;
  contact.softness = 1;
  contact.normal = {0, 0, 1};
  typename Law::template Memory<double> memory = {};
  Law fresh = law;
  fresh.set_time_step(1e-9);
  return safety * std::sqrt(stones.inertia[place] / fresh(contact, memory).stiffness);
}

// Of the stone that needs the smallest: used while nothing stiffer is in contact [s].
template <class Law>
double largest_step(const Law& law, const dem::ParticleStore& stones, double safety) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < stones.size(); ++k)
    least = std::min(least, stable_step(law, stones, k, safety));
  return least;
}

// The inertia [kg] of stones from which is taken what they do not need for the step of the one that
// needs most: against one like itself, and against as many of the smallest as find room around it,
// who press it all at once. None gets less than its mass.
// Not for a bed that still falls: where the scales differ, weight sorts the stones.
template <class Law>
std::vector<double> selected_inertia(const Law& law, const dem::ParticleStore& stones) {
  const double needed = largest_step(law, stones, 1);
  const auto smallest = static_cast<std::size_t>(
      std::min_element(stones.radius.begin(), stones.radius.end()) - stones.radius.begin());
  const double least = stones.inertia[smallest];
  std::vector<double> inertia(stones.size());
  for (std::size_t k = 0; k < stones.size(); ++k) {
    const double spare = needed / stable_step(law, stones, k, 1);
    const double room = 0.5 * (1 + stones.outer_radius(k) / stones.outer_radius(smallest));
    const double enough = std::max(stones.inertia[k] * spare * spare, least * room * room);
    inertia[k] = std::max(stones.mass[k], std::min(stones.inertia[k], enough));
  }
  return inertia;
}

// Contacts between stones that are held by a bond; without energy, bonds hold nothing.
template <class Law>
double bonds(const dem::Simulation<Law>& bed, const std::optional<BinderScene>& binder) {
  return binder && binder->bond_energy > 0 ? static_cast<double>(bed.pairs().held()) : 0;
}

// The simulation of a gas of the mix in a container, without walls yet, at rest and without bonds.
template <class Law>
dem::Simulation<Law> make_bed(const StonesScene& stones, const Mix& mix, const LawBook& book,
                              const FillScene& fill, const NumericsScene& numerics, int seed,
                              const dem::Mould& container) {
  std::vector<double> outer = mix.radius;
  for (double& r : outer) r += mix.shell;
  const dem::Gas gas = dem::pack_gas(outer, container, fill.packing_density, seed);
  dem::ParticleStore store =
      dem::make_stones(gas.position, mix.radius, mix.layers(stones), numerics.mass_scale);
  if (!mix.strength.empty()) dem::make_breakable(store, mix.strength);

  const Law law = book.law<Law>({std::nullopt, stones.friction}, fill.bonds);
  dem::Settings settings;
  settings.safety = numerics.safety;
  settings.largest_overlap = numerics.largest_overlap;
  settings.largest_step = largest_step(law, store, numerics.safety);
  settings.skin = 0.1 * (mix.smallest_radius() + mix.shell);
  return dem::Simulation<Law>(std::move(store), law, settings);
}

// How far the settling of a bed is.
struct Settling {
  double fall = 0;       // time of free fall over the depth of the gas [s]
  double threshold = 0;  // kinetic energy of a bed at rest [J]
  double start = 0;      // [s]
  double next_look = 0;  // at the kinetic energy [s]
  bool over = false;
};

// Begins to let a gas settle until its kinetic energy is below rest_energy x sum of m g R; motion
// also dies out by a drag of twice the rate of free fall over the depth of the gas, which only this
// stage has.
template <class Law>
Settling begin_settling(dem::Simulation<Law>& bed, const FillScene& fill) {
  const dem::ParticleStore& stones = bed.stones();
  Settling settling;
  for (std::size_t k = 0; k < stones.size(); ++k)
    settling.threshold += fill.rest_energy * stones.mass[k] * dem::earth_gravity * stones.radius[k];
  const double depth = dem::mean_of_highest(stones, 1);
  settling.fall = std::sqrt(2 * depth * dem::mean_inertia_scale(stones) / dem::earth_gravity);
  settling.start = bed.time();
  settling.next_look = bed.time() + 0.05 * settling.fall;
  bed.set_drag(2 / settling.fall);
  return settling;
}

// Goes on until the bed is at rest. Stops with NumericalTrouble if it does not come to rest within
// 100 times of free fall. `pulse` is called after every step.
template <class Law>
void settle(dem::Simulation<Law>& bed, Settling& settling,
            const std::function<void(double progress)>& report,
            const std::function<void()>& pulse) {
  while (!settling.over) {
    while (bed.time() < settling.next_look) {
      bed.step();
      pulse();
    }
    settling.next_look = bed.time() + 0.05 * settling.fall;
    const double energy = dem::kinetic_energy(bed.stones());
    const double spent = (bed.time() - settling.start) / settling.fall;
    report(std::min(1.0, settling.threshold / energy));
    settling.over = spent > 1 && energy < settling.threshold;
    if (!settling.over && spent > 100)
      throw dem::NumericalTrouble("kinetic energy [J] of a bed that does not come to rest",
                                  bed.stones().id.front(), bed.time(), energy);
  }
  bed.set_drag(0);
}

// The two in one, for a bed that is not interrupted.
template <class Law>
void settle(dem::Simulation<Law>& bed, const FillScene& fill,
            const std::function<void(double progress)>& report) {
  Settling settling = begin_settling(bed, fill);
  settle(bed, settling, report, [] {});
}

}  // namespace apps

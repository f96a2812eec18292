// What a run will be, said before it runs (--check): sizes, contacts, time step, time to take, and
// what its user should know.
//
// Estimates that no formula gives are measured ones of the two small scenes of apps/scenes: 1.7
// times of free fall until a bed is at rest, five touching neighbours of a stone.
#pragma once

#include <chrono>
#include <iosfwd>
#include <string>
#include <vector>

#include "apps/bed.h"

namespace apps {

struct BedPlan {
  const StonesScene& stones;
  const std::optional<BinderScene>& binder;
  const FillScene& fill;
  const NumericsScene& numerics;
  int seed;
  dem::Mould container;
};

struct Loading {
  double pressure;                // on the mix [Pa]
  double shear_rate;              // of the mix [1/s]
  double duration;                // after the bed has settled [s]
  double width;                   // least inner width of the container [m]
  double quasi_static;            // inertial number from which on `--check` warns [-]
  std::string container;          // "mould"
  std::string to_be_more_static;  // what to do, as an order
};

struct BedForecast {
  double stone_count;
  double shell, smallest, largest;       // thickness, diameters [m]
  double shortest_bond, longest_bond;    // relaxed, between two smallest, two largest stones [m]
  double contacts;                       // pairs of stones whose shells touch
  std::size_t memory;                    // of a contact's law [B]
  double loose_step, loaded_step;        // [s]
  double load;                           // stone contact force that limits the latter [N]
  double settling_time, loaded_time;     // simulated [s]
  double seconds_per_step;               // of the wall clock, without elastic steel
  double steel_seconds = 0;              // of the wall clock, from the meshes to the reduced bodies
  double steel_seconds_per_step = 0;     // of the wall clock, after the settling
  double inertial_number, quasi_static;  // what it will be, and from what on it is high [-]
  double widths;                         // container width / largest stone [-]
  dem::Departure fitted, drawn;          // see Mix
  std::string container, to_be_more_static;  // see Loading
  double loaded_steps() const { return loaded_time / loaded_step; }
  double steps() const { return settling_time / loose_step + loaded_steps(); }
  double seconds() const {
    return seconds_per_step * steps() + steel_seconds + steel_seconds_per_step * loaded_steps();
  }
};

// The part that is arithmetic.
BedForecast forecast(const BedPlan& plan, const Mix& mix, const Loading& loading);

// As one line each; the warnings begin with "warning:".
std::vector<std::string> forecast_lines(const BedForecast& forecast, const NumericsScene& numerics);

// Wall time of a step of the bed as dense as it will be, measured on this machine [s].
template <class Law>
double measured_step(const BedPlan& plan, const Mix& mix, const LawBook& book,
                     const dem::Gas& gas) {
  constexpr double dense = 0.58;       // of shells that touch five neighbours each
  constexpr double still = 1e-12;      // a step in which nothing moves [s]
  constexpr double long_enough = 0.3;  // to time [s]
  const double squeeze = std::cbrt(plan.fill.packing_density / dense);
  std::vector<dem::Vec3d> place = gas.position;
  for (dem::Vec3d& p : place) p *= squeeze;
  dem::ParticleStore store =
      dem::make_stones(place, mix.radius, mix.layers(plan.stones), plan.numerics.mass_scale);
  if (!mix.strength.empty())
    dem::make_breakable(store, std::vector<double>(mix.strength.size(), 1e30));
  dem::Settings settings;
  settings.largest_step = still;
  settings.largest_overlap = 1e30;
  settings.skin = 0.1 * (mix.smallest_radius() + mix.shell);
  dem::Simulation<Law> bed(std::move(store),
                           book.law<Law>({std::nullopt, plan.stones.friction}, true), settings);
  using Clock = std::chrono::steady_clock;
  for (int warm = 0; warm < 20; ++warm) bed.step();
  const auto start = Clock::now();
  const std::int64_t before = bed.steps();
  double spent = 0;
  while (spent < long_enough) {
    bed.step();
    spent = std::chrono::duration<double>(Clock::now() - start).count();
  }
  return spent / static_cast<double>(bed.steps() - before);
}

// The whole forecast: the bed is packed, its loose step asked of its law, its steps timed.
template <class Law>
BedForecast forecast_bed(const BedPlan& plan, const Mix& mix, const LawBook& book,
                         const Loading& loading) {
  BedForecast told = forecast(plan, mix, loading);
  std::vector<double> outer = mix.radius;
  for (double& r : outer) r += mix.shell;
  const dem::Gas gas = dem::pack_gas(outer, plan.container, plan.fill.packing_density, plan.seed);
  dem::ParticleStore store =
      dem::make_stones(gas.position, mix.radius, mix.layers(plan.stones), plan.numerics.mass_scale);
  const Law law = book.law<Law>({std::nullopt, plan.stones.friction}, plan.fill.bonds);
  told.settling_time *=
      std::sqrt(2 * gas.height * dem::mean_inertia_scale(store) / dem::earth_gravity);
  if (plan.numerics.selective_mass) store.inertia = selected_inertia(law, store);
  told.inertial_number *= std::sqrt(dem::mean_inertia_scale(store) / plan.numerics.mass_scale);
  told.memory = sizeof(typename Law::template Memory<double>);
  told.loose_step = largest_step(law, store, plan.numerics.safety);
  told.loaded_step = std::min(told.loaded_step, told.loose_step);
  told.seconds_per_step = measured_step<Law>(plan, mix, book, gas);
  return told;
}

}  // namespace apps

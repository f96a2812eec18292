#include "apps/forecast.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "dem/laws/bond.h"

namespace apps {
namespace {

constexpr double touching_neighbours = 5;  // of a stone, measured
// Of the step of the smallest stones under load, where no size has inertia to spare and the force
// chains through large stones count: measured, 0.55 to 0.6 with 450 and 5000 stones in the mould.
constexpr double left_of_step = 0.6;
constexpr double falls_to_rest = 1.7;    // times of free fall until a bed is at rest, measured
constexpr double nearly_static = 1e-2;   // inertial number up to which forces are roughly at rest
constexpr double nearly_unstable = 0.5;  // twelve such contacts around a stone bear 2 / sqrt(12)
constexpr double near_table = 0.05;      // of the mass, that stones may depart from it: our choice
constexpr double enough_widths = 4;  // 150 mm for stones up to 37.5 mm: AASHTO T 312, from memory

// How far a bond between two such stones stretches once all that relaxes has relaxed [m].
double relaxed_bond(const BinderScene& binder, const Mix& mix, double radius) {
  const double relaxes =
      mix.bitumen_fraction * std::accumulate(binder.alpha.begin(), binder.alpha.end(), 0.0);
  const double modulus = binder.shear_modulus * std::max(0.0, 1 - relaxes);
  return dem::Bond{binder.bond_energy}.stretch(modulus, (radius + mix.shell) / 2);
}

// Time step of the smallest stone pressed on one like it by a force [N].
double step_under(double force, const Mix& mix, const BedPlan& plan) {
  const StonesScene& stone = plan.stones;
  const double modulus = stone.young / (2 * (1 - stone.poisson * stone.poisson));  // E0
  const double radius = mix.smallest_radius(), effective = radius / 2;
  const double overlap = std::pow(0.75 * force / (modulus * std::sqrt(effective)), 2.0 / 3.0);
  const double stiffness = 2 * modulus * std::sqrt(effective * overlap);
  const double mass = mix.layers(stone).mass(radius);
  return plan.numerics.safety * std::sqrt(plan.numerics.mass_scale * mass / stiffness);
}

std::string duration(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

std::string steel_share(const BedForecast& told) {
  if (told.steel_seconds == 0) return "";
  return fmt::format(", {:.2g} ms more with the steel, {} to prepare that",
                     1e3 * told.steel_seconds_per_step, duration(told.steel_seconds));
}

std::string passing(const dem::Departure& departure) {
  return fmt::format("{:.1f} % instead of {:.1f} % pass {:g} mm", 100 * departure.found,
                     100 * departure.asked, 1e3 * departure.sieve);
}

bool is_far(const dem::Departure& departure) {
  return std::abs(departure.found - departure.asked) > near_table;
}

}  // namespace

BedForecast forecast(const BedPlan& plan, const Mix& mix, const Loading& loading) {
  BedForecast told = {};
  const auto count = static_cast<double>(mix.radius.size());
  const double mean =
      2 * std::accumulate(mix.radius.begin(), mix.radius.end(), 0.0) / count;  // diameter [m]
  told.stone_count = count;
  told.shell = mix.shell;
  told.smallest = 2 * mix.smallest_radius();
  told.largest = 2 * mix.largest_radius();
  if (plan.binder) {
    told.shortest_bond = relaxed_bond(*plan.binder, mix, mix.smallest_radius());
    told.longest_bond = relaxed_bond(*plan.binder, mix, mix.largest_radius());
  }
  told.contacts = 0.5 * touching_neighbours * count;
  told.load = loading.pressure * mean * mean;
  told.loaded_step = step_under(told.load, mix, plan);
  if (plan.numerics.selective_mass) told.loaded_step *= left_of_step;
  told.settling_time = falls_to_rest;  // in times of free fall until the gas is packed
  told.loaded_time = loading.duration;
  // da Cruz et al. (2005), of stones with their shells and the inertia that they have.
  const dem::Layers layers = mix.layers(plan.stones);
  double mass = 0;
  for (const double r : mix.radius) mass += layers.mass(r);
  const double density = mass / (mix.stone_volume + mix.binder_volume);
  told.inertial_number = loading.shear_rate * (mean + 2 * mix.shell) *
                         std::sqrt(plan.numerics.mass_scale * density / loading.pressure);
  told.quasi_static = loading.quasi_static;
  told.widths = loading.width / told.largest;
  told.fitted = mix.fitted;
  told.drawn = mix.drawn;
  told.container = loading.container;
  told.to_be_more_static = loading.to_be_more_static;
  return told;
}

std::vector<std::string> forecast_lines(const BedForecast& told, const NumericsScene& numerics) {
  std::vector<std::string> lines = {
      fmt::format("stones           {:.0f}, diameters {:.2f} to {:.2f} mm", told.stone_count,
                  1e3 * told.smallest, 1e3 * told.largest),
      fmt::format("sieve table      farthest from it: {}", passing(told.drawn)),
      fmt::format("shell thickness  {:.3f} mm", 1e3 * told.shell),
      fmt::format("contacts         about {:.0f} between stones, each remembers {} B",
                  told.contacts, told.memory),
      fmt::format("time step        {:.2e} s while loose, about {:.1e} s under load",
                  told.loose_step, told.loaded_step),
      fmt::format("limited by       two {}, later pressed by about {:.2g} N",
                  numerics.selective_mass ? "stones of any size" : "of the smallest stones",
                  told.load),
      fmt::format("steps            about {:.1e} ({:.0f} s of settling, {:.0f} s after it)",
                  told.steps(), told.settling_time, told.loaded_time),
      fmt::format("time to take     about {} here ({:.2g} ms a step{})", duration(told.seconds()),
                  1e3 * told.seconds_per_step, steel_share(told)),
      fmt::format("inertial number  {:.1e} (high from {:.0e} on)", told.inertial_number,
                  told.quasi_static)};
  if (told.longest_bond > 0)
    lines.push_back(fmt::format("bonds            stretch by {:.1f} to {:.1f} mm once relaxed",
                                1e3 * told.shortest_bond, 1e3 * told.longest_bond));
  if (told.longest_bond > told.largest)
    lines.push_back(
        "warning: bonds stretch farther than the largest stone is wide, which no film does; lower "
        "binder.bond_energy, or raise binder.shear_modulus");
  const double most = numerics.mass_scale * std::pow(told.quasi_static / told.inertial_number, 2);
  if (most < 1)
    lines.push_back(fmt::format(
        "warning: no numerics.mass_scale is low enough for a quasi-static run, the stones' own "
        "inertia will carry part of the load; {}",
        told.to_be_more_static));
  else if (told.inertial_number > nearly_static)
    lines.push_back(fmt::format(
        "warning: numerics.mass_scale = {:.0f} is too high, the stones' inertia will carry part of "
        "the load; {:.0f} would be quasi-static",
        numerics.mass_scale, most));
  else if (told.inertial_number > told.quasi_static)
    lines.push_back(fmt::format(
        "warning: numerics.mass_scale = {:.0f} is high for a quasi-static run ({:.0f} would be); "
        "show that half of it gives the same curve",
        numerics.mass_scale, most));
  if (numerics.safety > nearly_unstable)
    lines.push_back(fmt::format(
        "warning: numerics.safety = {:g} is near or beyond the limit of stability: energy may come "
        "from nowhere; take {:.1f} or less",
        numerics.safety, nearly_unstable));
  if (is_far(told.fitted))
    lines.push_back(fmt::format(
        "warning: the truncated normal does not fit the sieve table, {}; "
        "stones.distribution = \"log_linear\" follows it, with smaller stones: take more",
        passing(told.fitted)));
  else if (is_far(told.drawn))
    lines.push_back(
        fmt::format("warning: too few stones for the sieve table ({:.0f}), {}; take more",
                    told.stone_count, passing(told.drawn)));
  if (told.widths < enough_widths)
    lines.push_back(fmt::format(
        "warning: the {} is small for the largest stone, {:.1f} of them wide; below {:.0f} the "
        "walls order the stones and air voids are too high",
        told.container, told.widths, enough_widths));
  if (told.seconds() > 86400)
    lines.push_back("warning: more than a day; fewer stones or a larger mass_scale take less");
  return lines;
}

}  // namespace apps

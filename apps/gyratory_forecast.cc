#include "apps/gyratory_forecast.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "apps/clocks.h"
#include "apps/steel.h"

namespace apps {
namespace {

// Wall time of an exchange, the static modes' share included [s].
double measured_exchange(SteelPart& part, dem::Wall& wall) {
  constexpr double time_step = 1e-5;    // of about any run [s]
  constexpr double long_enough = 0.05;  // to time [s]
  const double began = wall_clock();
  int exchanges = 0;
  double spent = 0;
  for (; spent < long_enough; spent = wall_clock() - began)
    for (int k = 0; k < 100; ++k, ++exchanges) part.exchange(wall, {time_step, time_step});
  return spent / exchanges;
}

}  // namespace

Loading gyratory_loading(const GyratoryScene& scene, const Machine& machine) {
  // Where a third of the densification is lost, see inertia_price.h; a quarter at 3e-4, the
  // default's.
  constexpr double quasi_static = 4e-4;
  const GyrationScene& gyration = scene.gyration;
  return {gyration.pressure,
          gyration.angle * 2 * std::numbers::pi * gyration.speed,
          gyration.ramp + gyration.dwell + gyration.count / gyration.speed,
          2 * machine.mould_radius,
          quasi_static,
          "mould",
          "lower gyration.speed, or raise gyration.pressure"};
}

std::vector<std::string> mould_lines(const Machine& machine, int stones) {
  constexpr double flattest = 0.66;  // specimen height / diameter, EN 12697-31, from memory
  const double diameter = 2 * machine.mould_radius, share = machine.height / (flattest * diameter);
  std::vector<std::string> lines = {fmt::format("mould            {:g} mm wide", 1e3 * diameter)};
  if (share < 1)
    lines.push_back(fmt::format(
        "warning: the mix is flat, {:.2g} mm high in a mould of {:.4g} mm, usual are {:g} of the "
        "width and more: below, the highest stones carry the plate and air voids mean little; take "
        "{:.0f} stones, or a mould of {:.3g} mm",
        1e3 * machine.height, 1e3 * diameter, flattest, std::ceil(stones / share),
        1e3 * diameter * std::cbrt(share)));
  return lines;
}

SteelForecast steel_forecast(const GyratoryScene& scene, const Machine& machine) {
  SteelForecast told;
  const auto foretell = [&](const char* name, const auto& elastic) {
    if (!elastic) return;
    const double began = wall_clock();
    dem::Wall wall;
    const Steel part = make_steel(elastic, machine, scene.numerics, wall);
    told.seconds += wall_clock() - began;
    told.seconds_per_step += measured_exchange(*part, wall);
    told.parts.push_back({name, part->outline()});
  };
  foretell("head", scene.head.elastic);
  foretell("mould", scene.mould.elastic);
  return told;
}

std::vector<std::string> steel_lines(const SteelForecast& steel, const GyratoryScene& scene,
                                     double time_step) {
  constexpr double largest_lag = 0.1;  // of a mode behind what gyrates [rad]
  constexpr double quick = 5;          // frequency of a mode / that of the gyrations
  const double speed = scene.gyration.speed, scale = scene.numerics.head_mass_scale;
  std::vector<std::string> lines;
  for (const auto& [name, outline] : steel.parts) {
    lines.push_back(fmt::format(
        "{:16} elastic, {} unknowns, gain at most {:.2g} (bed / steel stiffness): {} modes swing, "
        "{} follow",
        name, outline.unknowns, outline.gain, outline.swinging, outline.following));
    // See model.md: such a mode comes to rest in 2 gain dt.
    const double lag = 4 * std::numbers::pi * speed * outline.gain * time_step;
    if (outline.swinging > 0 && lag > largest_lag)
      lines.push_back(
          fmt::format("warning: the {} is soft, it would bend {:.2g} rad of a gyration too late; "
                      "take stiffer steel, slower gyrations or a smaller numerics.mass_scale",
                      name, lag));
    const double frequency = outline.lowest_frequency;
    if (frequency < quick * speed)
      lines.push_back(fmt::format(
          "warning: numerics.head_mass_scale = {:.3g} lets the {} swing at only {:.2g} Hz, slow "
          "for gyrations of {:.2g} rev/s; {:.2g} would be {} times as quick as they are",
          scale, name, frequency, speed, scale * std::pow(frequency / (quick * speed), 2), quick));
  }
  return lines;
}

}  // namespace apps

#include "apps/gyratory_forecast.h"

#include <fmt/format.h>

#include <numbers>

#include "apps/steel.h"

namespace apps {
namespace {

std::string line(const char* name, const SteelPart& part) {
  const coupling::ElasticWall& wall = part.coupled();
  return fmt::format(
      "{:16} elastic, {} unknowns, gain at most {:.2g} (bed / steel stiffness): {} modes swing, {} "
      "follow",
      name, part.body().unknowns(), wall.gain().maxCoeff(), wall.oscillators(),
      wall.gain().size() - wall.oscillators());
}

}  // namespace

Loading gyratory_loading(const GyratoryScene& scene, const Machine& machine) {
  const GyrationScene& gyration = scene.gyration;
  return {gyration.pressure, gyration.angle * 2 * std::numbers::pi * gyration.speed,
          gyration.ramp + gyration.count / gyration.speed, 2 * machine.mould_radius};
}

std::vector<std::string> steel_forecast(const GyratoryScene& scene, const Machine& machine) {
  std::vector<std::string> lines;
  if (scene.head.elastic) {
    dem::Wall plate;
    lines.push_back(line("head", SteelPart(*scene.head.elastic, machine, scene.numerics, plate)));
  }
  if (scene.mould.elastic) {
    dem::Wall ring;
    lines.push_back(line("mould", SteelPart(*scene.mould.elastic, machine, scene.numerics, ring)));
  }
  return lines;
}

}  // namespace apps

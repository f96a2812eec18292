#include "apps/machine.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "apps/errors.h"
#include "apps/sections.h"

namespace apps {
namespace {

constexpr double reference_voids = 0.04;     // of the specimen that sizes a mould [-]
constexpr double clearance_share = 1.5e-3;   // plate clearance / mould diameter (EN 12697-31) [-]
constexpr double longest_gauge = 0.125;      // / circumference: a longer one reads no single place
constexpr double least_stones_across = 2.5;  // mould diameter / largest stone

}  // namespace

Machine size_machine(const GyratoryScene& scene, const Mix& mix) {
  const double pi = std::numbers::pi;
  const double volume = (mix.stone_volume + mix.binder_volume) / (1 - reference_voids);
  const double diameter = scene.mould.diameter.value_or(
      std::cbrt(4 * volume / (pi * scene.mould.aspect_ratio.value_or(1))));
  const double height = volume / (pi / 4 * diameter * diameter);
  std::vector<std::string> mistakes;
  if (scene.mould.diameter && height > highest_specimen * diameter) {
    const double most = highest_specimen * diameter / height * scene.stones.count;
    mistakes.push_back(fmt::format(
        "{}: expected at most {:.0f} stones for a mould of {:.4g} mm, found {}; change the "
        "count, or give mould.aspect_ratio instead of mould.diameter to scale the mould "
        "to the stones",
        scene.where("stones.count"), std::floor(most), 1e3 * diameter, scene.stones.count));
  }
  if (const auto& steel = scene.mould.elastic; steel && steel->height < height)
    mistakes.push_back(fmt::format(
        "{}: expected a mould higher than the specimen, {:.4g} mm at {:.0f} % air voids, found "
        "{:.4g} mm; make it higher, twice that gives room to the loose bed",
        scene.where("mould.elastic.height"), 1e3 * height, 1e2 * reference_voids,
        1e3 * steel->height));
  const double plate = diameter * (1 - clearance_share);
  if (const auto& steel = scene.head.elastic; steel && steel->shaft_diameter >= plate)
    mistakes.push_back(fmt::format(
        "{}: expected a shaft thinner than the plate, {:.4g} mm for {} stones, found {:.4g} mm; "
        "take a thinner shaft or a wider mould",
        scene.where("head.elastic.shaft_diameter"), 1e3 * plate, scene.stones.count,
        1e3 * steel->shaft_diameter));
  const double outside =
      diameter + 2 * (scene.mould.elastic ? scene.mould.elastic->wall_thickness : 0);
  for (std::size_t i = 0; i < scene.gauges.size(); ++i)
    if (scene.gauges[i].length > longest_gauge * pi * outside)
      mistakes.push_back(fmt::format(
          "{}: expected a gauge of at most {:.4g} mm, an eighth of the circumference, found {:.4g} "
          "mm; take a shorter one",
          scene.where(gauge_section(i) + ".length"), 1e3 * longest_gauge * pi * outside,
          1e3 * scene.gauges[i].length));
  const double largest = 2 * mix.largest_radius();
  if (diameter < least_stones_across * largest)
    mistakes.push_back(scene.where(scene.mould.diameter ? "mould.diameter" : "stones.count") +
                       ": expected a mould of at least " +
                       fmt::format("{:.4g}", 1e3 * least_stones_across * largest) +
                       " mm for a largest stone of " + fmt::format("{:.4g}", 1e3 * largest) +
                       " mm, found " + fmt::format("{:.4g}", 1e3 * diameter) +
                       " mm; take a wider mould or more stones");
  if (!mistakes.empty()) throw InputError(mistakes);
  const double radius = diameter / 2;
  return {radius, plate / 2, pi * radius * radius, height};
}

double rigid_head_mass(const HeadScene& head, const Machine& machine) {
  constexpr double thickness = 0.020, density = 7850;  // of the plate [m], of steel [kg/m3]
  const double area = std::numbers::pi * machine.plate_radius * machine.plate_radius;
  return head.mass.value_or(density * thickness * area);
}

}  // namespace apps

#include "apps/stress_case.h"

#include <cmath>
#include <filesystem>
#include <numbers>

#include "apps/scene_manual.h"
#include "apps/sections.h"
#include "apps/stress_theory.h"

namespace apps {
namespace {

constexpr Unit millimetre{"mm", "m"}, kilopascal{"kPa", "Pa"}, gigapascal{"GPa", "Pa"};
constexpr Unit newton{"N", "N"}, newton_metre{"N m", "N m"}, density_unit{"kg/m3", "kg/m3"};

void add_steel(Section& section, fem::Steel& steel) {
  section.parameters.insert(
      section.parameters.end(),
      {{&steel.young, "young", gigapascal, positive, "Young's modulus", ""},
       {&steel.poisson, "poisson", pure, poisson_range, "Poisson's ratio", ""},
       {&steel.density, "density", density_unit, positive, "of the steel", ""}});
}

std::vector<Section> describe(StressCase& given) {
  Section mould{
      "mould",
      "A cylinder with free ends, held at its base against rigid motion; clamped there under one "
      "stone.",
      {{&given.mould.inner_diameter, "inner_diameter", millimetre, positive, "inside", ""},
       {&given.mould.wall_thickness, "wall_thickness", millimetre, positive, "of the cylinder", ""},
       {&given.mould.height, "height", millimetre, positive,
        "of the cylinder, loaded over all of it", ""}}};
  add_steel(mould, given.mould.steel);
  Section head{
      "head",
      "A round plate on a shaft, which is clamped at its root.",
      {{&given.head.plate_diameter, "plate_diameter", millimetre, positive, "of the loaded face",
        ""},
       {&given.head.plate_thickness, "plate_thickness", millimetre, positive, "of the plate", ""},
       {&given.head.shaft_diameter, "shaft_diameter", millimetre, positive,
        "less than that of the plate", ""},
       {&given.head.shaft_length, "shaft_length", millimetre, positive,
        "from the back of the plate to the root", ""}}};
  add_steel(head, given.head.steel);
  ColumnOfStones& stones = given.stones;
  return {
      std::move(mould),
      std::move(head),
      {"load",
       "What the steel bears: the mould under pressure, band, ovalling or stones, the head under "
       "plate_pressure, eccentric, point or angle_check.",
       {{&given.load.kind,
         "kind",
         pure,
         unbounded,
         "of the load",
         "",
         required("\"pressure\""),
         {"pressure", "band", "ovalling", "plate_pressure", "eccentric", "point", "angle_check",
          "stones"}},
        {&given.load.pressure, "pressure", kilopascal, positive,
         "amplitude of an ovalling pressure, mean of an eccentric one", ""},
        {&given.load.length, "length", millimetre, positive, "of a band along the axis", ""},
        {&given.load.harmonic, "harmonic", pure, between(2, 6), "n of cos(n angle)", ""},
        {&given.load.eccentricity, "eccentricity", millimetre, positive,
         "of the resultant of a pressure that varies linearly over the plate, or of a point on it",
         ""},
        {&given.load.force, "force", newton, positive, "on a point, or on one stone", ""},
        {&given.load.moment, "moment", newton_metre, positive, "of a couple on the head", ""}}},
      {"stones",
       "For kind = \"stones\": one stone pressed on the wall at mid-height, or a settled column.",
       {{&stones.count, "count", pure, at_least(1), "one, or as many as fill a column", ""},
        {&stones.smallest, "smallest", millimetre, positive, "diameter", ""},
        {&stones.largest, "largest", millimetre, positive, "diameter; of the one stone, too", ""},
        {&stones.density, "density", density_unit, positive, "of the stones", ""},
        {&stones.young, "young", gigapascal, positive, "Young's modulus", ""},
        {&stones.poisson, "poisson", pure, poisson_range, "Poisson's ratio", ""},
        {&stones.friction, "friction", pure, at_least(0), "Coulomb coefficient of stones", ""},
        {&stones.wall_friction, "wall_friction", pure, at_least(0), "at wall and floor", ""},
        {&stones.restitution, "restitution", pure, restitution_range, "speed after / before", ""},
        {&stones.mass_scale, "mass_scale", pure, at_least(1), "inertia / true inertia", ""},
        {&stones.modes, "modes", pure, at_least(1), "of the mould's reduced body", ""},
        {&stones.seed, "seed", pure, at_least(0), "of sizes and places", ""}}},
      {"mesh",
       "Of the steel.",
       {{&given.mesh.refinement, "refinement", pure, between(0, 3), "times the elements are halved",
         ""}}}};
}

class CaseCheck {
 public:
  CaseCheck(const Document& document, Mistakes& mistakes)
      : document_(document), mistakes_(mistakes) {}

  void check(const StressCase& given) const {
    const fem::Head& head = given.head;
    if (head.shaft_diameter >= head.plate_diameter)
      refuse("head.shaft_diameter", "a shaft thinner than the plate is wide", "make it thinner");
    if (given.load.kind == "point" && given.load.eccentricity >= head.plate_diameter / 2)
      refuse("load.eccentricity", "a point on the plate, less than half of its diameter",
             "move it inwards");
    const fem::Mould& mould = given.mould;
    const double wave = 2 * std::numbers::pi / shell_wave_number(mould);
    if (given.load.kind == "band" && mould.height < given.load.length + wave)
      refuse("mould.height",
             "a mould that reaches half a wave of the shell, " +
                 std::to_string(std::lround(500 * wave)) + " mm, beyond both edges of the band",
             "make it taller, or the band shorter");
    // Free ends let a ring yield more, by about nu^2 / (beta height): 1.4 % at this height.
    if (given.load.kind == "ovalling" && mould.height < wave)
      refuse("mould.height",
             "a mould in plane strain, as high as a wave of the shell, " +
                 std::to_string(std::lround(1000 * wave)) + " mm",
             "make it taller");
    if (given.stones.largest < given.stones.smallest)
      refuse("stones.largest", "no less than stones.smallest", "swap them");
    if (given.load.kind == "stones" && given.stones.largest > 0.4 * mould.inner_diameter)
      refuse("stones.largest", "a stone that fits well into the mould", "make it smaller");
  }

 private:
  void refuse(const std::string& key, const std::string& expected,
              const std::string& advice) const {
    const Value* value = document_.find(key);
    mistakes_.add(document_.place(key), "for " + key + ' ' + expected,
                  value ? value->written : "the default", advice);
  }

  const Document& document_;
  Mistakes& mistakes_;
};

}  // namespace

std::string StressCase::name() const {
  return std::filesystem::path(path).stem().string();
}

std::string stress_case_manual() {
  StressCase given;
  return manual(describe(given));
}

StressCase read_stress_case(const std::string& path, const std::vector<std::string>& overrides) {
  const UnitSystem units;
  Mistakes mistakes;
  const Document document = read_document(path, overrides, mistakes);
  StressCase given;
  given.path = path;
  read_sections(describe(given), document, units, mistakes);
  if (!mistakes.any()) CaseCheck(document, mistakes).check(given);
  if (mistakes.any()) throw InputError(mistakes.lines());
  return given;
}

}  // namespace apps

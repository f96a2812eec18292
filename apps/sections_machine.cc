// The declarations of what compacts: mould, head, gyration, flow test.
#include "apps/machine.h"
#include "apps/sections.h"

namespace apps {
namespace {

constexpr Unit millimetre{"mm", "m"}, second{"s", "s"}, degree{"deg", "rad"};
constexpr Unit kilopascal{"kPa", "Pa"}, gigapascal{"GPa", "Pa"}, density{"kg/m3", "kg/m3"};
constexpr Unit kilogram{"kg", "kg"}, revolutions{"rev/s", "rev/s"}, speed{"mm/min", "m/s"};
constexpr Unit approach{"mm/s", "m/s"};

constexpr const char* gyratory_test = "Olsson, Jelagin, Partl, section 3.3";
constexpr const char* flow_test = "Olsson, Jelagin, Partl, section 3.2";
constexpr const char* authors_code = "a hint from the authors' public code, not from the paper";
constexpr const char* standard = "AASHTO T 312, from memory";
constexpr const char* measured_loss = "our choice: bends as much as machines do, from memory";
constexpr const char* steel = "structural steel";
constexpr const char* ours = "our choice";

template <class ElasticScene>
void add_steel(Section& section, ElasticScene& body) {
  section.parameters.insert(
      section.parameters.end(),
      {{&body.young, "young", gigapascal, positive, "Young's modulus", steel},
       {&body.poisson, "poisson", pure, poisson_range, "Poisson's ratio", steel},
       {&body.density, "density", density, positive, "of the steel", steel},
       {&body.modes, "modes", pure, positive,
        "of the reduced body: how many, or, below 1, the share of the largest compliance that may "
        "be left out, as in \"1e-3\"",
        ours},
       {&body.full, "full", pure, unbounded,
        "true: the full body answers at every exchange, what the modes leave out statically; the "
        "reference for `modes`",
        ours}});
}

}  // namespace

Section describe(MouldScene& mould) {
  return {"mould",
          "A cylinder. Give either its diameter, or the aspect ratio of the specimen.",
          {{&mould.diameter, "diameter", millimetre, positive, "inside", standard,
            alternative("\"150 mm\"")},
           {&mould.aspect_ratio, "aspect_ratio", pure, above_zero_to(highest_specimen),
            "height of the specimen at 4 % air voids / diameter: the mould is scaled to the stones",
            authors_code, optional("1")},
           {&mould.wall_friction, "wall_friction", pure, friction_range,
            "Coulomb coefficient of stones on wall and base", authors_code}}};
}

Section describe(std::optional<ElasticMouldScene>& mould) {
  if (!mould) mould.emplace();
  Section section{"mould.elastic",
                  "The mould as an elastic body; absent: rigid.",
                  {{&mould->wall_thickness, "wall_thickness", millimetre, above_zero_to(1e3),
                    "of the cylinder, 7.5 mm or more by standard", standard},
                   {&mould->height, "height", millimetre, above_zero_to(5e3),
                    "of the cylinder above its clamped lower edge", standard}},
                  [&mould] { mould.reset(); }};
  add_steel(section, *mould);
  return section;
}

Section describe(HeadScene& head) {
  return {"head",
          "The loading plate and its ram.",
          {{&head.mass, "mass", kilogram, positive,
            "of a rigid head; absent: that of a steel plate, 20 mm thick", ours,
            optional("\"2.8 kg\"")},
           {&head.friction, "friction", pure, friction_range,
            "Coulomb coefficient of stones on the plate", authors_code}}};
}

Section describe(std::optional<ElasticHeadScene>& head) {
  if (!head) head.emplace();
  Section section{"head.elastic",
                  "Plate and shaft as an elastic body; absent: rigid.",
                  {{&head->plate_thickness, "plate_thickness", millimetre, above_zero_to(1e3),
                    "of the plate", ours},
                   {&head->shaft_diameter, "shaft_diameter", millimetre, above_zero_to(1e3),
                    "of the ram, less than that of the mould", measured_loss},
                   {&head->shaft_length, "shaft_length", millimetre, above_zero_to(5e3),
                    "from the back of the plate to the clamped root", measured_loss}},
                  [&head] { head.reset(); }};
  add_steel(section, *head);
  return section;
}

Section describe(GyrationScene& gyration) {
  return {
      "gyration",
      "The tilted head presses, then its tilt precesses about the mould's axis.",
      {{&gyration.angle, "angle", degree, between(0, 5), "tilt imposed at the root of the ram",
        gyratory_test},
       {&gyration.pressure, "pressure", kilopascal, positive,
        "force of the ram / cross section of the mould", gyratory_test},
       {&gyration.ramp, "ramp", second, positive,
        "time in which the pressure rises linearly, before the gyrations", gyratory_test},
       {&gyration.dwell, "dwell", second, at_least(0),
        "time at full pressure before the gyrations, until the ram has come down", ours},
       {&gyration.speed, "speed", revolutions, positive, "of the gyrations", gyratory_test},
       {&gyration.count, "count", pure, positive, "number of gyrations", ours},
       {&gyration.spin, "spin", pure, unbounded,
        "true: the plate turns with its tilt; false: it precesses, as in a real machine", ours},
       {&gyration.approach_speed, "approach_speed", approach, positive,
        "of the ram at most: on its way through the valve oil loses pressure with the square of "
        "the ram's speed, at this one all of it",
        ours}}};
}

Section describe(FlowScene& flow) {
  return {"flow",
          "Compaction flow test: a strip presses on one end of the mix in a rigid box.",
          {{&flow.length, "length", millimetre, positive, "of the box, inside", flow_test},
           {&flow.width, "width", millimetre, positive, "of the box and of the strip", flow_test},
           {&flow.height, "height", millimetre, positive, "of the box", flow_test},
           {&flow.strip_length, "strip_length", millimetre, positive,
            "of the strip, along the box and at its low end", flow_test},
           {&flow.speed, "speed", speed, positive, "of the strip, downwards", flow_test},
           {&flow.displacement, "displacement", millimetre, positive,
            "of the strip at the end of the test", ours},
           {&flow.wall_friction, "wall_friction", pure, friction_range,
            "Coulomb coefficient of stones on walls and strip", authors_code}}};
}

}  // namespace apps

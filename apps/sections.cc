#include "apps/sections.h"

namespace apps {
namespace {

constexpr Unit second{"s", "s"}, minute{"min", "s"}, degree{"deg", "rad"}, millimetre{"mm", "m"};
constexpr const char* ours = "our choice";

}  // namespace

Section describe(NumericsScene& numerics) {
  return {
      "numerics",
      "What trades accuracy for speed.",
      {{&numerics.mass_scale, "mass_scale", pure, at_least(1),
        "inertia / true inertia; the weight is never scaled (a flow test: 3000)",
        "Thornton, Antony (1998); apps/docs/trade.md"},
       {&numerics.selective_mass, "selective_mass", pure, unbounded,
        "true: mass_scale is that of the stone that needs most for its time step, the others get "
        "what they need for the same once the bed lies (a flow test: false)",
        "measured, apps/docs/trade.md"},
       {&numerics.safety, "safety", pure, above_zero_to(3),
        "time step / sqrt(m / k) of the stiffest contact", "O'Sullivan, Bray (2004), near 0.17"},
       {&numerics.time_compression, "time_compression", pure, at_least(1),
        "times that the process is run faster than asked for, and the binder relaxes faster", ours},
       {&numerics.largest_overlap, "largest_overlap", pure, above_zero_to(1),
        "a run stops where stones overlap by this share of the smaller radius", ours}}};
}

Section describe(OutputScene& output) {
  return {"output",
          "What a run writes down, and how often.",
          {{&output.history_interval, "history_interval", second, positive,
            "of simulated time between the rows of the histories", ours},
           {&output.picture_interval, "picture_interval", second, at_least(0),
            "of simulated time between pictures; 0: only the end", ours},
           {&output.energy_ledger, "energy_ledger", pure, unbounded,
            "where the work goes, in the history; takes time, changes no other result", ours},
           {&output.checkpoint_interval, "checkpoint_interval", minute, positive,
            "of wall time between checkpoints, from which --resume goes on", ours}}};
}

std::string gauge_section(std::size_t number) {
  return repeated("output.gauge", number);
}

Section describe(GaugeScene& gauge, std::size_t number) {
  return {gauge_section(number),
          "A strain gauge on the outside of an elastic mould: a column of the history.",
          {{&gauge.angle, "angle", degree, between(-360, 360), "from the x axis", ours,
            required("\"0 deg\"")},
           {&gauge.height, "height", millimetre, positive, "above the base of the mould", ours,
            required("\"50 mm\"")},
           {&gauge.length, "length", millimetre, positive, "along the circumference", ours}}};
}

std::vector<Section> describe(GyratoryScene& scene) {
  Section numerics = describe(scene.numerics);
  numerics.parameters.push_back(
      {&scene.numerics.exchange_interval, "exchange_interval", pure, at_least(1),
       "steps between exchanges with the static modes of the steel", ours});
  numerics.parameters.push_back(
      {&scene.numerics.head_mass_scale, "head_mass_scale", pure, at_least(1),
       "inertia / true inertia of the head and of the modes of the steel; "
       "at least: modes too quick for the time step get more",
       ours});
  Section output = describe(scene.output);
  output.parameters.push_back(
      {&scene.maps, "maps", pure, unbounded,
       "true: the traction on the mould, unrolled and averaged over each gyration", ours});
  output.parameters.push_back(
      {&scene.movie, "movie", pure, unbounded,
       "true: 16 pictures of the last gyration, for a movie (apps/render_run.py)", ours});
  std::vector<Section> sections = {
      describe(scene.run),           describe(scene.stones), describe(scene.stones.fracture),
      describe(scene.binder),        describe(scene.fill),   describe(scene.mould),
      describe(scene.mould.elastic), describe(scene.head),   describe(scene.head.elastic),
      describe(scene.gyration),      std::move(numerics),    std::move(output)};
  for (std::size_t i = 0; i < scene.gauges.size(); ++i)
    sections.push_back(describe(scene.gauges[i], i));
  return sections;
}

std::vector<Section> describe(FlowTestScene& scene) {
  return {describe(scene.run),      describe(scene.stones), describe(scene.stones.fracture),
          describe(scene.binder),   describe(scene.fill),   describe(scene.flow),
          describe(scene.numerics), describe(scene.output)};
}

}  // namespace apps

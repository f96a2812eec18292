// What may stand in a scene: the declarations of all its sections.
#pragma once

#include <optional>
#include <vector>

#include "apps/parameters.h"
#include "apps/scene.h"

namespace apps {

inline constexpr Bounds poisson_range{.least = 0, .most = 0.5, .most_excluded = true};

// The box that tests/extremes/contact_box_test.cc drives pairs of stones in, and that no scene may
// leave. What has no bounds here, as sizes and relaxation times, is taken there over decades.
inline constexpr Bounds friction_range = between(0, 1.5);          // [-]
inline constexpr Bounds restitution_range = between(0.01, 1);      // of stones [-]
inline constexpr Bounds young_range = between(1e-3, 1e3);          // of stones [GPa]
inline constexpr Bounds shear_modulus_range = between(1e-3, 1e3);  // of binder [MPa]
inline constexpr Bounds bond_energy_range = between(0, 0.1);       // [J/mm2]
inline constexpr double thickest_shell = 1.25;                     // / radius of a stone in it [-]

Section describe(RunScene& run);
Section describe(StonesScene& stones);
Section describe(FillScene& fill);
Section describe(MouldScene& mould);
Section describe(HeadScene& head);
Section describe(GyrationScene& gyration);
Section describe(FlowScene& flow);
Section describe(NumericsScene& numerics);  // of what every program needs
Section describe(OutputScene& output);

// A section that may be absent is filled in, so that it can be read into; its `drop` empties it.
Section describe(std::optional<FractureScene>& fracture);
Section describe(std::optional<BinderScene>& binder);
Section describe(std::optional<ElasticMouldScene>& mould);
Section describe(std::optional<ElasticHeadScene>& head);

Section describe(GaugeScene& gauge, std::size_t number);  // counted from 0
std::string gauge_section(std::size_t number);            // "output.gauge[0]"

std::vector<Section> describe(GyratoryScene& scene);
std::vector<Section> describe(FlowTestScene& scene);

}  // namespace apps

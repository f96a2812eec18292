// What may stand in a scene: the declarations of all its sections.
#pragma once

#include <optional>
#include <vector>

#include "apps/parameters.h"
#include "apps/scene.h"

namespace apps {

inline constexpr Bounds poisson_range{.least = 0, .most = 0.5, .most_excluded = true};

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

#include "apps/gyratory_findings.h"

#include <algorithm>
#include <cassert>

namespace apps {
namespace {

void add_steel(std::vector<Finding>& found, const std::string& name, const SteelPart& part) {
  const SteelPart::Outline outline = part.outline();
  found.push_back({name + "_unknowns", static_cast<std::int64_t>(outline.unknowns)});
  found.push_back({name + "_gain", outline.gain});
  found.push_back({name + "_truncation_error", outline.truncation});
}

}  // namespace

std::size_t Rows::place(const std::string& column) const {
  const auto found = std::ranges::find(columns, column, &Column::name);
  assert(found != columns.end());
  return static_cast<std::size_t>(found - columns.begin());
}

double Rows::mean(const std::string& column) const {
  if (values.size() == 1) return last(column);
  const std::size_t time = place("time"), of = place(column);
  double sum = 0;
  for (std::size_t k = 1; k < values.size(); ++k)
    sum += values[k][of] * (values[k][time] - values[k - 1][time]);
  return sum / (values.back()[time] - values.front()[time]);
}

double Rows::last(const std::string& column) const {
  return values.back()[place(column)];
}

std::vector<Finding> gyratory_findings(const GyratoryScene& scene, const Mix& mix,
                                       const Machine& machine, const GyratoryOutcome& outcome) {
  const Rows& rows = outcome.last_gyrations;
  std::vector<Finding> found =
      bed_findings(outcome.bed, mix, scene.numerics, scene.run.seed, outcome.spent);
  const std::vector<Finding> own = {{"gyrations", scene.gyration.count},
                                    {"settling_steps", outcome.settled_steps},
                                    {"air_voids_start", outcome.voids_at_start},
                                    {"air_voids_end", rows.last("air_voids")},
                                    {"settled_height_m", outcome.settled_height},
                                    {"height_end_m", rows.last("height")},
                                    {"mould_diameter_m", 2 * machine.mould_radius},
                                    {"ram_pressure_mean_Pa", rows.mean("ram_pressure")},
                                    {"head_force_mean_N", rows.mean("head_force")},
                                    {"head_weight_N", outcome.head_mass * dem::earth_gravity},
                                    {"commanded_angle_deg", rows.mean("commanded_angle")},
                                    {"internal_angle_deg", rows.mean("internal_angle")}};
  found.insert(found.end(), own.begin(), own.end());
  if (outcome.head) {
    const SteelPart::Tilt tilt = outcome.head->tilt();
    found.push_back({"head_tilt_per_moment_rad_per_Nm", tilt.per_moment});
    found.push_back({"head_tilt_per_force_rad_per_N", tilt.per_force});
    add_steel(found, "head", *outcome.head);
  }
  if (outcome.mould) add_steel(found, "mould", *outcome.mould);
  return found;
}

}  // namespace apps

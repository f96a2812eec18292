#include "apps/gyratory_history.h"

#include <algorithm>
#include <iterator>
#include <numbers>

#include "apps/ledger.h"
#include "apps/wall_outputs.h"

namespace apps {

std::vector<Column> GyratoryHistory::columns(const GyratoryScene& scene) {
  std::vector<Column> all = {{"time", "s"},
                             {"gyration", "1"},
                             {"height", "m"},
                             {"air_voids", "1"},
                             {"ram_pressure", "Pa"},
                             {"head_force", "N"},
                             {"head_lateral_x", "N"},
                             {"head_lateral_y", "N"},
                             {"head_moment_x", "N m"},
                             {"head_moment_y", "N m"},
                             {"commanded_angle", "deg"},
                             {"internal_angle", "deg"},
                             {"fractured", "1"},
                             {"bonds", "1"},
                             {"coordination", "1"},
                             {"kinetic_energy", "J"},
                             {"mould_force", "N"},
                             {"time_step", "s"}};
  if (scene.output.energy_ledger) add_energy_columns(all);
  std::ranges::copy(WallOutputs::columns(scene), std::back_inserter(all));
  all.push_back({"air_voids_decrease", "1"});
  return all;
}

void GyratoryHistory::look(const dem::Wall& head, const dem::Wall& mould, double time, double dt) {
  const auto& ram = std::get<dem::Ram>(head.motion);
  means_.span += dt;
  means_.force += head.force * dt;
  means_.moment += head.moment * dt;
  means_.mould_push += mould.push * dt;
  means_.ram_force += ram.thrust_at(time, head.frame.velocity.z) * dt;
}

std::vector<double> GyratoryHistory::end_row(const Moment& moment, const GyratoryScene& scene,
                                             double section) {
  const double degree = 180 / std::numbers::pi;
  const double span = means_.span;
  const std::vector<double> row = {moment.time,
                                   std::max(0.0, moment.gyration),
                                   moment.height,
                                   moment.air_voids,
                                   means_.ram_force / span / section,
                                   means_.force.z / span,
                                   means_.force.x / span,
                                   means_.force.y / span,
                                   means_.moment.x / span,
                                   means_.moment.y / span,
                                   scene.gyration.angle * degree,
                                   moment.internal_angle * degree,
                                   moment.fractured,
                                   moment.bonds,
                                   moment.coordination,
                                   moment.kinetic_energy,
                                   means_.mould_push / span,
                                   moment.time_step};
  means_ = {};
  return row;
}

void GyratoryHistory::record(Recorder& recorder, const Moment& moment, double gyrations,
                             std::vector<double> row) {
  const auto put = [&](std::vector<double> whole) {
    whole.push_back(*voids_at_start_ - whole[air_voids]);
    recorder.append(whole);
  };
  if (moment.gyration < 0) {
    held_rows_.push_back(std::move(row));
    return;
  }
  if (!voids_at_start_) {
    voids_at_start_ = moment.air_voids;
    for (auto& held : held_rows_) put(std::move(held));
  }
  constexpr double rounding = 1e-3;  // of a row's end to a whole step, in gyrations
  if (moment.gyration <= std::max(0.0, gyrations - 2) + rounding) last_rows_.clear();
  last_rows_.push_back(row);
  put(std::move(row));
}

void GyratoryHistory::visit_state(Archive& item) {
  item("means", means_);
  item("held_rows", held_rows_);
  item("last_rows", last_rows_);
  item("voids_at_start", voids_at_start_);
}

}  // namespace apps

#include "apps/wall_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace apps {
namespace {

constexpr std::array<const char*, WallOutputs::parts> names = {"floor", "mould", "head"};

Eigen::Map<const Eigen::VectorXd> letters(const dem::SurfaceField& field) {
  return {&field.impulse.front().x, 3 * static_cast<Eigen::Index>(field.size())};
}

}  // namespace

WallOutputs::WallOutputs(const GyratoryScene& scene, const Machine& machine)
    : gauges_(scene.gauges), maps_(scene.maps), machine_(machine) {
  elastic_[mould] = scene.mould.elastic.has_value();
  elastic_[head] = scene.head.elastic.has_value();
}

std::vector<Column> WallOutputs::columns(const GyratoryScene& scene) {
  std::vector<Column> columns = {{"floor_force", "N"},     {"mould_axial_force", "N"},
                                 {"floor_traction", "Pa"}, {"mould_traction", "Pa"},
                                 {"head_traction", "Pa"},  {"mould_axial_traction", "Pa"}};
  const std::array<bool, parts> elastic = {false, scene.mould.elastic.has_value(),
                                           scene.head.elastic.has_value()};
  for (const int part : {mould, head})
    if (elastic[part])
      for (const char* what : {"force", "moment", "work"})
        columns.push_back({fmt::format("{}_residual_{}", names[part], what), "1"});
  for (std::size_t i = 0; i < scene.gauges.size(); ++i)
    columns.push_back({fmt::format("gauge_{}_hoop_strain", i + 1), "1"});
  return columns;
}

void WallOutputs::begin(std::vector<dem::Wall>& walls, const SteelPart* steel_mould) {
  dem::Wall& ring = walls[mould];
  if (maps_ && !ring.field) {
    constexpr int rows = 8, sectors = 24;  // of the specimen, as it stands now
    ring.field.emplace(
        dem::CylinderGrid{machine_.mould_radius, walls[head].frame.origin.z, rows, sectors});
    rigid_letterbox_ = true;
  }
  if (steel_mould)
    for (const GaugeScene& gauge : gauges_)
      influence_.push_back(steel_mould->gauge_influence(*ring.field, gauge));
  if (maps_ || !influence_.empty())
    row_impulse_ = gyration_impulse_ =
        Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(ring.field->size()));
}

void WallOutputs::add_up(std::vector<dem::Wall>& walls, double dt, double specimen_height) {
  const double side = 2 * std::numbers::pi * machine_.mould_radius * specimen_height;
  const double plate = std::numbers::pi * machine_.plate_radius * machine_.plate_radius;
  const std::array<double, parts> area = {machine_.section, side, plate};
  sums_.span += dt;
  for (int part = 0; part < parts; ++part) {
    sums_.force[part] += walls[part].force * dt;
    sums_.traction[part] += walls[part].push / area[part] * dt;
  }
  sums_.axial_traction += walls[mould].force.z / side * dt;
  if (row_impulse_.size() == 0) return;
  row_impulse_ += letters(*walls[mould].field);
  gyration_impulse_ += letters(*walls[mould].field);
  gyration_span_ += dt;
  if (rigid_letterbox_) std::ranges::fill(walls[mould].field->impulse, dem::Vec3d{0, 0, 0});
}

// Force, moment about the wall's origin and power: of the contacts on the wall against what the
// letterbox holds, over the size of what could be lost.
void WallOutputs::compare_sides(const dem::Wall& wall, int part, double dt,
                                double power_of_stones) {
  if (wall.push <= 0) return;
  const dem::SurfaceField& field = *wall.field;
  dem::Vec3d force = {0, 0, 0}, moment = {0, 0, 0};
  double power = 0;
  for (std::size_t n = 0; n < field.size(); ++n) {
    const dem::Vec3d share = field.impulse[n] * (1 / dt);
    force += share;
    moment += cross(field.node[n], share);
    power += dot(share, field.velocity[n]);
  }
  const auto on_wall = [&](const dem::Vec3d& v) { return wall.frame.to_frame(v); };
  Residual& residual = residual_[part];
  residual.force =
      std::max(residual.force, norm(force - on_wall(wall.force)) / std::max(wall.push, 1e-300));
  residual.moment = std::max(
      residual.moment, norm(moment - on_wall(wall.moment)) / (wall.push * machine_.mould_radius));
  if (field.fastest > 0)
    residual.work =
        std::max(residual.work, std::abs(power - power_of_stones) / (wall.push * field.fastest));
}

std::vector<double> WallOutputs::row() {
  const double span = sums_.span;
  std::vector<double> row = {sums_.force[floor].z / span,  sums_.force[mould].z / span,
                             sums_.traction[floor] / span, sums_.traction[mould] / span,
                             sums_.traction[head] / span,  sums_.axial_traction / span};
  for (const int part : {mould, head})
    if (elastic_[part])
      row.insert(row.end(), {residual_[part].force, residual_[part].moment, residual_[part].work});
  for (const Eigen::VectorXd& influence : influence_)
    row.push_back(influence.dot(row_impulse_) / span);
  sums_ = {};
  residual_ = {};
  row_impulse_.setZero();
  return row;
}

void WallOutputs::turn(double gyration, const dem::Wall& mould_wall, const SteelPart* steel_mould,
                       Recorder& recorder) {
  constexpr double rounding = 1e-6;  // of a time that is a sum of steps
  if (!maps_) return;
  if (turns_ >= 0) {
    if (gyration < turns_ + 1 - rounding) return;
    turns_ = std::floor(gyration + rounding);
    add_map(*mould_wall.field, steel_mould);
    write(recorder);
  } else if (gyration >= 0) {  // ramp and dwell, until now, belong to no gyration
    turns_ = 0;
  }
  gyration_impulse_.setZero();
  gyration_span_ = 0;
}

void WallOutputs::add_map(const dem::SurfaceField& field, const SteelPart* steel_mould) {
  const Eigen::VectorXd forces = gyration_impulse_ / gyration_span_;
  if (steel_mould)
    std::ranges::copy(steel_mould->hoop_stress(field, forces), std::back_inserter(map_.hoop));
  for (std::size_t n = 0; n < field.size(); ++n) {
    const dem::Vec3d& x = field.node[n];
    const auto force = forces.segment<3>(3 * static_cast<Eigen::Index>(n));
    map_.gyration.push_back(turns_);
    map_.angle.push_back(std::atan2(x.y, x.x));
    map_.height.push_back(x.z);
    map_.normal.push_back((force[0] * x.x + force[1] * x.y) / std::hypot(x.x, x.y) / field.area[n]);
    map_.axial.push_back(force[2] / field.area[n]);
  }
}

void WallOutputs::write(Recorder& recorder) const {
  recorder.write("/walls/mould/gyration", map_.gyration, "1");
  recorder.write("/walls/mould/angle", map_.angle, "rad");
  recorder.write("/walls/mould/height", map_.height, "m");
  recorder.write("/walls/mould/normal_traction", map_.normal, "Pa");
  recorder.write("/walls/mould/axial_traction", map_.axial, "Pa");
  if (!map_.hoop.empty()) recorder.write("/walls/mould/hoop_stress", map_.hoop, "Pa");
}

}  // namespace apps

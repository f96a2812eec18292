#include "apps/steel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "apps/errors.h"
#include "apps/pictures.h"
#include "apps/steel_answers.h"
#include "coupling/elastic_wall.h"

namespace apps {
namespace {

// The letterbox is coarser than a stone contact: local indentation is Hertz's business.
constexpr int sectors = 24;
constexpr int plate_rings = 6;

fem::Head head_of(const ElasticHeadScene& scene, const Machine& machine) {
  return {2 * machine.plate_radius,
          scene.plate_thickness,
          scene.shaft_diameter,
          scene.shaft_length,
          {scene.young, scene.poisson, scene.density}};
}

fem::Mould mould_of(const ElasticMouldScene& scene, const Machine& machine) {
  return {2 * machine.mould_radius,
          scene.wall_thickness,
          scene.height,
          fem::BaseSupport::clamped,
          {scene.young, scene.poisson, scene.density}};
}

double face_radius(const ElasticHeadScene&, const Machine& machine) {
  return machine.plate_radius;
}

double face_radius(const ElasticMouldScene&, const Machine& machine) {
  return machine.mould_radius;
}

fem::ElasticBody body_of(const ElasticHeadScene& scene, const Machine& machine) {
  return {head_of(scene, machine), fem::MeshSize{}};
}

fem::ElasticBody body_of(const ElasticMouldScene& scene, const Machine& machine) {
  return {mould_of(scene, machine), fem::MeshSize{}};
}

dem::SurfaceField letterbox(const ElasticHeadScene&, const Machine& machine) {
  return dem::SurfaceField(dem::DiscGrid{machine.plate_radius, plate_rings, sectors});
}

dem::SurfaceField letterbox(const ElasticMouldScene& scene, const Machine& machine) {
  const double cell = 2 * std::numbers::pi * machine.mould_radius / sectors;
  const int rows = std::max(4, static_cast<int>(std::lround(scene.height / cell)));
  return dem::SurfaceField(dem::CylinderGrid{machine.mould_radius, scene.height, rows, sectors});
}

class ElasticPart : public SteelPart {
 public:
  // `section`: of the scene, whose modes it has.
  template <class ElasticScene>
  ElasticPart(const ElasticScene& scene, const std::string& section, const Machine& machine,
              const NumericsScene& numerics, dem::Wall& wall);

  void exchange(dem::Wall& wall, dem::Steps steps) override { coupled_->exchange(wall, steps); }
  void visit_state(Archive& item, const std::string& in) override {
    coupled_->visit_state(item, in);
  }
  Outline outline() const override;
  Tilt tilt() const override;
  Eigen::VectorXd gauge_influence(const dem::SurfaceField& field,
                                  const GaugeScene& gauge) const override;
  std::vector<double> hoop_stress(const dem::SurfaceField& field,
                                  const Eigen::VectorXd& forces) const override {
    return hoop_stress_at_nodes(body_, field, forces);
  }
  void draw(const std::string& vtu, const dem::Frame& frame) const override;

 private:
  fem::ElasticBody body_;
  std::optional<coupling::ElasticWall> coupled_;
  double face_radius_;  // [m]
};

template <class ElasticScene>
ElasticPart::ElasticPart(const ElasticScene& scene, const std::string& section,
                         const Machine& machine, const NumericsScene& numerics, dem::Wall& wall)
    : body_(body_of(scene, machine)), face_radius_(face_radius(scene, machine)) {
  wall.field = letterbox(scene, machine);
  coupling::ExchangeSettings settings;
  settings.interval = numerics.exchange_interval;
  settings.inertia_scale = numerics.head_mass_scale;
  const Eigen::Matrix3Xd points = coupling::letterbox_points(wall);
  const int count = static_cast<int>(scene.modes);
  try {
    coupled_.emplace(count < 1 ? body_.reduce(scene.modes, points) : body_.reduce(count, points),
                     wall, settings);
  } catch (const std::invalid_argument&) {
    throw InputError({fmt::format(
        "{}.modes: expected fewer than the degrees of freedom of the steel's face, found {:g}; "
        "take fewer",
        section, scene.modes)});
  }
  if (scene.full) coupled_->follow_fully(body_.face_compliance(points), wall);
}

SteelPart::Outline ElasticPart::outline() const {
  const int swinging = coupled_->oscillators();
  return {body_.unknowns(),
          body_.mass(),
          coupled_->gain().maxCoeff(),
          coupled_->body().truncation_error,
          swinging,
          static_cast<int>(coupled_->gain().size()) - swinging,
          coupled_->lowest_frequency()};
}

Eigen::VectorXd ElasticPart::gauge_influence(const dem::SurfaceField& field,
                                             const GaugeScene& gauge) const {
  const double outside = body_.nodes().topRows(2).colwise().norm().maxCoeff();
  return apps::gauge_influence(body_, field, gauge, outside).reshaped();
}

SteelPart::Tilt ElasticPart::tilt() const {
  // A pressure p x / a^2 with x over the disc has the moment p pi a^2 / 4 about -y; its push along
  // +z at +x turns the plate by a negative angle about y.
  const double a = face_radius_, pi = std::numbers::pi;
  const Eigen::VectorXd moment = body_.face_load([&](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(0, 0, -4 * x.x() / (pi * std::pow(a, 4)));
  });
  const Eigen::VectorXd force = body_.face_load(
      [&](const Eigen::Vector3d&) { return Eigen::Vector3d(1 / (pi * a * a), 0, 0); });
  return {body_.face_motion(body_.solve(moment).col(0)).tilt_y,
          body_.face_motion(body_.solve(force).col(0)).tilt_y};
}

void ElasticPart::draw(const std::string& vtu, const dem::Frame& frame) const {
  const fem::CellMesh& cells = body_.cells();
  const Eigen::VectorXd displacement = coupled_->body().full_shape * coupled_->amplitude();
  const fem::StressField stress = body_.stress(displacement);
  Eigen::Matrix3d axes;
  axes << frame.ex.x, frame.ey.x, frame.ez.x, frame.ex.y, frame.ey.y, frame.ez.y, frame.ex.z,
      frame.ey.z, frame.ez.z;
  const Eigen::Vector3d origin(frame.origin.x, frame.origin.y, frame.origin.z);

  const Eigen::Index points = cells.points.cols();
  Eigen::Matrix3Xd place(3, points);
  Array shift = {"displacement [m]", 3, {}}, mises = {"von Mises stress [Pa]", 1, {}};
  Array tensor = {"stress in the body's axes [Pa]", 6, {}, {"xx", "yy", "zz", "yz", "zx", "xy"}};
  for (Eigen::Index p = 0; p < points; ++p) {
    const Eigen::Vector3d u = axes * displacement.segment<3>(3 * cells.node[p]);
    place.col(p) = origin + axes * cells.points.col(p) + u;
    shift.values.insert(shift.values.end(), {u.x(), u.y(), u.z()});
    const auto s = stress.col(p);
    tensor.values.insert(tensor.values.end(), s.begin(), s.end());
    mises.values.push_back(std::sqrt(
        0.5 * (std::pow(s[0] - s[1], 2) + std::pow(s[1] - s[2], 2) + std::pow(s[2] - s[0], 2)) +
        3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5])));
  }
  write_hexahedra(vtu, place, cells.hexahedra, {shift, mises, tensor});
}

}  // namespace

Steel make_steel(const std::optional<ElasticHeadScene>& scene, const Machine& machine,
                 const NumericsScene& numerics, dem::Wall& wall) {
  if (!scene) return nullptr;
  return std::make_unique<ElasticPart>(*scene, "head.elastic", machine, numerics, wall);
}

Steel make_steel(const std::optional<ElasticMouldScene>& scene, const Machine& machine,
                 const NumericsScene& numerics, dem::Wall& wall) {
  if (!scene) return nullptr;
  return std::make_unique<ElasticPart>(*scene, "mould.elastic", machine, numerics, wall);
}

void use_program_of(const GyratoryScene&, const std::vector<std::string>&) {}  // it is this one

}  // namespace apps

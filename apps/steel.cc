#include "apps/steel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "apps/errors.h"

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

}  // namespace

template <class ElasticScene>
void SteelPart::couple(const ElasticScene& scene, const std::string& section,
                       const NumericsScene& numerics, dem::Wall& wall) try {
  coupling::ExchangeSettings settings;
  settings.interval = numerics.exchange_interval;
  settings.inertia_scale = numerics.head_mass_scale;
  const Eigen::Matrix3Xd points = coupling::letterbox_points(wall);
  const int count = static_cast<int>(scene.modes);
  coupled_.emplace(count < 1 ? body_.reduce(scene.modes, points) : body_.reduce(count, points),
                   wall, settings);
  if (scene.full) coupled_->follow_fully(body_.face_compliance(points), wall);
} catch (const std::invalid_argument&) {
  throw InputError({fmt::format(
      "{}.modes: expected fewer than the degrees of freedom of the steel's face, found {:g}; take "
      "fewer",
      section, scene.modes)});
}

SteelPart::SteelPart(const ElasticHeadScene& scene, const Machine& machine,
                     const NumericsScene& numerics, dem::Wall& wall)
    : body_(head_of(scene, machine), fem::MeshSize{}), face_radius_(machine.plate_radius) {
  wall.field.emplace(dem::DiscGrid{machine.plate_radius, plate_rings, sectors});
  couple(scene, "head.elastic", numerics, wall);
}

SteelPart::SteelPart(const ElasticMouldScene& scene, const Machine& machine,
                     const NumericsScene& numerics, dem::Wall& wall)
    : body_(mould_of(scene, machine), fem::MeshSize{}), face_radius_(machine.mould_radius) {
  const double cell = 2 * std::numbers::pi * machine.mould_radius / sectors;
  const int rows = std::max(4, static_cast<int>(std::lround(scene.height / cell)));
  wall.field.emplace(dem::CylinderGrid{machine.mould_radius, scene.height, rows, sectors});
  couple(scene, "mould.elastic", numerics, wall);
}

SteelPart::Tilt SteelPart::tilt() const {
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

void SteelPart::draw(const std::string& vtu, const dem::Frame& frame) const {
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

}  // namespace apps

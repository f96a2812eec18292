#include <cmath>
#include <functional>
#include <numbers>

#include "apps/stress_cases.h"
#include "apps/stress_theory.h"

namespace apps {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;
using Load = std::function<VectorXd(const fem::ElasticBody&)>;  // nodal forces (unknowns) [N]

// The head under one load, solved.
class LoadedHead {
 public:
  LoadedHead(const fem::Head& head, fem::MeshSize mesh, const Load& load)
      : head_(head), body_(head, mesh) {
    const VectorXd forces = load(body_);
    displacement_ = body_.solve(forces);
    reaction_ = body_.reaction(displacement_, forces).head<3>();
  }

  fem::FaceMotion face_motion() const { return body_.face_motion(displacement_); }
  Vector3d reaction() const { return reaction_; }  // [N]

  double axial_at(double radius) const {  // displacement of the loaded face on +x [m]
    return body_.face_displacement(displacement_, Vector3d(radius, 0, 0))(2);
  }
  double rim_deflection() const {  // of the loaded face against the shaft's circle [m]
    return axial_at(head_.plate_diameter / 2) - axial_at(head_.shaft_diameter / 2);
  }

  // Axial stress at the shaft's surface half way to the root, as mean + slope x: least squares over
  // the nodes there.
  struct SurfaceStress {
    double mean;    // [Pa]
    double at_rim;  // slope times the shaft's radius [Pa]
  };
  SurfaceStress mid_shaft_stress() const {
    const fem::StressField stress = body_.stress(displacement_);
    const double b = head_.shaft_diameter / 2;
    const double middle = head_.plate_thickness + head_.shaft_length / 2;
    const auto& nodes = body_.nodes();
    const auto on_surface = [&](Eigen::Index i) {
      return std::abs(std::hypot(nodes(0, i), nodes(1, i)) - b) < 1e-3 * b;
    };
    double nearest = INFINITY;
    for (Eigen::Index i = 0; i < nodes.cols(); ++i)
      if (on_surface(i)) nearest = std::min(nearest, std::abs(nodes(2, i) - middle));
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (Eigen::Index i = 0; i < nodes.cols(); ++i) {
      if (!on_surface(i) || std::abs(nodes(2, i) - middle) > nearest + 1e-6 * b) continue;
      const Eigen::Vector2d basis(1, nodes(0, i) / b);
      normal += basis * basis.transpose();
      right += basis * stress(2, i);
    }
    const Eigen::Vector2d fit = normal.ldlt().solve(right);
    return {fit[0], fit[1]};
  }

  StressReport report(std::vector<StressRow> rows) const {
    return {std::move(rows), loaded_body(body_, displacement_), {}};
  }

 private:
  fem::Head head_;
  fem::ElasticBody body_;
  VectorXd displacement_;  // (unknowns) [m]
  Vector3d reaction_;      // [N]
};

// Mix under the plate pushes it towards the root: along +z.
StressReport press_plate(const StressCase& given) {
  const fem::Head& head = given.head;
  const double p = given.load.pressure;
  const Load load = [p](const fem::ElasticBody& body) {
    return body.face_load([p](const Vector3d&) { return Vector3d(0, 0, p); });
  };
  const LoadedHead loaded(head, given.mesh, load);
  const double force = p * pi / 4 * std::pow(head.plate_diameter, 2);
  return loaded.report(
      {{"reaction_force", "N", -loaded.reaction()[2], force, "pressure x area; the face's edge is "
        "quadratic arcs", 1e-3},
       {"axial_stress_shaft", "Pa", loaded.mid_shaft_stress().mean, -axial_stress(head, force),
        "bar, F/A at mid-length", 0.01},
       {"axial_displacement", "m", loaded.face_motion().axial, bar_shortening(head, force), "x",
        0.01},
       {"rim_deflection", "m", loaded.rim_deflection(), rim_deflection(head, p), "x", 0.01}});
}

// x
StressReport press_off_centre(const StressCase& given) {
  const fem::Head& head = given.head;
  const double a = head.plate_diameter / 2, p = given.load.pressure;
  const double slope = 4 * given.load.eccentricity / (a * a);  // p (1 + slope x) [1/m]
  const Load load = [=](const fem::ElasticBody& body) {
    return body.face_load([=](const Vector3d& x) { return Vector3d(0, 0, p * (1 + slope * x[0])); });
  };
  const LoadedHead loaded(head, given.mesh, load);
  const double moment = p * pi * a * a * given.load.eccentricity;  // about -y
  const double tilt = -loaded.face_motion().tilt_y / moment;
  const double beam = beam_rotation(head, 1), hub = hub_rotation(head, 1);
  return loaded.report(
      {{"tilt_per_moment", "rad/(N m)", tilt, beam + hub,
        "beam + hub: L/(EI) + 3(1-nu2)/(4 E b3) (Johnson 1985, 5.3)",
        0.01 + 0.5 * hub / (beam + hub)},
       {"bending_stress_shaft", "Pa", -loaded.mid_shaft_stress().at_rim,
        bending_stress(head, moment), "beam, M b/I at mid-length; the shaft is compressed at +x",
        0.02}});
}

// The displacement of a force on the face's centre is F (1 - nu^2) / (pi E r) of a half-space plus
// what the body's other faces add, which is smooth and even in r; a fit of s/r + c0 + c2 r^2 + c4 r^4
// tells the singular part s.
StressReport press_on_point(const StressCase& given) {
  const fem::Head& head = given.head;
  const double force = given.load.force;
  const LoadedHead loaded(head, given.mesh, [force](const fem::ElasticBody& body) {
    return body.point_load(Vector3d::Zero(), Vector3d(0, 0, force));
  });
  constexpr int samples = 40;
  const double reach = 0.5 * std::min(head.plate_thickness, head.plate_diameter / 2);
  Eigen::MatrixXd terms(samples, 4);
  VectorXd displacement(samples);
  for (int k = 0; k < samples; ++k) {
    const double r = reach * (0.3 + 0.7 * k / (samples - 1)), x = r / reach;
    terms.row(k) << 1 / x, 1, x * x, x * x * x * x;
    displacement[k] = loaded.axial_at(r);
  }
  const double singular = terms.colPivHouseholderQr().solve(displacement)[0] * reach;
  const double nu = head.steel.poisson;
  return loaded.report(
      {{"displacement_times_distance", "m2", singular,
        force * (1 - nu * nu) / (pi * head.steel.young),
        "Boussinesq, F(1-nu2)/(pi E), away from the loaded patch", 0.02}});
}

}  // namespace

StressReport load_head(const StressCase& given) {
  if (given.load.kind == "plate_pressure") return press_plate(given);
  return given.load.kind == "eccentric" ? press_off_centre(given) : press_on_point(given);
}

}  // namespace apps

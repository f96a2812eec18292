#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>

#include "apps/stress_cases.h"
#include "apps/stress_theory.h"

namespace apps {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr const char* joint_source =
    "annular plate + rocking half-space + built-in edge; tolerance 30 %: the last two are the "
    "limits of a thick and a thin plate and overlap";
constexpr double joint_tolerance = 0.3;
constexpr const char* tilt_source =
    "beam + joint; tolerance 5 %: the joint is a tenth of it, known to 30 %";
constexpr double tilt_tolerance = 0.05;

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

  // Axial displacement on the axis, by the parabola of the element in which a depth below the face
  // lies [m].
  double axial_below(double depth) const {
    const auto& nodes = body_.nodes();
    std::map<double, double> on_axis;  // depth -> displacement, three nodes an element [m]
    for (Eigen::Index i = 0; i < nodes.cols(); ++i)
      if (nodes.col(i).head<2>().norm() < 1e-9 * head_.shaft_diameter)
        on_axis[nodes(2, i)] = displacement_[3 * i + 2];
    auto node = on_axis.begin();
    while (std::next(node, 2)->first < depth) std::advance(node, 2);
    const auto [z0, u0] = *node++;
    const auto [z1, u1] = *node++;
    const auto [z2, u2] = *node;
    const double at = (depth - z0) / (z2 - z0);
    return (1 - at) * (1 - 2 * at) * u0 + 4 * at * (1 - at) * u1 + at * (2 * at - 1) * u2;
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

// The same head on a shaft twice as long: what hub, plate and clamp add cancels in the difference.
fem::Head on_longer_shaft(fem::Head head) {
  head.shaft_length *= 2;
  return head;
}

// Rim deflection / plate theory, as the plate becomes thin. The hub yields by a share of the
// plate's own deflection that goes with thickness; two thin plates tell the share, and the rest is
// the plate.
double thin_plate_ratio(fem::Head head, fem::MeshSize mesh, double pressure, const Load& load) {
  const auto ratio = [&](double share_of_shaft) {
    head.plate_thickness = share_of_shaft * head.shaft_diameter;
    return LoadedHead(head, mesh, load).rim_deflection() / rim_deflection(head, pressure);
  };
  return 2 * ratio(0.06) - ratio(0.12);
}

// Mix under the plate pushes it towards the root: along +z.
StressReport press_plate(const StressCase& given) {
  const fem::Head& head = given.head;
  const double p = given.load.pressure;
  const Load load = [p](const fem::ElasticBody& body) {
    return body.face_load([p](const Vector3d&) { return Vector3d(0, 0, p); });
  };
  const LoadedHead loaded(head, given.mesh, load);
  const LoadedHead longer(on_longer_shaft(head), given.mesh, load);
  const double force = p * pi / 4 * std::pow(head.plate_diameter, 2);
  return loaded.report(
      {{"reaction_force", "N", -loaded.reaction()[2], force,
        "pressure x area; the face's rim is made of quadratic arcs", 1e-3},
       {"axial_stress_shaft", "Pa", loaded.mid_shaft_stress().mean, -axial_stress(head, force),
        "bar, F/A at mid-length", 0.01},
       {"shaft_shortening", "m", longer.face_motion().axial - loaded.face_motion().axial,
        bar_shortening(head, force), "bar, F L/(EA), from heads on shafts L and 2L", 0.01},
       {"thin_plate_deflection_ratio", "1", thin_plate_ratio(head, given.mesh, p, load), 1,
        "annular plate (Timoshenko & Woinowsky-Krieger 1959, 17-20), hub extrapolated away from "
        "t = 0.06 and 0.12 shaft diameters",
        0.02}});
}

StressReport press_off_centre(const StressCase& given) {
  const fem::Head& head = given.head;
  const double a = head.plate_diameter / 2, p = given.load.pressure;
  const double slope = 4 * given.load.eccentricity / (a * a);  // p (1 + slope x) [1/m]
  const Load load = [=](const fem::ElasticBody& body) {
    return body.face_load(
        [=](const Vector3d& x) { return Vector3d(0, 0, p * (1 + slope * x[0])); });
  };
  const LoadedHead loaded(head, given.mesh, load);
  const LoadedHead longer(on_longer_shaft(head), given.mesh, load);
  const double moment = p * pi * a * a * given.load.eccentricity;  // about -y
  const double tilt = -loaded.face_motion().tilt_y / moment;
  const double tilt_longer = -longer.face_motion().tilt_y / moment;
  const double beam = beam_rotation(head, 1), joint = joint_rotation(head).sum();
  return loaded.report(
      {{"tilt_per_moment", "rad/(N m)", tilt, beam + joint, tilt_source, tilt_tolerance},
       {"joint_rotation_per_moment", "rad/(N m)", tilt - beam, joint, joint_source,
        joint_tolerance},
       {"tilt_per_moment_of_shaft", "rad/(N m)", tilt_longer - tilt, beam,
        "beam, L/(EI), from heads on shafts L and 2L", 0.01},
       {"bending_stress_shaft", "Pa", -loaded.mid_shaft_stress().at_rim,
        bending_stress(head, moment), "beam, M b/I at mid-length; the shaft is compressed at +x",
        0.02}});
}

// A force at the centre of the face, with elements small enough for the field close to it. It is a
// half-space's while the distance is small against plate and shaft; differences of displacement
// drop the plate's own, so that what is left goes with the third power of that ratio: 0.4^3 / 8 at
// 2 r. A shaft as long as it is wide is all of it that the field feels.
std::vector<StressRow> beside_a_point(const StressCase& given) {
  fem::Head head = given.head;
  head.shaft_length = std::min(head.shaft_length, head.shaft_diameter);
  const double force = given.load.force;
  const double near = 0.2 * std::min(head.plate_thickness, head.shaft_diameter / 2), far = 2 * near;
  fem::MeshSize mesh = given.mesh;
  mesh.at_centre = near / 10;
  const LoadedHead loaded(head, mesh, [&](const fem::ElasticBody& body) {
    return body.point_load(Vector3d::Zero(), Vector3d(0, 0, force));
  });
  return {{"dip_beside_point", "m", loaded.axial_at(near) - loaded.axial_at(far),
           boussinesq_deflection(head.steel, force, near) -
               boussinesq_deflection(head.steel, force, far),
           "Boussinesq, from r to 2r on the face, r = 1/5 of plate or shaft", 0.02},
          {"shortening_below_point", "m", loaded.axial_below(near) - loaded.axial_below(far),
           boussinesq_sinking(head.steel, force, near) - boussinesq_sinking(head.steel, force, far),
           "Boussinesq, from r to 2r below the face", 0.02}};
}

// Away from the patch that takes it, a force acts by its resultant alone (Saint-Venant).
StressReport press_on_point(const StressCase& given) {
  const fem::Head& head = given.head;
  const double force = given.load.force, moment = force * given.load.eccentricity;
  const Load load = [&](const fem::ElasticBody& body) {
    return body.point_load(Vector3d(given.load.eccentricity, 0, 0), Vector3d(0, 0, force));
  };
  const LoadedHead loaded(head, given.mesh, load);
  const LoadedHead longer(on_longer_shaft(head), given.mesh, load);
  const LoadedHead::SurfaceStress stress = loaded.mid_shaft_stress();
  std::vector<StressRow> rows = {
      {"reaction_force", "N", -loaded.reaction()[2], force, "balance", 1e-9},
      {"axial_stress_shaft", "Pa", stress.mean, -axial_stress(head, force),
       "bar, F/A at mid-length", 0.01},
      {"bending_stress_shaft", "Pa", -stress.at_rim, bending_stress(head, moment),
       "beam, F e b/I at mid-length", 0.02},
      {"tilt_of_shaft", "rad", loaded.face_motion().tilt_y - longer.face_motion().tilt_y,
       beam_rotation(head, moment), "beam, F e L/(EI), from heads on shafts L and 2L", 0.01}};
  for (StressRow& row : beside_a_point(given)) rows.push_back(std::move(row));
  return loaded.report(std::move(rows));
}

// A known couple on the head without mix, as simulated-loading devices apply it to a machine.
StressReport check_angle(const StressCase& given) {
  const fem::Head& head = given.head;
  const double a = head.plate_diameter / 2, moment = given.load.moment;
  const Load load = [=](const fem::ElasticBody& body) {
    return body.face_load([=](const Vector3d& x) {
      return Vector3d(0, 0, 4 * moment / (pi * std::pow(a, 4)) * x[0]);
    });
  };
  const LoadedHead loaded(head, given.mesh, load);
  const double degree = 180 / pi, loss = -loaded.face_motion().tilt_y * degree;
  const double shaft = beam_rotation(head, moment), joint = joint_rotation(head).sum() * moment;
  constexpr double least = 0.5e-4, most = 5e-4;  // of machines, from memory [deg/(N m)]
  return loaded.report(
      {{"angle_loss", "deg", loss, (shaft + joint) * degree, tilt_source, tilt_tolerance},
       {"joint_rotation", "deg", loss - shaft * degree, joint * degree, joint_source,
        joint_tolerance},
       {"angle_loss_per_moment", "deg/(N m)", loss / moment, (least + most) / 2,
        "machines lie from 0.5e-4 to 5e-4 (from memory): the middle, tolerance to either end; TRR "
        "1789's 0.074 and 0.110 deg are 1.6e-4 and 2.4e-4 of the 466 N m on both heads together, "
        "3.2e-4 and 4.7e-4 of the 233 N m on each",
        (most - least) / (most + least)}});
}

}  // namespace

StressReport load_head(const StressCase& given) {
  if (given.load.kind == "plate_pressure") return press_plate(given);
  if (given.load.kind == "angle_check") return check_angle(given);
  return given.load.kind == "eccentric" ? press_off_centre(given) : press_on_point(given);
}

}  // namespace apps

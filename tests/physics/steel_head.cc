// The loading head: shaft and plate against beam and plate theory.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "apps/stress_theory.h"
#include "fem/elastic_body.h"

namespace {

using Eigen::Vector3d;
using std::numbers::pi;

// A slender shaft on a plate so stiff that only the shaft bends: seven tenths as thick as it is
// wide.
constexpr fem::Head slender{.plate_diameter = 0.05,
                            .plate_thickness = 0.035,
                            .shaft_diameter = 0.02,
                            .shaft_length = 0.3,
                            .steel = {}};

// Pure moment [N m] about -y as a traction growing linearly with x.
fem::ElasticBody::Traction moment_about_y(const fem::Head& head, double moment) {
  const double second_moment = pi * std::pow(head.plate_diameter, 4) / 64;
  return [=](const Vector3d& x) { return Vector3d(0, 0, moment * x[0] / second_moment); };
}

// Cantilever: tip rotation M L / (E I), deflection M L^2 / (2 E I); Timoshenko & Goodier
// (1970), 21. The hub where the shaft enters the plate and the clamp's hindered contraction reach
// one shaft radius each, i.e. 3 % of the length each, with opposite signs; 2 % holds, and locking
// elements (2-5 times too stiff) do not.
TEST(shaft, bends_as_a_cantilever_under_an_eccentric_load) {
  const fem::ElasticBody body(slender, {});
  const double moment = 50;  // [N m]
  const Eigen::VectorXd displacement = body.solve(body.face_load(moment_about_y(slender, moment)));
  const fem::FaceMotion motion = body.face_motion(displacement);

  const double bending = slender.steel.young * pi * std::pow(slender.shaft_diameter, 4) / 64;
  const double rotation = moment * slender.shaft_length / bending;
  EXPECT_NEAR(-motion.tilt_y, rotation, 0.02 * rotation);  // u_z grows with x: tilt about -y
  EXPECT_NEAR(motion.tilt_x, 0, 1e-8 * rotation);
  EXPECT_NEAR(motion.axial, 0, 1e-8 * rotation * slender.plate_diameter);

  // The face swings by the shaft's deflection and the rigid plate's arm.
  const double arm = slender.shaft_length / 2 + slender.plate_thickness;
  const Vector3d centre = body.face_displacement(displacement, Vector3d::Zero());
  EXPECT_NEAR(std::abs(centre[0]), rotation * arm, 0.02 * rotation * arm);
}

// Bar: F L / (E A). The plate's and the hub's own shortening adds about what the plate has as a
// block (2 %) and the clamp takes a little; 4 % covers both.
TEST(shaft, shortens_as_a_bar_under_a_central_load) {
  const fem::ElasticBody body(slender, {});
  const double force = 1000;  // [N]
  const double face = pi * std::pow(slender.plate_diameter, 2) / 4;
  const Eigen::VectorXd displacement =
      body.solve(body.face_load([&](const Vector3d&) { return Vector3d(0, 0, force / face); }));
  const double section = pi * std::pow(slender.shaft_diameter, 2) / 4;
  const double shortening = force * slender.shaft_length / (slender.steel.young * section);
  EXPECT_NEAR(body.face_motion(displacement).axial, shortening, 0.04 * shortening);
}

// The hub on which the plate is clamped yields as well, by a slope that goes with M / (E t^2), so
// by a share of the plate's own deflection that goes with t / (a - b): a quarter to a third at t =
// 10 mm. Two thin plates tell this share, and what is left without it must be plate theory. 2 %:
// the mesh's 1 % and the share's own curvature in t.
TEST(plate, bends_as_an_annular_plate_once_the_hub_is_taken_away) {
  const auto excess = [](double thickness) {
    const fem::Head head{.plate_diameter = 0.1495,
                         .plate_thickness = thickness,
                         .shaft_diameter = 0.050,
                         .shaft_length = 0.1,
                         .steel = {}};
    const double pressure = 600e3;  // [Pa]
    const fem::ElasticBody body(head, {});
    const Eigen::VectorXd displacement =
        body.solve(body.face_load([&](const Vector3d&) { return Vector3d(0, 0, pressure); }));
    const double rim = body.face_displacement(displacement, Vector3d(0.07475, 0, 0))(2);
    const double hub = body.face_displacement(displacement, Vector3d(0.025, 0, 0))(2);
    return (rim - hub) / apps::rim_deflection(head, pressure) - 1;
  };
  const double thinner = excess(0.003), thicker = excess(0.006);
  EXPECT_GT(thinner, 0);
  EXPECT_LT(thicker, 0.3);
  EXPECT_NEAR(2 * thinner - thicker, 0, 0.02);
}

}  // namespace

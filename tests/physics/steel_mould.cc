// The mould under pressure: Lame's cylinder, the ring that goes oval, and the shell's edge.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "apps/stress_theory.h"
#include "fem/elastic_body.h"

namespace {

using Eigen::Vector3d;

constexpr double pressure = 300e3;  // [Pa]

fem::Mould mould_of_wall(double wall_thickness, fem::BaseSupport base) {
  return {.inner_diameter = 0.15,
          .wall_thickness = wall_thickness,
          .height = 0.25,
          .base = base,
          .steel = {}};
}

Vector3d outwards(const Vector3d& x) {
  return Vector3d(x[0], x[1], 0).normalized();
}

fem::ElasticBody::Traction uniform_pressure() {
  return [](const Vector3d& x) -> Vector3d { return pressure * outwards(x); };
}

// Hoop stress [Pa] averaged over the nodes of one radius [m] near mid-height.
double mean_hoop_stress(const fem::ElasticBody& body, const fem::StressField& stress, double radius,
                        double height) {
  double sum = 0;
  int count = 0;
  for (Eigen::Index i = 0; i < body.nodes().cols(); ++i) {
    const Vector3d x = body.nodes().col(i);
    if (std::abs(std::hypot(x[0], x[1]) - radius) > 1e-5) continue;
    if (std::abs(x[2] - height / 2) > 0.1 * height) continue;
    const double c = x[0] / radius, s = x[1] / radius;
    sum += s * s * stress(0, i) + c * c * stress(1, i) - 2 * s * c * stress(5, i);
    ++count;
  }
  return sum / count;
}

class LameCylinder : public testing::TestWithParam<double> {
 protected:
  static void is_met(const fem::Mould& mould);
};

// Lame (1852), plane stress (ends free): Timoshenko & Goodier (1970), 28.
// 1 % is what the default mesh promises; the displacement is right to 4e-5.
void LameCylinder::is_met(const fem::Mould& mould) {
  const fem::ElasticBody body(mould, {});
  const auto displacement = Eigen::VectorXd(body.solve(body.face_load(uniform_pressure())));

  const double a = mould.inner_diameter / 2, b = a + mould.wall_thickness;
  const double ratio = (b * b + a * a) / (b * b - a * a);
  const double growth = pressure * a / mould.steel.young * (ratio + mould.steel.poisson);
  for (const double angle : {0.0, 0.3, 1.7, 4.0}) {
    const Vector3d place(a * std::cos(angle), a * std::sin(angle), mould.height / 2);
    const Vector3d moved = body.face_displacement(displacement, place);
    EXPECT_NEAR(moved.dot(outwards(place)), growth, 0.01 * growth);
  }
  const fem::StressField stress = body.stress(displacement);
  const double inside = pressure * ratio;
  const double outside = pressure * (ratio - 1);
  EXPECT_NEAR(mean_hoop_stress(body, stress, a, mould.height), inside, 0.01 * inside);
  EXPECT_NEAR(mean_hoop_stress(body, stress, b, mould.height), outside, 0.01 * outside);
}

TEST_P(LameCylinder, grows_and_is_stressed_as_lame_says) {
  is_met(mould_of_wall(GetParam(), fem::BaseSupport::guided));
}

// Nearly incompressible: stresses multiply what the strains change the volume by mistake by fifty.
TEST_P(LameCylinder, of_rubber_grows_and_is_stressed_as_lame_says) {
  fem::Mould mould = mould_of_wall(GetParam(), fem::BaseSupport::guided);
  mould.steel.poisson = 0.49;
  is_met(mould);
}

INSTANTIATE_TEST_SUITE_P(walls, LameCylinder,
                         testing::Values(0.0005, 0.005, 0.0075, 0.0125, 0.03, 0.075));

// cos(n theta) component of the radial displacement [m] at a height, by sums over the circle.
double harmonic(const fem::ElasticBody& body, const Eigen::VectorXd& displacement,
                const fem::Mould& mould, int n, double height) {
  const int samples = 48;  // exact up to n = 47
  double sum = 0;
  for (int k = 0; k < samples; ++k) {
    const double angle = 2 * std::numbers::pi * k / samples;
    const Vector3d out(std::cos(angle), std::sin(angle), 0);
    const Vector3d place = mould.inner_diameter / 2 * out + Vector3d(0, 0, height);
    const Vector3d moved = body.face_displacement(displacement, place);
    sum += 2.0 / samples * std::cos(n * angle) * moved.dot(out);
  }
  return sum;
}

// A long guided cylinder is in plane strain away from its free edge. 1 % is what the default mesh
// promises; elements that lock miss it by far (fully integrated ones of this size by 5 %).
TEST(ovalling, is_as_large_as_michell_says) {
  auto mould = mould_of_wall(0.0075, fem::BaseSupport::guided);
  mould.height = 1.0;
  const fem::ElasticBody body(mould, {});
  for (const int n : {2, 3}) {
    const double amplitude = 10e3;  // [Pa]
    const Eigen::VectorXd displacement =
        body.solve(body.face_load([&](const Vector3d& x) -> Vector3d {
          return amplitude * std::cos(n * std::atan2(x[1], x[0])) * outwards(x);
        }));
    const double exact = apps::michell_amplitude(mould, n, amplitude);
    EXPECT_NEAR(harmonic(body, displacement, mould, n, 0.5), exact, 0.01 * exact) << "n = " << n;
  }
}

// The thin ring itself, w = p R^4 / (D (n^2 - 1)^2), D = E t^3 / (12 (1 - nu^2)), R the middle
// radius and p a / R the load carried to it: Timoshenko & Woinowsky-Krieger (1959), 15. For t / a =
// 2 / 75 the ring leaves out hoop stretch and shear of order n^2 (t / R)^2 < 1 %; 2 % with the
// mesh's own 1 %.
TEST(ovalling, of_a_thin_wall_follows_the_ring_formula) {
  auto mould = mould_of_wall(0.002, fem::BaseSupport::guided);
  mould.height = 0.6;
  const fem::ElasticBody body(mould, {});
  const double a = mould.inner_diameter / 2, middle = a + mould.wall_thickness / 2;
  const double nu = mould.steel.poisson;
  const double bending =
      mould.steel.young * std::pow(mould.wall_thickness, 3) / (12 * (1 - nu * nu));  // [N m]
  for (const int n : {2, 3}) {
    const double amplitude = 10e3;  // [Pa]
    const Eigen::VectorXd displacement =
        body.solve(body.face_load([&](const Vector3d& x) -> Vector3d {
          return amplitude * std::cos(n * std::atan2(x[1], x[0])) * outwards(x);
        }));
    const double ring =
        amplitude * a / middle * std::pow(middle, 4) / (bending * std::pow(n * n - 1, 2));
    EXPECT_NEAR(harmonic(body, displacement, mould, n, 0.3), ring, 0.02 * ring) << "n = " << n;
  }
}

// Long shell clamped at its base under uniform pressure: w = w0 (1 - exp(-z')(cos z' + sin z'))
// with z' = beta z; Timoshenko & Woinowsky-Krieger (1959), 114-115. Shell theory of the middle
// surface errs by t / R = 10 % of w0 here at most; 5 % of w0 is met because w0 is Lame's.
TEST(mould_base, holds_the_shell_over_its_decay_length) {
  const auto mould = mould_of_wall(0.0075, fem::BaseSupport::clamped);
  const fem::ElasticBody body(mould, {});
  const Eigen::VectorXd displacement = body.solve(body.face_load(uniform_pressure()));
  const double a = mould.inner_diameter / 2, b = a + mould.wall_thickness, middle = (a + b) / 2;
  const double nu = mould.steel.poisson;
  const double free_growth =
      pressure * a / mould.steel.young * ((b * b + a * a) / (b * b - a * a) + nu);
  const double beta = std::pow(3 * (1 - nu * nu), 0.25) / std::sqrt(middle * mould.wall_thickness);
  for (const double z : {0.01, 0.02, 0.03, 0.05, 0.08, 0.12}) {
    const double decayed = std::exp(-beta * z) * (std::cos(beta * z) + std::sin(beta * z));
    const Vector3d moved = body.face_displacement(displacement, Vector3d(a, 0, z));
    EXPECT_NEAR(moved[0], free_growth * (1 - decayed), 0.05 * free_growth) << "z = " << z;
  }
}

}  // namespace

// The reduced body against the full one.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "fem/assembly.h"
#include "fem/elastic_body.h"
#include "fem/elements.h"
#include "fem/loaded_face.h"

namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr fem::Head head{.plate_diameter = 0.1,
                         .plate_thickness = 0.02,
                         .shaft_diameter = 0.04,
                         .shaft_length = 0.1,
                         .steel = {}};
constexpr fem::Mould mould{.inner_diameter = 0.1,
                           .wall_thickness = 0.0075,
                           .height = 0.12,
                           .base = fem::BaseSupport::clamped,
                           .steel = {}};

Vector3d uneven(const Vector3d& x) {
  return {1e5 * x[1] / 0.05, 0, 6e5 * (1 + x[0] / 0.05)};
}

const Eigen::Matrix3Xd three_points = [] {
  Eigen::Matrix3Xd points(3, 3);
  points << 0.05, 0, -0.02, 0, 0.05, -0.01, 0, 0, 0;
  return points;
}();

// Sum of the modes' static answers, displacement of the whole body [m].
VectorXd modal_answer(const fem::ReducedBody& modes, const VectorXd& load) {
  return modes.full_shape * (modes.full_shape.transpose() * load).cwiseQuotient(modes.stiffness);
}

// Galerkin: the modes' answer is the best in energy, so its compliance grows with every mode,
// towards that of the full body; what is missing is bounded by the first compliance left out, load
// . (u - u_modes) <= s_left_out |traction|^2.
TEST(modes, answer_a_static_load_ever_better) {
  const fem::ElasticBody body(head, {});
  const VectorXd load = body.face_load(uneven);
  const VectorXd full = body.solve(load);
  double previous = INFINITY;
  for (const int count : {2, 4, 8, 16, 32}) {
    const fem::ReducedBody modes = body.reduce(count, three_points);
    const double missing = 1 - load.dot(modal_answer(modes, load)) / load.dot(full);
    EXPECT_LT(missing, previous) << count;
    EXPECT_GT(missing, 0) << count;
    // int |t|^2 dA of `uneven` over a disc of radius 50 mm.
    const double area = M_PI * 0.05 * 0.05;
    const double squared_traction = (0.25 * 1e10 + 1.25 * 36e10) * area;
    EXPECT_LT(missing * load.dot(full), modes.compliance[count] * squared_traction * 1.001)
        << count;
    previous = missing;
  }
  EXPECT_LT(previous, 1e-4);
}

// The largest compliance that the modes lack, over all tractions, is the first eigenvalue left out:
// power iteration on (C - C_modes) M of the loaded face. 2 %: what iteration leaves where the next
// eigenvalues are close.
TEST(modes, lack_as_much_as_the_first_eigenvalue_left_out) {
  const fem::ElasticBody body(head, {});
  for (const int count : {4, 10, 20}) {
    const fem::ReducedBody modes = body.reduce(count, three_points);
    const fem::Elements elements = fem::make_elements(head, {});
    const fem::LoadedFace face(elements.face);
    const auto unknowns = static_cast<Eigen::Index>(body.unknowns());
    Eigen::Matrix3Xd traction(3, face.nodes().size());
    for (Eigen::Index i = 0; i < traction.cols(); ++i)
      traction.col(i) << std::sin(1.0 + 3 * i), std::cos(2.0 + 5 * i), std::sin(3.0 + 7 * i);
    double lacking = 0;
    for (int turn = 0; turn < 60; ++turn) {
      const Eigen::Matrix3Xd forces = traction * face.mass();
      traction /= std::sqrt(forces.cwiseProduct(traction).sum());
      const VectorXd load = face.on_body(traction * face.mass(), unknowns);
      const VectorXd missing = body.solve(load).col(0) - modal_answer(modes, load);
      lacking = load.dot(missing);
      traction = face.of_body(missing);
    }
    EXPECT_NEAR(lacking, modes.compliance[count], 0.02 * modes.compliance[count]) << count;
  }
}

// Rayleigh-Ritz: modes are orthogonal in stiffness and in mass. 1e-8 is the precision of the modes.
TEST(modes, are_oscillators_of_their_own) {
  const int count = 20;
  const fem::ElasticBody body(head, {});
  const fem::ReducedBody modes = body.reduce(count, three_points);
  const fem::Elements elements = fem::make_elements(head, {});
  const auto stiffness = fem::assemble_stiffness(elements, head.steel);
  const auto mass = fem::assemble_mass(elements, head.steel);

  const MatrixXd shape = modes.full_shape;
  const MatrixXd k = shape.transpose() * (stiffness.selfadjointView<Eigen::Lower>() * shape);
  MatrixXd m = MatrixXd::Zero(count, count);
  for (int direction = 0; direction < 3; ++direction) {
    const MatrixXd part = shape(Eigen::seqN(direction, shape.rows() / 3, 3), Eigen::all);
    m += part.transpose() * (mass.selfadjointView<Eigen::Lower>() * part);
  }
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      const double kij = i == j ? modes.stiffness[i] : 0, mij = i == j ? modes.mass[i] : 0;
      EXPECT_NEAR(k(i, j), kij, 1e-8 * std::sqrt(modes.stiffness[i] * modes.stiffness[j]));
      EXPECT_NEAR(m(i, j), mij, 1e-8 * std::sqrt(modes.mass[i] * modes.mass[j]));
    }
}

// Equal bodies, equal bits: nothing in the modes depends on chance.
TEST(modes, repeat_bit_by_bit) {
  const auto shape = [] {
    return fem::ElasticBody(head, {.degree = 1}).reduce(12, three_points).full_shape;
  };
  EXPECT_EQ(shape(), shape());
}

// A round body has pairs of modes; the first of a pair moves the point on +x, the second mirrors
// it.
TEST(modes, of_a_pair_share_their_stiffness_and_lie_on_the_axes) {
  const fem::ReducedBody modes = fem::ElasticBody(head, {}).reduce(2, three_points);
  EXPECT_NEAR(modes.stiffness[1] / modes.stiffness[0], 1, 1e-8);
  const double tilt = modes.shape(2, 0);  // axial, at x = radius
  EXPECT_GT(std::abs(tilt), 0.1);
  EXPECT_NEAR(modes.shape(2, 1), 0, 1e-8);
  EXPECT_NEAR(std::abs(modes.shape(5, 1)), std::abs(tilt), 1e-8);  // axial, at y = radius
}

// Modes asked for by tolerance leave out no more than it, and not one mode fewer would do.
TEST(modes, are_as_few_as_the_tolerance_allows) {
  const double tolerance = 0.05;
  const fem::ReducedBody modes = fem::ElasticBody(mould, {}).reduce(tolerance, {});
  const auto count = modes.stiffness.size();
  EXPECT_LT(modes.truncation_error, tolerance);
  EXPECT_GE(modes.compliance[count - 1], tolerance * modes.compliance[0]);
  EXPECT_EQ(modes.compliance.size(), count + 1);
}

// The mass of a disc and a cylinder; twelve quadratic arcs hold 1.6e-4 less than the circle's area.
TEST(mass, is_density_times_volume) {
  const double plate = M_PI / 4 * 0.1 * 0.1 * 0.02, shaft = M_PI / 4 * 0.04 * 0.04 * 0.1;
  const double exact = head.steel.density * (plate + shaft);
  const fem::ElasticBody body(head, {});
  EXPECT_NEAR(body.mass(), exact, 2e-4 * exact);
  EXPECT_NEAR(body.reduce(2, three_points).body_mass, body.mass(), 1e-10 * exact);
}

TEST(modes, refuse_a_count_that_the_face_does_not_have) {
  const fem::ElasticBody body(mould, {.degree = 1});
  EXPECT_THROW(body.reduce(0, three_points), std::invalid_argument);
  EXPECT_THROW(body.reduce(1000000, three_points), std::invalid_argument);
  EXPECT_THROW(body.reduce(0.0, three_points), std::invalid_argument);
}

}  // namespace

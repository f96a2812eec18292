// The loaded face: its area, its moments, and finding the nearest place on it.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/elements.h"
#include "fem/loaded_face.h"

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr fem::Head head{.plate_diameter = 0.1,
                         .plate_thickness = 0.02,
                         .shaft_diameter = 0.04,
                         .shaft_length = 0.1,
                         .steel = {}};
constexpr fem::Mould mould{.inner_diameter = 0.15,
                           .wall_thickness = 0.0075,
                           .height = 0.2,
                           .base = fem::BaseSupport::clamped,
                           .steel = {}};

fem::LoadedFace face_of(const auto& body, int degree) {
  return fem::LoadedFace(fem::make_elements(body, {.degree = degree}).face);
}

class Face : public testing::TestWithParam<int> {};  // degree of the displacement
INSTANTIATE_TEST_SUITE_P(polynomials, Face, testing::Values(1, 2));

// Area of a disc and of a cylinder. Quadratic arcs of 30 and 15 degrees hold 1.6e-4 of the disc's
// area and 5e-6 of the cylinder's too little.
TEST_P(Face, has_the_area_of_its_circle) {
  const double disc = M_PI * 0.05 * 0.05, cylinder = M_PI * 0.15 * 0.2;
  EXPECT_NEAR(face_of(head, GetParam()).area(), disc, 2e-4 * disc);
  EXPECT_NEAR(face_of(mould, GetParam()).area(), cylinder, 1e-5 * cylinder);
}

// A uniform pressure has the resultant p A, and p z has its centre of pressure two thirds up.
TEST_P(Face, carries_a_traction_with_its_resultant_and_moment) {
  const auto face = face_of(mould, GetParam());
  const Matrix3Xd force = face.load([](const Vector3d& x) { return Vector3d(0, 0, x[2]); });
  const double resultant = face.area() * 0.1;
  EXPECT_NEAR(force.row(2).sum(), resultant, 1e-12 * resultant);
  const double height = force.row(2).dot(face.places().row(2)) / force.row(2).sum();
  // A degree that holds z exactly holds its moment exactly.
  EXPECT_NEAR(height, 2.0 / 3 * 0.2, 1e-12);
}

// Interpolation weights sum to one and give back the nodes themselves.
TEST_P(Face, interpolates_its_own_nodes) {
  const auto face = face_of(mould, GetParam());
  const Matrix3Xd found = face.places() * face.interpolation(face.places());
  EXPECT_LT((found - face.places()).cwiseAbs().maxCoeff(), 1e-12);
}

// Points on the exact circle, off the surface by the quadratic arc's error (7e-6 of the radius for
// 15 degrees), and a little beyond the rim, are taken to the nearest place.
TEST(nearest_place, is_found_for_points_on_and_about_the_mould) {
  const auto face = face_of(mould, 2);
  Matrix3Xd points(3, 200);
  for (int i = 0; i < 200; ++i) {
    const double angle = 0.7 * i;
    points.col(i) << 0.075 * std::cos(angle), 0.075 * std::sin(angle), 0.2 * i / 199.0;
  }
  points(2, 0) = -1e-7;  // below the base
  const Matrix3Xd found = face.places() * face.interpolation(points);
  EXPECT_LT((found - points).colwise().norm().maxCoeff(), 1e-5 * 0.075);
}

TEST(nearest_place, is_on_the_rim_for_points_beyond_it) {
  const auto face = face_of(head, 2);
  Matrix3Xd points(3, 2);
  points << 0.0501, 0.2, 0, 0, 0, 0.03;
  const Matrix3Xd found = face.places() * face.interpolation(points);
  EXPECT_NEAR(found(0, 0), 0.05, 1e-9);
  EXPECT_NEAR(found(0, 1), 0.05, 1e-9);
  EXPECT_NEAR(found.row(2).cwiseAbs().maxCoeff(), 0, 1e-12);
}

}  // namespace

// Laws that every elastic body keeps, whatever its mesh.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "fem/assembly.h"
#include "fem/elastic_body.h"
#include "fem/elements.h"

namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr fem::Head head{.plate_diameter = 0.1,
                         .plate_thickness = 0.02,
                         .shaft_diameter = 0.04,
                         .shaft_length = 0.1,
                         .steel = {}};
constexpr fem::Mould guided{.inner_diameter = 0.1,
                            .wall_thickness = 0.0075,
                            .height = 0.1,
                            .base = fem::BaseSupport::guided,
                            .steel = {}};

VectorXd field(const fem::ElasticBody& body, const Eigen::Matrix3d& gradient) {
  return (gradient * body.nodes()).reshaped();
}

// Patch test (Irons 1965): a linear displacement has a constant stress, exactly but for rounding.
// (Displacements of degree 1 on round elements of degree 2 do not hold linear fields.)
TEST(patch, of_linear_displacement_has_constant_stress) {
  const fem::ElasticBody body(guided, {});
  Eigen::Matrix3d gradient;
  gradient << 1e-4, 2e-5, -3e-5, 4e-5, -2e-4, 1e-5, 6e-5, -1e-5, 3e-4;
  const auto stress = body.stress(field(body, gradient));
  const double shear = 210e9 / 2.6, lame = 2 * shear * 0.3 / 0.4;  // [Pa]
  const Eigen::Matrix3d strain = (gradient + gradient.transpose()) / 2;
  const Eigen::Matrix3d exact =
      2 * shear * strain + lame * strain.trace() * Eigen::Matrix3d::Identity();
  Eigen::Matrix<double, 6, 1> voigt;
  voigt << exact(0, 0), exact(1, 1), exact(2, 2), exact(1, 2), exact(2, 0), exact(0, 1);
  EXPECT_LT((stress.colwise() - voigt).cwiseAbs().maxCoeff(), 1e-10 * exact.norm());
}

// Uniaxial tension of the guided cylinder: the solver returns the constant-strain field whose nodal
// forces it is given. 1e-10 is rounding (1e-16) times the condition of the stiffness (1e5).
TEST(guided_cylinder, stretches_uniformly_under_the_forces_of_a_uniform_stretch) {
  const fem::ElasticBody body(guided, {});
  Eigen::Matrix3d stretch = Eigen::Matrix3d::Zero();
  stretch.diagonal() << -0.3e-4, -0.3e-4, 1e-4;
  const VectorXd exact = field(body, stretch);
  const auto stiffness = fem::assemble_stiffness(fem::make_elements(guided, {}), guided.steel);
  const VectorXd load = stiffness.selfadjointView<Eigen::Lower>() * exact;
  EXPECT_LT((body.solve(load) - exact).cwiseAbs().maxCoeff(), 1e-10 * exact.cwiseAbs().maxCoeff());
}

// A body moved or turned as a whole is not strained: its stiffness answers with no force.
TEST(stiffness, does_not_feel_rigid_motions) {
  const fem::Elements elements = fem::make_elements(head, {});
  const auto stiffness = fem::assemble_stiffness(elements, head.steel);
  for (int i = 0; i < 6; ++i) {
    const Vector3d axis = Vector3d::Unit(i % 3);
    const Eigen::Matrix3Xd moved = i < 3
                                       ? Eigen::Matrix3Xd(axis.replicate(1, elements.nodes.cols()))
                                       : Eigen::Matrix3Xd(elements.nodes.colwise().cross(-axis));
    const VectorXd motion = moved.reshaped();
    const VectorXd force = stiffness.selfadjointView<Eigen::Lower>() * motion;
    const double scale = stiffness.diagonal().maxCoeff() * motion.cwiseAbs().maxCoeff();
    EXPECT_LT(force.cwiseAbs().maxCoeff(), 1e-13 * scale) << "motion " << i;
  }
}

// Newton: the supports answer the load, force and moment, to rounding.
TEST(supports, answer_the_load) {
  const fem::ElasticBody body(head, {});
  const VectorXd load = body.face_load([](const Vector3d& x) -> Vector3d {
    return {1e5, -2e5, 6e5 + 1e7 * x[0]};
  }) + body.point_load({0.03, 0.01, 0}, {10, 20, 500});
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
  for (Eigen::Index i = 0; i < body.nodes().cols(); ++i) {
    force += load.segment<3>(3 * i);
    moment += body.nodes().col(i).cross(load.segment<3>(3 * i));
  }
  const auto reaction = body.reaction(body.solve(load), load);
  EXPECT_LT((reaction.head<3>() + force).norm(), 1e-10 * force.norm());
  EXPECT_LT((reaction.tail<3>() + moment).norm(), 1e-10 * moment.norm());
}

// Maxwell (1864), Betti (1872): the face's compliance is symmetric; it is positive by Clapeyron.
TEST(compliance, is_symmetric_and_positive) {
  const fem::ElasticBody body(head, {});
  const int cases = 12;
  MatrixXd loads(body.unknowns(), cases);
  for (int i = 0; i < cases; ++i) {
    const double angle = 2.4 * i, radius = 0.05 * std::sqrt((i + 0.5) / cases);
    loads.col(i) = body.point_load({radius * std::cos(angle), radius * std::sin(angle), 0},
                                   Vector3d::Unit(i % 3));
  }
  const MatrixXd compliance = loads.transpose() * body.solve(loads);
  EXPECT_LT((compliance - compliance.transpose()).norm(), 1e-10 * compliance.norm());
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<MatrixXd>(compliance).eigenvalues().minCoeff(), 0);
}

// Loads are the transpose of displacements: a point force does the work that the point's
// displacement says, to rounding.
TEST(point_load, does_the_work_of_its_point) {
  const fem::ElasticBody body(head, {});
  const VectorXd displacement =
      body.solve(body.face_load([](const Vector3d& x) { return Vector3d(0, x[1], 6e5); }));
  const Vector3d point(0.021, -0.013, 0), force(3, -2, 7);
  const double work = body.point_load(point, force).dot(displacement);
  EXPECT_NEAR(work, force.dot(body.face_displacement(displacement, point).col(0)),
              1e-12 * std::abs(work));
}

// A cell mesh fills the body: the volume of its cells is the body's, less the 1.1 % that 24 chords
// cut off a circle (sin(15 deg) / (15 deg)).
TEST(cells, fill_the_body_and_point_outwards) {
  const fem::ElasticBody body(head, {});
  const fem::CellMesh& cells = body.cells();
  double volume = 0;
  for (std::size_t c = 0; c < cells.hexahedra.size(); c += 8) {
    const auto at = [&](int corner) -> Vector3d {
      return cells.points.col(cells.hexahedra[c + corner]);
    };
    // Five tetrahedra of a VTK hexahedron.
    constexpr int tetrahedra[5][4] = {
        {0, 1, 2, 5}, {0, 2, 3, 7}, {0, 5, 7, 4}, {2, 7, 5, 6}, {0, 2, 7, 5}};
    for (const auto& t : tetrahedra) {
      const double part =
          (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).dot(at(t[3]) - at(t[0])) / 6;
      EXPECT_GT(part, 0);
      volume += part;
    }
  }
  EXPECT_NEAR(volume, body.mass() / head.steel.density, 0.012 * volume);
  for (std::size_t i = 0; i < cells.node.size(); ++i)
    ASSERT_EQ(Vector3d(cells.points.col(i)), Vector3d(body.nodes().col(cells.node[i])));
}

TEST(body, refuses_lengths_that_do_not_describe_it) {
  fem::Head wide_shaft = head;
  wide_shaft.shaft_diameter = head.plate_diameter;
  EXPECT_THROW(fem::ElasticBody(wide_shaft, {}), std::invalid_argument);
  fem::Mould no_wall = guided;
  no_wall.wall_thickness = 0;
  EXPECT_THROW(fem::ElasticBody(no_wall, {}), std::invalid_argument);
  EXPECT_THROW(fem::ElasticBody(guided, {.degree = 3}), std::invalid_argument);
}

}  // namespace

// What a run tells of its walls: signs, virtual gauges, and both sides of the letterbox.
#include <gtest/gtest.h>

#include "apps/steel_answers.h"
#include "apps/wall_outputs.h"
#include "tests/physics/coupling_bench.h"

namespace {

using bench::Stone;

apps::GyratoryScene rigid_scene() {
  apps::GyratoryScene scene;
  scene.mould.diameter = 0.1;
  return scene;
}

constexpr apps::Machine machine{0.05, 0.0499, 0.00785};

// Newton: a stone at rest presses on the floor with its weight, downwards; normal traction is
// positive where a wall is pressed on. 1e-3 is what is left of the stone's motion.
TEST(wall_outputs, of_one_resting_stone_are_its_weight_pressing_down) {
  const Stone stone;
  dem::Wall floor, ring, plate;
  floor.surface = dem::Plane{};
  ring.surface = dem::CylinderInside{machine.mould_radius};
  plate.surface = dem::Disc{machine.plate_radius};
  plate.frame.origin = {0, 0, 0.1};
  plate.frame.ez = {0, 0, 1};
  auto bed = bench::above(floor, stone);
  const auto law = bed.pairs().law;
  bed.add_wall(ring, law);
  bed.add_wall(plate, law);
  bed.set_drag(0.05 / bed.time_step() / 20);
  apps::WallOutputs outputs(rigid_scene(), machine);
  outputs.begin(bed.walls(), nullptr);
  for (int step = 0; step < 40000; ++step) {
    bed.step();
    if (step == 20000) outputs.row();
    outputs.look(bed.walls(), bed.time_step(), 0.1, [](int) { return 0.0; });
  }
  const std::vector<apps::Column> columns = apps::WallOutputs::columns(rigid_scene());
  const std::vector<double> row = outputs.row();
  ASSERT_EQ(row.size(), columns.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string& name = columns[i].name;
    const double expected = name == "floor_force"      ? -stone.load
                            : name == "floor_traction" ? stone.load / machine.section
                                                       : 0;
    EXPECT_NEAR(row[i], expected, 1e-3 * std::abs(expected) + 1e-9) << name;
  }
}

constexpr fem::Mould mould{.inner_diameter = 0.1,
                           .wall_thickness = 0.0075,
                           .height = 0.12,
                           .base = fem::BaseSupport::clamped,
                           .steel = {}};

// Lame (1852): pressure p on the whole letterbox strains the outside by p 2 a^2 / (b^2 - a^2) / E
// around, far from the clamped base. 2 %: forces stand on nodes of the letterbox, the default mesh
// is right to 1 %.
TEST(gauge, reads_lames_hoop_strain_under_uniform_pressure) {
  const fem::ElasticBody body(mould, {});
  const double a = mould.inner_diameter / 2, b = a + mould.wall_thickness, pressure = 300e3;
  dem::SurfaceField field(dem::CylinderGrid{a, mould.height, 24, 48});
  const double exact = pressure * 2 * a * a / (b * b - a * a) / mould.steel.young;
  for (const double angle : {0.0, 1.0, -2.5}) {
    const apps::GaugeScene gauge{angle, 0.07, 0.01};
    const Eigen::Matrix3Xd influence = apps::gauge_influence(body, field, gauge, b);
    double strain = 0;
    for (std::size_t n = 0; n < field.size(); ++n) {
      const dem::Vec3d& x = field.node[n];
      strain += influence.col(static_cast<Eigen::Index>(n))
                    .dot(pressure * field.area[n] / a * Eigen::Vector3d(x.x, x.y, 0));
    }
    EXPECT_NEAR(strain, exact, 0.02 * exact) << angle;
  }
}

// Lame (1852): pressure p on the whole inner face stretches it by p (b^2 + a^2) / (b^2 - a^2), far
// from the ends; a base that slides leaves out the bending of a clamped one. 2 %: the letterbox is
// as coarse as in a run, the default mesh is right to 1 %.
TEST(hoop_stress, of_a_mould_under_uniform_pressure_is_lames) {
  fem::Mould sliding = mould;
  sliding.base = fem::BaseSupport::guided;
  const fem::ElasticBody body(sliding, {});
  const double a = mould.inner_diameter / 2, b = a + mould.wall_thickness, pressure = 300e3;
  const dem::SurfaceField field(dem::CylinderGrid{a, mould.height, 9, 24});
  Eigen::VectorXd forces(3 * static_cast<Eigen::Index>(field.size()));
  for (std::size_t n = 0; n < field.size(); ++n)
    forces.segment<3>(3 * static_cast<Eigen::Index>(n))
        << pressure * field.area[n] / a * field.node[n].x,
        pressure * field.area[n] / a * field.node[n].y, 0;
  const std::vector<double> hoop = apps::hoop_stress_at_nodes(body, field, forces);
  const double exact = pressure * (b * b + a * a) / (b * b - a * a);
  for (std::size_t n = 0; n < field.size(); ++n)
    if (std::abs(field.node[n].z - 0.07) < 0.02) {
      EXPECT_NEAR(hoop[n], exact, 0.02 * exact) << n;
    }
}

// Near a clamped base stress bends by half of itself within a row of the map; the rows lie between
// the nodes of the mesh. Reference: nodes of a mesh whose elements end at the rows. 3 %: two
// default meshes, each right to 1 % away from the clamp, and a letterbox that tapers over a row.
TEST(hoop_stress, near_a_clamped_base_is_that_at_the_height_it_is_told_for) {
  const fem::Mould clamped = {0.15, 7.5e-3, 0.25, fem::BaseSupport::clamped, {}};
  constexpr int rows = 13, sectors = 24;  // as a run has them
  const double a = clamped.inner_diameter / 2, pressure = 300e3;
  const dem::SurfaceField field(dem::CylinderGrid{a, clamped.height, rows, sectors});
  Eigen::VectorXd forces(3 * static_cast<Eigen::Index>(field.size()));
  for (std::size_t n = 0; n < field.size(); ++n)
    forces.segment<3>(3 * static_cast<Eigen::Index>(n))
        << pressure * field.area[n] / a * field.node[n].x,
        pressure * field.area[n] / a * field.node[n].y, 0;
  const std::vector<double> hoop =
      apps::hoop_stress_at_nodes(fem::ElasticBody(clamped, {}), field, forces);

  fem::MeshSize at_rows;
  for (int row = 1; row < rows; ++row) at_rows.levels.push_back(clamped.height * row / rows);
  const fem::ElasticBody body(clamped, at_rows);
  const Eigen::VectorXd exact = apps::hoop_stress(
      body, body.solve(body.face_load([&](const Eigen::Vector3d& x) -> Eigen::Vector3d {
        return pressure * Eigen::Vector3d(x.x(), x.y(), 0).normalized();
      })));
  for (int row = 1; row <= 4; ++row) {
    const dem::Vec3d& x = field.node[row * sectors];
    Eigen::Index node;
    ASSERT_LT(
        (body.nodes().colwise() - Eigen::Vector3d(x.x, x.y, x.z)).colwise().norm().minCoeff(&node),
        1e-9);
    EXPECT_NEAR(hoop[row * sectors], exact[node], 0.03 * exact[node]) << x.z;
  }
}

// Maxwell (1864): the influence of a force is the strain that this force makes. 1e-8 is the
// precision of the solver times the difference of two close displacements.
TEST(gauge, reads_what_the_full_body_says_of_a_single_force) {
  const fem::ElasticBody body(mould, {});
  const double b = 0.0575;
  const dem::SurfaceField field(dem::CylinderGrid{0.05, mould.height, 6, 12});
  const apps::GaugeScene gauge{0.4, 0.05, 0.01};
  const Eigen::Matrix3Xd influence = apps::gauge_influence(body, field, gauge, b);
  const Eigen::Index n = 3 * 12 + 2;
  const Eigen::Vector3d force(300, -200, 100);
  const dem::Vec3d& x = field.node[n];
  const Eigen::VectorXd moved = body.solve(body.point_load({x.x, x.y, x.z}, force)).col(0);
  const double half = 0.5 * gauge.length / b;
  const auto place = [&](double angle) {
    return Eigen::Vector3d(b * std::cos(angle), b * std::sin(angle), gauge.height);
  };
  const double strain = body.gauge(place(0.4 - half), place(0.4 + half)).dot(moved);
  EXPECT_NEAR(influence.col(n).dot(force), strain, 1e-8 * std::abs(strain));
  EXPECT_GT(std::abs(strain), 1e-7);
}

// Between its nodes the letterbox is a polygon: of a motion exp(i m angle) around the axis it shows
// sinc^2(m pi / sectors), and of a ring that goes oval, whose harmonics are n + 1 and n - 1, the
// mean of these shares that the ring's shape weighs. Forces lose this share on their way to the
// nodes; displacements, read by the transpose, lose it again. The middle of a wall does not
// stretch, u_angle = -u_r / n; its sections stay straight, so that the inner face adds to that.
// 5e-3: a wall of 2 mm is sheared and stretched a little.
TEST(letterbox, of_a_mould_stiffens_its_ovalling_by_the_share_that_a_polygon_shows) {
  constexpr int sectors = 24, rows = 8, per_cell = 8;  // of the letterbox; points at which to load
  fem::Mould sliding = mould;
  sliding.base = fem::BaseSupport::guided;
  sliding.wall_thickness = 0.002;
  const fem::ElasticBody body(sliding, {});
  const double a = mould.inner_diameter / 2;
  const auto shown = [](int m) {
    const double x = m * std::numbers::pi / sectors;
    return std::pow(std::sin(x) / x, 2);
  };
  for (const int n : {2, 3, 4}) {
    const auto traction = [&](const Eigen::Vector3d& x) -> Eigen::Vector3d {
      return std::cos(n * std::atan2(x.y(), x.x())) * Eigen::Vector3d(x.x(), x.y(), 0) / a;
    };
    const Eigen::VectorXd spread = body.face_load(traction);
    const Eigen::VectorXd oval = body.solve(spread).col(0);

    dem::SurfaceField field(dem::CylinderGrid{a, mould.height, rows, sectors});
    const double share = 2 * std::numbers::pi * a * mould.height /
                         (per_cell * sectors * per_cell * rows);  // of a point [m2]
    for (int i = 0; i < per_cell * sectors; ++i)
      for (int k = 0; k < per_cell * rows; ++k) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / (per_cell * sectors);
        const Eigen::Vector3d x(a * std::cos(angle), a * std::sin(angle),
                                mould.height * (k + 0.5) / (per_cell * rows));
        const Eigen::Vector3d force = share * traction(x);
        field.add_impulse(field.stencil({x.x(), x.y(), x.z()}), {force.x(), force.y(), force.z()});
      }
    Eigen::VectorXd letters = Eigen::VectorXd::Zero(body.unknowns());
    for (std::size_t node = 0; node < field.size(); ++node) {
      const dem::Vec3d &x = field.node[node], &force = field.impulse[node];
      letters += body.point_load({x.x, x.y, x.z}, {force.x, force.y, force.z});
    }
    const double t = sliding.wall_thickness, lean = (1 + (n * n - 1) * t / (2 * a + t)) / n;
    const double of_ring = (1 - lean) / 2 * shown(n + 1) + (1 + lean) / 2 * shown(n - 1);
    EXPECT_NEAR(letters.dot(oval) / spread.dot(oval), of_ring, 5e-3) << n;
  }
}

// A stone that rolls on the inside of an elastic cylinder. Force and work pass the letterbox to
// rounding; the moment is off by at most the height of its chords, R (1 - cos(pi / sectors)), and
// the lever between the face and the contact point.
TEST(letterbox, of_a_cylinder_hands_on_force_and_work_and_bounds_the_moment) {
  constexpr int sectors = 24;
  const double radius = 0.05;
  Stone stone;
  dem::Wall wall;
  wall.surface = dem::CylinderInside{radius};
  wall.frame.ex = {0, 0, -1};
  wall.frame.ey = {0, 1, 0};
  wall.frame.ez = {1, 0, 0};
  wall.frame.origin = {0, 0, radius};
  wall.field.emplace(dem::CylinderGrid{radius, 0.12, 8, sectors});
  wall.motion = dem::Driven{{0.5, 1, 0}};
  dem::ParticleStore stones =
      dem::make_stones({{0.05, 0.004, stone.radius + 2e-4}}, {stone.radius}, {stone.density}, 1);
  const bench::Law law = {{stone.modulus, dem::damping_ratio(0.5)}, 0.8 * stone.modulus, 0.3};
  dem::Settings settings;
  settings.gravity = stone.load / stone.mass();
  settings.safety = 1;
  settings.largest_step = std::sqrt(stone.mass() / stone.stiffness()) / 20;
  settings.skin = 0.1 * stone.radius;
  dem::Simulation<bench::Law> bed(std::move(stones), law, settings);
  bed.add_wall(std::move(wall), law);
  dem::Wall& ring = bed.walls().front();
  const fem::ElasticBody body(fem::Mould{2 * radius, 0.002, 0.12, fem::BaseSupport::clamped, {}},
                              {});
  coupling::ElasticWall elastic(body.reduce(12, coupling::letterbox_points(ring)), ring,
                                {.interval = 5});
  double worked = 0;
  for (int step = 0; step < 3000; ++step) {
    bed.step();
    const double dt = bed.time_step();
    const dem::SurfaceField& field = *ring.field;
    dem::Vec3d force{}, moment{};
    double power = 0;
    for (std::size_t n = 0; n < field.size(); ++n) {
      const dem::Vec3d share = field.impulse[n] * (1 / dt);
      force += share;
      moment += cross(field.node[n], share);
      power += dot(share, field.velocity[n]);
    }
    const dem::Vec3d given = ring.frame.to_frame(ring.force);
    const double size = norm(given);
    EXPECT_LE(norm(force - given), 1e-12 * size);
    EXPECT_LE(std::abs(power - bed.wall_contacts(0).bending_power(ring)),
              1e-12 * size * field.fastest);
    const double lever =
        radius * (1 - std::cos(std::numbers::pi / sectors)) + 4 * stone.overlap() + 1e-4;
    EXPECT_LE(norm(moment - ring.frame.to_frame(ring.moment)), lever * size);
    worked = std::max(worked, std::abs(power));
    elastic.exchange(ring, {dt, dt});
  }
  EXPECT_GT(worked, 0);
}

}  // namespace

// A stone dropped on an elastic head whose steel is anything from rubber to nearly rigid, with any
// exchange interval and mass scale: the run must not gain energy.
#include <gtest/gtest.h>

#include "tests/physics/coupling_bench.h"

namespace {

using bench::Stone;

constexpr fem::Head head{.plate_diameter = 0.15,
                         .plate_thickness = 0.02,
                         .shaft_diameter = 0.05,
                         .shaft_length = 0.25,
                         .steel = {}};

// The head in steel; shapes and masses are those of any Young's modulus.
const fem::ElasticBody& steel_head() {
  static const fem::ElasticBody body(head, {.degree = 2});
  return body;
}
const fem::ReducedBody& steel_modes() {
  static const fem::ReducedBody modes =
      steel_head().reduce(20, coupling::letterbox_points(bench::plate()));
  return modes;
}

struct Setting {
  double young;       // [Pa]
  int interval;       // [steps]
  double mass_scale;  // [-]
};

// Makes the wall answer with more than its modes, given Young's modulus over steel's.
using Rest = void (*)(coupling::ElasticWall& elastic, const dem::Wall& wall, double softness);

// Energy: neither the stone (kinetic and potential) nor the strain of the modes ever holds more
// than the stone was dropped with; 2 % is room for the work of a plate that answers one exchange
// late.
void drop_a_stone(const Setting& setting, fem::ReducedBody modes, Rest rest) {
  const auto [young, interval, mass_scale] = setting;
  Stone stone;
  stone.mass_scale = mass_scale;
  stone.load = stone.mass() * bench::gravity;
  stone.x = 0.05;
  stone.height = 0.01;
  stone.modulus = 1e9;
  auto simulation = bench::above(bench::plate(), stone, 50);
  dem::Wall& wall = simulation.walls().front();
  modes.stiffness *= young / head.steel.young;
  coupling::ExchangeSettings settings;
  settings.interval = interval;
  settings.inertia_scale = mass_scale;
  coupling::ElasticWall elastic(modes, wall, settings);
  rest(elastic, wall, head.steel.young / young);
  const double dropped = stone.load * stone.height;  // [J]
  const double fall = std::sqrt(2 * stone.height * mass_scale / bench::gravity);
  double highest = 0, bounced = 0;
  bool touched = false;
  while (simulation.time() < 4 * fall) {
    simulation.step();
    elastic.exchange(wall, {simulation.last_step(), simulation.time_step()});
    touched = touched || wall.push > 0;
    const dem::Vec3d& v = simulation.stones().velocity[0];
    const double height = simulation.stones().position[0].z - stone.radius;
    const double energy = 0.5 * stone.mass() * mass_scale * dot(v, v) + stone.load * height;
    ASSERT_TRUE(std::isfinite(energy));
    highest = std::max(highest, energy);
    if (touched) bounced = std::max(bounced, height);
  }
  EXPECT_TRUE(touched);
  EXPECT_LE(highest, 1.02 * dropped);
  EXPECT_LT(bounced, stone.height);
  const double strain = 0.5 * elastic.amplitude().cwiseAbs2().dot(modes.stiffness);
  EXPECT_LE(strain, 1.02 * dropped);
}

class Extreme : public testing::TestWithParam<std::tuple<double, int, double>> {
 protected:
  static Setting setting() { return std::make_from_tuple<Setting>(GetParam()); }
};

TEST_P(Extreme, steel_never_feeds_a_dropped_stone) {
  drop_a_stone(setting(), steel_modes(), [](coupling::ElasticWall&, const dem::Wall&, double) {});
}

class ExtremeRest : public Extreme {};

// With two modes, the tilts, most of what yields follows statically, whatever its gain.
TEST_P(ExtremeRest, steel_that_follows_fully_never_feeds_a_dropped_stone) {
  static const Eigen::Matrix3Xd points = coupling::letterbox_points(bench::plate());
  static const fem::ReducedBody tilts = steel_head().reduce(2, points);
  static const Eigen::MatrixXd compliance = steel_head().face_compliance(points);
  drop_a_stone(setting(), tilts,
               [](coupling::ElasticWall& elastic, const dem::Wall& wall, double softness) {
                 elastic.follow_fully(softness * compliance, wall);
               });
}
INSTANTIATE_TEST_SUITE_P(sweep, ExtremeRest,
                         testing::Combine(testing::Values(1e6, 1e8, 210e9),
                                          testing::Values(20, 1000), testing::Values(1.0)));
INSTANTIATE_TEST_SUITE_P(sweep, Extreme,
                         testing::Combine(testing::Values(1e6, 1e8, 210e9, 1e14, 1e18),
                                          testing::Values(1, 20, 1000), testing::Values(1.0, 1e5)));

}  // namespace

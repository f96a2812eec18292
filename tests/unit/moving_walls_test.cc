// The contact lists of a whole simulation against brute force, while walls and stones move.
#include <gtest/gtest.h>

#include <cmath>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "apps/laws.h"
#include "dem/packing.h"
#include "dem/random.h"

namespace {

using apps::Dry;

constexpr double length = 0.02, width = 0.02;  // of the box [m]

Dry law() {
  const dem::Material soft = {1e8, 0.2};
  return {{1 / (2 * dem::normal_compliance(soft))}, 1 / (2 * dem::shear_compliance(soft)), 0.5};
}

// Stones of radius 0.4 to 3.2 mm (1:8) that fall, a floor, two sides, and a block that is driven
// down.
dem::Simulation<Dry> falling_stones() {
  std::vector<double> radius;
  for (std::uint32_t k = 0; k < 150; ++k)
    radius.push_back(0.4e-3 * std::pow(8.0, std::pow(dem::uniform(7, dem::Purpose::size, k), 3)));
  std::sort(radius.begin(), radius.end());
  const dem::Gas gas = dem::pack_gas(radius, dem::RectangularMould{length, width}, 0.3, 3);
  dem::Settings settings;
  settings.largest_step = 2e-6;
  settings.skin = 0.1e-3;
  dem::Simulation<Dry> bed(dem::make_stones(gas.position, radius, {2650}, 1), law(), settings);
  const auto add = [&](dem::Surface surface, const dem::Frame& frame, dem::Motion motion) {
    dem::Wall wall;
    wall.surface = surface;
    wall.frame = frame;
    wall.motion = motion;
    bed.add_wall(wall, law());
  };
  dem::Frame at;
  add(dem::Plane{}, at, dem::Fixed{});
  add(dem::CylinderInside{0.5 * length * 1.5}, {.origin = {length / 2, width / 2, 0}},
      dem::Fixed{});
  at.origin = {0, width / 2, gas.height + 0.018};
  add(dem::Block{{length / 2, width / 2, 0.018}}, at, dem::Driven{{0, 0, -0.3}});
  return bed;
}

double distance_of(const dem::Wall& wall, const dem::Vec3d& x) {
  const dem::Vec3d local = wall.frame.to_frame(x - wall.frame.origin);
  return std::visit([&](const auto& s) { return s.nearest(local).distance; }, wall.surface);
}

TEST(moving_walls, every_touching_pair_is_listed_at_every_step) {
  dem::Simulation<Dry> bed = falling_stones();
  std::size_t seen = 0;
  for (int step = 0; step < 6000; ++step) {
    bed.step();
    if (step % 50) continue;
    const dem::ParticleStore& stones = bed.stones();
    std::set<std::pair<int, int>> listed;
    for (std::int64_t s = 0; s < bed.pairs().slots(); ++s)
      listed.insert(std::minmax(bed.pairs().first(s), bed.pairs().second(s)));
    for (int i = 0; i < int(stones.size()); ++i)
      for (int j = i + 1; j < int(stones.size()); ++j) {
        const double apart = norm(stones.position[i] - stones.position[j]);
        if (apart >= stones.radius[i] + stones.radius[j]) continue;
        ++seen;
        ASSERT_TRUE(listed.count({i, j})) << "step " << step;
      }
  }
  EXPECT_GT(seen, 100u);
  EXPECT_GT(bed.rebuilds(), 10);
}

TEST(moving_walls, every_stone_that_touches_a_wall_is_listed_at_every_step) {
  dem::Simulation<Dry> bed = falling_stones();
  std::vector<int> seen(bed.walls().size(), 0);
  for (int step = 0; step < 8000; ++step) {
    bed.step();
    if (step % 20) continue;
    const dem::ParticleStore& stones = bed.stones();
    for (std::size_t w = 0; w < bed.walls().size(); ++w) {
      const auto& contacts = bed.wall_contacts(w);
      const auto end = contacts.stones.begin() + contacts.slots();
      for (int k = 0; k < int(stones.size()); ++k) {
        if (distance_of(bed.walls()[w], stones.position[k]) >= stones.radius[k]) continue;
        ++seen[w];
        ASSERT_TRUE(std::binary_search(contacts.stones.begin(), end, k)) << "step " << step;
      }
    }
  }
  for (const int touches : seen) EXPECT_GT(touches, 20);
}

TEST(moving_walls, a_resting_stone_presses_on_the_floor_with_its_weight) {
  // Equilibrium: force on the wall is (0, 0, -m g), push is +m g; 1 % for what still bounces.
  const dem::Material soft = {1e7, 0.2};
  const apps::DampedDry damped = {{1 / (2 * dem::normal_compliance(soft)), dem::damping_ratio(0.1)},
                                  1 / (2 * dem::shear_compliance(soft)),
                                  0.5};
  dem::Settings settings;
  settings.largest_step = 1e-6;
  settings.skin = 0.1e-3;
  dem::Simulation<apps::DampedDry> bed(dem::make_stones({{0, 0, 3e-3}}, {3e-3}, {2650}, 1), damped,
                                       settings);
  dem::Wall floor;
  floor.surface = dem::Plane{};
  bed.add_wall(floor, damped);
  for (int step = 0; step < 100000; ++step) bed.step();
  const double weight = bed.stones().mass[0] * settings.gravity;
  EXPECT_NEAR(bed.walls()[0].force.z, -weight, 0.01 * weight);
  EXPECT_NEAR(bed.walls()[0].push, weight, 0.01 * weight);
}

// A stone with a shell, whose centre is `height` [m] above a floor, after a step without gravity.
dem::Simulation<Dry> shelled_stone(double height, double speed, double spin) {
  dem::Settings settings;
  settings.largest_step = 1e-9;
  settings.skin = 0.1e-3;
  settings.gravity = 0;
  dem::ParticleStore stone = dem::make_stones({{0, 0, height}}, {1e-3}, {2650, 0.5e-3}, 1);
  stone.velocity[0] = {speed, 0, 0};
  stone.spin[0] = {0, spin, 0};
  dem::Simulation<Dry> bed(std::move(stone), law(), settings);
  dem::Wall floor;
  floor.surface = dem::Plane{};
  bed.add_wall(floor, law());
  bed.step();
  return bed;
}

class Height : public testing::TestWithParam<double> {};

TEST_P(Height, of_a_shelled_stone_over_the_face_is_the_arm_that_it_rolls_on) {
  // Closed form: the wall's face is where they meet, until the shell of 0.5 mm is pressed to
  // nothing on a stone of 1 mm; what slides pushes the stone round, and not the wall, by that arm.
  const double arm = GetParam();
  const dem::Simulation<Dry> rolls = shelled_stone(arm, 0.1, 0.1 / arm);
  const dem::Vec3d rolling = rolls.walls()[0].force;
  EXPECT_LT(rolling.z, -0.1);
  EXPECT_NEAR(rolling.x, 0, 1e-12 * std::abs(rolling.z));
  const dem::Simulation<Dry> slides = shelled_stone(arm, 0.1, 0);
  const dem::Vec3d force = slides.walls()[0].force;
  EXPECT_GT(force.x, 1e-9);
  const double x = slides.stones().position[0].x;
  EXPECT_NEAR(slides.walls()[0].moment.y, -x * force.z, 1e-12 * force.x * arm);
  // 1e-8: in the step it moves by that share of its radius.
  EXPECT_NEAR(slides.stones().load[0].torque.y, arm * force.x, 1e-8 * arm * force.x);
}

INSTANTIATE_TEST_SUITE_P(moving_walls, Height, testing::Values(1e-3, 1.2e-3, 1.45e-3));

TEST(moving_walls, a_pressed_stone_meets_the_wall_in_the_middle_of_their_overlap) {
  // Rule of two bodies that yield alike: 20 um of overlap of the bare stone leave an arm of 990 um.
  const dem::Simulation<Dry> rolls = shelled_stone(0.98e-3, 0.1, 0.1 / 0.99e-3);
  EXPECT_NEAR(rolls.walls()[0].force.x, 0, 1e-12 * std::abs(rolls.walls()[0].force.z));
}

TEST(moving_walls, a_wall_that_is_stopped_drags_no_stone) {
  // Closed form: on a stone that is too heavy to be moved the floor pulls by 8 G* a, times the way
  // that it has gone, 0.1 um a step, and by no more once it stands.
  constexpr double radius = 2e-3, overlap = 10e-6;
  dem::Settings settings;
  settings.largest_step = 1e-6;
  settings.skin = 0.1e-3;
  settings.gravity = 0;
  dem::Simulation<Dry> bed(dem::make_stones({{0, 0, radius - overlap}}, {radius}, {2650}, 1e30),
                           law(), settings);
  dem::Wall floor;
  floor.surface = dem::Plane{};
  floor.motion = dem::Driven{{0.1, 0, 0}};
  bed.add_wall(floor, law());
  const double pull = 8 * law().shear_modulus * std::sqrt(radius * overlap) * 10 * 0.1e-6;
  for (int n = 0; n < 10; ++n) bed.step();
  EXPECT_NEAR(bed.stones().load[0].force.x, pull, 1e-9 * pull);
  bed.walls()[0].motion = dem::Fixed{};
  for (int n = 0; n < 10; ++n) bed.step();
  EXPECT_NEAR(bed.stones().load[0].force.x, pull, 1e-9 * pull);
}

TEST(moving_walls, a_stone_outside_the_mould_stops_the_run_by_name) {
  // Closed form: a stone of radius 2 mm whose centre is 5 mm beyond the wall overlaps it by 7 mm.
  dem::Settings settings;
  settings.largest_step = 1e-6;
  settings.skin = 0.1e-3;
  dem::Simulation<Dry> bed(
      dem::make_stones({{0, 0, 5e-3}, {15e-3, 0, 5e-3}}, {2e-3, 2e-3}, {2650}, 1), law(), settings);
  dem::Wall ring;
  ring.name = "mould";
  ring.surface = dem::CylinderInside{10e-3};
  bed.add_wall(ring, law());
  try {
    bed.step();
    FAIL() << "the run went on";
  } catch (const dem::NumericalTrouble& trouble) {
    EXPECT_EQ(trouble.stone, 1u);
    EXPECT_NEAR(trouble.value, 7.0 / 2, 1e-12);
    EXPECT_NE(std::string(trouble.what()).find("mould"), std::string::npos);
  }
}

// From the promise of dem/time_step.h, with steps in which a wall goes a third of the skin: the
// step at the first touch of a wall that starts at `gap` [m] is that of a contact pressed by one
// step.
void expect_a_short_step_at_touch(double gap) {
  dem::Settings settings;
  settings.largest_step = 1e-4;
  settings.skin = 0.3e-3;
  settings.gravity = 0;
  constexpr double radius = 2e-3, speed = 1;
  dem::Simulation<Dry> bed(dem::make_stones({{0, 0, 0}}, {radius}, {2650}, 1), law(), settings);
  dem::Wall lid;
  lid.surface = dem::Plane{};
  lid.frame.ex = {1, 0, 0};
  lid.frame.ey = {0, -1, 0};
  lid.frame.ez = {0, 0, -1};
  lid.frame.origin = {0, 0, radius + gap};
  lid.motion = dem::Driven{{0, 0, -speed}};
  bed.add_wall(lid, law());
  while (bed.walls()[0].push == 0) bed.step();
  ASSERT_LT(bed.time(), gap / speed + settings.largest_step);
  const double pressed = speed * bed.last_step();
  const double stiffness = 2 * law().normal.modulus * std::sqrt(radius * pressed);
  EXPECT_LE(bed.last_step(), settings.safety * std::sqrt(bed.stones().inertia[0] / stiffness));
}

TEST(moving_walls, the_step_shortens_before_a_fast_wall_strikes) {
  expect_a_short_step_at_touch(0.75e-3);
}

TEST(moving_walls, a_wall_that_is_already_near_is_expected_at_its_speed) {
  expect_a_short_step_at_touch(0.05e-3);
}

TEST(moving_walls, a_wall_without_a_number_stops_the_run_by_name) {
  // From the promise: numerical trouble names stone, time and value, wherever it begins.
  dem::Settings settings;
  settings.largest_step = 1e-6;
  settings.skin = 0.1e-3;
  dem::Simulation<Dry> bed(dem::make_stones({{0, 0, 1e-3}}, {2e-3}, {2650}, 1), law(), settings);
  dem::Wall lid;
  lid.name = "lid";
  lid.surface = dem::Plane{};
  lid.motion = dem::Driven{{0, 0, std::nan("")}};
  bed.add_wall(lid, law());
  try {
    bed.step();
    FAIL() << "the run went on";
  } catch (const dem::NumericalTrouble& trouble) {
    EXPECT_EQ(trouble.stone, 0u);
    EXPECT_TRUE(std::isnan(trouble.value));
    EXPECT_NE(std::string(trouble.what()).find("lid"), std::string::npos);
  }
}

}  // namespace

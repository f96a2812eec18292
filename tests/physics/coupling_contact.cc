// Stones and elastic walls together, against answers in closed form.
#include <gtest/gtest.h>

#include "tests/physics/coupling_bench.h"

namespace {

using bench::Stone;

// Approach of stone and yielding plate after they have come to rest [m].
double resting_approach(const Stone& stone, double gain, int interval) {
  auto simulation = bench::above(bench::plate(), stone);
  dem::Wall& wall = simulation.walls().front();
  const double stiffness = stone.stiffness() / gain;
  coupling::ExchangeSettings settings;
  settings.interval = interval;
  coupling::ElasticWall elastic(bench::sinking_plate(stiffness, 2.8, wall.field->size()), wall,
                                settings);
  simulation.set_drag(0.05 / simulation.time_step() / (20 * interval));
  double before = INFINITY, now = 0;
  for (int round = 0; round < 200 && std::abs(now - before) > 1e-7 * stone.overlap(); ++round) {
    before = now;
    for (int step = 0; step < 2000 + 200 * interval; ++step) {
      simulation.step();
      elastic.exchange(wall, {simulation.last_step(), simulation.time_step()});
    }
    now = stone.radius - simulation.stones().position[0].z;
  }
  return now;
}

class Gain : public testing::TestWithParam<double> {};

// Hertz (1882) and a spring in series: d = (F / K)^(2/3) + C F. 1e-4: what is left of the motion
// when the round above stops.
TEST_P(Gain, a_stone_and_a_yielding_plate_give_way_in_series) {
  const Stone stone;
  const double gain = GetParam();
  const double exact = stone.overlap() + gain / stone.stiffness() * stone.load;
  EXPECT_NEAR(resting_approach(stone, gain, 10), exact, 1e-4 * exact);
}
INSTANTIATE_TEST_SUITE_P(contact_stiffness_times_compliance, Gain,
                         testing::Values(0.001, 0.06, 0.5, 1.0, 4.0, 100.0));

class Interval : public testing::TestWithParam<int> {};

// The same balance however seldom stones and plate meet, where a static exchange would diverge.
TEST_P(Interval, of_the_exchange_does_not_change_where_the_stone_rests) {
  const Stone stone;
  const double exact = stone.overlap() + 4 / stone.stiffness() * stone.load;
  EXPECT_NEAR(resting_approach(stone, 4, GetParam()), exact, 1e-4 * exact);
}
INSTANTIATE_TEST_SUITE_P(steps, Interval, testing::Values(1, 10, 100, 1000));

// A stone that is held still on a plate of one mode that follows statically. A turn goes half of
// the way w from where the plate is to where the mean force of the turn, r = C dF/dd times what it
// sank on the way there, would have it: errors of two turns obey
//   e2 = (1 - w - w r / 2) e1 - (w r / 2) e0,  w = 1/2,
// which shrink below r = 4 and grow above. Returns the distance from the balance after `turns`,
// over the way to it.
double left_after(double gain, int turns) {
  Stone stone;
  stone.restitution = 1;
  const double sinks = gain / stone.stiffness() * stone.load;
  stone.height = -(stone.overlap() + sinks);
  dem::Wall plate = bench::plate();
  auto simulation = bench::above(std::move(plate), stone, 1e6);  // too short for it to move
  dem::Wall& wall = simulation.walls().front();
  constexpr int interval = 20;
  coupling::ElasticWall elastic(
      bench::sinking_plate(stone.stiffness() / gain, 2.8, wall.field->size()), wall,
      {.interval = interval, .static_gain = INFINITY});
  for (int step = 0; step < turns * interval; ++step) {
    simulation.step();
    elastic.exchange(wall, {simulation.last_step(), simulation.time_step()});
  }
  return std::abs(elastic.amplitude()[0] + sinks) / sinks;
}

TEST(static_exchange, settles_below_its_threshold_and_chatters_above) {
  // Below 4 an error shrinks by sqrt(r / 4) a turn or faster, above it grows until the two part.
  for (const double gain : {0.1, 1.0, 3.5}) EXPECT_LT(left_after(gain, 400), 1e-4) << gain;
  for (const double gain : {4.5, 10.0}) EXPECT_GT(left_after(gain, 400), 0.01) << gain;
}

// Newton's third law through the letterbox: force to rounding; moment up to the lever between the
// face, where the letterbox lies, and the contact point, half an overlap and the plate's sinking
// away.
TEST(letterbox, hands_on_force_moment_and_work_of_a_rubbing_stone) {
  Stone stone;
  stone.x = 0.031;
  auto simulation = bench::above(bench::plate(), stone);
  dem::Wall& wall = simulation.walls().front();
  wall.motion = dem::Driven{{1, 0.4, 0}};  // rubs under the stone
  coupling::ElasticWall elastic(bench::sinking_plate(stone.stiffness(), 2.8, wall.field->size()),
                                wall, {.interval = 1});
  double rubbed = 0;
  for (int step = 0; step < 2000; ++step) {
    simulation.step();
    const double dt = simulation.time_step();
    dem::Vec3d force{}, moment{};
    double work = 0;
    for (std::size_t n = 0; n < wall.field->size(); ++n) {
      const dem::Vec3d share = wall.field->impulse[n] * (1 / dt);
      force += share;
      moment += cross(wall.field->node[n], share);
      work += dot(share, wall.field->velocity[n]);
    }
    const double size = norm(wall.force);
    EXPECT_LE(norm(force - wall.force), 1e-12 * size);
    const double sunk = -wall.field->displacement[0].z;
    const double lever =
        std::hypot(wall.force.x, wall.force.y) * (stone.overlap() * 2 + std::abs(sunk));
    EXPECT_LE(norm(moment - wall.moment), lever + 1e-12 * size * bench::plate_radius);
    EXPECT_NEAR(work, dot(wall.force, wall.field->velocity[0]), 1e-12 * size);
    rubbed = std::max(rubbed, std::hypot(wall.force.x, wall.force.y));
    elastic.exchange(wall, {dt, dt});
  }
  EXPECT_GT(rubbed, 0.2 * stone.load);
}

// Speed of a stone after its rebound from a plate [m/s].
double rebound(double plate_stiffness) {
  Stone stone;
  stone.height = 1e-3;
  dem::Wall wall = bench::plate();
  const bool elastic = std::isfinite(plate_stiffness);
  if (!elastic) wall.field.reset();
  auto simulation = bench::above(std::move(wall), stone);
  dem::Wall& plate = simulation.walls().front();
  std::optional<coupling::ElasticWall> coupled;
  if (elastic)
    coupled.emplace(bench::sinking_plate(plate_stiffness, 2.8, plate.field->size()), plate,
                    coupling::ExchangeSettings{.interval = 1});
  bool touched = false;
  while (!touched || plate.push > 0) {
    simulation.step();
    if (coupled) coupled->exchange(plate, {simulation.last_step(), simulation.time_step()});
    touched = touched || plate.push > 0;
  }
  return simulation.stones().velocity[0].z;
}

// A plate a million times stiffer than steel rebounds as a rigid one: what it yields is 1e-6 of the
// overlap or so.
TEST(rigid_limit, rebounds_as_a_rigid_plate) {
  const double rigid = rebound(INFINITY);
  EXPECT_GT(rigid, 0.05);
  EXPECT_NEAR(rebound(1.4e9 * 1e6), rigid, 1e-5 * rigid);
  EXPECT_GT(std::abs(rebound(1e6) - rigid), 1e-3 * rigid);  // and a soft one does not
}

}  // namespace

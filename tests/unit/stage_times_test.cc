#include "dem/stage_times.h"

#include <gtest/gtest.h>

#include <thread>

#include "dem/laws/mindlin.h"
#include "dem/simulation.h"

namespace dem {
namespace {

TEST(stage_times, each_stage_has_the_time_from_its_beginning_to_the_next) {
  using namespace std::chrono_literals;
  StageTimes times;
  times.enter(Stage::pairs);
  std::this_thread::sleep_for(20ms);
  times.enter(Stage::rest);
  times.enter(Stage::pairs);
  std::this_thread::sleep_for(20ms);
  times.enter(Stage::rest);
  EXPECT_GE(times.spent(Stage::pairs), 0.04);
  EXPECT_EQ(times.spent(Stage::motion), 0);
}

TEST(stage_times, a_bed_that_is_timed_moves_as_one_that_is_not) {
  // Two stones that meet; every stage that they have takes time.
  const auto bed = [] {
    constexpr double radius = 1e-3;
    ParticleStore stones =
        make_stones({{0, 0, 0}, {1.9 * radius, 0, 0}}, {radius, radius}, {2650}, 1);
    const Mindlin<> law = {Hertz<>{1e9}, 1e9, 0.5};
    Settings settings;
    settings.largest_step = 1e-6;
    settings.skin = 1e-5;
    return Simulation<Mindlin<>>(stones, law, settings);
  };
  Simulation<Mindlin<>> plain = bed(), timed = bed();
  StageTimes times;
  timed.time_stages(times);
  for (int k = 0; k < 100; ++k) {
    plain.step();
    timed.step();
  }
  EXPECT_EQ(plain.stones().position[0].x, timed.stones().position[0].x);
  for (const Stage stage : {Stage::motion, Stage::lists, Stage::pairs})
    EXPECT_GT(times.spent(stage), 0);
}

}  // namespace
}  // namespace dem

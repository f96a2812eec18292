#include "dem/state.h"

#include <gtest/gtest.h>

#include "apps/archive.h"
#include "apps/bed.h"

namespace {

using Law = apps::BreakingAsphalt<2>;

// A small bed that falls on a floor under a driven lid, with a broken stone.
struct Bed {
  apps::StonesScene stones;
  std::optional<apps::BinderScene> binder{std::in_place};
  apps::Mix mix;
  dem::Simulation<Law> simulation;

  Bed() : mix(), simulation(make()) {}

  dem::Simulation<Law> make() {
    stones.count = 40;
    stones.fracture.emplace();
    binder->shear_modulus = 6.65e6;
    binder->alpha = {0.513, 0.487};
    binder->tau = {0.0948, 105.9};
    for (int k = 0; k < stones.count; ++k) {
      mix.radius.push_back(k % 3 == 0 ? 4e-3 : 2e-3);
      mix.strength.push_back(k % 5 == 0 ? 1e3 : 1e9);
    }
    mix.shell = 0.2e-3;
    mix.bitumen_fraction = 0.5;
    const apps::LawBook book(stones, binder, mix);
    const apps::FillScene fill;
    const apps::NumericsScene numerics;
    auto bed = apps::make_bed<Law>(stones, mix, book, fill, numerics, 1, dem::RoundMould{0.012});
    const Law wall_law = book.law<Law>({apps::rigid, 0.3}, true);
    dem::Wall floor, ring, lid;
    floor.name = "floor";
    floor.surface = dem::Plane{};
    ring.name = "ring";
    ring.surface = dem::CylinderInside{0.012};
    lid.name = "lid";
    lid.surface = dem::Disc{0.012};
    lid.frame.origin = {0, 0, 1.1 * dem::mean_of_highest(bed.stones(), 1)};
    lid.motion = dem::Driven{{0, 0, -0.012}};
    for (const dem::Wall& wall : {floor, ring, lid}) bed.add_wall(wall, wall_law);
    return bed;
  }

  std::string state() {
    apps::Archive archive;
    simulation.visit_state(archive);
    return archive.bytes();
  }

  void step_to(std::int64_t step) {
    while (simulation.steps() < step) simulation.step();
  }
};

TEST(state, of_a_bed_is_all_that_the_next_steps_depend_on) {
  // Continued from any step, the whole state at the end is the same, bit by bit: lists that were
  // just made or are old, looks at the time step in any phase, bonds, cracks.
  constexpr std::int64_t end = 5000;
  Bed unbroken;
  std::vector<std::string> states;
  std::vector<std::int64_t> moments = {0, 1, 15, 16, 17, 999, 2000, 3001, 3999, 4803, 4999};
  for (const std::int64_t moment : moments) {
    unbroken.step_to(moment);
    states.push_back(unbroken.state());
  }
  unbroken.step_to(end);
  EXPECT_GT(unbroken.simulation.pairs().held(), 0);
  EXPECT_GT(unbroken.simulation.cracks().size(), 0u);
  EXPECT_GT(unbroken.simulation.rebuilds(), 20);
  for (std::size_t m = 0; m < moments.size(); ++m) {
    Bed continued;
    apps::Archive archive(states[m]);
    continued.simulation.visit_state(archive);
    EXPECT_TRUE(continued.state() == states[m]) << moments[m];
    continued.step_to(end);
    EXPECT_TRUE(continued.state() == unbroken.state()) << moments[m];
  }
}

}  // namespace

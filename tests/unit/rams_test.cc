// The steps that a whole simulation takes under a ram.
#include <gtest/gtest.h>

#include <vector>

#include "apps/laws.h"

namespace {

using apps::Dry;

Dry law() {
  const dem::Material soft = {1e8, 0.2};
  return {{1 / (2 * dem::normal_compliance(soft))}, 1 / (2 * dem::shear_compliance(soft)), 0.5};
}

TEST(rams, a_light_ram_on_heavy_stones_does_not_shake) {
  // Equilibrium: nine stones bear a ram that has a thousandth of the inertia of one of them. A
  // step for the stones alone would be ten times too long for it. 5 % for the ram, which rings on
  // undamped.
  dem::Settings settings;
  settings.largest_step = 1e-3;
  settings.skin = 0.1e-3;
  constexpr double radius = 2e-3, pressed = 1e-6, load = 10;
  std::vector<dem::Vec3d> place;
  for (int k = 0; k < 9; ++k)
    place.push_back({5e-3 * (k % 3 - 1), 5e-3 * (k / 3 - 1), radius - pressed});
  const std::vector<double> radii(9, radius);
  dem::Simulation<Dry> bed(dem::make_stones(place, radii, {2650}, 100), law(), settings);
  bed.set_drag(1000);
  dem::Wall floor;
  floor.surface = dem::Plane{};
  bed.add_wall(floor, law());
  dem::Wall lid;
  lid.name = "head";
  lid.surface = dem::Disc{10e-3};
  lid.frame.origin = {0, 0, 2 * radius - 2 * pressed};
  lid.motion = dem::Ram{.inertia = 1e-3 * bed.stones().inertia[0],
                        .weight = 0,
                        .force = load,
                        .ramp_start = 0,
                        .ramp = 0.05,
                        .angle = 0,
                        .speed = 0,
                        .spin = false};
  dem::orient(std::get<dem::Ram>(lid.motion), lid.frame, 0);
  bed.add_wall(lid, law());
  while (bed.time() < 0.2) bed.step();
  EXPECT_EQ(bed.limiting_contact(), "wall head on its stones");
  for (int step = 0; step < 100; ++step) {
    bed.step();
    ASSERT_NEAR(bed.walls()[1].force.z, load, 0.05 * load);
  }
}

TEST(rams, a_fast_ram_does_not_come_far_in_a_step) {
  // From the definition: two skins a step, though nothing touches and steps could be a hundred
  // times as long. It falls until its oil loses what pressure and weight give.
  dem::Settings settings;
  settings.largest_step = 0.2;
  settings.skin = 0.1e-3;
  settings.gravity = 0;
  dem::Simulation<Dry> bed(dem::make_stones({{0, 0, -1}}, {2e-3}, {2650}, 1e7), law(), settings);
  dem::Wall lid;
  lid.name = "head";
  lid.surface = dem::Disc{10e-3};
  lid.motion = dem::Ram{.inertia = 1,
                        .weight = 3e3,
                        .force = 1e3,
                        .ramp_start = 0,
                        .ramp = 0,
                        .angle = 0,
                        .speed = 0,
                        .spin = false,
                        .valve_speed = 0.1};
  dem::orient(std::get<dem::Ram>(lid.motion), lid.frame, 0);
  bed.add_wall(lid, law());
  for (int step = 0; step < 20; ++step) {
    const double before = bed.walls()[0].frame.origin.z;
    bed.step();
    ASSERT_LE(before - bed.walls()[0].frame.origin.z, 2 * settings.skin);
  }
  EXPECT_EQ(bed.limiting_contact(), "the speed of wall head");
  EXPECT_NEAR(bed.walls()[0].frame.velocity.z, -0.2, 1e-3);
}

}  // namespace

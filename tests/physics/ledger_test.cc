// The kinds of energy that stones, walls and weight bring into the ledger, where a closed form
// knows them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/physics/ledger_bench.h"

namespace {

using namespace bench;
using dem::Vec3d;

// Two stones that meet at 1 m/s each.
template <class Law>
dem::Simulation<Law> meeting(const Law& law) {
  const double gap = 1e-7;
  dem::ParticleStore stones =
      dem::make_stones({{0, 0, 0}, {0, 0, 2 * radius + gap}}, {radius, radius}, {2650}, 1);
  stones.velocity = {{0, 0, 1}, {0, 0, -1}};
  return {stones, law, settings(1e-8, 0)};
}

TEST(ledger, shows_the_motion_of_meeting_stones_stored_and_given_back) {
  // Hertz: at their closest all of m v^2 is stored. The step is 1e-3 of the contact, the closest is
  // met within half of it: 1e-5.
  auto pair = meeting(dry(2, 0.5));
  dem::EnergyLedger<Dry> ledger;
  const double motion = pair.stones().mass[0];
  double most = 0, worst = 0;
  for (int n = 0; n < 3000; ++n) {
    pair.step();
    ledger.look(pair);
    most = std::max(most, ledger.energies().stored.stone);
    worst = std::max(worst, std::abs(ledger.energies().residual()));
  }
  const dem::Energies& end = ledger.energies();
  EXPECT_NEAR(most, motion, 1e-5 * motion);
  EXPECT_NEAR(end.kinetic, motion, 1e-5 * motion);
  EXPECT_EQ(end.stored.stone, 0);
  EXPECT_NEAR(end.lost.sum(), 0, 1e-12 * motion);
  EXPECT_LT(worst, 1e-5 * motion);
}

TEST(ledger, shows_what_restitution_takes_as_damping) {
  // 1 - e^2 of the motion; the impact itself has e to 1e-3 (impact_test).
  auto pair = meeting(damped(2, 0.5, 0.6));
  dem::EnergyLedger<DampedDry> ledger;
  const double motion = pair.stones().mass[0];
  for (int n = 0; n < 5000; ++n) {
    pair.step();
    ledger.look(pair);
  }
  const dem::Energies& end = ledger.energies();
  EXPECT_NEAR(end.lost.damping, (1 - 0.6 * 0.6) * motion, 2e-3 * motion);
  EXPECT_NEAR(end.lost.sum(), end.lost.damping, 1e-12 * motion);
  EXPECT_LT(std::abs(end.residual()), 1e-4 * motion);
}

TEST(ledger, shows_what_weight_and_scaled_inertia_do_in_a_fall) {
  // Free fall with inertia s m: m g z of work, all of it motion, 1 - 1/s of that not of true mass.
  // Leapfrog falls exactly.
  constexpr double scale = 100;
  dem::Simulation<Dry> fall(dem::make_stones({{0, 0, 1}}, {radius}, {2650}, scale), dry(2, 0.5),
                            settings(1e-4, 9.81));
  dem::EnergyLedger<Dry> ledger;
  ledger.look(fall);
  for (int n = 0; n < 1000; ++n) {
    fall.step();
    ledger.look(fall);
  }
  const dem::Energies& end = ledger.energies();
  const double weight = 9.81 * fall.stones().mass[0];
  const double depth = 0.5 * 9.81 / scale * fall.time() * fall.time();
  EXPECT_NEAR(end.gravity, weight * depth, 1e-9 * weight * depth);
  EXPECT_NEAR(end.kinetic, end.gravity, 1e-9 * end.gravity);
  EXPECT_NEAR(end.mass_scaling, 0.99 * end.kinetic, 1e-12 * end.kinetic);
}

TEST(ledger, shows_the_friction_of_a_stone_that_slides_until_it_rolls) {
  // 2/7 of m v^2 / 2, whatever the friction. The stone rests in its floor at first, whose shear
  // spring swings on in the end with the rest: (mu m g)^2 / 2k, 1e-4 of it.
  const Dry law = dry(1, 0.3);
  dem::ParticleStore stones = dem::make_stones({{0, 0, radius}}, {radius}, {2650}, 1);
  const double weight = 9.81 * stones.mass[0], speed = 0.1;
  stones.position[0].z -=
      std::pow(weight / (4.0 / 3 * law.normal.modulus * std::sqrt(radius)), 2.0 / 3);
  dem::Simulation<Dry> slide(stones, law, settings(1e-7, 9.81));
  dem::Wall floor;
  floor.surface = dem::Plane{};
  slide.add_wall(floor, law);
  slide.step();
  dem::ParticleStore moving = slide.stones();
  moving.velocity[0].x = speed;
  dem::Simulation<Dry> run(moving, law, settings(1e-7, 9.81));
  run.add_wall(floor, law);
  dem::EnergyLedger<Dry> ledger;
  while (run.time() < 1.5 * 2 * speed / (7 * 0.3 * 9.81)) {
    run.step();
    ledger.look(run);
  }
  const double motion = 0.5 * moving.mass[0] * speed * speed;
  EXPECT_NEAR(ledger.energies().lost.friction, 2.0 / 7 * motion, 1e-3 * motion);
  EXPECT_NEAR(ledger.energies().kinetic, 5.0 / 7 * motion, 1e-3 * motion);
  EXPECT_LT(std::abs(ledger.energies().residual()), 1e-4 * motion);
}

// A stone on a floor below a plate that comes down by 1 um in 1000 steps.
dem::Energies pressed(const dem::Wall& plate) {
  const Dry law = dry(1, 0.3);
  dem::Simulation<Dry> press(dem::make_stones({{0, 0, radius}}, {radius}, {2650}, 1), law,
                             settings(1e-7, 0));
  dem::Wall floor;
  floor.surface = dem::Plane{};
  press.add_wall(floor, law);
  press.add_wall(plate, law);
  dem::EnergyLedger<Dry> ledger;
  ledger.look(press);
  for (int n = 0; n < 100000; ++n) {
    press.step();
    ledger.look(press);
  }
  return ledger.energies();
}

// 1 um shared by two contacts: twice 8/15 E0 sqrt(R) d^2.5. The plate moves at 1e-4 m/s, so slowly
// that the stone's own motion is below 1e-4 of it.
const double squeezed =
    2 * 8.0 / 15 / dem::normal_compliance(granite) * std::sqrt(radius) * std::pow(0.5e-6, 2.5);

TEST(ledger, shows_the_work_of_a_wall_that_is_driven) {
  dem::Wall plate;
  plate.surface = dem::Disc{0.01};
  plate.frame.origin = {0, 0, 2 * radius};
  plate.motion = dem::Driven{{0, 0, -1e-4}};
  const dem::Energies end = pressed(plate);
  EXPECT_NEAR(end.walls, squeezed, 1e-3 * squeezed);
  EXPECT_NEAR(end.stored.stone, squeezed, 1e-3 * squeezed);
  EXPECT_LT(std::abs(end.residual_share()), 1e-4);
}

TEST(ledger, shows_the_work_of_a_wall_that_bends) {
  // The same, but the plate stays where it is and its face moves.
  dem::Wall plate;
  plate.surface = dem::Disc{0.01};
  plate.frame.origin = {0, 0, 2 * radius};
  plate.field.emplace(dem::DiscGrid{0.01, 2, 8});
  for (Vec3d& velocity : plate.field->velocity) velocity = {0, 0, -1e-4};
  plate.field->fastest = 1e-4;
  const dem::Energies end = pressed(plate);
  EXPECT_NEAR(end.walls, squeezed, 1e-3 * squeezed);
  EXPECT_LT(std::abs(end.residual_share()), 1e-4);
}

}  // namespace

// The energy ledger over whole beds: the kinds of energy that stones, walls and weight bring in,
// where a closed form knows them, and the residual of beds that settle and are pressed.
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>

#include "apps/ledger.h"
#include "dem/packing.h"

namespace {

using apps::BreakingAsphalt;
using apps::DampedDry;
using apps::Dry;
using dem::Vec3d;

constexpr dem::Material granite = {74e9, 0.15};
constexpr double radius = 3e-3;  // [m]

// The law of contacts in which so many bodies yield.
Dry dry(double bodies, double friction) {
  return {{1 / (bodies * dem::normal_compliance(granite))},
          1 / (bodies * dem::shear_compliance(granite)),
          friction};
}

DampedDry damped(double bodies, double friction, double restitution) {
  const Dry law = dry(bodies, friction);
  return {{law.normal.modulus, dem::damping_ratio(restitution)}, law.shear_modulus, friction};
}

dem::Settings settings(double time_step, double gravity) {
  omp_set_num_threads(1);  // more would only wait for each other
  dem::Settings settings;
  settings.gravity = gravity;
  settings.safety = 1;  // the step stays at its largest
  settings.largest_step = time_step;
  settings.skin = 0.1 * radius;
  return settings;
}

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

// A gas of stones that falls into a cylinder, then under a ram that gyrates.
template <class Law>
class Compaction {
 public:
  Compaction(const Law& pair, const Law& wall, double shell) : wall_(wall) {
    std::vector<double> sizes, outer;
    for (int k = 0; k < count; ++k) sizes.push_back(2e-3 + 1.5e-3 * k / count);
    for (const double r : sizes) outer.push_back(r + shell);
    const dem::Gas gas = dem::pack_gas(outer, dem::RoundMould{mould}, 0.3, 3);
    dem::ParticleStore stones = dem::make_stones(gas.position, sizes, {2650, shell, 1950}, 1e4);
    if (Law::breaks) dem::make_breakable(stones, std::vector<double>(count, strength));
    dem::Settings numerics = settings(shell > 0 ? 1e-4 : 3e-5, 9.81);
    numerics.safety = 0.2;
    bed_.emplace(stones, pair, numerics);
    dem::Wall floor, ring;
    floor.surface = dem::Plane{};
    ring.surface = dem::CylinderInside{mould};
    bed_->add_wall(floor, wall);
    bed_->add_wall(ring, wall);
  }

  void run(double duration, bool watched) {
    const double end = bed_->time() + duration;
    ledger_.restart();
    while (bed_->time() < end) {
      bed_->step();
      if (watched) ledger_.look(*bed_);
    }
  }

  void settle(bool watched = true) {
    bed_->set_drag(0.5);
    run(6, watched);
    bed_->set_drag(0);
  }

  void gyrate(bool watched = true) {
    const dem::Ram ram = {
        100, 10, 600e3 * std::numbers::pi * mould * mould, bed_->time(), 0.3, 0.02, 1, false};
    dem::Wall head;
    head.surface = dem::Disc{mould};
    head.motion = ram;
    orient(ram, head.frame, bed_->time());
    const dem::ParticleStore& stones = bed_->stones();
    for (std::size_t k = 0; k < stones.size(); ++k)
      head.frame.origin.z = std::max(
          head.frame.origin.z,
          (dot(stones.position[k], head.frame.ez) + stones.outer_radius(k)) / head.frame.ez.z);
    bed_->add_wall(head, wall_);
    run(1.3, watched);
  }

  const dem::Simulation<Law>& bed() const { return *bed_; }
  const dem::Energies& energies() const { return ledger_.energies(); }

 private:
  static constexpr int count = 40;
  static constexpr double mould = 12e-3;    // radius [m]
  static constexpr double strength = 60e6;  // of every stone [Pa]
  Law wall_;
  std::optional<dem::Simulation<Law>> bed_;
  dem::EnergyLedger<Law> ledger_;
};

Compaction<DampedDry> dry_bed() {
  return {damped(2, 0.7, 0.5), damped(1, 0.3, 0.5), 0};
}

Compaction<BreakingAsphalt<2>> asphalt_bed() {
  const double shell = 0.5e-3;
  const auto law = [&](int bodies) {
    apps::BreakingAsphalt<2> law;
    law.a = {dry(bodies, bodies == 2 ? 0.7 : 0.3), 1};
    law.a.stone.gap = bodies * shell;
    law.b = {6.65e6,          {0.22, 0.21},
             {0.0948, 105.9}, bodies == 2 ? 8.0 / 3 : 16.0 / 3,
             bodies * shell,  {bodies == 2 ? 1e4 : 0.0}};
    if (bodies == 1) law.b.friction = 0.3;
    return law;
  };
  return {law(2), law(1), shell};
}

// Closed below 0.1 % of the work done: the promise to the user.
constexpr double closed = 1e-3;

TEST(ledger, closes_over_a_dry_bed_that_settles_and_gyrates) {
  auto dry = dry_bed();
  dry.settle();
  EXPECT_GT(dry.energies().gravity, 0);
  EXPECT_GT(dry.energies().lost.damping, 0);
  EXPECT_LT(std::abs(dry.energies().residual_share()), closed);
  dry.gyrate();
  EXPECT_GT(dry.energies().walls, 10 * dry.energies().gravity);
  EXPECT_GT(dry.energies().lost.friction, 0.1 * dry.energies().walls);
  EXPECT_LT(std::abs(dry.energies().residual_share()), closed);
}

TEST(ledger, closes_over_a_bed_of_asphalt_that_settles_and_gyrates) {
  auto asphalt = asphalt_bed();
  asphalt.settle();
  EXPECT_GT(asphalt.energies().stored.binder, 0);
  EXPECT_LT(std::abs(asphalt.energies().residual_share()), closed);
  asphalt.gyrate();
  EXPECT_GT(asphalt.bed().cracks().size(), 0u);
  EXPECT_GT(asphalt.energies().lost.fracture, 0);
  EXPECT_GT(asphalt.energies().lost.binder, 0.01 * asphalt.energies().walls);
  EXPECT_LT(std::abs(asphalt.energies().residual_share()), closed);
}

TEST(ledger, does_not_change_what_it_watches) {
  auto watched = asphalt_bed(), alone = asphalt_bed();
  watched.run(3, true);
  alone.run(3, false);
  const auto &a = watched.bed().stones().position, &b = alone.bed().stones().position;
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3d)), 0);
}

}  // namespace

// The residual of the energy ledger over whole beds that settle and are pressed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>

#include "dem/packing.h"
#include "tests/physics/ledger_bench.h"

namespace {

using namespace bench;
using apps::BreakingAsphalt;
using dem::Vec3d;

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
    law.a.stone.cover = bodies * shell;
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

TEST(ledger_beds, closes_over_a_dry_bed_that_settles_and_gyrates) {
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

TEST(ledger_beds, closes_over_a_bed_of_asphalt_that_settles_and_gyrates) {
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

TEST(ledger_beds, does_not_change_what_it_watches) {
  auto watched = asphalt_bed(), alone = asphalt_bed();
  watched.run(3, true);
  alone.run(3, false);
  const auto &a = watched.bed().stones().position, &b = alone.bed().stones().position;
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3d)), 0);
}

}  // namespace

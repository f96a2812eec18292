#include "dem/pair_contacts.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "dem/fracture.h"
#include "dem/integrator.h"
#include "dem/laws/binder.h"
#include "dem/laws/fracture.h"
#include "dem/laws/mindlin.h"
#include "dem/laws/sum.h"
#include "dem/wall_contacts.h"

namespace dem {
namespace {

using Law = Sum<Mindlin<>, Binder<2>>;
using Pairs = PairContacts<Law>;
constexpr double dt = 1e-5;       // [s]
constexpr double ahead = 16e-5;   // horizon of those who look [s]
constexpr double shell = 0.5e-3;  // [m]

Law asphalt() {
  Law law = {{{3.8e10}, 8e9, 0.7, 2 * shell},
             {6.65e6, {0.2, 0.2}, {0.09, 106}, 8.0 / 3, 2 * shell, {1e4}}};
  law.set_time_step(dt);
  return law;
}

void list_pairs(Pairs& pairs, ParticleStore& stones) {
  std::vector<double> outer(stones.size());
  for (std::size_t k = 0; k < outer.size(); ++k) outer[k] = stones.outer_radius(k);
  NeighborList list;
  list.build({stones.position, outer, stones.id}, 0.5e-3);
  pairs.law = asphalt();
  pairs.take(list, stones);
}

// A cloud in a cube of some side [m] in which some overlap, some nearly touch, and all move and
// spin.
ParticleStore cloud(int count = 60, double side = 20e-3) {
  std::mt19937 engine(1);
  const auto any = [&] { return engine() / 4294967295.0 - 0.5; };
  std::vector<Vec3d> position;
  std::vector<double> radius;
  for (int k = 0; k < count; ++k) {
    position.push_back({side * any(), side * any(), side * any()});
    radius.push_back(2e-3 + 1e-3 * any());
  }
  ParticleStore stones = make_stones(position, radius, {2650, shell, 1950}, 100);
  for (std::size_t k = 0; k < stones.size(); ++k) {
    stones.velocity[k] = {any(), any(), any()};
    stones.spin[k] = {100 * any(), 100 * any(), 100 * any()};
  }
  return stones;
}

void drift(ParticleStore& stones) {
  for (std::size_t k = 0; k < stones.size(); ++k) stones.position[k] += stones.velocity[k] * dt;
}

struct Answer {
  Extremes extremes;
  std::vector<Load> load;  // of the stones, without weight
};

template <class T = Pack>
Answer evaluated(Pairs& pairs, ParticleStore& stones, double horizon = 0) {
  weigh(stones, 0);
  const Extremes extremes = pairs.evaluate<T>(stones, dt, horizon);
  return {extremes, {stones.load.begin(), stones.load.begin() + stones.size()}};
}

TEST(pair_contacts, eight_slots_at_a_time_are_answered_as_one_at_a_time) {
  // Reference: the same text with T = double, over 50 steps of contacts that touch, slip and part,
  // each from the same memories. Of 1e-13: an overlap is what is left of radii and a distance, here
  // 1e2 times larger and rounded to 1e-16 of themselves, so that a force is known to 1e-14 of those
  // of deep contacts at best; the rest are sums in another order and fused operations.
  ParticleStore stones = cloud();
  Pairs fast, slow;
  list_pairs(fast, stones);
  list_pairs(slow, stones);
  ASSERT_GE(fast.slots(), 50);
  for (int n = 0; n < 50; ++n) {
    const double horizon = n % 7 == 0 ? ahead : 0;
    slow.history = fast.history;
    const auto [at_fast, on_fast] = evaluated<Pack>(fast, stones, horizon);
    const auto [at_slow, on_slow] = evaluated<double>(slow, stones, horizon);
    double force = 0, torque = 0;
    for (const Load& load : on_slow) {
      force = std::max(force, norm(load.force));
      torque = std::max(torque, norm(load.torque));
    }
    for (std::size_t k = 0; k < stones.size(); ++k) {
      ASSERT_NEAR(norm(on_fast[k].force - on_slow[k].force), 0, 1e-13 * force);
      ASSERT_NEAR(norm(on_fast[k].torque - on_slow[k].torque), 0, 1e-13 * torque);
    }
    EXPECT_NEAR(at_fast.rate, at_slow.rate, 1e-13 * at_slow.rate);
    EXPECT_EQ(at_fast.rate_slot, at_slow.rate_slot);
    EXPECT_NEAR(at_fast.overlap, at_slow.overlap, 1e-13);
    EXPECT_EQ(at_fast.overlap_slot, at_slow.overlap_slot);
    drift(stones);
  }
  EXPECT_EQ(fast.touching(stones), slow.touching(stones));
  EXPECT_EQ(fast.held(), slow.held());
}

// Stones, some of them broken, and the face of a bending disc above them, which some touch and some
// nearly do; all move and spin.
struct BedAtWall {
  using Law = Sum<Fracture<Mindlin<>>, Binder<2>>;

  ParticleStore stones;
  Wall wall;
  WallContacts<Law> contacts;

  explicit BedAtWall(int count) {
    std::mt19937 engine(2);
    const auto any = [&] { return engine() / 4294967295.0 - 0.5; };
    const auto vector = [&](double size) { return Vec3d{any(), any(), any()} * size; };
    const double angle = 0.02, c = std::cos(angle), s = std::sin(angle);
    wall.surface = Disc{disc};
    wall.frame = {{3e-3, -2e-3, 5e-3}, {c, 0, -s},       {0, 1, 0},
                  {s, 0, c},           {0.1, 0.2, -0.1}, {3, -2, 5}};
    wall.field.emplace(DiscGrid{disc, 3, 12});
    for (Vec3d& u : wall.field->displacement) u = vector(2e-6);
    for (Vec3d& v : wall.field->velocity) v = vector(0.02);
    std::vector<Vec3d> position;
    std::vector<double> radius;
    for (int k = 0; k < count; ++k) {
      radius.push_back(2e-3 + 1e-3 * any());
      const double overlap = 0.3e-3 + 0.8e-3 * any();
      const Vec3d at = {disc * any(), disc * any(), overlap - radius.back() - shell};
      position.push_back(wall.frame.origin + wall.frame.to_laboratory(at));
    }
    stones = make_stones(position, radius, {2650, shell, 1950}, 100);
    make_breakable(stones, std::vector<double>(count, 1e300));
    for (int k = 0; k < count; ++k) {
      stones.velocity[k] = vector(1);
      stones.spin[k] = vector(100);
      if (k % 3 == 0) stones.softness[k] = 5.5 + 9 * any();
    }
    contacts.law = {{{{3.8e10}, 8e9, 0.7, shell}, 0.8},
                    {6.65e6, {0.2, 0.2}, {0.09, 106}, 16.0 / 3, shell, {100}, 0.3}};
    contacts.law.set_time_step(dt);
    const double skin = 0.5e-3;
    contacts.find(stones, wall, skin, leashes(stones, skin, std::vector<double>(count, 0.0)));
  }

  template <class T>
  WallExtremes evaluate(double horizon) {
    weigh(stones, 0);
    return contacts.evaluate<T>(stones, wall, dt, horizon);
  }

  static constexpr double disc = 20e-3;  // radius [m]
};

TEST(wall_contacts, eight_slots_at_a_time_are_answered_as_one_at_a_time) {
  // As between stones, here with memories that each keeps for itself, so that rounding, 1e-13 of
  // the largest force, may add up over the steps. Two chunks of slots, the last pack not full.
  constexpr int count = 75;
  constexpr int steps = 50;
  BedAtWall fast(count), slow(count);
  ASSERT_EQ(fast.contacts.slots(), count);
  double impulse = 0;
  for (int n = 0; n < steps; ++n) {
    const double horizon = n % 7 == 0 ? ahead : 0, rounding = 1e-13 * (n + 1);
    const WallExtremes at_fast = fast.evaluate<Pack>(horizon);
    const WallExtremes at_slow = slow.evaluate<double>(horizon);
    double force = 0, torque = 0, crush = 0, sum = 0;
    for (int k = 0; k < count; ++k) {
      const Load& load = slow.stones.load[k];
      force = std::max(force, norm(load.force));
      torque = std::max(torque, norm(load.torque));
      crush = std::max(crush, load.crush);
      sum += norm(load.force);
    }
    ASSERT_GT(crush, 0);
    for (int k = 0; k < count; ++k) {
      const Load &a = fast.stones.load[k], &b = slow.stones.load[k];
      ASSERT_NEAR(norm(a.force - b.force), 0, rounding * force) << n << ' ' << k;
      ASSERT_NEAR(norm(a.torque - b.torque), 0, rounding * torque) << n << ' ' << k;
      ASSERT_NEAR(a.crush, b.crush, rounding * crush) << n << ' ' << k;
    }
    EXPECT_NEAR(norm(fast.wall.force - slow.wall.force), 0, rounding * sum);
    EXPECT_NEAR(norm(fast.wall.moment - slow.wall.moment), 0, rounding * sum * BedAtWall::disc);
    EXPECT_NEAR(fast.wall.push, slow.wall.push, rounding * sum);
    impulse += sum * dt;
    EXPECT_NEAR(at_fast.rate, at_slow.rate, rounding * at_slow.rate);
    EXPECT_EQ(at_fast.rate_slot, at_slow.rate_slot);
    EXPECT_NEAR(at_fast.overlap, at_slow.overlap, rounding);
    EXPECT_EQ(at_fast.overlap_slot, at_slow.overlap_slot);
    EXPECT_NEAR(at_fast.stiffness, at_slow.stiffness, rounding * at_slow.stiffness);
    drift(fast.stones);
    drift(slow.stones);
  }
  for (std::size_t n = 0; n < fast.wall.field->size(); ++n)
    EXPECT_NEAR(norm(fast.wall.field->impulse[n] - slow.wall.field->impulse[n]), 0,
                1e-13 * steps * impulse);
  int held = 0;
  for (int s = 0; s < count; ++s) {
    EXPECT_EQ(fast.contacts.history.holds(s), slow.contacts.history.holds(s));
    held += slow.contacts.history.holds(s);
  }
  EXPECT_GT(held, 0);
  EXPECT_LT(held, count);
}

TEST(pair_contacts, looking_at_the_extremes_does_not_change_the_forces) {
  // From the promise: same bits with a check and without.
  ParticleStore stones = cloud();
  Pairs looking, blind;
  list_pairs(looking, stones);
  list_pairs(blind, stones);
  const std::vector<Load> seen = evaluated(looking, stones, ahead).load;
  const std::vector<Load> unseen = evaluated(blind, stones).load;
  EXPECT_EQ(__builtin_memcmp(seen.data(), unseen.data(), seen.size() * sizeof(Load)), 0);
}

// By definition: force on the first stone, its opposite on the second, torques by their arms.
void expect_sums(const Pairs& pairs, const ParticleStore& stones, const std::vector<Load>& known) {
  const std::vector<SlotForce> forces = pairs.forces(stones);
  std::vector<Load> sum(stones.size(), Load{});
  for (std::int64_t s = 0; s < pairs.slots(); ++s) {
    const std::int32_t i = pairs.first(s), j = pairs.second(s);
    sum[i].force += forces[s].force;
    sum[j].force -= forces[s].force;
    for (const std::int32_t k : {i, j})
      sum[k].torque += forces[s].moment * (stones.outer_radius(k) - forces[s].inset);
  }
  for (std::size_t k = 0; k < stones.size(); ++k) {
    const double scale = 1e-10 * (1 + norm(known[k].force));
    EXPECT_NEAR(norm(sum[k].force - known[k].force), 0, scale);
    EXPECT_NEAR(norm(sum[k].torque - known[k].torque), 0, scale);
  }
}

TEST(pair_contacts, forces_found_again_add_up_to_the_loads) {
  ParticleStore stones = cloud();
  Pairs pairs;
  list_pairs(pairs, stones);
  const std::vector<Load> known = evaluated(pairs, stones).load;
  expect_sums(pairs, stones, known);
}

TEST(pair_contacts, a_large_bed_is_added_up_by_any_number_of_threads_with_the_same_bits) {
  // More stones and slots than for which anything is done otherwise; sums as above.
  ParticleStore stones = cloud(25000, 0.1);
  Pairs pairs;
  list_pairs(pairs, stones);
  ASSERT_GT(pairs.slots(), 200000);
  const auto memories = pairs.history;
  const int threads = omp_get_max_threads();
  std::vector<std::vector<Load>> loads;
  for (const int count : {1, 2, 3}) {
    omp_set_num_threads(count);
    pairs.history = memories;
    loads.push_back(evaluated(pairs, stones).load);
    EXPECT_EQ(
        __builtin_memcmp(loads.back().data(), loads[0].data(), loads[0].size() * sizeof(Load)), 0);
  }
  omp_set_num_threads(threads);
  expect_sums(pairs, stones, loads[0]);
}

// Two stones on the z axis whose shells overlap by `overlap`.
ParticleStore pair_at(double overlap) {
  return make_stones({{0, 0, 0}, {0, 0, 5e-3 - overlap}}, {2e-3, 2e-3}, {2650, shell}, 1);
}

TEST(pair_contacts, memories_follow_their_pairs_into_a_new_list) {
  // By definition; and those that touch or hold on come first.
  ParticleStore stones = cloud();
  std::vector<double> outer(stones.size());
  for (std::size_t k = 0; k < outer.size(); ++k) outer[k] = stones.outer_radius(k);
  Pairs pairs;
  pairs.law = asphalt();
  NeighborList list;
  std::map<std::pair<int, int>, Law::Memory<double>> known;
  int followed = 0;
  for (int n = 0; n < 4; ++n) {
    list.build({stones.position, outer, stones.id}, 0.5e-3);
    pairs.take(list, stones);
    bool lively = true;
    for (std::int64_t s = 0; s < pairs.slots(); ++s) {
      const Law::Memory<double> memory = pairs.history.slot(s);
      const auto before = known.find({pairs.first(s), pairs.second(s)});
      const Law::Memory<double> old =
          before == known.end() ? Law::Memory<double>{} : before->second;
      EXPECT_EQ(__builtin_memcmp(&memory, &old, sizeof memory), 0);
      followed += memory.b.bonded > 0;
      const bool lives = pairs.touches(stones, s) || pairs.history.holds(s);
      EXPECT_LE(lives, lively);
      lively = lives;
    }
    EXPECT_FALSE(lively);
    for (int step = 0; step < 5; ++step, drift(stones)) evaluated(pairs, stones);
    known.clear();
    for (std::int64_t s = 0; s < pairs.slots(); ++s)
      known[{pairs.first(s), pairs.second(s)}] = pairs.history.slot(s);
  }
  EXPECT_GE(followed, 50);
}

TEST(pair_contacts, a_contact_ends_and_another_begins_anew) {
  // By definition: nothing is felt between, and nothing remembered of the first.
  Pairs pairs;
  ParticleStore stones = pair_at(0.1e-3);
  list_pairs(pairs, stones);
  pairs.law.b.bond.energy = 0;
  stones.velocity[1] = {1, 0, 0};
  const Load first = evaluated(pairs, stones).load[0];
  evaluated(pairs, stones);
  stones.position[1].z = 5.4e-3;
  for (int n = 0; n < 3; ++n) EXPECT_EQ(norm(evaluated(pairs, stones).load[0].force), 0);
  stones.position[1].z = 4.9e-3;
  const Load again = evaluated(pairs, stones).load[0];
  EXPECT_GT(norm(again.force), 0);
  EXPECT_EQ(__builtin_memcmp(&again, &first, sizeof again), 0);
}

TEST(pair_contacts, stones_that_only_come_near_feel_nothing) {
  // By definition, although such pairs are listed and evaluated.
  ParticleStore stones = pair_at(-0.1e-3);
  Pairs pairs;
  list_pairs(pairs, stones);
  ASSERT_EQ(pairs.slots(), 1);
  for (const double horizon : {ahead, 0.0}) {
    pairs.evaluate(stones, dt, horizon);
    EXPECT_EQ(norm(pairs.forces(stones)[0].force), 0);
    EXPECT_EQ(pairs.touching(stones), 0);
    EXPECT_EQ(pairs.held(), 0);
  }
}

TEST(pair_contacts, a_stretched_bond_pulls_although_the_shells_have_parted) {
  // Closed form: -8/3 sqrt(R0) G0 |h|^1.5 for a fast pull; relaxation in 1e-5 s takes 1e-4 of it.
  ParticleStore stones = pair_at(-0.1e-3);
  Pairs pairs;
  list_pairs(pairs, stones);
  evaluated(pairs, stones);
  stones.position[1].z = 4.9e-3;
  evaluated(pairs, stones);
  EXPECT_EQ(pairs.touching(stones), 1);
  EXPECT_EQ(pairs.held(), 1);
  stones.position[1].z = 5.1e-3;
  const double felt = evaluated(pairs, stones).load[1].force.z;
  EXPECT_EQ(pairs.touching(stones), 0);
  EXPECT_EQ(pairs.held(), 1);
  const double towards_second = pairs.first(0) == 0 ? 1 : -1;
  const double pull = 8.0 / 3 * std::sqrt(1.25e-3) * 6.65e6 * std::pow(0.1e-3, 1.5);
  EXPECT_NEAR(pairs.forces(stones)[0].force.z * towards_second / pull, 1, 1e-4);
  EXPECT_NEAR(-felt / pull, 1, 1e-4);
}

TEST(pair_contacts, rolling_without_slip_meets_no_resistance) {
  // Closed form: surfaces that move alike, v = spin x arm, with arms to the middle of the overlap.
  ParticleStore stones = pair_at(0.2e-3);
  const double arm = 2.5e-3 - 0.1e-3;
  stones.spin[0] = {0, 40, 0};
  stones.spin[1] = {0, -40, 0};
  Pairs pairs;
  list_pairs(pairs, stones);
  pairs.evaluate(stones, dt);
  EXPECT_NEAR(pairs.forces(stones)[0].force.x, 0, 1e-12);
  stones.spin[1] = {0, 0, 0};
  stones.velocity[1] = {40 * arm, 0, 0};
  pairs.evaluate(stones, dt);
  EXPECT_NEAR(pairs.forces(stones)[0].force.x, 0, 1e-12);
}

TEST(pair_contacts, the_most_limiting_contact_is_that_of_the_lighter_stone) {
  // Closed form: k / min(m_i, m_j) with k = 2 E0 a and scaled inertia, now and at the overlap that
  // is ahead until the next look.
  ParticleStore stones = make_stones({{0, 0, 0}, {0, 0, 6.0e-3 - 10e-6}}, {2e-3, 4e-3}, {2650}, 10);
  PairContacts<Mindlin<>> pairs;
  NeighborList list;
  list.build({stones.position, stones.radius, stones.id}, 0.1e-3);
  pairs.law = {{3.8e10}, 8e9, 0.7};
  pairs.take(list, stones);
  const Extremes at = pairs.evaluate(stones, dt, ahead);
  const double a = std::sqrt(8e-3 / 6 * 10e-6);
  EXPECT_NEAR(at.rate / (2 * 3.8e10 * a / (10 * stones.mass[0])), 1, 1e-9);
  EXPECT_NEAR(at.overlap, 10e-6 / 2e-3, 1e-12);
  stones.velocity[1] = {0, 0, -1};
  const Extremes soon = pairs.evaluate(stones, dt, ahead);
  const double a_soon = std::sqrt(8e-3 / 6 * (10e-6 + ahead));
  EXPECT_NEAR(soon.rate / at.rate, a_soon / a, 1e-9);
}

}  // namespace
}  // namespace dem

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "dem/laws/binder.h"
#include "dem/laws/mindlin.h"
#include "dem/laws/sum.h"
#include "dem/pair_contacts.h"
#include "dem/wall_contacts.h"
#include "tests/physics/check.h"

namespace dem {
namespace {

using checks::absolute, checks::check;

using Law = Sum<Mindlin<>, Binder<1>>;

Vec3d turned(const Eigen::AngleAxisd& turn, const Vec3d& v) {
  const Eigen::Vector3d r = turn * Eigen::Vector3d(v.x, v.y, v.z);
  return {r.x(), r.y(), r.z()};
}

// Two stones of different size, stone against stone, and the one slot of their contact.
class LoadedPair {
 public:
  LoadedPair() {
    Mindlin<> stone = {{3.8e10}, 8e9, 0.7, 1e-3};
    Binder<1> binder = {6.65e6, {0.4}, {1e9}, 8.0 / 3, 1e-3, {1e4}};
    pairs_.law = {stone, binder};
    pairs_.law.set_time_step(dt_);
    stones_ = make_stones({{0, 0, 0}, {0, 0, 3.99e-3}}, {1.5e-3, 2.5e-3}, {2650, 0.5e-3, 1950}, 1);
    NeighborList list;
    const std::vector<double> outer = {stones_.outer_radius(0), stones_.outer_radius(1)};
    list.build({stones_.position, outer, stones_.id}, 1e-3);
    pairs_.take(list, stones_);
    stones_.velocity[0] = {1e-7, 2e-7, 0};
    pairs_.evaluate<double>(stones_, dt_);
    for (int k = 0; k < 20; ++k) pairs_.evaluate<double>(stones_, dt_);
    stones_.velocity[0] = {0, 0, 0};
  }

  // Turns the pair as one rigid body.
  void turn(const Vec3d& axis, double angle, int steps) {
    const Eigen::Vector3d unit = Eigen::Vector3d(axis.x, axis.y, axis.z).normalized();
    const Eigen::AngleAxisd step(angle / steps, unit);
    for (int n = 0; n < steps; ++n) {
      for (int k = 0; k < 2; ++k) {
        const Vec3d to = turned(step, stones_.position[k]);
        stones_.velocity[k] = (to - stones_.position[k]) * (1 / dt_);
        stones_.position[k] = to;
        stones_.spin[k] = Vec3d{unit.x(), unit.y(), unit.z()} * (angle / steps / dt_);
      }
      pairs_.evaluate<double>(stones_, dt_);
    }
  }

  SlotForce slot() const { return pairs_.forces(stones_)[0]; }
  const ParticleStore& stones() const { return stones_; }
  Vec3d normal() const {
    const Vec3d apart = stones_.position[pairs_.first(0)] - stones_.position[pairs_.second(0)];
    return apart * (1 / norm(apart));
  }

 private:
  static constexpr double dt_ = 1;  // short against the relaxation time [s]
  ParticleStore stones_;
  PairContacts<Law> pairs_;
};

// How far the force is from having turned with the pair, / its shear part.
double turning_error(const Vec3d& axis, double angle, int steps) {
  LoadedPair pair;
  const Vec3d before = pair.slot().force;
  const Vec3d normal = pair.normal();
  const Vec3d shear = before - normal * dot(normal, before);
  pair.turn(axis, angle, steps);
  const Eigen::AngleAxisd whole(angle, Eigen::Vector3d(axis.x, axis.y, axis.z).normalized());
  return norm(pair.slot().force - turned(whole, before)) / norm(shear);
}

// A stone on a plane, stone against wall.
class LoadedStone {
 public:
  LoadedStone() {
    Mindlin<> stone = {{3.8e10}, 8e9, 0.7, 0.5e-3};
    Binder<1> binder = {6.65e6, {0.4}, {1e9}, 16.0 / 3, 0.5e-3, {1e4}, 0.3};
    contacts_.law = {stone, binder};
    contacts_.law.set_time_step(dt_);
    wall_.surface = Plane{};
    wall_.frame.origin = {2e-3, -1e-3, 0.5e-3};
    stones_ =
        make_stones({wall_.frame.origin + Vec3d{0, 0, 1.49e-3}}, {1.5e-3}, {2650, 0.5e-3, 1950}, 1);
    const double skin = 1e-3;
    contacts_.find(stones_, wall_, skin, leashes(stones_, skin, std::vector<double>{0}));
    stones_.velocity[0] = {1e-7, 2e-7, 0};
    for (int k = 0; k < 21; ++k) contacts_.evaluate<double>(stones_, wall_, dt_);
  }

  // Turns stone and plane as one rigid body.
  void turn(const Vec3d& axis, double angle, int steps) {
    const Eigen::Vector3d unit = Eigen::Vector3d(axis.x, axis.y, axis.z).normalized();
    const Eigen::AngleAxisd step(angle / steps, unit);
    Frame& frame = wall_.frame;
    frame.spin = Vec3d{unit.x(), unit.y(), unit.z()} * (angle / steps / dt_);
    stones_.spin[0] = frame.spin;
    const auto go = [&](Vec3d& place, Vec3d& velocity) {
      const Vec3d to = turned(step, place);
      velocity = (to - place) * (1 / dt_);
      place = to;
    };
    for (int n = 0; n < steps; ++n) {
      go(stones_.position[0], stones_.velocity[0]);
      go(frame.origin, frame.velocity);
      for (Vec3d* e : {&frame.ex, &frame.ey, &frame.ez}) *e = turned(step, *e);
      contacts_.evaluate<double>(stones_, wall_, dt_);
    }
  }

  Vec3d force() const { return contacts_.touch(0).action.force; }

 private:
  static constexpr double dt_ = 1;  // short against the relaxation time [s]
  ParticleStore stones_;
  Wall wall_;
  WallContacts<Law> contacts_;
};

// What the force lacks to have turned with stone and plane, / its shear part.
Vec3d turning_error_at_wall(const Vec3d& axis, double angle, int steps) {
  LoadedStone stone;
  const Vec3d before = stone.force();
  stone.turn(axis, angle, steps);
  const Eigen::AngleAxisd whole(angle, Eigen::Vector3d(axis.x, axis.y, axis.z).normalized());
  return (stone.force() - turned(whole, before)) * (1 / norm(Vec3d{before.x, before.y, 0}));
}

TEST(frame, a_carried_vector_is_turned_to_second_order) {
  // Closed form: rotation by an angle about an axis (Rodrigues 1840), for a vector of the contact
  // plane, whether it rolls over, twists, or both: the error of 1 rad in n steps falls as 1/n2.
  for (const Vec3d& axis :
       {Vec3d{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6, 0, 0.8}, {-0.6, 0.48, 0.64}}) {
    const auto error = [&](int steps) {
      const Eigen::Vector3d unit(axis.x, axis.y, axis.z);
      const Eigen::AngleAxisd step(1.0 / steps, unit), whole(1, unit);
      Contact<double> contact = {};
      contact.normal = {0, 0, 1};
      contact.turn = axis * (1.0 / steps);
      Vec3d v = {0.8, -0.6, 0};
      for (int n = 0; n < steps; ++n) {
        contact.normal = turned(step, contact.normal);
        v = carried(v, contact);
      }
      return norm(v - turned(whole, {0.8, -0.6, 0}));
    };
    EXPECT_LT(error(100), 2e-5);  // of 1/6 n2
    EXPECT_LT(error(1000), 2e-7);
  }
}

TEST(frame, a_pair_turned_as_a_rigid_body_keeps_its_forces) {
  // From the principle of frame indifference, whether the pair rolls over, twists, or both at once.
  // A chord replaces each arc, which is second order in the angle of a step; the pair is 1000 times
  // larger than what its surfaces have slid.
  for (const Vec3d& axis : {Vec3d{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, -0.3, 0.8}, {-1, 1, 0.1}}) {
    const double coarse = turning_error(axis, 2, 2000), fine = turning_error(axis, 2, 4000);
    check({"force turned with the pair, rad in 1000 steps, error / shear force", "1", coarse, 0,
           absolute(1e-3), "frame indifference"});
    EXPECT_LT(fine, coarse / 3.5 + 1e-5);  // and rounding
  }
}

TEST(frame, a_stone_and_its_plane_turned_as_a_rigid_body_keep_their_force) {
  // From the principle of frame indifference, about axes in the plane, along its normal, and
  // oblique to it. The velocity of a wall is taken where the step leaves its points, half a step
  // after that of the stone: in n steps of 1 rad in all, an oblique axis lets the stone slide by up
  // to 1/4n of its height over the wall's origin, which two steps for one tell. A chord for each
  // arc is 1/6n2 of that height, which is 320 times as far as the stone was slid: 5e-5.
  for (const Vec3d& axis : {Vec3d{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, -0.3, 0.8}, {-1, 1, 0.1}}) {
    const Vec3d coarse = turning_error_at_wall(axis, 1, 1000);
    const Vec3d fine = turning_error_at_wall(axis, 1, 2000);
    EXPECT_LT(norm(coarse), 320 / 4e3 + 1e-4);
    check({"force turned with stone and plane, 1 rad in ever more steps, error / shear force", "1",
           norm(2.0 * fine - coarse), 0, absolute(1e-4), "frame indifference"});
  }
}

TEST(frame, the_force_on_a_bound_pair_leaves_its_linear_and_angular_momentum_alone) {
  // Newton's third law: one force, of opposite sign, and torques that balance its couple; the
  // contact point lies on the line of centres, so that they do so for any shear.
  LoadedPair pair;
  pair.turn({0.5, -0.3, 0.8}, 0.3, 30);
  const SlotForce& slot = pair.slot();
  const ParticleStore& stones = pair.stones();
  Vec3d torque = {0, 0, 0};
  for (int k = 0; k < 2; ++k) torque += slot.moment * (stones.outer_radius(k) - slot.inset);
  const Vec3d apart = pair.normal() * norm(stones.position[0] - stones.position[1]);
  const Vec3d couple = cross(apart, slot.force);
  EXPECT_NEAR(norm(torque + couple) / norm(torque), 0, 1e-12);
  EXPECT_GT(norm(torque), 0);
}

}  // namespace
}  // namespace dem

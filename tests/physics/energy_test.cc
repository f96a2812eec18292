// The energy ledger: each kind of energy where a closed form knows it, on one contact.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "dem/laws/binder_energy.h"
#include "dem/laws/stone_energy.h"
#include "dem/laws/sum_energy.h"
#include "tests/physics/binder_laws.h"

namespace dem {
namespace {

using Stone = Mindlin<>;
constexpr double radius = 1e-3;  // R0 of shells and of stones [m]

// One contact moved by hand, with its book.
template <class Law>
class Booked {
 public:
  explicit Booked(const Law& law) : law_(law) {
    contact_.outer_radius = contact_.stone_radius = radius;
    contact_.mass = 1e-3;
    contact_.softness = softness_ = 1;
    contact_.normal = {0, 0, 1};
  }

  // A step of dt [s] that ends at this overlap [m], sliding by `sliding` [m].
  void move(double overlap, double dt, const Vec3d& sliding = {0, 0, 0}) {
    Contact<double> contact = contact_;
    contact.overlap = overlap;
    contact.sliding = sliding;
    contact.softness = softness_;
    law_.set_time_step(dt);
    auto memory = memory_;
    const Response<double> response = law_(contact, memory);
    losses += lost(law_, seen(), Seen<Law>{contact, memory});
    work += 0.5 * (force_.push + response.push) * (overlap - contact_.overlap) -
            0.5 * dot(force_.shear + response.shear, sliding);
    force_ = response;
    contact_ = contact;
    memory_ = memory;
  }

  void soften(double softness) { softness_ = softness; }
  Stored energy() const { return stored(law_, seen()); }
  double push() const { return force_.push; }
  double shear() const { return norm(force_.shear); }
  bool held() const { return Law::template holds<double>(memory_); }

  double work = 0;  // put into the contact [J]
  Lost losses;

 private:
  Seen<Law> seen() const { return {contact_, memory_}; }

  Law law_;
  Contact<double> contact_ = {};
  typename Law::template Memory<double> memory_ = {};
  Response<double> force_ = {};
  double softness_;
};

Stone stone(double friction) {
  return {{3.8e10}, 8e9, friction};
}

// weights of the terms that relax within 0.1 s and 2 s.
Binder<2> binder(double fast, double slow, double bond_energy = 0) {
  return {6.65e6, {fast, slow}, {0.1, 2.0}, 8.0 / 3, 1e-3, {bond_energy}};
}

double normal_factor() {
  return 8.0 / 3 * 6.65e6 * std::sqrt(radius);
}
double film_area(double h) {
  return std::numbers::pi * radius * h;
}

TEST(energy, of_a_pressed_stone_is_the_integral_of_hertz) {
  // Hertz (1882): 8/15 E0 sqrt(R) d^2.5; the trapezoidal rule over 1000 steps is right to 1e-6.
  Booked<Stone> contact(stone(0.5));
  const double d = 5e-6;
  for (int n = 1; n <= 1000; ++n) contact.move(d * n / 1000, 1e-6);
  const double hertz = 8.0 / 15 * 3.8e10 * std::sqrt(radius) * std::pow(d, 2.5);
  EXPECT_NEAR(contact.energy().stone, hertz, 1e-12 * hertz);
  EXPECT_NEAR(contact.work, hertz, 2e-6 * hertz);
  EXPECT_EQ(contact.losses.sum(), 0);
}

TEST(energy, of_a_stone_that_slides_goes_into_friction) {
  // Coulomb and Mindlin at constant overlap: a spring of stiffness k stretches until S = mu F, then
  // the rest of the way L slips: S^2 / 2k stored, S (L - S / k) lost. One step in 1000 is half of
  // each: 1e-6.
  Booked<Stone> contact(stone(0.5));
  const double d = 5e-6, way = 20e-6;
  contact.move(d, 1e-6);
  const double hertz = contact.energy().stone;
  for (int n = 0; n < 1000; ++n) contact.move(d, 1e-6, {way / 1000, 0, 0});
  const double shear = 0.5 * contact.push(), stiffness = 8 * 8e9 * std::sqrt(radius * d);
  EXPECT_NEAR(contact.shear(), shear, 1e-9 * shear);
  const double spring = shear * shear / (2 * stiffness), slip = shear * (way - shear / stiffness);
  EXPECT_NEAR(contact.energy().stone - hertz, spring, 1e-9 * hertz);
  EXPECT_NEAR(contact.losses.friction, slip, 1e-6 * slip);
  EXPECT_NEAR(contact.losses.sum(), contact.losses.friction, 1e-12 * slip);
}

TEST(energy, that_softening_frees_is_that_of_the_stiffness_lost) {
  // At constant overlap a stone left with a tenth of its stiffness keeps a tenth of the force of
  // normal and shear spring, and of what they store. Exact.
  Booked<Fracture<Stone>> contact({stone(10), 1});
  contact.move(5e-6, 1e-6);
  contact.move(5e-6, 1e-6, {1e-6, 0, 0});
  const double before = contact.energy().stone, push = contact.push(), shear = contact.shear();
  contact.soften(10);
  contact.move(5e-6, 1e-6);
  EXPECT_NEAR(contact.energy().stone, 0.1 * before, 1e-12 * before);
  EXPECT_NEAR(contact.losses.fracture, 0.9 * before, 1e-12 * before);
  EXPECT_NEAR(contact.push(), 0.1 * push, 1e-12 * push);
  EXPECT_NEAR(contact.shear(), 0.1 * shear, 1e-12 * shear);
}

TEST(energy, of_held_shells_turns_into_heat_as_their_springs_relax) {
  // At constant h each dashpot creeps as H(v) = H(h) (1 - exp(-t/tau)); what is stored is then
  // 2/5 h^2.5 + 3/5 v^2.5 - H(v) h, and nothing comes from outside. The creep begins like t^(2/3),
  // which the trapezoidal rule over 20000 steps resolves to 1e-5.
  Booked<Binder<2>> contact(binder(0.3, 0.4));
  const double h = 0.2e-3, hold = 3.0;
  contact.move(h, 0);
  const double whole = normal_factor() * 0.4 * std::pow(h, 2.5);
  EXPECT_NEAR(contact.energy().binder, whole, 1e-12 * whole);
  for (int n = 0; n < 20000; ++n) contact.move(h, hold / 20000);
  double left = 0.3;
  for (const auto& [weight, time] : {std::pair{0.3, 0.1}, {0.4, 2.0}}) {
    const double crept = -std::expm1(-hold / time);  // H(v) / H(h)
    left += weight * (1 + 1.5 * std::pow(crept, 5.0 / 3) - 2.5 * crept);
  }
  EXPECT_NEAR(contact.energy().binder, left * whole, 1e-9 * whole);
  EXPECT_NEAR(contact.losses.binder, (1 - left) * whole, 1e-5 * whole);
  EXPECT_EQ(contact.losses.sum(), contact.losses.binder);
}

TEST(energy, of_a_swinging_film_turns_into_heat_as_its_loss_modulus_says) {
  // Linear viscoelasticity: pi G'' A s0^2 / b per cycle, G'' = sum of G_i w tau / (1 + w^2 tau^2);
  // 1000 steps per cycle are right to 1e-5, the slow term has settled to exp(-20).
  Booked<Binder<2>> contact(binder(0.3, 0.4));
  const double h = 0.2e-3, swing = 1e-6, rate = 2 * std::numbers::pi / 0.5;
  contact.move(h, 0);
  const auto cycle = [&] {
    const double before = contact.losses.binder;
    for (int n = 0; n < 1000; ++n) {
      const auto at = [&](int k) { return swing * std::sin(2 * std::numbers::pi * k / 1000); };
      contact.move(h, 0.5 / 1000, {at(n + 1) - at(n), 0, 0});
    }
    return contact.losses.binder - before;
  };
  for (int n = 0; n < 80; ++n) cycle();
  double loss_modulus = 0;
  for (const auto& [weight, time] : {std::pair{0.3, 0.1}, {0.4, 2.0}})
    loss_modulus += 6.65e6 * weight * rate * time / (1 + rate * rate * time * time);
  const double lost = std::numbers::pi * loss_modulus * film_area(h) / 1e-3 * swing * swing;
  EXPECT_NEAR(cycle(), lost, 2e-5 * lost);
  EXPECT_NEAR(contact.losses.film_area, 0, 1e-12 * lost);
  EXPECT_NEAR(contact.losses.friction, 0, 1e-12 * lost);
}

TEST(energy, of_a_film_that_slips_goes_into_friction) {
  // As for a stone, with the stiffness G A / b of a film that does not relax.
  Binder<2> law = binder(0, 0);
  law.friction = 0.3;
  Booked<Binder<2>> contact(law);
  const double h = 0.2e-3, way = 2e-3;
  contact.move(h, 0);
  const double squeezed = contact.energy().binder;
  for (int n = 0; n < 1000; ++n) contact.move(h, 1e-5, {0, way / 1000, 0});
  const double shear = 0.3 * contact.push(), stiffness = 6.65e6 * film_area(h) / 1e-3;
  const double slip = shear * (way - shear / stiffness);
  ASSERT_GT(slip, 0.1 * shear * way);
  EXPECT_NEAR(contact.energy().binder - squeezed, shear * shear / (2 * stiffness), 1e-9 * slip);
  EXPECT_NEAR(contact.losses.friction, slip, 1e-6 * slip);
  EXPECT_NEAR(contact.losses.sum(), contact.losses.friction, 1e-12 * slip);
}

TEST(energy, of_a_bond_is_lost_when_it_breaks) {
  // Shells that do not relax, pulled to F_min = 3/2 pi w R0 = K |h|^1.5, store 2/5 F_min |h|. The
  // break falls into a step of 1e-3 of the way, at which the force is largest: 2.5e-3.
  Booked<Binder<2>> contact(binder(0, 0, 10));
  contact.move(1e-5, 0);
  const double pull_off = 1.5 * std::numbers::pi * 10 * radius;
  const double stretch = std::pow(pull_off / normal_factor(), 2.0 / 3);
  for (int n = 1; contact.held(); ++n) contact.move(1e-5 - stretch * n / 1000, 1e-5);
  EXPECT_NEAR(contact.losses.bond, 0.4 * pull_off * stretch, 2.5e-3 * 0.4 * pull_off * stretch);
  EXPECT_EQ(contact.losses.sum(), contact.losses.bond);
  EXPECT_EQ(contact.energy().binder, 0);
}

// First law: work = stored + lost on paths that press, pull, slide, turn back, relax, slip, break
// bonds and stones. Steps are 1e-3 of the way; 1e-3 of all the work ever done covers the
// trapezoidal rule where contacts begin, break and jump.
template <int Rings>
void expect_balance() {
  using Law = Sum<Fracture<Stone>, Binder<2, Rings>>;
  std::mt19937 engine(1);
  const auto any = [&] { return engine() / 4294967296.0; };
  for (int path = 0; path < 200; ++path) {
    Law law = {{stone(0.5), 1}, in_rings<Rings>(binder(0.3, 0.4, any() < 0.5 ? 20 : 0))};
    law.a.stone.cover = 0.1e-3 * any();
    if (any() < 0.5) law.b.friction = 0.3;
    if (Rings > 1) law.b.film = 0.1e-3;  // the paths cross all rings
    Booked<Law> contact(law);
    double overlap = 0, turnover = 0, softness = 1;
    for (int leg = 0; leg < 8; ++leg) {
      const double to = 0.11e-3 * any() - (any() < 0.3 ? 0.1e-3 : 0), from = overlap;
      const Vec3d slide = {3e-5 * (any() - 0.5), 3e-5 * (any() - 0.5), 0};
      const double dt = std::pow(10.0, -6 + 4 * any()), softer = 1 + 3 * any();
      const bool softening = any() < 0.3;
      for (int n = 1; n <= 1000; ++n) {
        if (softening) contact.soften(softness + (softer - softness) * n / 1000);
        overlap = from + (to - from) * n / 1000;
        const double before = contact.work;
        contact.move(overlap, dt, slide * 1e-3);
        turnover += std::abs(contact.work - before);
      }
      if (softening) softness = softer;
    }
    const Stored stored = contact.energy();
    const double rest = contact.work - stored.stone - stored.binder - contact.losses.sum();
    EXPECT_NEAR(rest, 0, 1e-3 * turnover) << path;
  }
}

TEST(energy, of_a_contact_balances_along_any_path) {
  expect_balance<1>();
}

TEST(energy, of_a_film_in_rings_balances_along_any_path) {
  expect_balance<16>();
}

}  // namespace
}  // namespace dem

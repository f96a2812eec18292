#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/physics/binder_laws.h"
#include "tests/physics/check.h"
#include "tests/physics/one_contact.h"

namespace dem {
namespace {

using checks::absolute, checks::at_least, checks::check, checks::relative;

constexpr double r0 = 1.4e-3;  // of two stones of 5.6 mm [m]
constexpr double deep = 1e-3;  // [m]

OneContact<Binder<2>> contact_of(const Binder<2>& law) {
  return {law, r0, r0};
}

// K G0 H of an overlap: the force of a binder that does not relax [N].
double elastic(const Binder<2>& law, double overlap) {
  return law.normal_factor * std::sqrt(r0) * law.modulus * odd_power(overlap);
}

// Largest difference between the recursion and the hereditary integral, / elastic force at `deep`.
double largest_error(const Binder<2>& law, const std::function<double(double)>& overlap,
                     double duration, int steps) {
  auto contact = contact_of(law);
  contact.move(overlap(0), 0);
  double worst = 0;
  for (int k = 1; k <= steps; ++k) {
    const double time = duration * k / steps;
    const double force = contact.move(overlap(time), duration / steps).push;
    const double exact = law.normal_factor * std::sqrt(r0) * law.modulus *
                         lee_radok(law, overlap, time, odd_power(deep));
    worst = std::max(worst, std::abs(force - exact) / elastic(law, deep));
  }
  return worst;
}

TEST(binder, a_step_of_overlap_relaxes_as_the_modulus) {
  // Closed form: F = K G(t) h^1.5 (Lee & Radok 1960). Exact but for rounding.
  for (const double phi : {0.25, 0.43, 1.0}) {
    const Binder<2> law = hot_binder(phi);
    auto contact = contact_of(law);
    const std::string name = "force of a step of overlap / K G0 h^1.5, time / s";
    const std::string source = "closed form, G(t) / G0, Lee & Radok (1960)";
    check({name, "1", contact.move(deep, 0).push / elastic(law, deep), 1, relative(1e-12), source,
           0});
    double time = 0;
    for (const double dt : {1e-6, 1e-3, 0.05, 1.0, 20.0, 500.0, 1e-4}) {
      time += dt;
      check({name, "1", contact.move(deep, dt).push / elastic(law, deep), relaxation(law, time),
             relative(1e-12), source, time});
    }
  }
}

TEST(binder, the_force_is_in_proportion_to_its_factor) {
  // From the law. That of walls is twice that of pairs: tests/unit/law_book_test.cc.
  Binder<2> twice = hot_binder(1);
  twice.normal_factor *= 2;
  auto one = contact_of(hot_binder(1)), two = contact_of(twice);
  for (int k = 1; k < 50; ++k) {
    const double h = deep * k / 50;
    check({"force of twice the factor / of the factor, overlap / m", "1",
           two.move(h, 0.01).push / one.move(h, 0.01).push, 2, relative(1e-12),
           "the law: linear in its factor", h});
  }
}

TEST(binder, the_first_touch_answers_with_the_whole_modulus) {
  // Closed form: F = 8/3 sqrt(R0) G0 h^1.5, 20.98 N at h = 1 mm, R0 = 1.4 mm, G0 = 6.65 MPa.
  check({"force at the first touch, h = 1 mm, R0 = 1.4 mm", "N",
         contact_of(hot_binder(0.43)).move(deep, 0).push, 20.983, absolute(0.001),
         "closed form, 8/3 sqrt(R0) G0 h^1.5"});
}

TEST(binder, a_ramp_ends_at_the_force_of_the_hereditary_integral) {
  // References: adaptive quadrature, F / (K G0 H) at the end of a ramp to 1 mm, given to 5 digits;
  // second order in the step, so 400 steps err by less than the last digit.
  const double duration[] = {0.05, 0.2, 1, 20};
  const double reference[] = {0.90625, 0.74044, 0.55446, 0.45575};
  const Binder<2> law = hot_binder(1);
  for (int k = 0; k < 4; ++k) {
    auto contact = contact_of(law);
    double force = 0;
    for (int n = 1; n <= 400; ++n) force = contact.move(deep * n / 400, duration[k] / 400).push;
    check({"force at the end of a ramp / K G0 h^1.5, duration / s", "1", force / elastic(law, deep),
           reference[k], absolute(1e-5), "hereditary integral by quadrature, in 400 steps",
           duration[k]});
  }
}

// Of the force at the end of a ramp to 1 mm [-].
double ramp_error(double duration, int steps) {
  const Binder<2> law = hot_binder(1);
  const auto ramp = [&](double t) { return deep * t / duration; };
  auto contact = contact_of(law);
  double force = 0;
  for (int n = 1; n <= steps; ++n) force = contact.move(deep * n / steps, duration / steps).push;
  const double exact = lee_radok(law, ramp, duration, odd_power(deep)) / odd_power(deep);
  return std::abs(force / elastic(law, deep) / exact - 1);
}

TEST(binder, a_ramp_of_100_steps_is_right_to_a_hundred_thousandth) {
  // Reference: the hereditary integral by adaptive quadrature. The recursion is exact for h^1.5
  // piecewise linear; h itself is linear here, hence a second order error.
  for (const double duration : {0.05, 0.2, 1.0, 20.0})
    check({"error of a ramp of 100 steps, duration / s", "1", ramp_error(duration, 100), 0,
           absolute(1e-5), "hereditary integral by quadrature", duration});
}

TEST(binder, halving_the_step_of_a_ramp_quarters_the_error) {
  // Reference: adaptive quadrature; order 2 in the step. The curvature of h^1.5 is infinite at the
  // start, which leaves the observed order short of 2 by a few hundredths.
  for (const double duration : {0.05, 0.2, 1.0, 20.0})
    check({"observed order of a ramp, duration / s", "1",
           std::log2(ramp_error(duration, 100) / ramp_error(duration, 200)), 2, absolute(0.1),
           "theory of the recursion", duration});
}

TEST(binder, an_oscillation_is_followed_in_modulus_and_phase) {
  // Reference: adaptive quadrature under h = 0.5 mm (1 - cos wt), from fast to slow against tau_1,
  // bonded without limit. Chords of 1/100 period miss a wave by (2 pi/100)^2/12 of its amplitude,
  // here half of `deep` of which 43 % relax: 7e-5; half the step, a quarter of that.
  const Binder<2> law = hot_binder(0.43, 1e9);
  for (const double period : {0.05, 0.5, 5.0}) {
    const auto wave = [&](double t) {
      return 0.5 * deep * (1 - std::cos(2 * std::numbers::pi * t / period));
    };
    const double coarse = largest_error(law, wave, 4 * period, 400);
    check({"largest error under a sine of 100 steps a period, period / s", "1", coarse, 0,
           absolute(1e-4), "hereditary integral by quadrature", period});
    EXPECT_LT(largest_error(law, wave, 4 * period, 800), 0.3 * coarse);
  }
}

TEST(binder, unloading_follows_the_hereditary_integral_into_tension) {
  // Reference: adaptive quadrature of a triangle h(t) of rise time tm, bonded without limit.
  for (const double phi : {0.25, 0.43, 1.0})
    for (const double rise : {0.1, 0.5}) {
      const auto triangle = [&](double t) { return deep * (1 - std::abs(1 - t / rise)); };
      check({"largest error of loading and unloading, rise time / s", "1",
             largest_error(hot_binder(phi, 1e9), triangle, 2.2 * rise, 440), 0, absolute(1e-5),
             "hereditary integral by quadrature", rise});
    }
}

TEST(binder, the_spurious_tension_of_lee_and_radok_is_as_large_as_known) {
  // Reference: quadrature with phi = 1, 150 degC, triangle of rise time tm: F turns tensile at
  // 1.64 and 1.66 tm, and falls to -0.19 and -0.10 of its maximum for tm = 0.1 s and 0.5 s, given
  // to two digits.
  const double rise[] = {0.1, 0.5}, turn[] = {1.64, 1.66}, least[] = {-0.19, -0.10};
  for (int k = 0; k < 2; ++k) {
    auto contact = contact_of(hot_binder(1, 1e9));
    double most = 0, lowest = 0, turned = 0;
    for (int n = 1; n <= 1000; ++n) {
      const double t = rise[k] * n / 500;
      const double force = contact.move(deep * (1 - std::abs(1 - t / rise[k])), rise[k] / 500).push;
      most = std::max(most, force);
      lowest = std::min(lowest, force);
      if (force < 0 && turned == 0) turned = t / rise[k];
    }
    check({"bitumen alone: time / rise time at which the force turns tensile, rise time / s", "1",
           turned, turn[k], absolute(0.006), "quadrature, two digits", rise[k]});
    check({"bitumen alone: least / largest force of a triangle, rise time / s", "1", lowest / most,
           least[k], absolute(0.006), "quadrature, two digits", rise[k]});
  }
}

TEST(binder, a_change_of_step_in_mid_run_does_no_harm) {
  // Reference: adaptive quadrature of a ramp, a rest and a retreat taken with steps that jump by
  // factors of 1000; the largest step, 1/100 of a ramp, sets the accuracy.
  const Binder<2> law = hot_binder(0.43, 1e9);
  const auto overlap = [](double t) {
    return deep * (std::min(t, 0.2) - 0.5 * std::max(0.0, t - 0.5)) / 0.2;
  };
  auto contact = contact_of(law);
  double time = 0;
  for (int n = 0; time < 0.7; ++n) {
    const double dt = n % 3 == 0 ? 2e-3 : n % 3 == 1 ? 2e-6 : 1e-4;
    time += dt;
    const double force = contact.move(overlap(time), dt).push;
    if (n % 20) continue;
    const double exact = law.normal_factor * std::sqrt(r0) * law.modulus *
                         lee_radok(law, overlap, time, odd_power(deep));
    check({"force / K G0 h^1.5, step changing by factors of 1000, time / s", "1",
           force / elastic(law, deep), exact / elastic(law, deep), absolute(1e-5),
           "hereditary integral by quadrature", time});
  }
}

TEST(binder, fast_loading_is_glassy_and_slow_loading_relaxed) {
  // Closed form: F / (K H) -> G0 for dt << tau_i, -> G0 (1 - sum A_i) for dt >> tau_i; the rest is
  // of order duration / tau_1 and tau_2 / duration.
  const Binder<2> law = hot_binder(0.43);
  const auto end_of_ramp = [&](double duration) {
    auto contact = contact_of(law);
    double force = 0;
    for (int n = 1; n <= 100; ++n) force = contact.move(deep * n / 100, duration / 100).push;
    return force / elastic(law, deep);
  };
  check({"force / K G0 h^1.5 of a ramp within 1e-8 s", "1", end_of_ramp(1e-8), 1, absolute(1e-7),
         "closed form, glassy limit"});
  check({"force / K G0 h^1.5 of a ramp within 1e10 s", "1", end_of_ramp(1e10), 1 - 0.43,
         absolute(1e-7), "closed form, relaxed limit"});
}

Binder<2> binder_with_film(double thickness) {
  Binder<2> law = hot_binder(0.43, 1e4);
  law.film = thickness;
  return law;
}

// Against pressing, stretching and sliding further, in steps that take no time, from a contact at
// this overlap [N/m].
struct Slopes {
  double normal, shear;
};

Slopes slopes_of(const OneContact<Binder<2>>& contact, double overlap) {
  const double step = 1e-4 * std::abs(overlap);
  const auto after = [&](double rise, double sliding) {
    OneContact<Binder<2>> copy = contact;
    return copy.move(overlap + rise, 0, {sliding, 0, 0});
  };
  return {(after(step, 0).push - after(-step, 0).push) / (2 * step),
          (after(0, -step).shear.x - after(0, step).shear.x) / (2 * step)};
}

// Pressed, then held at this overlap for a time.
OneContact<Binder<2>> contact_at(const Binder<2>& law, double overlap, double time) {
  auto contact = contact_of(law);
  contact.move(deep, 0);
  contact.move(overlap, 0);
  contact.move(overlap, time);
  return contact;
}

TEST(binder, the_reported_stiffness_is_the_steepest_slope_of_the_force) {
  // Central differences over 1e-4 h, whose own error is 4e-10. A thick film is stiffer against
  // pressing, a thin one against sliding, and relaxation softens neither against a quick step.
  for (const double time : {0.0, 1.0, 1e4})
    for (const double overlap : {0.05e-3, 0.15e-3})
      for (const double film : {0.2e-3, 1e-3}) {
        auto contact = contact_at(binder_with_film(film), overlap, time);
        const auto [normal, shear] = slopes_of(contact, overlap);
        EXPECT_EQ(shear > normal, film == 0.2e-3) << film << ' ' << overlap;
        check({"reported stiffness / steepest slope of the force, overlap / m", "1",
               contact.move(overlap, 0).stiffness / std::max(normal, shear), 1, relative(1e-8),
               "central difference", overlap});
      }
}

TEST(binder, a_stretched_bond_is_reported_no_softer_than_it_is) {
  // Central difference, as above. A stretched bond has no film, which the law counts all the same:
  // too stiff where the film is thin, exact where it is thick.
  constexpr double overlap = -0.15e-3;
  for (const double time : {0.0, 1.0, 1e4}) {
    auto thin = contact_at(binder_with_film(0.2e-3), overlap, time);
    auto thick = contact_at(binder_with_film(1e-3), overlap, time);
    EXPECT_TRUE(thin.held() && thick.held());
    for (const auto& bond : {thin, thick}) EXPECT_EQ(slopes_of(bond, overlap).shear, 0);
    check({"reported stiffness / slope of a stretched bond, thin film", "1",
           thin.move(overlap, 0).stiffness / slopes_of(thin, overlap).normal, 1, at_least,
           "central difference"});
    check({"reported stiffness / slope of a stretched bond, thick film", "1",
           thick.move(overlap, 0).stiffness / slopes_of(thick, overlap).normal, 1, relative(1e-8),
           "central difference"});
  }
}

TEST(binder, shells_that_approach_are_reported_as_stiff_as_they_will_be_at_the_horizon) {
  // From the promise of dem/contact.h: shells at h that approach at v are as stiff as those at rest
  // at h + v x horizon; shells that part, as they are.
  constexpr double horizon = 2e-3;  // [s]
  for (const double film : {0.2e-3, 1e-3}) {
    Binder<2> law = binder_with_film(film);
    law.set_time_step(1e-6);
    const auto stiffness = [&](double overlap, double closing) {
      Contact<double> contact = {};
      contact.overlap = overlap;
      contact.outer_radius = r0;
      contact.normal = {0, 0, 1};
      contact.closing = closing;
      contact.horizon = horizon;
      Binder<2>::Memory<double> memory = {};
      return law(contact, memory).stiffness;
    };
    const double at_rest = stiffness(0.5e-3, 0);
    for (const double overlap : {-0.1e-3, 0.3e-3})
      check({"stiffness reported of shells that approach / at rest where they get to, overlap / m",
             "1", stiffness(overlap, (0.5e-3 - overlap) / horizon) / at_rest, 1, relative(1e-12),
             "the promise of dem/contact.h", overlap});
    EXPECT_EQ(stiffness(0.5e-3, -0.1), at_rest);
    EXPECT_EQ(stiffness(-0.5e-3, 0.1), 0);  // 0.3 mm apart by then
  }
}

TEST(binder, a_pair_that_never_touched_feels_nothing) {
  // From the definition of a bond: shells stick only after they were pressed.
  auto contact = contact_of(hot_binder(0.43, 1e4));
  for (const double gap : {1e-3, 1e-4, 1e-6}) {
    EXPECT_EQ(contact.move(-gap, 1e-3).push, 0);
    EXPECT_FALSE(contact.held());
  }
  EXPECT_NEAR(contact.move(deep, 0).push / elastic(hot_binder(1), deep), 1, 1e-12);
}

}  // namespace
}  // namespace dem

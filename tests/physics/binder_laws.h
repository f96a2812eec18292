// The binder of the tests: that of the source at 150 degC, and the hereditary integral itself by
// adaptive quadrature as a slow and obvious reference for the recursion.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "dem/laws/binder.h"

namespace dem {

inline constexpr double pair_factor = 8.0 / 3.0, wall_factor = 16.0 / 3.0;

// Olsson, Jelagin, Partl, Table 1, 150 degC.
inline Binder<2> hot_binder(double bitumen_fraction, double bond_energy = 0) {
  return {6.65e6,
          {bitumen_fraction * 0.513, bitumen_fraction * 0.487},
          {0.0948, 105.9},
          pair_factor,
          1e-3,
          {bond_energy}};
}

// The same shells with a film that is remembered in rings.
template <int Rings = 16, int Terms>
Binder<Terms, Rings> in_rings(const Binder<Terms>& even) {
  return {even.modulus, even.weight, even.time,    even.normal_factor,
          even.film,    even.bond,   even.friction};
}

// G(t) / G0.
inline double relaxation(const Binder<2>& law, double time) {
  double sum = 1;
  for (int i = 0; i < 2; ++i) sum += law.weight[i] * std::expm1(-time / law.time[i]);
  return sum;
}

// Adaptive Simpson rule to the absolute accuracy `tolerance`.
inline double integral(const std::function<double(double)>& f, double from, double to,
                       double tolerance) {
  const auto simpson = [](double a, double b, double fa, double fm, double fb) {
    return (b - a) / 6 * (fa + 4 * fm + fb);
  };
  const std::function<double(double, double, double, double, double, double, double)> refine =
      [&](double a, double b, double fa, double fm, double fb, double whole, double accuracy) {
        const double m = 0.5 * (a + b);
        const double fl = f(0.5 * (a + m)), fr = f(0.5 * (m + b));
        const double left = simpson(a, m, fa, fl, fm), right = simpson(m, b, fm, fr, fb);
        const double error = (left + right - whole) / 15;
        if (std::abs(error) < accuracy || b - a < 1e-12 * (to - from)) return left + right + error;
        return refine(a, m, fa, fl, fm, left, accuracy / 2) +
               refine(m, b, fm, fr, fb, right, accuracy / 2);
      };
  if (to <= from) return 0;
  const double fa = f(from), fm = f(0.5 * (from + to)), fb = f(to);
  return refine(from, to, fa, fm, fb, simpson(from, to, fa, fm, fb), tolerance);
}

// h^1.5 carried to negative h as an odd function.
inline double odd_power(double h) {
  return std::copysign(std::pow(std::abs(h), 1.5), h);
}

// Lee & Radok (1960): F / (K G0) = H(t) + int_0^t G'(t - s)/G0 H(s) ds, the hereditary integral
// after partial integration, whose integrand is smooth wherever h(t) is [m^1.5].
inline double lee_radok(const Binder<2>& law, const std::function<double(double)>& overlap,
                        double time, double scale) {
  const auto lost = [&](double s) {
    double rate = 0;
    for (int i = 0; i < 2; ++i)
      rate += law.weight[i] / law.time[i] * std::exp(-(time - s) / law.time[i]);
    return rate * odd_power(overlap(s));
  };
  double sum = 0;
  constexpr int pieces = 13;  // in step with no oscillation of a test
  for (int k = 0; k < pieces; ++k)
    sum += integral(lost, time * k / pieces, time * (k + 1) / pieces, 1e-12 * scale);
  return odd_power(overlap(time)) - sum;
}

}  // namespace dem

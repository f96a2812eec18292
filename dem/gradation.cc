#include "dem/gradation.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>

#include "dem/random.h"

namespace dem {
namespace {

double cube(double x) {
  return x * x * x;
}

// The piece [node[k], node[k + 1]] of a rising grid that holds x.
std::size_t piece_of(const std::vector<double>& node, double x) {
  const auto above = std::upper_bound(node.begin() + 1, node.end() - 1, x);
  return static_cast<std::size_t>(above - node.begin()) - 1;
}

double log_interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const std::size_t k = piece_of(x, at);
  return y[k] + (y[k + 1] - y[k]) * std::log(at / x[k]) / std::log(x[k + 1] / x[k]);
}

// The sieve curve of the stones alone, from (smallest, 0) to (largest, 1).
struct StoneCurve {
  std::vector<double> diameter;    // [m]
  std::vector<double> mass_finer;  // [-]
};

StoneCurve stone_curve(const SieveTable& table, double smallest) {
  const double fines = passing_at(table, smallest);
  assert(fines < 1);
  StoneCurve curve{{smallest}, {0}};
  for (std::size_t k = 0; curve.mass_finer.back() < 1; ++k) {
    assert(k < table.sieve.size());
    if (table.sieve[k] <= smallest) continue;
    curve.diameter.push_back(table.sieve[k]);
    curve.mass_finer.push_back((table.passing[k] - fines) / (1 - fines));
  }
  return curve;
}

// `mass_finer` is that of the stones.
template <class MassFiner>
Departure largest_departure(const SieveTable& table, double smallest, const MassFiner& mass_finer) {
  const double fines = passing_at(table, smallest);
  Departure largest;
  for (std::size_t k = 0; k < table.sieve.size(); ++k) {
    if (table.sieve[k] <= smallest) continue;
    const double found = fines + (1 - fines) * mass_finer(table.sieve[k]);
    if (largest.sieve == 0 ||
        std::abs(found - table.passing[k]) > std::abs(largest.found - largest.asked))
      largest = {table.sieve[k], table.passing[k], found};
  }
  return largest;
}

double mass_quantile(const StoneCurve& curve, double share) {
  const std::size_t k = piece_of(curve.mass_finer, share);
  const double a = curve.mass_finer[k], b = curve.mass_finer[k + 1];
  return curve.diameter[k] *
         std::pow(curve.diameter[k + 1] / curve.diameter[k], (share - a) / (b - a));
}

// (1 - Phi(z)) / phi(z) of a standard normal, z >= 5: Laplace's continued fraction (Abramowitz,
// Stegun (1964), 26.2.14), whose 40 terms are exact to rounding there.
double mills_ratio(double z) {
  double tail = z;
  for (int term = 40; term > 0; --term) tail = z + term / tail;
  return 1 / tail;
}

// The share of a standard normal cut to [a, b] that lies below x. A fit to a curve that only falls
// or only rises drives the whole interval far into one tail, where plain differences vanish.
double share_below(double x, double a, double b) {
  if (b < 0) return 1 - share_below(-x, -b, -a);
  if (a < 5) {
    const auto above = [](double z) { return std::erfc(z / std::numbers::sqrt2); };
    return (above(a) - above(x)) / (above(a) - above(b));
  }
  const auto above = [a](double z) { return std::exp((a - z) * (a + z) / 2) * mills_ratio(z); };
  return (above(a) - above(x)) / (above(a) - above(b));
}

// A normal cut to the curve as a function of (mean / d, ln(deviation / d)), d being the largest
// diameter: two numbers free of units and of sign conditions.
using Shape = std::array<double, 2>;

TruncatedNormal normal_of(const Shape& shape, const StoneCurve& curve) {
  const double largest = curve.diameter.back();
  return {shape[0] * largest, std::exp(shape[1]) * largest, curve.diameter.front(), largest};
}

std::vector<double> misfit(const Shape& shape, const StoneCurve& curve) {
  const TruncatedNormal normal = normal_of(shape, curve);
  std::vector<double> residual;
  for (std::size_t k = 0; k < curve.diameter.size(); ++k) {
    residual.push_back(normal.mass_finer(curve.diameter[k]) - curve.mass_finer[k]);
  }
  return residual;
}

// How the misfit changes with one number of the shape, by central differences.
std::vector<double> slope_of_misfit(const Shape& shape, const StoneCurve& curve, int number) {
  constexpr double step = 1e-5;  // errs by step^2
  Shape up = shape, down = shape;
  up[number] += step;
  down[number] -= step;
  std::vector<double> slope = misfit(up, curve);
  const std::vector<double> below = misfit(down, curve);
  for (std::size_t k = 0; k < slope.size(); ++k) slope[k] = (slope[k] - below[k]) / (2 * step);
  return slope;
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// Least squares by damped Gauss-Newton steps, Marquardt (1963), from a first guess.
Shape least_squares(Shape shape, const StoneCurve& curve) {
  std::vector<double> residual = misfit(shape, curve);
  double damping = 1e-3;
  for (int step = 0; step < 1000 && damping < 1e9; ++step) {
    const auto slope0 = slope_of_misfit(shape, curve, 0);
    const auto slope1 = slope_of_misfit(shape, curve, 1);
    const double a00 = (1 + damping) * product(slope0, slope0), a01 = product(slope0, slope1);
    const double a11 = (1 + damping) * product(slope1, slope1);
    const double b0 = product(slope0, residual), b1 = product(slope1, residual);
    const double determinant = a00 * a11 - a01 * a01;
    const Shape next = {shape[0] - (a11 * b0 - a01 * b1) / determinant,
                        shape[1] - (a00 * b1 - a01 * b0) / determinant};
    const std::vector<double> next_residual = misfit(next, curve);
    const double gain = product(residual, residual) - product(next_residual, next_residual);
    if (!(gain > 0)) {
      damping *= 10;
      continue;
    }
    shape = next;
    residual = next_residual;
    damping /= 10;
  }
  return shape;
}

}  // namespace

double passing_at(const SieveTable& table, double diameter) {
  assert(table.sieve.size() == table.passing.size() && table.sieve.size() >= 2);
  assert(table.sieve.front() <= diameter && diameter <= table.sieve.back());
  return log_interpolate(table.sieve, table.passing, diameter);
}

SizeDistribution::SizeDistribution(std::vector<double> diameter, std::vector<double> mass_finer)
    : diameter_(std::move(diameter)), mass_finer_(std::move(mass_finer)) {
  assert(diameter_.size() == mass_finer_.size() && diameter_.size() >= 2);
  assert(mass_finer_.front() == 0 && mass_finer_.back() == 1);
  number_finer_ = {0};
  for (std::size_t k = 0; k + 1 < diameter_.size(); ++k) {
    const double a = diameter_[k], b = diameter_[k + 1];
    const double mass = mass_finer_[k + 1] - mass_finer_[k];
    assert(a < b && mass >= 0);
    const double number = mass / (3 * std::log(b / a)) * (1 / cube(a) - 1 / cube(b));
    number_finer_.push_back(number_finer_.back() + number);
  }
  number_per_volume_ = number_finer_.back();
  for (double& number : number_finer_) number /= number_per_volume_;
}

double SizeDistribution::mass_finer(double diameter) const {
  return log_interpolate(diameter_, mass_finer_, std::clamp(diameter, smallest(), largest()));
}

double SizeDistribution::number_finer(double diameter) const {
  const double d = std::clamp(diameter, smallest(), largest());
  const std::size_t k = piece_of(diameter_, d);
  const double at_a = 1 / cube(diameter_[k]), at_b = 1 / cube(diameter_[k + 1]);
  const double share = (at_a - 1 / cube(d)) / (at_a - at_b);
  return number_finer_[k] + share * (number_finer_[k + 1] - number_finer_[k]);
}

double SizeDistribution::quantile(double share) const {
  assert(0 <= share && share <= 1);
  const std::size_t k = piece_of(number_finer_, share);
  const double a = diameter_[k], b = diameter_[k + 1];
  const double number = number_finer_[k + 1] - number_finer_[k];
  const double local = number > 0 ? (share - number_finer_[k]) / number : 0;
  const double d = 1 / std::cbrt((1 - local) / cube(a) + local / cube(b));
  return std::clamp(d, a, b);
}

double SizeDistribution::mean_diameter() const {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < diameter_.size(); ++k) {
    const double a = diameter_[k], b = diameter_[k + 1];
    const double mass = mass_finer_[k + 1] - mass_finer_[k];
    sum += mass / (2 * std::log(b / a)) * (1 / (a * a) - 1 / (b * b));
  }
  return sum / number_per_volume_;
}

double SizeDistribution::mean_volume() const {
  return std::numbers::pi / 6 / number_per_volume_;
}

SizeDistribution log_linear(const SieveTable& table, double smallest) {
  StoneCurve curve = stone_curve(table, smallest);
  return {std::move(curve.diameter), std::move(curve.mass_finer)};
}

double TruncatedNormal::mass_finer(double diameter) const {
  const auto reduced = [this](double d) { return (d - mean) / deviation; };
  return share_below(reduced(diameter), reduced(smallest), reduced(largest));
}

TruncatedNormal fit_truncated_normal(const SieveTable& table, double smallest) {
  const StoneCurve curve = stone_curve(table, smallest);
  const double largest = curve.diameter.back();
  const double below = mass_quantile(curve, 0.16), above = mass_quantile(curve, 0.84);
  const Shape guess = {mass_quantile(curve, 0.5) / largest,
                       std::log((above - below) / (2 * largest))};
  return normal_of(least_squares(guess, curve), curve);
}

SizeDistribution truncated_normal(const TruncatedNormal& normal) {
  constexpr int pieces = 4000;  // log-linear pieces follow the normal to about 1e-7
  std::vector<double> diameter{normal.smallest}, mass_finer{0};
  const double ratio = normal.largest / normal.smallest;
  for (int k = 1; k < pieces; ++k) {
    diameter.push_back(normal.smallest * std::pow(ratio, static_cast<double>(k) / pieces));
    mass_finer.push_back(normal.mass_finer(diameter.back()));
  }
  diameter.push_back(normal.largest);
  mass_finer.push_back(1);
  return {std::move(diameter), std::move(mass_finer)};
}

std::vector<double> draw_diameters(const SizeDistribution& distribution, int count,
                                   std::uint64_t seed) {
  std::vector<double> diameter(count);
  for (int k = 0; k < count; ++k) {
    diameter[k] = distribution.quantile((k + uniform(seed, Purpose::size, k)) / count);
  }
  return diameter;
}

Departure largest_departure(const SieveTable& table, const SizeDistribution& distribution) {
  return largest_departure(table, distribution.smallest(),
                           [&](double d) { return distribution.mass_finer(d); });
}

Departure largest_departure(const SieveTable& table, double smallest,
                            const std::vector<double>& diameters) {
  const auto mass_below = [&](double limit) {
    double mass = 0;
    for (const double d : diameters)
      if (d <= limit) mass += cube(d);
    return mass;
  };
  const double all = mass_below(table.sieve.back());
  return largest_departure(table, smallest, [&](double d) { return mass_below(d) / all; });
}

}  // namespace dem

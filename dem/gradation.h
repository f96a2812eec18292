// From a sieve curve (mass) to the diameters of single stones (number).
//
// Stones finer than `smallest` belong to the binder phase. What is left has the mass distribution
// C(d) = (P(d) - P(smallest)) / (1 - P(smallest)), P being the mass fraction passing the sieve d.
// Between the sieves the curve is either log-linear or a fitted truncated normal; the choice
// decides the number of stones (SMA 11: a mean volume of 57 against 125 mm3).
#pragma once

#include <cstdint>
#include <vector>

namespace dem {

struct SieveTable {
  std::vector<double> sieve;    // opening [m], rising
  std::vector<double> passing;  // mass fraction finer [-], not falling, 1 at the last sieve
};

// Log-linear between sieves; the diameter [m] lies between the first and the last of them.
double passing_at(const SieveTable& table, double diameter);

// A curve of mass finer against diameter, log-linear between its nodes: within a piece of mass w
// between a and b, the mass density is f_m = w / (d ln(b/a)) and the number density f_m / d^3.
class SizeDistribution {
 public:
  // `mass_finer` rises from 0 at the first node to 1 at the last.
  SizeDistribution(std::vector<double> diameter, std::vector<double> mass_finer);

  double smallest() const { return diameter_.front(); }  // [m]
  double largest() const { return diameter_.back(); }    // [m]

  double mass_finer(double diameter) const;    // share of the mass below a diameter [-]
  double number_finer(double diameter) const;  // share of the stones below a diameter [-]
  double quantile(double share) const;  // diameter below which a share of the stones lies [m]

  double mean_diameter() const;  // over the stones [m]
  double mean_volume() const;    // over the stones [m3]

 private:
  std::vector<double> diameter_;      // [m]
  std::vector<double> mass_finer_;    // [-]
  std::vector<double> number_finer_;  // [-]
  double number_per_volume_;          // integral of f_m / d^3 [1/m3]
};

SizeDistribution log_linear(const SieveTable& table, double smallest);

// A normal density of mass, cut off at both ends (Olsson, Jelagin, Partl).
struct TruncatedNormal {
  double mean;       // of the normal before it is cut [m]
  double deviation;  // of the normal before it is cut [m]
  double smallest;   // [m]
  double largest;    // [m]

  double mass_finer(double diameter) const;
};

// Least squares on C(d) at the sieves between `smallest` and the first sieve that all stones pass.
TruncatedNormal fit_truncated_normal(const SieveTable& table, double smallest);

SizeDistribution truncated_normal(const TruncatedNormal& normal);

// Diameters in rising order. One stone is drawn from each of `count` equal shares of the number
// distribution: a few large stones hold most of the mass, and with independent draws their number,
// and with it the whole curve, would scatter by several percent from seed to seed.
std::vector<double> draw_diameters(const SizeDistribution& distribution, int count,
                                   std::uint64_t seed);

// What passes a sieve of the table: mass fractions of the mix, its fines included.
struct Departure {
  double sieve = 0;             // [m]
  double asked = 0, found = 0;  // [-]
};

// At the sieve where a distribution, or single stones, depart most from their table.
Departure largest_departure(const SieveTable& table, const SizeDistribution& distribution);
Departure largest_departure(const SieveTable& table, double smallest,
                            const std::vector<double>& diameters);

}  // namespace dem

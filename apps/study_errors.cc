#include "apps/study_errors.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>

#include "apps/history_file.h"

namespace apps {
namespace {

// The value at x of a curve whose abscissa rises.
double at(const std::vector<double>& abscissa, const std::vector<double>& values, double x) {
  const auto above = std::ranges::lower_bound(abscissa, x);
  if (above == abscissa.begin()) return values.front();
  if (above == abscissa.end()) return values.back();
  const auto k = static_cast<std::size_t>(above - abscissa.begin());
  const double part = (x - abscissa[k - 1]) / (abscissa[k] - abscissa[k - 1]);
  return values[k - 1] + part * (values[k] - values[k - 1]);
}

// By least squares over points as far apart in decades, after the first half unit.
std::vector<double> slope_per_decade(const std::vector<double>& abscissa,
                                     const std::vector<double>& values) {
  constexpr double settling = 0.5;
  const auto from = std::ranges::upper_bound(abscissa, settling);
  if (from == abscissa.end() || *from == abscissa.back()) return {};
  const double decades = std::log10(abscissa.back() / *from);
  double xx = 0, xy = 0;
  for (int k = 0; k < curve_points; ++k) {
    const double x = decades * (k / (curve_points - 1.0) - 0.5);  // about the middle
    xx += x * x;
    xy += x * at(abscissa, values, *from * std::pow(10, x + 0.5 * decades));
  }
  return {xy / xx};
}

std::vector<double> points_of(const Quantity& quantity, const std::vector<double>& abscissa,
                              const std::vector<double>& values) {
  switch (quantity.take) {
    case Quantity::last:
      return {values.back()};
    case Quantity::largest:
      return {std::ranges::max(values)};
    case Quantity::smallest:
      return {std::ranges::min(values)};
    case Quantity::mean:
      return {std::accumulate(values.begin(), values.end(), 0.0) /
              static_cast<double>(values.size())};
    case Quantity::per_decade:
      return slope_per_decade(abscissa, values);
    case Quantity::curve:
      break;
  }
  std::vector<double> points;
  for (int k = 1; k <= curve_points; ++k)
    points.push_back(at(abscissa, values, abscissa.back() * k / curve_points));
  return points;
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// By point, over the seeds.
struct Statistics {
  std::vector<double> mean, deviation;
};

Statistics statistics(const BySeed& runs) {
  const auto n = static_cast<double>(runs.size());
  const std::size_t points = runs.begin()->second.size();
  Statistics of = {std::vector<double>(points, 0), std::vector<double>(points, 0)};
  for (const auto& [seed, run] : runs)
    for (std::size_t k = 0; k < points; ++k) of.mean[k] += run[k] / n;
  for (const auto& [seed, run] : runs)
    for (std::size_t k = 0; k < points; ++k)
      of.deviation[k] += (run[k] - of.mean[k]) * (run[k] - of.mean[k]) / (n - 1);
  for (double& square : of.deviation) square = std::sqrt(square);
  return of;
}

// What the mean over a few runs may be off by, in its standard errors, in 19 of 20 cases.
double student(double freedom) {
  return boost::math::quantile(boost::math::students_t(freedom), 0.975);
}

bool has_none(const BySeed& runs) {
  return std::ranges::all_of(runs, [](const auto& run) {
    return std::ranges::all_of(run.second, [](double point) { return point == 0; });
  });
}

// In n runs of the setting and of the reference, told in parts of a size.
Judgement none_in(std::size_t n, double size) {
  return {0, 0, 3 / (static_cast<double>(n) * size), true, static_cast<int>(n)};
}

bool lacks(const BySeed& runs) {
  return runs.size() < 2 ||
         std::ranges::any_of(runs, [](const auto& run) { return run.second.empty(); });
}

}  // namespace

Interest interest_of(const std::string& program) {
  using enum Quantity::Take;
  constexpr double percent = 0.01, per_mille = 1e-3, millimetre = 1e-3, kilopascal = 1e3;
  if (program == "flow_test")
    return {"displacement",
            {{"pressure, curve", "pressure", curve, kilopascal},
             {"pressure, peak", "pressure", largest, kilopascal},
             {"uplift, curve", "uplift", curve, millimetre},
             {"uplift, end", "uplift", last, millimetre},
             {"fractured stones", "fractured", last, 1},
             {"coordination", "coordination", last, 1}}};
  return {"gyration",
          {{"air-void decrease, curve", "air_voids_decrease", curve, per_mille},
           {"air-void decrease per decade", "air_voids_decrease", per_decade, per_mille},
           {"air voids, end", "air_voids", last, percent},
           {"height, end", "height", last, millimetre},
           {"internal angle", "internal_angle", mean, percent},
           {"mould traction, mean", "mould_traction", mean, kilopascal},
           {"mould traction, peak", "mould_traction", largest, kilopascal},
           {"fractured stones", "fractured", last, 1},
           {"coordination", "coordination", last, 1}}};
}

Found read_found(const std::string& results, const Interest& interest) {
  const HistoryFile file(results);
  const std::vector<double> whole = file.column(interest.abscissa);
  // From where the abscissa begins to rise: before, a machine only takes up its load.
  const auto begin = std::ranges::find_if(whole, [](double x) { return x > 0; }) - whole.begin();
  const std::vector<double> abscissa(whole.begin() + begin, whole.end());
  Found found;
  for (const Quantity& quantity : interest.quantities) {
    found.emplace_back();
    if (!file.has(quantity.column) || abscissa.empty()) continue;
    const std::vector<double> column = file.column(quantity.column);
    found.back() = points_of(quantity, abscissa, {column.begin() + begin, column.end()});
  }
  return found;
}

Judgement judge(const BySeed& setting, const BySeed& reference, double least_size) {
  BySeed difference, expected;
  for (const auto& [seed, points] : reference) {
    const auto found = setting.find(seed);
    if (found == setting.end()) continue;
    if (found->second.size() != points.size()) return {};
    expected[seed] = points;
    std::ranges::transform(found->second, points, std::back_inserter(difference[seed]),
                           std::minus<>());
  }
  if (lacks(expected)) return {};
  if (has_none(expected) && has_none(difference)) return none_in(expected.size(), least_size);
  const double size = std::max(rms(statistics(expected).mean), least_size);
  const auto [mean, deviation] = statistics(difference);
  const auto n = static_cast<double>(difference.size());
  const int sign = mean.size() > 1 ? 0 : mean.front() < 0 ? -1 : 1;
  return {rms(mean) / size, sign, student(n - 1) / std::sqrt(n) * rms(deviation) / size, true};
}

Judgement scatter(const BySeed& reference, double least_size) {
  if (lacks(reference)) return {};
  if (has_none(reference)) return none_in(reference.size(), least_size);
  const auto [mean, deviation] = statistics(reference);
  const auto n = static_cast<double>(reference.size());
  const double size = std::max(rms(mean), least_size);
  return {0, 0, student(2 * n - 2) * std::sqrt(2 / n) * rms(deviation) / size, true};
}

}  // namespace apps

#include <cmath>
#include <functional>
#include <numbers>

#include "apps/steel_answers.h"
#include "apps/stress_cases.h"
#include "apps/stress_theory.h"

namespace apps {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using Pressure =
    std::function<double(const Vector3d&)>;  // on the inner face, at a point [m] -> [Pa]

constexpr const char* lame_source = "Lame, free ends (Timoshenko & Goodier 1970, 28)";

double radius_of(const Vector3d& x) {
  return std::hypot(x[0], x[1]);
}

Vector3d outwards(const Vector3d& x) {
  return Vector3d(x[0], x[1], 0) / radius_of(x);
}

// The mould under a pressure, solved.
class LoadedMould {
 public:
  LoadedMould(const StressCase& given, Pressure pressure)
      : mould_(given.mould), body_(given.mould, given.mesh), pressure_(std::move(pressure)) {
    displacement_ = body_.solve(
        body_.face_load([&](const Vector3d& x) -> Vector3d { return pressure_(x) * outwards(x); }));
    hoop_ = hoop_stress(body_, displacement_);
  }

  // Mean over the nodes at a radius [m], on the level of nodes nearest to a height [m].
  double hoop_at(double radius, double height) const {
    const auto& nodes = body_.nodes();
    const auto on_surface = [&](Eigen::Index i) {
      return std::abs(radius_of(nodes.col(i)) - radius) < 1e-3 * mould_.wall_thickness;
    };
    double nearest = INFINITY;
    for (Eigen::Index i = 0; i < nodes.cols(); ++i)
      if (on_surface(i)) nearest = std::min(nearest, std::abs(nodes(2, i) - height));
    double sum = 0;
    int count = 0;
    for (Eigen::Index i = 0; i < nodes.cols(); ++i)
      if (on_surface(i) && std::abs(nodes(2, i) - height) < nearest + 1e-6 * mould_.height) {
        sum += hoop_[i];
        ++count;
      }
    return sum / count;
  }

  // Component cos(n angle) of the inner face's radial displacement at a height [m], by sums over
  // the circle that are exact for n + n' < 48.
  double growth_at(double height, int n) const {
    constexpr int samples = 48;
    double sum = 0;
    for (int k = 0; k < samples; ++k) {
      const double angle = 2 * std::numbers::pi * k / samples, inner = mould_.inner_diameter / 2;
      const Vector3d place(inner * std::cos(angle), inner * std::sin(angle), height);
      const Vector3d moved = body_.face_displacement(displacement_, place);
      sum += std::cos(n * angle) * (n == 0 ? 1.0 : 2.0) / samples * moved.dot(outwards(place));
    }
    return sum;
  }

  StressReport report(std::vector<StressRow> rows) const {
    StressReport report{std::move(rows), loaded_body(body_, displacement_), {}};
    const double inner = mould_.inner_diameter / 2;
    for (Eigen::Index i = 0; i < body_.nodes().cols(); ++i) {
      const Vector3d x = body_.nodes().col(i);
      if (std::abs(radius_of(x) - inner) > 1e-3 * mould_.wall_thickness) continue;
      report.map.push_back({std::atan2(x[1], x[0]), x[2], pressure_(x), hoop_[i]});
    }
    return report;
  }

 private:
  fem::Mould mould_;
  fem::ElasticBody body_;
  Pressure pressure_;
  VectorXd displacement_, hoop_;  // (unknowns) [m], (nodes) [Pa]
};

StressReport press_everywhere(const StressCase& given) {
  const fem::Mould& mould = given.mould;
  const double p = given.load.pressure, middle = mould.height / 2;
  const LoadedMould loaded(given, [p](const Vector3d&) { return p; });
  const LameCylinder exact = lame(mould, p);
  const double inner = mould.inner_diameter / 2, outer = inner + mould.wall_thickness;
  return loaded.report({{"hoop_stress_inner", "Pa", loaded.hoop_at(inner, middle), exact.hoop_inner,
                         lame_source, 0.02},
                        {"hoop_stress_outer", "Pa", loaded.hoop_at(outer, middle), exact.hoop_outer,
                         lame_source, 0.02},
                        {"radial_displacement_inner", "m", loaded.growth_at(middle, 0),
                         exact.growth, lame_source, 0.01}});
}

// Elements end where the pressure does and where growth is asked for. In the band it is that of the
// wall's stretch; beyond its edge it reaches as far as the wall is stiff in bending.
StressReport press_band(const StressCase& given) {
  const fem::Mould& mould = given.mould;
  const double p = given.load.pressure, length = given.load.length, middle = mould.height / 2;
  StressCase meshed = given;
  // There the growth tells most of the bending stiffness: twice as stiff is a quarter more.
  const double beyond = length / 2 + 0.8 / shell_wave_number(mould);
  meshed.mesh.levels = {middle - length / 2, middle + length / 2, middle + beyond};
  const LoadedMould loaded(
      meshed, [=](const Vector3d& x) { return std::abs(x[2] - middle) < length / 2 ? p : 0.0; });
  const auto row = [&](const std::string& where, double z) {
    return StressRow{"radial_displacement_" + where,
                     "m",
                     loaded.growth_at(middle + z, 0),
                     p * band_growth(mould, length, z),
                     "long cylinder, Fourier integral of Love's solution (Timoshenko & Goodier "
                     "1970, 133)",
                     0.02};
  };
  return loaded.report(
      {row("band_centre", 0), row("band_edge", length / 2), row("beyond_band", beyond)});
}

StressReport press_oval(const StressCase& given) {
  const fem::Mould& mould = given.mould;
  const double p = given.load.pressure;
  const int n = given.load.harmonic;
  const LoadedMould loaded(
      given, [=](const Vector3d& x) { return p * std::cos(n * std::atan2(x[1], x[0])); });
  return loaded.report({{"radial_displacement_oval", "m", loaded.growth_at(mould.height / 2, n),
                         michell_amplitude(mould, n, p),
                         "Michell, plane strain (Timoshenko & Goodier 1970, 43)", 0.02}});
}

}  // namespace

StressReport load_mould(const StressCase& given) {
  if (given.load.kind == "pressure") return press_everywhere(given);
  return given.load.kind == "band" ? press_band(given) : press_oval(given);
}

}  // namespace apps

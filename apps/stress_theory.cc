#include "apps/stress_theory.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace apps {
namespace {

using std::numbers::pi;

double section(const fem::Head& head) {  // of the shaft [m2]
  return pi / 4 * std::pow(head.shaft_diameter, 2);
}
double second_moment(const fem::Head& head) {  // of the shaft [m4]
  return pi / 64 * std::pow(head.shaft_diameter, 4);
}

}  // namespace

LameCylinder lame(const fem::Mould& mould, double pressure) {
  const double a = mould.inner_diameter / 2, b = a + mould.wall_thickness;
  const double ratio = (b * b + a * a) / (b * b - a * a);
  return {pressure * ratio, pressure * (ratio - 1),
          pressure * a / mould.steel.young * (ratio + mould.steel.poisson)};
}

double shell_wave_number(const fem::Mould& mould) {
  const double middle = (mould.inner_diameter + mould.wall_thickness) / 2;
  const double nu = mould.steel.poisson;
  return std::pow(3 * (1 - nu * nu), 0.25) / std::sqrt(middle * mould.wall_thickness);
}

namespace {

// Growth of the inner face of a long cylinder under the pressure cos(wave number z) [m/Pa], by
// Love's stress function sin(k z) (A I0 + B K0 + C k r I1 + D k r K1)(k r); Timoshenko & Goodier
// (1970), article 133. The functions are scaled with their size at the faces.
double growth_under_wave(const fem::Mould& mould, double wave_number) {
  const double a = mould.inner_diameter / 2, b = a + mould.wall_thickness;
  const double nu = mould.steel.poisson, shear = mould.steel.young / (2 * (1 + nu));
  struct Rows {
    Eigen::RowVector4d slope, radial, sheared;  // of the function; stresses / k^3
  };
  const auto at = [&](double r) {
    const double x = wave_number * r;
    const double small = std::exp(-wave_number * b), large = std::exp(wave_number * a);
    const double i0 = small * std::cyl_bessel_i(0, x), i1 = small * std::cyl_bessel_i(1, x);
    const double k0 = large * std::cyl_bessel_k(0, x), k1 = large * std::cyl_bessel_k(1, x);
    const Eigen::RowVector4d slope(i1, -k1, x * i0, -x * k0);
    const Eigen::RowVector4d bend(i0 - i1 / x, k0 + k1 / x, i0 + x * i1, -k0 + x * k1);
    const Eigen::RowVector4d laplacian(0, 0, 2 * i0, -2 * k0), its_slope(0, 0, 2 * i1, 2 * k1);
    return Rows{slope, nu * laplacian - bend, (1 - nu) * its_slope + slope};
  };
  const Rows inside = at(a), outside = at(b);
  Eigen::Matrix4d conditions;
  conditions << inside.radial, outside.radial, inside.sheared, outside.sheared;
  const Eigen::Vector4d weights = conditions.fullPivLu().solve(Eigen::Vector4d(-1, 0, 0, 0));
  return -inside.slope.dot(weights) / (2 * shear * wave_number);
}

}  // namespace

double band_growth(const fem::Mould& mould, double length, double z) {
  const double a = mould.inner_diameter / 2, b = a + mould.wall_thickness;
  // Shorter waves move a half-space: what they add falls off with the square of the wave number.
  constexpr double wave_in_wall = 20, largest_argument = 600;
  const double shortest = std::min(wave_in_wall / mould.wall_thickness, largest_argument / b);
  constexpr int samples = 4000;  // of the integral; a quarter of them changes 1e-8
  const double step = shortest / samples;
  double growth = 0;
  for (int i = 0; i < samples; ++i) {
    const double k = (i + 0.5) * step;
    growth += step * 2 / pi * std::sin(k * length / 2) / k * std::cos(k * z) *
              growth_under_wave(mould, k);
  }
  return growth;
}

double michell_amplitude(const fem::Mould& mould, int n, double pressure) {
  // Stress function (A r^n + B r^-n + C r^(n+2) + D r^(2-n)) cos(n angle), lengths in units of a.
  const double a = mould.inner_diameter / 2, outer = 1 + mould.wall_thickness / a;
  const double nu = mould.steel.poisson, shear = mould.steel.young / (2 * (1 + nu));
  const auto radial = [n](double r) {
    return Eigen::RowVector4d(n * (1 - n) * std::pow(r, n - 2), -n * (1 + n) * std::pow(r, -n - 2),
                              -(n - 2) * (n + 1) * std::pow(r, n),
                              -(n + 2) * (n - 1) * std::pow(r, -n));
  };
  const auto tangential = [n](double r) {
    return Eigen::RowVector4d(n * (n - 1) * std::pow(r, n - 2), -n * (n + 1) * std::pow(r, -n - 2),
                              n * (n + 1) * std::pow(r, n), -n * (n - 1) * std::pow(r, -n));
  };
  Eigen::Matrix4d conditions;
  conditions << radial(1), tangential(1), radial(outer), tangential(outer);
  const Eigen::Vector4d weights = conditions.fullPivLu().solve(Eigen::Vector4d(-pressure, 0, 0, 0));
  const double kappa = 3 - 4 * nu;
  return a / (2 * shear) * Eigen::RowVector4d(-n, n, kappa - 1 - n, kappa - 1 + n).dot(weights);
}

double beam_rotation(const fem::Head& head, double moment) {
  return moment * head.shaft_length / (head.steel.young * second_moment(head));
}

double bar_shortening(const fem::Head& head, double force) {
  return force * head.shaft_length / (head.steel.young * section(head));
}

double bending_stress(const fem::Head& head, double moment) {
  return moment * head.shaft_diameter / 2 / second_moment(head);
}

double axial_stress(const fem::Head& head, double force) {
  return force / section(head);
}

double rim_deflection(const fem::Head& head, double pressure) {
  // w = c1 + c2 ln r + c3 r^2 + c4 r^2 ln r + q r^4 / (64 D)
  const double a = head.plate_diameter / 2, b = head.shaft_diameter / 2, t = head.plate_thickness;
  const double nu = head.steel.poisson, shear = head.steel.young / (2 * (1 + nu));
  const double bending = head.steel.young * t * t * t / (12 * (1 - nu * nu));
  const double load = pressure / (64 * bending), c4 = -8 * load * a * a;  // no shear force at a
  const auto particular = [&](double r) {
    return c4 * r * r * std::log(r) + load * std::pow(r, 4);
  };
  const auto particular_slope = [&](double r) {
    return c4 * (2 * r * std::log(r) + r) + 4 * load * std::pow(r, 3);
  };
  const double rim_moment =  // w'' + nu w' / r of the particular part at the rim
      c4 * (2 * std::log(a) + 3) + 12 * load * a * a + nu / a * particular_slope(a);
  Eigen::Matrix2d conditions;  // on c2, c3: no moment at r = a, no slope at r = b
  conditions << (nu - 1) / (a * a), 2 + 2 * nu, 1 / b, 2 * b;
  const Eigen::Vector2d c =
      conditions.fullPivLu().solve(Eigen::Vector2d(-rim_moment, -particular_slope(b)));
  const double by_bending =
      c[0] * std::log(a / b) + c[1] * (a * a - b * b) + particular(a) - particular(b);
  const double by_shear =
      pressure / (2 * (5.0 / 6) * shear * t) * (a * a * std::log(a / b) - (a * a - b * b) / 2);
  return by_bending + by_shear;
}

double boussinesq_deflection(const fem::Steel& steel, double force, double distance) {
  return force * (1 - steel.poisson * steel.poisson) / (pi * steel.young * distance);
}

double boussinesq_sinking(const fem::Steel& steel, double force, double depth) {
  const double nu = steel.poisson;
  return force * (1 + nu) * (3 - 2 * nu) / (2 * pi * steel.young * depth);
}

}  // namespace apps

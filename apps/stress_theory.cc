#include "apps/stress_theory.h"

#include <Eigen/Dense>
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

double band_growth(const fem::Mould& mould, double length, double z) {
  const double beta = shell_wave_number(mould);
  const auto from_edge =
      [&](double x) {  // growth at the depth x inside the edge of a half-infinite band
        const double decayed = 0.5 * std::exp(-beta * std::abs(x)) * std::cos(beta * x);
        return x >= 0 ? 1 - decayed : decayed;
      };
  return from_edge(length / 2 - z) + from_edge(length / 2 + z) - 1;
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

}  // namespace apps

// How far the plate of a head turns against its shaft under a moment, by plate theory.
#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "apps/stress_theory.h"

namespace apps {
namespace {

using std::numbers::pi;

// w = (c1 r + c2 / r + c3 r^3 + c4 r ln r + c5 r^5) cos(angle): an annular plate from the shaft's
// circle to its free rim, c5 = q / (192 D) under the pressure q r cos(angle).
class AnnularPlate {
 public:
  using Terms = Eigen::Matrix<double, 1, 5>;

  explicit AnnularPlate(const fem::Head& head)
      : rim_(head.plate_diameter / 2), hub_(head.shaft_diameter / 2), nu_(head.steel.poisson) {
    conditions_ << value(hub_), slope(hub_), moment(rim_),
        72 * rim_ * rim_ * Terms::Unit(4) + 8 * Terms::Unit(2) -
            2 / (rim_ * rim_) * Terms::Unit(3) -
            (1 - nu_) / rim_ * twist(rim_);  // the Laplacian's slope: no force at the rim
  }

  // Weights of the terms for a slope of the plate at the hub and the fifth weight.
  Eigen::Matrix<double, 5, 1> solve(double hub_slope, double fifth) const {
    const Eigen::Vector4d right = Eigen::Vector4d::Unit(1) * hub_slope - fifth * conditions_.col(4);
    Eigen::Matrix<double, 5, 1> weights;
    weights << conditions_.leftCols<4>().fullPivLu().solve(right), fifth;
    return weights;
  }

  static Terms value(double r) {
    return Terms(r, 1 / r, r * r * r, r * std::log(r), std::pow(r, 5));
  }
  // Radial moment / bending stiffness.
  Terms moment(double r) const {
    return Terms(0, 2 / (r * r * r), 6 * r, 1 / r, 20 * r * r * r) + nu_ * twist(r);
  }

 private:
  static Terms slope(double r) {
    return Terms(1, -1 / (r * r), 3 * r * r, std::log(r) + 1, 5 * std::pow(r, 4));
  }
  static Terms twist(double r) { return slope(r) / r - value(r) / (r * r); }

  double rim_, hub_, nu_;
  Eigen::Matrix<double, 4, 5> conditions_;  // no deflection, this slope, no moment, no force
};

// Slope of the plane fitted to a face that deflects by w(r) cos(angle) outside the shaft's circle.
template <class Deflection>
double fitted_tilt(const fem::Head& head, Deflection deflection) {
  const double a = head.plate_diameter / 2, b = head.shaft_diameter / 2;
  constexpr int samples = 2000;
  const double step = (a - b) / samples;
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    const double r = b + (i + 0.5) * step;
    sum += deflection(r) * r * r * step;
  }
  return 4 / std::pow(a, 4) * sum;
}

}  // namespace

JointRotation joint_rotation(const fem::Head& head) {
  const double a = head.plate_diameter / 2, b = head.shaft_diameter / 2, t = head.plate_thickness;
  const double nu = head.steel.poisson, young = head.steel.young, shear = young / (2 * (1 + nu));
  const double bending = young * t * t * t / (12 * (1 - nu * nu));
  const double pressure = 4 / (pi * std::pow(a, 4));  // over r cos(angle), of a unit moment [1/m4]
  const AnnularPlate plate(head);
  const auto loaded = plate.solve(0, pressure / (192 * bending));
  // By shear: c1 r + c2 / r - q r^3 / (8 k G t), zero at the shaft, without slope at the rim.
  const double sheared = pressure / (8 * (5.0 / 6) * shear * t);
  Eigen::Matrix2d held;
  held << b, 1 / b, 1, -1 / (a * a);
  const Eigen::Vector2d c = held.fullPivLu().solve(sheared * Eigen::Vector2d(b * b * b, 3 * a * a));
  const auto turned = plate.solve(1, 0);
  const double hub_moment = bending * plate.moment(b).dot(loaded);  // amplitude [N m/m] of 1 N m
  const double edge = 16.67 / pi * (1 - nu * nu) * hub_moment / (young * t * t);
  return {fitted_tilt(head,
                      [&](double r) {
                        return AnnularPlate::value(r).dot(loaded) + c[0] * r + c[1] / r -
                               sheared * r * r * r;
                      }),
          edge * fitted_tilt(head, [&](double r) { return AnnularPlate::value(r).dot(turned); }),
          3 * (1 - nu * nu) / (4 * young * b * b * b)};
}

}  // namespace apps

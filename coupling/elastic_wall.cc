#include "coupling/elastic_wall.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coupling {
namespace {

// Phase that an oscillator together with the bed may go through between two exchanges [rad].
constexpr double largest_phase = 0.1;

}  // namespace

Eigen::Matrix3Xd letterbox_points(const dem::Wall& wall) {
  Eigen::Matrix3Xd points(3, wall.field->size());
  for (std::size_t n = 0; n < wall.field->size(); ++n) {
    const dem::Vec3d& p = wall.field->node[n];
    points.col(n) << p.x, p.y, p.z;
  }
  return points;
}

ElasticWall::ElasticWall(fem::ReducedBody body, const dem::Wall& wall,
                         const ExchangeSettings& settings)
    : body_(std::move(body)), settings_(settings) {
  const auto& area = wall.field->area;
  const double face = std::accumulate(area.begin(), area.end(), 0.0);
  bed_stiffness_ = settings.bed_modulus * face / std::sqrt(face);
  gain_ = bed_stiffness_ * body_.stiffness.cwiseInverse();
  amplitude_ = velocity_ = Eigen::VectorXd::Zero(gain_.size());
  oscillators_ = static_cast<int>((gain_.array() > settings.static_gain).count());
}

void ElasticWall::exchange(dem::Wall& wall, double dt) {
  gathered_ += dt;
  if (++waited_ < settings_.interval) return;
  const double span = gathered_;
  const double ahead = waited_ * dt;  // the time until the next exchange
  gathered_ = 0;
  waited_ = 0;

  dem::SurfaceField& field = *wall.field;
  const Eigen::Index unknowns = 3 * static_cast<Eigen::Index>(field.size());
  Eigen::Map<Eigen::VectorXd> impulse(&field.impulse.front().x, unknowns);
  const Eigen::VectorXd load = body_.shape.transpose() * impulse / span;  // modal, mean of the span [N]
  impulse.setZero();

  for (Eigen::Index m = 0; m < load.size(); ++m) {
    const double stiffness = body_.stiffness[m];
    if (gain_[m] > settings_.static_gain) {
      const double least = (stiffness + bed_stiffness_) * std::pow(ahead / largest_phase, 2);
      const double mass = std::max(settings_.inertia_scale * body_.mass[m], least);
      // The stones answer one exchange late, which acts as a drag of -bed stiffness x delay.
      const double drag =
          2 * settings_.damping * std::sqrt(stiffness * mass) + 2 * bed_stiffness_ * ahead;
      velocity_[m] += ahead / mass * (load[m] - stiffness * amplitude_[m] - drag * velocity_[m]);
      amplitude_[m] += ahead * velocity_[m];
    } else {
      const double share = std::min(0.5, 1 / (1 + gain_[m]));
      amplitude_[m] += share * (load[m] / stiffness - amplitude_[m]);
    }
  }

  Eigen::Map<Eigen::VectorXd> velocity(&field.velocity.front().x, unknowns);
  const Eigen::Map<const Eigen::VectorXd> displacement(&field.displacement.front().x, unknowns);
  velocity = (body_.shape * amplitude_ - displacement) / ahead;
  field.fastest = std::sqrt(
      Eigen::Map<const Eigen::Matrix3Xd>(velocity.data(), 3, field.size()).colwise().squaredNorm().maxCoeff());
}

}  // namespace coupling

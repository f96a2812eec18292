#include "coupling/elastic_wall.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace coupling {
namespace {

// Phase that an oscillator together with the bed may go through in one time step [rad].
constexpr double largest_phase = 0.1;

// Of the way to its rest that a static mode goes at an exchange: stable below a gain of 4, see
// left_after in tests/physics/coupling_contact.cc.
constexpr double static_share = 0.5;

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
  sort_modes();
  amplitude_ = velocity_ = Eigen::VectorXd::Zero(gain_.size());
  gathered_ = static_velocity_ = Eigen::VectorXd::Zero(body_.shape.rows());
}

void ElasticWall::sort_modes() {
  gain_ = bed_stiffness_ * body_.stiffness.cwiseInverse();
  oscillators_.clear();
  statics_.clear();
  for (Eigen::Index m = 0; m < gain_.size(); ++m)
    (gain_[m] > settings_.static_gain ? oscillators_ : statics_).push_back(m);
  swinging_ = body_.shape(Eigen::all, oscillators_);
  following_ = body_.shape(Eigen::all, statics_);
}

double ElasticWall::lowest_frequency() const {
  double lowest = INFINITY;
  for (const Eigen::Index m : oscillators_)
    lowest =
        std::min(lowest, std::sqrt(body_.stiffness[m] / (settings_.inertia_scale * body_.mass[m])));
  return lowest / (2 * std::numbers::pi);
}

void ElasticWall::follow_fully(const Eigen::MatrixXd& compliance, const dem::Wall& wall) {
  const Eigen::MatrixXd of_modes =
      body_.shape * body_.stiffness.cwiseInverse().asDiagonal() * body_.shape.transpose();
  rest_compliance_ = compliance - of_modes;
  rest_ = Eigen::VectorXd::Zero(body_.shape.rows());
  // The gain of the softest traction that the letterbox can hold, on a bed that yields as stiffly
  // as one of the letterbox's cells can feel it.
  const Eigen::VectorXd area = Eigen::VectorXd::Map(wall.field->area.data(), rest_.size() / 3);
  const Eigen::VectorXd root =
      area.cwiseSqrt().transpose().replicate(3, 1).reshaped();  // of each unknown's share [m]
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> tractions(
      root.asDiagonal() * rest_compliance_ * root.asDiagonal(), Eigen::EigenvaluesOnly);
  const double softest = tractions.eigenvalues().maxCoeff();  // [m3/N]
  const double gain = settings_.bed_modulus / std::sqrt(area.mean()) * softest;
  rest_share_ = std::min(static_share, 1 / (1 + gain));
}

void ElasticWall::exchange(dem::Wall& wall, dem::Steps steps) {
  dem::SurfaceField& field = *wall.field;
  const auto nodes = static_cast<Eigen::Index>(field.size());
  // Copies here and below, because Eigen's sums depend on where in memory a vector begins.
  Eigen::Map<Eigen::VectorXd> letters(&field.impulse.front().x, 3 * nodes);
  const Eigen::VectorXd impulse = letters;
  letters.setZero();
  gathered_ += impulse;
  span_ += steps.before;
  swing(impulse, steps);
  if (++waited_ >= settings_.interval) {
    relax();
    const Eigen::VectorXd displacement =
        Eigen::Map<const Eigen::VectorXd>(&field.displacement.front().x, 3 * nodes);
    const Eigen::VectorXd swung =
        swinging_ * velocity_(oscillators_) * steps.now;  // still to be moved
    Eigen::VectorXd wanted = body_.shape * amplitude_;
    if (rest_.size() > 0) wanted += rest_;
    static_velocity_ = (wanted - displacement - swung) / (waited_ * steps.now);
    waited_ = 0;
  }
  const Eigen::VectorXd velocity = static_velocity_ + swinging_ * velocity_(oscillators_);
  Eigen::Map<Eigen::VectorXd>(&field.velocity.front().x, 3 * nodes) = velocity;
  field.fastest = std::sqrt(Eigen::Map<const Eigen::Matrix3Xd>(velocity.data(), 3, nodes)
                                .colwise()
                                .squaredNorm()
                                .maxCoeff());
}

void ElasticWall::swing(const Eigen::VectorXd& impulse, dem::Steps steps) {
  const double dt = steps.now;
  const Eigen::VectorXd load = swinging_.transpose() * impulse / steps.before;  // [N]
  for (std::size_t k = 0; k < oscillators_.size(); ++k) {
    const Eigen::Index m = oscillators_[k];
    const double stiffness = body_.stiffness[m];
    const double least = (stiffness + bed_stiffness_) * std::pow(dt / largest_phase, 2);
    const double mass = std::max(settings_.inertia_scale * body_.mass[m], least);
    // The second part is more than what a bed that answers a step late could drive: stiffness x dt.
    const double drag =
        2 * settings_.damping * std::sqrt(stiffness * mass) + 2 * bed_stiffness_ * dt;
    velocity_[m] +=
        steps.kick() / mass * (load[k] - stiffness * amplitude_[m] - drag * velocity_[m]);
    amplitude_[m] += dt * velocity_[m];
  }
}

void ElasticWall::relax() {
  const Eigen::VectorXd load = following_.transpose() * gathered_ / span_;  // mean of the span [N]
  for (std::size_t k = 0; k < statics_.size(); ++k) {
    const Eigen::Index m = statics_[k];
    amplitude_[m] += static_share * (load[k] / body_.stiffness[m] - amplitude_[m]);
  }
  if (rest_.size() > 0) rest_ += rest_share_ * (rest_compliance_ * (gathered_ / span_) - rest_);
  gathered_.setZero();
  span_ = 0;
}

}  // namespace coupling

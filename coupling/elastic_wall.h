// An elastic wall in the run: the modes of a reduced steel body, driven by what the stones leave in
// the letterbox, answering through how the letterbox moves.
//
// A mode whose compliance could answer the bed strongly (gain = bed stiffness / modal stiffness above
// `static_gain`) is an oscillator with scaled modal mass and damping, stable for any softness; the
// others follow statically with relaxation 1 / (1 + gain), at most 1/2. The gain comes from a bound on
// the bed's stiffness, bed_modulus x face area / face size. Plain static exchange diverges where the
// gain exceeds 1, which head tilt and mould ovalling do.
#pragma once

#include <Eigen/Dense>

#include "dem/simulation.h"
#include "fem/elastic_body.h"

namespace coupling {

struct ExchangeSettings {
  int interval = 10;          // time steps between two exchanges
  double inertia_scale = 1;   // modal mass / true modal mass [-]
  double damping = 0.15;      // of the critical damping of each oscillator [-]
  double static_gain = 0.02;  // modes below it follow statically [-]
  double bed_modulus = 1e9;   // bound of the bed's confined modulus [Pa]
};

class ElasticWall {
 public:
  // `body` sampled at the nodes of wall.field, in their order.
  ElasticWall(fem::ReducedBody body, const dem::Wall& wall, const ExchangeSettings& settings);

  // To be called after every time step of length dt [s]; acts at every interval-th call.
  void exchange(dem::Wall& wall, double dt);

  const fem::ReducedBody& body() const { return body_; }
  const Eigen::VectorXd& amplitude() const { return amplitude_; }  // of the modes [m]
  int oscillators() const { return oscillators_; }

 private:
  fem::ReducedBody body_;
  ExchangeSettings settings_;
  Eigen::VectorXd gain_;       // bed stiffness / modal stiffness [-]
  Eigen::VectorXd amplitude_, velocity_;  // [m], [m/s]
  double bed_stiffness_;       // bound [N/m]
  double gathered_ = 0;        // time since the last exchange [s]
  int waited_ = 0;             // steps since the last exchange
  int oscillators_ = 0;        // modes that move with inertia
};

// The points at which a reduced body must be sampled for a wall's letterbox: (3, nodes) [m].
Eigen::Matrix3Xd letterbox_points(const dem::Wall& wall);

}  // namespace coupling

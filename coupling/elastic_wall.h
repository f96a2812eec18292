// An elastic wall in the run: the modes of a reduced steel body, driven by what the stones leave in
// the letterbox, answering through how the letterbox moves.
//
// A mode whose compliance could answer the bed strongly (gain = bed stiffness / modal stiffness
// above `static_gain`) is an oscillator with scaled modal mass and damping that moves with every
// time step, stable for any softness; the others follow statically at every exchange with
// relaxation 1/2. The gain comes from an estimate of the bed's stiffness, bed_modulus x face area /
// face size, which is no bound for a mould: bed_modulus x face area / radius is more. A mode that
// follows would diverge above a gain of 4, which the tilt of a soft head exceeds, and the ovalling
// of a mould only where it is softer than steel or thin.
//
// Beyond its damping an oscillator is held back by what a bed that answers a step late could drive,
// bed stiffness x 2 dt: a mode that is soft against the bed comes to rest in 2 gain dt.
//
// As the reference of what modes leave out, a wall may follow fully: the rest of its compliance,
// that of the full body less that of the modes, then answers statically at every exchange. Modes
// that swing go on swinging, so that the full answer is as stable as theirs.
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "dem/simulation.h"
#include "fem/elastic_body.h"

namespace coupling {

struct ExchangeSettings {
  int interval = 10;         // time steps between two exchanges of the static modes
  double inertia_scale = 1;  // modal mass / true modal mass [-]
  double damping = 0.15;     // of the critical damping of each oscillator [-]
  double static_gain = 0.1;  // modes below it follow statically [-]
  double bed_modulus = 1e9;  // of the bed in confined compression, an estimate [Pa]
};

class ElasticWall {
 public:
  // `body` sampled at the nodes of wall.field, in their order.
  ElasticWall(fem::ReducedBody body, const dem::Wall& wall, const ExchangeSettings& settings);

  // From here on the wall comes to rest where the full body does. `compliance`: of its face at the
  // nodes of wall.field (fem::ElasticBody::face_compliance).
  void follow_fully(const Eigen::MatrixXd& compliance, const dem::Wall& wall);

  // To be called after every time step: its length and that of the next.
  void exchange(dem::Wall& wall, dem::Steps steps);

  const fem::ReducedBody& body() const { return body_; }
  const Eigen::VectorXd& amplitude() const { return amplitude_; }  // of the modes [m]
  const Eigen::VectorXd& gain() const { return gain_; }            // of each mode [-]
  int oscillators() const { return static_cast<int>(oscillators_.size()); }
  // Of the slowest oscillator, by its scaled mass [Hz]; infinite where there is none.
  double lowest_frequency() const;

  // Shows, as in dem/state.h, the modes too: solvers may find them with other signs and last bits.
  template <class Visit>
  void visit_state(Visit& visit, const std::string& in);

 private:
  void sort_modes();  // by gain into oscillators and statics
  void swing(const Eigen::VectorXd& impulse, dem::Steps steps);  // moves the oscillators [N s], [s]
  void relax();  // moves the static modes and the rest

  fem::ReducedBody body_;
  ExchangeSettings settings_;
  Eigen::VectorXd gain_;                             // bed stiffness / modal stiffness [-]
  std::vector<Eigen::Index> oscillators_, statics_;  // the modes of either kind
  Eigen::MatrixXd swinging_, following_;             // their shapes at the nodes [-]
  Eigen::VectorXd amplitude_, velocity_;             // of all modes [m], [m/s]
  Eigen::VectorXd gathered_;                         // impulse since the last exchange [N s]
  Eigen::VectorXd static_velocity_;                  // of the nodes until the next exchange [m/s]
  double bed_stiffness_;                             // estimate [N/m]
  Eigen::MatrixXd rest_compliance_;                  // of what the modes leave out [m/N]
  Eigen::VectorXd rest_;                             // its displacement [m]; empty: left out
  double rest_share_ = 0;                            // relaxation of the rest [-]
  double span_ = 0;                                  // time since the last exchange [s]
  int waited_ = 0;                                   // steps since the last exchange
};

template <class Visit>
void ElasticWall::visit_state(Visit& visit, const std::string& in) {
  visit(in + "stiffness", body_.stiffness);
  visit(in + "mass", body_.mass);
  visit(in + "shape", body_.shape);
  visit(in + "full_shape", body_.full_shape);
  visit(in + "amplitude", amplitude_);
  visit(in + "mode_velocity", velocity_);
  visit(in + "gathered", gathered_);
  visit(in + "static_velocity", static_velocity_);
  visit(in + "span", span_);
  visit(in + "waited", waited_);
  visit(in + "rest_compliance", rest_compliance_);
  visit(in + "rest", rest_);
  visit(in + "rest_share", rest_share_);
  sort_modes();
}

// The points at which a reduced body must be sampled for a wall's letterbox: (3, nodes) [m].
Eigen::Matrix3Xd letterbox_points(const dem::Wall& wall);

}  // namespace coupling

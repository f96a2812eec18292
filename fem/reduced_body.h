// A steel body as the run sees it: a few modes of its loaded face.
//
// The modes span the shapes that yield most to tractions on the loaded face G (Steklov problem
// K u = s M_G u with M_G = surface mass, smallest s first); a Rayleigh-Ritz step with stiffness K
// and mass M then makes each mode an oscillator of its own:
//   displacement(x) = sum_m amplitude_m shape_m(x),
//   mass_m amplitude_m'' + stiffness_m amplitude_m = sum_contacts shape_m(x_c) . force_c.
// An amplitude is the root mean square displacement [m] of the loaded face in that mode.
#pragma once

#include <Eigen/Dense>

namespace fem {

struct ReducedBody {
  Eigen::VectorXd stiffness;  // (modes) modal stiffness [N/m]; lowest stiffness / mass first
  Eigen::VectorXd mass;       // (modes) modal mass [kg]
  Eigen::MatrixXd shape;      // (3 points, modes) (x, y, z) of point 0, ... per unit amplitude [-]
  Eigen::MatrixXd
      full_shape;  // (unknowns, modes) the same for every node of the body, for pictures
  Eigen::VectorXd compliance;  // (modes + 1) Steklov compliances 1/s [m3/N], the last one left out
  double truncation_error;     // first compliance left out / largest [-]
  double body_mass;            // [kg]
};

}  // namespace fem

// The balance of energy of a bed: what is in it, what was lost, what came from outside.
#pragma once

#include <cmath>

#include "dem/contact_energy.h"

namespace dem {

// All in J.
struct Energies {
  // As it is now.
  double kinetic = 0;       // with inertia as it is used, spin included
  double spin = 0;          // the part of it in spin
  double mass_scaling = 0;  // the part of it that true inertia would not have
  Stored stored;            // in contacts
  double at_start = 0;      // kinetic + stored when the book was opened

  // Since then.
  Lost lost;           // by contacts
  double drag = 0;     // lost to the drag that settles a bed
  double walls = 0;    // work of the walls on the stones
  double gravity = 0;  // its work on the true weights

  double work() const { return walls + gravity; }

  // What the work from outside leaves unexplained: the error of the integration in time.
  double residual() const {
    return work() - (kinetic + stored.stone + stored.binder - at_start) - lost.sum() - drag;
  }
  // Of the work, whether put in or taken out; 0 before any was done [-].
  double residual_share() const {
    const double turnover = std::abs(walls) + std::abs(gravity);
    return turnover > 0 ? residual() / turnover : 0;
  }
};

}  // namespace dem

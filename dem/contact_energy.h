// What a contact stores and what it loses in a step. The energy ledger asks every law for
//   Stored stored(law, seen)     of a contact as it is, from its memory;
//   Lost lost(law, before, now)  in a step that is as long as the law's time step.
// Friction, dashpots and damping lose force x displacement, forces being means of both ends of the
// step (see energy_ledger.h). What springs forget at once, where areas change, bonds part or stones
// break, is what they held less what they hold after it, and less what the force of the old state
// still did in the half step that was left to it.
#pragma once

#include "dem/contact.h"

namespace dem {

// A contact at the end of a step, lent to its law.
template <class Law>
struct Seen {
  const Contact<double>& contact;
  const typename Law::template Memory<double>& memory;
};

struct Stored {
  double stone = 0, binder = 0;  // [J]

  friend Stored operator+(const Stored& a, const Stored& b) {
    return {a.stone + b.stone, a.binder + b.binder};
  }
};

// All in J.
struct Lost {
  double binder = 0;      // in the dashpots of the binder
  double friction = 0;    // of stones and films that slip
  double stone_area = 0;  // shear that stone contacts forget as their area changes
  double film_area = 0;   // the same of films
  double damping = 0;     // of the restitution of stones
  double bond = 0;        // by bonds that yield and break
  double fracture = 0;    // by springs of stones that lose stiffness

  Lost& operator+=(const Lost& other) {
    binder += other.binder;
    friction += other.friction;
    stone_area += other.stone_area;
    film_area += other.film_area;
    damping += other.damping;
    bond += other.bond;
    fracture += other.fracture;
    return *this;
  }
  friend Lost operator+(Lost a, const Lost& b) { return a += b; }
  double sum() const {
    return binder + friction + stone_area + film_area + damping + bond + fracture;
  }
};

}  // namespace dem

// When stones break, and how soft they become.
//
// A stone breaks when F / R0^2 of one of its stone contacts exceeds its strength sigma_F (Hertz
// stress depends on F / R0^2 only; Olsson, Jelagin, Partl, Eq. 4 gives sigma_F). It stays one
// sphere. Its crack runs along the load that broke it (unit vector c, force F_b). The paper leaves
// the remaining stiffness to its reference [12], whose text we do not have; our rule is
//   share = residual + (1 - residual) C / (C + F_b),  C = 1/2 sum_k F_k (1 - (n_k . c)^2),
// C being the force with which its other stone contacts clamp it across the crack. No clamping
// leaves `residual` of the stiffness, clamping far above F_b all of it. The share enters as
// compliance: softness = 1 / share. It follows the rule with a lag of a few looks, so that a break
// is no impact, and only downwards: a stone is as stiff as when it was clamped least since it
// broke. Stiffness given back at the same overlap would lift the load with energy from nowhere;
// given back to later load only, it would let a contact creep to nothing under a clamp that comes
// and goes. Limits: fragments do not separate, strength is not drawn again, and in a bed that is
// moved much the residual is what stays.
#pragma once

#include <cstdint>
#include <vector>

#include "dem/particle_store.h"

namespace dem {

// Force of one stone-to-stone or stone-to-wall contact on a stone.
struct StoneLoad {
  Vec3d direction;  // unit normal of the contact [-]
  double force;     // F of the stone contact [N]
  double crush;     // F / R0^2 [Pa]
};

struct Crack {
  std::uint32_t stone;  // id
  double time;          // of the break [s]
  double crush;         // F / R0^2 that broke it [Pa]
  Vec3d direction;      // c, turns with the stone [-]
  double force;         // F_b [N]
};

struct FractureRule {
  double residual = 0.1;  // stiffness share of an unclamped broken stone [-]
  double lag = 0.2;       // part of the way to the rule's share gone at each look [-]
};

// Strengths for every stone and no cracks: switches fracture on.
void make_breakable(ParticleStore& stones, std::vector<double> strength_by_id);

// Stones (places in the store) whose crush exceeds their strength and that are still whole, rising.
std::vector<std::int32_t> overloaded(const ParticleStore& stones);

// The crack that the largest of the loads makes.
Crack crack_of(std::uint32_t stone, double time, const std::vector<StoneLoad>& loads);

// Stiffness share that the rule gives a cracked stone under these loads [-].
double stiffness_share(const FractureRule& rule, const Crack& crack,
                       const std::vector<StoneLoad>& loads);

}  // namespace dem

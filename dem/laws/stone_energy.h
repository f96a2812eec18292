// Energies of the stone contact: Hertz, Mindlin, and stones that break.
//
// The normal spring stores 8/15 E0 sqrt(R0) d^2.5 (Hertz 1882). The shear spring, S of stiffness k,
// stores S^2 / 2k: what it would give back if the contact did not change. It forgets some of that
// where k changes: on unloading because its force falls with k, on loading because the same force
// then stands for less displacement.
#pragma once

#include "dem/contact_energy.h"
#include "dem/laws/fracture.h"
#include "dem/laws/mindlin.h"

namespace dem {

// Of whole stones [J].
template <class Normal>
double normal_energy(const Mindlin<Normal>& law, const Contact<double>& contact) {
  const double d = larger(contact.overlap - law.cover, 0.0);
  return 8.0 / 15 * law.normal.modulus * d * d * std::sqrt(contact.stone_radius * d);
}

// Part of the push of whole stones that is not the spring's [N].
template <class Normal>
double damping_force(const Mindlin<Normal>& law, const Contact<double>& contact) {
  const double d = larger(contact.overlap - law.cover, 0.0);
  return law.normal(d, contact).force - Hertz<>{law.normal.modulus}(d, contact).force;
}

// Of the shear spring [N/m]; 0 if stones do not touch, where the compliance is 0 or beyond all
// size.
template <class Memory>
double shear_stiffness(const Memory& memory) {
  return memory.compliance > 0 && memory.compliance < 1e100 ? 1 / memory.compliance : 0;
}

template <class Memory>
double shear_energy(const Memory& memory) {
  const double k = shear_stiffness(memory);
  return k > 0 ? dot(memory.shear, memory.shear) / (2 * k) : 0;
}

template <class Normal>
Lost shear_lost(const Mindlin<Normal>&, const Seen<Mindlin<Normal>>& before,
                const Seen<Mindlin<Normal>>& now) {
  const double old_k = shear_stiffness(before.memory), k = shear_stiffness(now.memory);
  if (old_k <= 0 && k <= 0) return {};
  const Vec3d& sliding = now.contact.sliding;
  const Vec3d old = carried(before.memory.shear, now.contact);
  if (k <= 0) return {.stone_area = shear_energy(before.memory) - 0.5 * dot(old, sliding)};
  const Vec3d kept = old * smaller(k / larger(old_k, 1e-300), 1.0);
  const Vec3d slip = (kept - now.memory.shear) * (1 / k) - sliding;  // against the force [m]
  const Vec3d stretch = -sliding - slip;
  return {.friction = 0.5 * dot(old + now.memory.shear, slip),
          .stone_area = shear_energy(before.memory) - dot(kept, kept) / (2 * k) +
                        0.5 * dot(old - kept, stretch)};
}

template <class Normal>
Stored stored(const Mindlin<Normal>& law, const Seen<Mindlin<Normal>>& seen) {
  return {.stone = normal_energy(law, seen.contact) + shear_energy(seen.memory)};
}

template <class Normal>
Lost lost(const Mindlin<Normal>& law, const Seen<Mindlin<Normal>>& before,
          const Seen<Mindlin<Normal>>& now) {
  Lost sum = shear_lost(law, before, now);
  sum.damping = 0.5 * (damping_force(law, before.contact) + damping_force(law, now.contact)) *
                (now.contact.overlap - before.contact.overlap);
  return sum;
}

// What the normal spring of a contact holds with stones as soft as in `as` [J].
template <class Stone>
double spring_energy(const Fracture<Stone>& law, const Contact<double>& contact,
                     const Contact<double>& as) {
  return normal_energy(law.stone, contact) / law.weakness(as);
}

template <class Stone>
Stored stored(const Fracture<Stone>& law, const Seen<Fracture<Stone>>& seen) {
  return {.stone = spring_energy(law, seen.contact, seen.contact) + shear_energy(seen.memory)};
}

template <class Stone>
Lost lost(const Fracture<Stone>& law, const Seen<Fracture<Stone>>& before,
          const Seen<Fracture<Stone>>& now) {
  Lost sum = shear_lost(law.stone, Seen<Stone>{before.contact, before.memory},
                        Seen<Stone>{now.contact, now.memory});
  if (before.contact.softness == now.contact.softness || before.contact.softness == 0) return sum;
  const auto mean = [&](const Contact<double>& as) {
    return 0.5 * (spring_energy(law, before.contact, as) + spring_energy(law, now.contact, as));
  };
  sum.fracture = sum.stone_area + mean(before.contact) - mean(now.contact);
  sum.stone_area = 0;
  return sum;
}

}  // namespace dem

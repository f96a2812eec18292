// Energies of the binder.
//
// Normal: each term of the recursion is a spring in series with a dashpot, F = k (H(h) - H(v)),
// H(h) = sign(h) |h|^1.5, v being what the dashpot has crept and q = H(h) - H(v) the memory. Drawn
// quickly from v to h, at H(v) constant, the spring takes up
//   k [2/5 |h|^2.5 + 3/5 |v|^2.5 - H(v) h],
// never negative (Young's inequality), and the dashpot turns k (h - v) dH(v) >= 0 into heat. Both
// follow from F dh = dE + dD alone; on monotonic loading other splits of F dh are possible, since
// the law leaves open what its half-space stores.
// Film: springs G A / b in series with dashpots, which store T^2 / 2k each. Where the area shrinks,
// what the parted film held is lost; where it grows, the law no longer tells old film, strained,
// from new film, and what it cannot give back any more is counted as lost.
#pragma once

#include <cmath>

#include "dem/contact_energy.h"
#include "dem/laws/binder.h"

namespace dem {

// The shells' squeeze as the recursion sees it.
struct Squeeze {
  double h;  // [m]
  double H;  // sign(h) |h|^1.5 [m^1.5]
};

template <class Memory>
Squeeze squeeze_of(const Memory& memory) {
  const double h = memory.root * std::abs(memory.root);
  return {h, h * std::abs(memory.root)};
}

// v of a term: the squeeze its dashpot has crept to [m].
inline double crept(double H, double transient) {
  const double root = std::cbrt(H - transient);
  return root * std::abs(root);
}

// Force / H of all terms together without relaxation [N/m^1.5].
template <int Terms, int Rings>
double normal_stiffness(const Binder<Terms, Rings>& law, const Contact<double>& contact) {
  return law.normal_factor * law.modulus * std::sqrt(contact.outer_radius);
}

template <int Terms, int Rings>
double normal_energy(const Binder<Terms, Rings>& law, const Seen<Binder<Terms, Rings>>& seen) {
  const auto [h, H] = squeeze_of(seen.memory);
  const double whole = 0.4 * std::abs(h * H);
  double sum = law.relaxed * whole;
  for (int i = 0; i < Terms; ++i) {
    const double q = seen.memory.push[i];
    const double v = crept(H, q);
    sum += law.weight[i] * (whole + 0.6 * (H - q) * v - (H - q) * h);
  }
  return normal_stiffness(law, seen.contact) * sum;
}

// Force of the springs before a bond limits it, and what the limit takes from it [N].
struct Pull {
  double springs, given_up;
};

template <int Terms, int Rings>
Pull pull_of(const Binder<Terms, Rings>& law, const Seen<Binder<Terms, Rings>>& seen) {
  double sum = law.relaxed * squeeze_of(seen.memory).H;
  for (int i = 0; i < Terms; ++i) sum += law.weight[i] * seen.memory.push[i];
  const double springs = normal_stiffness(law, seen.contact) * sum;
  const double limit = -law.bond.pull_off(seen.contact.outer_radius);
  return {springs, larger(limit - springs, 0.0)};
}

template <int Terms, int Rings>
Lost normal_lost(const Binder<Terms, Rings>& law, const Seen<Binder<Terms, Rings>>& before,
                 const Seen<Binder<Terms, Rings>>& now) {
  Lost sum;
  // Where shells do not bond, what they let go in parting is creep that has not come back.
  double& parting = law.bond.energy > 0 ? sum.bond : sum.binder;
  const double approach = now.contact.overlap - before.contact.overlap;
  const Pull pull = pull_of(law, before);
  if (now.memory.bonded <= 0.5) {  // its force has acted for half of the step
    if (before.memory.bonded > 0.5)
      parting = normal_energy(law, before) + 0.5 * (pull.springs + pull.given_up) * approach;
    return sum;
  }
  const auto [h0, H0] = squeeze_of(before.memory);
  const auto [h1, H1] = squeeze_of(now.memory);
  for (int i = 0; i < Terms; ++i) {
    const double q0 = before.memory.push[i], q1 = now.memory.push[i];
    const double drawn = h0 - crept(H0, q0) + h1 - crept(H1, q1);
    sum.binder += law.weight[i] * 0.5 * drawn * (H1 - H0 - (q1 - q0));
  }
  sum.binder *= normal_stiffness(law, now.contact);
  parting += 0.5 * (pull.given_up + pull_of(law, now).given_up) * approach;
  return sum;
}

// The area of a ring of film at both ends of a step.
struct FilmArea {
  double before, now;  // [m2]

  double kept() const { return smaller(now / larger(before, 1e-300), 1.0); }
};

// One term of a ring, its history being int A ds with what it forgot.
struct FilmTerm {
  double stiffness;  // force / history [N/m3]
  double decay, growth;
  Vec3d before, now;  // histories [m3]
};

inline Lost film_lost(const FilmTerm& term, const Contact<double>& contact, const FilmArea& area) {
  const Vec3d& sliding = contact.sliding;
  const Vec3d old = carried(term.before, contact);
  const double held = area.before > 0 ? 0.5 * dot(term.before, term.before) / area.before : 0;
  if (area.now <= 0) return {.film_area = term.stiffness * (held + 0.5 * dot(old, sliding))};
  const Vec3d kept = old * area.kept();
  const Vec3d sheared = kept * term.decay + sliding * (area.now * term.growth);  // before slip
  const Vec3d mean = 0.5 * (old + term.now);
  const double scale = term.stiffness / area.now;
  return {.binder = scale * dot(mean, kept + sliding * area.now - sheared),
          .friction = scale * dot(mean, sheared - term.now),
          .film_area = term.stiffness * held +
                       0.5 * scale * (dot(old - kept, term.now - kept) - dot(kept, kept))};
}

template <int Terms, int Rings>
Stored stored(const Binder<Terms, Rings>& law, const Seen<Binder<Terms, Rings>>& seen) {
  double sum = normal_energy(law, seen);
  for (int k = 0; k < Rings; ++k) {
    const double area = law.ring_area(seen.contact, seen.memory.root, k);
    if (area <= 0) break;
    const auto& [film, shear] = seen.memory.ring[k];
    const double per_film = law.modulus / (2 * law.film * area);
    sum += per_film * law.relaxed * dot(film, film);
    for (int i = 0; i < Terms; ++i) sum += per_film * law.weight[i] * dot(shear[i], shear[i]);
  }
  return {.binder = sum};
}

template <int Terms, int Rings>
Lost lost(const Binder<Terms, Rings>& law, const Seen<Binder<Terms, Rings>>& before,
          const Seen<Binder<Terms, Rings>>& now) {
  Lost sum = normal_lost(law, before, now);
  const double stiffness = law.modulus / law.film;
  for (int k = 0; k < Rings; ++k) {
    const FilmArea area = {law.ring_area(now.contact, before.memory.root, k),
                           law.ring_area(now.contact, now.memory.root, k)};
    if (area.before <= 0 && area.now <= 0) break;
    const auto &old = before.memory.ring[k], &ring = now.memory.ring[k];
    sum += film_lost({stiffness * law.relaxed, 1, 1, old.film, ring.film}, now.contact, area);
    for (int i = 0; i < Terms; ++i)
      sum += film_lost(
          {stiffness * law.weight[i], law.decay[i], law.growth[i], old.shear[i], ring.shear[i]},
          now.contact, area);
  }
  return sum;
}

}  // namespace dem

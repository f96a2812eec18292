// Which contact law a scene asks for. A new law is one header in dem/laws/ and one line in
// `with_law`.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "apps/mix.h"
#include "apps/scene.h"
#include "apps/sections.h"
#include "dem/laws/binder.h"
#include "dem/laws/fracture.h"
#include "dem/laws/hertz.h"
#include "dem/laws/mindlin.h"
#include "dem/laws/sum.h"
#include "dem/material.h"
#include "dem/simulation.h"

namespace apps {

// What a stone meets: another stone, or a wall.
struct Counterpart {
  std::optional<dem::Material> wall;  // see `rigid` in apps/bed.h; absent: another stone
  double friction;                    // [-]
};

using Dry = dem::Mindlin<dem::Hertz<>>;
using DampedDry = dem::Mindlin<dem::Hertz<dem::Damping::restitution>>;
using BreakingDry = dem::Fracture<Dry>;
template <int Terms, int Rings = 1>
using Asphalt = dem::Sum<Dry, dem::Binder<Terms, Rings>>;
template <int Terms, int Rings = 1>
using BreakingAsphalt = dem::Sum<BreakingDry, dem::Binder<Terms, Rings>>;

inline constexpr int most_prony_terms = 8;
inline constexpr int film_rings = 16;  // of films that are remembered in rings

// The constants of a scene's laws.
class LawBook {
 public:
  LawBook(const StonesScene& stones, const std::optional<BinderScene>& binder, const Mix& mix)
      : stones_(stones),
        binder_(binder),
        shell_(mix.shell),
        thickest_(mix.radius.empty() ? mix.shell : thickest_shell * mix.smallest_radius()),
        bitumen_fraction_(mix.bitumen_fraction) {}

  // The law of a stone with its counterpart; bonds: may shells that were pressed carry tension.
  template <class Law>
  Law law(const Counterpart& counterpart, bool bonds) const {
    return Make<Law>::from(*this, counterpart, bonds);
  }

  // Throws InputError where the scene asks for a combination that there is no law for.
  void check(const SceneSource& source) const;

  // Terms of the scene's relaxation modulus, 0 without binder.
  int prony_terms() const { return binder_ ? static_cast<int>(binder_->alpha.size()) : 0; }
  bool fracture() const { return stones_.fracture.has_value(); }
  bool damping() const { return stones_.restitution.has_value(); }
  bool rings() const { return binder_ && binder_->film == "rings"; }

 private:
  template <class Law>
  struct Make;

  dem::Material stone() const { return {stones_.young, stones_.poisson}; }

  StonesScene stones_;
  std::optional<BinderScene> binder_;
  double shell_, thickest_, bitumen_fraction_;
};

template <dem::Damping kind>
struct LawBook::Make<dem::Mindlin<dem::Hertz<kind>>> {
  static dem::Mindlin<dem::Hertz<kind>> from(const LawBook& book, const Counterpart& counterpart,
                                             bool) {
    const dem::Material other = counterpart.wall.value_or(book.stone());
    const double normal = dem::normal_compliance(book.stone()) + dem::normal_compliance(other);
    const double shear = dem::shear_compliance(book.stone()) + dem::shear_compliance(other);
    dem::Hertz<kind> hertz = {1 / normal};
    if (kind == dem::Damping::restitution)
      hertz.damping_ratio = dem::damping_ratio(book.stones_.restitution.value());
    return {hertz, 1 / shear, counterpart.friction, (counterpart.wall ? 1 : 2) * book.shell_};
  }
};

template <class Stone>
struct LawBook::Make<dem::Fracture<Stone>> {
  static dem::Fracture<Stone> from(const LawBook& book, const Counterpart& counterpart,
                                   bool bonds) {
    const double stone = dem::normal_compliance(book.stone());
    const double wall = counterpart.wall ? dem::normal_compliance(*counterpart.wall) : 0;
    return {Make<Stone>::from(book, counterpart, bonds), stone / (stone + wall)};
  }
};

template <int Terms, int Rings>
struct LawBook::Make<dem::Binder<Terms, Rings>> {
  static dem::Binder<Terms, Rings> from(const LawBook& book, const Counterpart& counterpart,
                                        bool bonds) {
    const BinderScene& binder = book.binder_.value();
    dem::Binder<Terms, Rings> law;
    law.modulus = binder.shear_modulus;
    law.weight.fill(0);  // terms that the scene does not name do nothing
    law.time.fill(1);
    for (std::size_t i = 0; i < binder.alpha.size(); ++i) {
      law.weight[i] = book.bitumen_fraction_ * binder.alpha[i];
      law.time[i] = binder.tau[i];
    }
    law.normal_factor = counterpart.wall ? 16.0 / 3.0 : 8.0 / 3.0;
    law.film = (counterpart.wall ? 1 : 2) * book.shell_;
    const bool bonding = bonds && (!counterpart.wall || binder.wall_bonds);
    law.bond.energy = bonding ? binder.bond_energy : 0;
    if (counterpart.wall) law.friction = counterpart.friction;
    return law;
  }
};

template <class A, class B>
struct LawBook::Make<dem::Sum<A, B>> {
  static dem::Sum<A, B> from(const LawBook& book, const Counterpart& counterpart, bool bonds) {
    return {Make<A>::from(book, counterpart, bonds), Make<B>::from(book, counterpart, bonds)};
  }
};

// Calls run.operator()<Law>() with the law that does what the scene names, and nothing it does not.
template <class Run>
auto with_law(const LawBook& book, Run run) {
  const int terms = book.prony_terms();
  if (terms == 0 && book.damping()) return run.template operator()<DampedDry>();
  if (terms == 0)
    return book.fracture() ? run.template operator()<BreakingDry>()
                           : run.template operator()<Dry>();
  if (book.rings())
    return book.fracture() ? run.template operator()<BreakingAsphalt<2, film_rings>>()
                           : run.template operator()<Asphalt<2, film_rings>>();
  if (terms <= 2)
    return book.fracture() ? run.template operator()<BreakingAsphalt<2>>()
                           : run.template operator()<Asphalt<2>>();
  return book.fracture() ? run.template operator()<BreakingAsphalt<most_prony_terms>>()
                         : run.template operator()<Asphalt<most_prony_terms>>();
}

}  // namespace apps

// Compiled once, in laws_dry.cc, laws_asphalt.cc and laws_rings.cc.
extern template class dem::Simulation<apps::Dry>;
extern template class dem::Simulation<apps::DampedDry>;
extern template class dem::Simulation<apps::BreakingDry>;
extern template class dem::Simulation<apps::Asphalt<2>>;
extern template class dem::Simulation<apps::BreakingAsphalt<2>>;
extern template class dem::Simulation<apps::Asphalt<2, apps::film_rings>>;
extern template class dem::Simulation<apps::BreakingAsphalt<2, apps::film_rings>>;
extern template class dem::Simulation<apps::Asphalt<apps::most_prony_terms>>;
extern template class dem::Simulation<apps::BreakingAsphalt<apps::most_prony_terms>>;

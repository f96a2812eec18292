// The declarations of what is compacted: stones, binder, filling.
#include "apps/fidelity.h"
#include "apps/sections.h"

namespace apps {
namespace {

constexpr Unit millimetre{"mm", "m"}, cubic_millimetre{"mm3", "m3"}, second{"s", "s"};
constexpr Unit megapascal{"MPa", "Pa"}, gigapascal{"GPa", "Pa"}, energy_per_area{"J/mm2", "J/m2"};
constexpr Unit density{"kg/m3", "kg/m3"}, celsius{"degC", "K"};

constexpr const char* paper = "Olsson, Jelagin, Partl, section 3.1";
constexpr const char* contact = "Olsson, Jelagin, Partl, section 2.2";
constexpr const char* relaxation = "Olsson, Jelagin, Partl, Eq. 1";
constexpr const char* weibull = "Olsson, Jelagin, Partl, Eq. 4";
constexpr const char* ours = "our choice";

}  // namespace

Section describe(RunScene& run) {
  return {"run",
          "What tells one run of a scene from another.",
          {{&run.seed, "seed", pure, at_least(0),
            "of the random places, sizes and strengths of stones", ours},
           {&run.fidelity,
            "fidelity",
            pure,
            unbounded,
            "the defaults of numerics and modes, as a set",
            "measured, apps/docs/trade.md",
            {},
            fidelities}}};
}

Section describe(StonesScene& stones) {
  return {
      "stones",
      "Stones are spheres; what is finer than the smallest is in the binder phase.",
      {{&stones.count, "count", pure, at_least(1), "number of stones",
        "5000 in the paper's section 3.3", required("5000")},
       {&stones.gradation, "gradation", pure, unbounded,
        "path of the sieve table, from the folder of the scene", "",
        required("\"gradations/sma11.csv\"")},
       {&stones.distribution,
        "distribution",
        pure,
        unbounded,
        "of mass over diameter",
        paper,
        {},
        {"truncated_normal", "log_linear"}},
       {&stones.smallest, "smallest", millimetre, positive,
        "sieve below which stones belong to the binder phase", paper},
       {&stones.density, "density", density, positive, "of the stone",
        "granite 2650 to 2700, from memory"},
       {&stones.young, "young", gigapascal, young_range, "Young's modulus", paper},
       {&stones.poisson, "poisson", pure, poisson_range, "Poisson's ratio", paper},
       {&stones.friction, "friction", pure, friction_range, "Coulomb coefficient between stones",
        contact},
       {&stones.restitution, "restitution", pure, restitution_range,
        "speed after / before a dry impact; absent: no contact damping", ours, optional("0.5")}}};
}

Section describe(std::optional<FractureScene>& fracture) {
  if (!fracture) fracture.emplace();
  return {"stones.fracture",
          "Stones break at strengths of a Weibull law; absent: never.",
          {{&fracture->scale, "scale", megapascal, positive,
            "Weibull scale sigma0 of F / R0^2 at a stone contact", weibull},
           {&fracture->exponent, "exponent", pure, positive, "Weibull exponent m", weibull},
           {&fracture->reference_volume, "reference_volume", cubic_millimetre, positive,
            "V_ref, compared with the cube of a stone's radius", weibull}},
          [&fracture] { fracture.reset(); }};
}

Section describe(std::optional<BinderScene>& binder) {
  if (!binder) binder.emplace();
  return {
      "binder",
      "The shell around each stone, of bitumen and fines; absent: dry stones.\n"
      "Give either the temperature, or shear_modulus, alpha and tau.",
      {{&binder->content, "content", pure, within(0, 1), "mass of bitumen / mass of the mix",
        "SMA 11 S: 6.6 % or more, TL Asphalt-StB", required("\"6.6 %\"")},
       {&binder->density, "density", density, positive, "of the bitumen",
        "1020 to 1030, from memory"},
       {&binder->temperature, "temperature", celsius, unbounded,
        "of the mix, 110 or 150 degC: takes the row of the table",
        "Olsson, Jelagin, Partl, Table 1", alternative("\"150 degC\"")},
       {&binder->shear_modulus, "shear_modulus", megapascal, shear_modulus_range,
        "G0, instantaneous", relaxation, optional("\"6.65 MPa\"")},
       {&binder->alpha, "alpha", pure, above_zero_to(1),
        "shares of G0 that relax if all of the phase is bitumen, sum at most 1", relaxation,
        optional("[0.513, 0.487]")},
       {&binder->tau, "tau", second, positive, "relaxation times, one for each alpha", relaxation,
        optional("[\"0.0948 s\", \"105.9 s\"]")},
       {&binder->bond_energy, "bond_energy", energy_per_area, bond_energy_range,
        "work of separating two shells, per area", contact},
       {&binder->wall_bonds, "wall_bonds", pure, unbounded,
        "shells bond to walls, too, where their films slip by friction all the same; false: "
        "steel with release agent",
        ours},
       {&binder->film,
        "film",
        pure,
        unbounded,
        "what a film forgets where its area shrinks: an even share of its shear, or ring by ring "
        "what its rim has been sheared by, a reference that takes four times as long",
        ours,
        {},
        {"even", "rings"}}},
      [&binder] { binder.reset(); }};
}

Section describe(FillScene& fill) {
  return {"fill",
          "Stones are placed at random as a gas, then fall and come to rest.",
          {{&fill.packing_density, "packing_density", pure,
            above_zero_to(0.38),  // random insertion of spheres jams there: Feder (1980)
            "of the gas", "Olsson, Jelagin, Partl, section 3.2"},
           {&fill.bonds, "bonds", pure, unbounded, "may stones bond while they settle", ours},
           {&fill.rest_energy, "rest_energy", pure, positive,
            "kinetic energy at rest / sum of m g R over the stones", ours}}};
}

}  // namespace apps

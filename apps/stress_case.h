// A case for the validation of wall stresses: the steel, what loads it, how finely it is meshed.
#pragma once

#include <string>
#include <vector>

#include "fem/elastic_body.h"

namespace apps {

struct SteelLoad {
  std::string kind;            // see stress_case.cc
  double pressure = 300e3;     // on the loaded face; of an eccentric load its mean [Pa]
  double length = 100e-3;      // of a pressure band along the axis, at mid-height [m]
  int harmonic = 2;            // n of an ovalling pressure cos(n angle) [-]
  double eccentricity = 5e-3;  // of the resultant from the head's axis [m]
  double force = 1000;         // of a point load, or on one stone [N]
  double moment = 233;         // of a couple on the head [N m]
};

// Stones that load the mould: one that is pressed on it, or a column that fills it.
struct ColumnOfStones {
  int count = 1;
  double smallest = 8e-3;      // diameter [m]
  double largest = 12e-3;      // diameter, all between are equally likely [m]
  double density = 2650;       // [kg/m3]
  double young = 74e9;         // [Pa]
  double poisson = 0.15;       // [-]
  double friction = 0.7;       // between stones [-]
  double wall_friction = 0.3;  // [-]
  double restitution = 0.3;    // [-]
  double mass_scale = 1e4;     // inertia / true inertia [-]
  int modes = 20;              // of the mould's reduced body
  int seed = 1;
};

struct StressCase {
  std::string path;
  fem::Mould mould = {0.150, 7.5e-3, 0.25, fem::BaseSupport::guided, {}};
  fem::Head head = {0.1495, 20e-3, 50e-3, 0.25, {}};
  SteelLoad load;
  ColumnOfStones stones;
  fem::MeshSize mesh;

  std::string name() const;  // of the file, without folder and ending
};

// A complete case as TOML, with the meaning of every key.
std::string stress_case_manual();

// Throws InputError with every mistake found.
StressCase read_stress_case(const std::string& path, const std::vector<std::string>& overrides);

}  // namespace apps

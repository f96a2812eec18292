// One contact and the path it is driven along, as a case file describes them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/mistakes.h"
#include "apps/scene.h"
#include "dem/material.h"

namespace apps {

struct PathPoint {
  double time;     // [s]
  double overlap;  // of the outer surfaces, 0 when they just touch [m]
  double shear;    // tangential displacement of the first body against the second [m]
};

struct PathCase {
  std::string kind;            // "pair" or "wall"
  std::vector<double> radius;  // of the bare stones, two of a pair, one at a wall [m]

  std::optional<BinderScene> binder;  // absent: dry stones
  double shell = 0;                   // [m]
  double bitumen_fraction = 1;        // of the binder phase [-]

  std::optional<StonesScene> stone;   // absent: the shells meet no stone, however deep
  std::string shear = "force";        // "force", "displacement" or "rings": what carries the shear
  int seed = 1;                       // of the strengths, for stones that break
  std::optional<dem::Material> wall;  // absent: a rigid one

  std::vector<PathPoint> path;

  bool at_wall() const { return kind == "wall"; }
};

// The points of a table. `asked` is where its path was written, for when there is no such file.
std::vector<PathPoint> read_path(const std::string& file, const Place& asked, Mistakes& mistakes);

// Reads the case, lays the overrides over it, reads the path it names, and checks all of it. Throws
// InputError with every mistake found.
PathCase read_path_case(const std::string& path, const std::vector<std::string>& overrides);

}  // namespace apps

// Meshes of hexahedra as a plane section of quadrilaterals swept along z (internal to this room:
// deal.II is seen here).
#pragma once

#include <deal.II/grid/tria.h>

#include <array>
#include <vector>

namespace fem {

using Quadrilateral = std::array<unsigned, 4>;  // corners, first local coordinate fastest

// A plane section; parts that are swept further come first in both lists.
struct Section {
  std::vector<dealii::Point<2>> points;  // [m]
  std::vector<Quadrilateral> quadrilaterals;
};

// A sweep of the first `quadrilaterals` (on the first `points`) of a section over levels of z.
struct Sweep {
  unsigned points, quadrilaterals;
  std::vector<double> levels;  // [m] ascending
};

// Every interval cut into `parts` equal ones.
std::vector<double> subdivided(const std::vector<double>& levels, int parts);

// Intervals that grow from `first` by `growth` each, none longer than `longest`.
struct Grading {
  double first, longest;  // [m]
  double growth = 3;      // [-]
};
// Levels from `from` to `to` (either way); all intervals are stretched alike to end at `to`.
std::vector<double> graded(double from, double to, Grading grading);
// The same from both ends to the middle, from < to.
std::vector<double> graded(double from, double to, Grading at_from, Grading at_to);

// Adds rings of quadrilaterals from the closed loop of points `inner` outwards to circles of radii
// [m]; radii[0] stands for the loop itself. Returns the last circle's points.
std::vector<unsigned> add_rings(Section& section, std::vector<unsigned> inner,
                                const std::vector<double>& radii);

// A disc's middle: a grid of cells x cells quadrilaterals, a square bulged half way to a circle so
// that no corner is sharp. Returns its border, counter-clockwise. `radius` [m] is that of the
// circle.
std::vector<unsigned> add_core(Section& section, double radius, int cells);

// Sweeps follow one another along z; a later one starts on the last level of the one before.
void sweep(const Section& section, const std::vector<Sweep>& sweeps,
           dealii::Triangulation<3>& mesh);

double distance_to_axis(const dealii::Point<3>& p);

// Makes every edge that follows a circle of at least `radius` [m] about the axis an arc.
void round_edges(dealii::Triangulation<3>& mesh, double radius);

}  // namespace fem

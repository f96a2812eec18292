#include "fem/body_mesh.h"

#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace fem {
namespace {

using dealii::Point;
using Quadrilateral = std::array<unsigned, 4>;  // corners, first local coordinate fastest

// A plane section; parts that are swept further come first in both lists.
struct Section {
  std::vector<Point<2>> points;  // [m]
  std::vector<Quadrilateral> quadrilaterals;
};

// A sweep of the first `quadrilaterals` (on the first `points`) of a section over levels of z.
struct Sweep {
  unsigned points, quadrilaterals;
  std::vector<double> levels;  // [m] ascending
};

constexpr dealii::types::manifold_id round = 1;

// Every interval cut into `parts` equal ones.
std::vector<double> subdivided(const std::vector<double>& levels, int parts) {
  std::vector<double> finer;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i)
    for (int k = 0; k < parts; ++k)
      finer.push_back(levels[i] + (levels[i + 1] - levels[i]) * k / parts);
  finer.push_back(levels.back());
  return finer;
}

// Levels from `from` to `to` (either way) whose intervals grow from `first` by `growth` each, none
// longer than `longest` [m]; all are stretched alike to end at `to`.
struct Grading {
  double first, longest;  // [m]
  double growth = 3;      // [-]
};
std::vector<double> graded(double from, double to, Grading grading) {
  const double length = std::abs(to - from);
  std::vector<double> reached = {0};
  double interval = grading.first;
  while (reached.back() < length) {
    reached.push_back(reached.back() + interval);
    interval = std::min(interval * grading.growth, grading.longest);
  }
  // Stop short of `to` and stretch, or go beyond it and shrink, whichever changes less.
  if (reached.size() > 2 && length / reached[reached.size() - 2] < reached.back() / length)
    reached.pop_back();
  for (double& level : reached) level = from + (to - from) * level / reached.back();
  return reached;
}

// Adds rings of quadrilaterals from the closed loop of points `inner` outwards to circles of radii
// [m]; radii[0] stands for the loop itself. Returns the last circle's points.
std::vector<unsigned> add_rings(Section& section, std::vector<unsigned> inner,
                                const std::vector<double>& radii) {
  const auto sectors = static_cast<unsigned>(inner.size());
  for (std::size_t ring = 1; ring < radii.size(); ++ring) {
    const double radius = radii[ring];
    std::vector<unsigned> outer(sectors);
    for (unsigned k = 0; k < sectors; ++k) {
      const auto& p = section.points[inner[k]];
      outer[k] = static_cast<unsigned>(section.points.size());
      section.points.push_back(p * (radius / p.norm()));
    }
    for (unsigned k = 0; k < sectors; ++k) {
      const unsigned next = (k + 1) % sectors;
      section.quadrilaterals.push_back({inner[k], outer[k], inner[next], outer[next]});
    }
    inner = outer;
  }
  return inner;
}

// A disc's middle: a grid of cells x cells quadrilaterals, a square bulged half way to a circle so
// that no corner is sharp. Returns its border, counter-clockwise. `radius` [m] is that of the
// circle.
std::vector<unsigned> add_core(Section& section, double radius, int cells) {
  constexpr double square = 0.425;  // corners at 1.10, sides at 0.925 of `radius`
  constexpr double circle = 0.5;
  const auto at = [&](int i) {  // equal angles along the border, as the rings outside need
    return std::tan(std::numbers::pi / 4 * (2.0 * i / cells - 1));
  };
  const auto number = [&](int i, int j) { return static_cast<unsigned>(j * (cells + 1) + i); };
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const Point<2> p(at(i), at(j));
      const double length = p.norm();
      const double bulge =
          length > 0 ? circle * std::max(std::abs(p[0]), std::abs(p[1])) / length : 0;
      section.points.push_back(p * (radius * (square + bulge)));
    }
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i)
      section.quadrilaterals.push_back(
          {number(i, j), number(i + 1, j), number(i, j + 1), number(i + 1, j + 1)});

  std::vector<unsigned> border;
  for (int i = 0; i < cells; ++i) border.push_back(number(i, 0));
  for (int i = 0; i < cells; ++i) border.push_back(number(cells, i));
  for (int i = cells; i > 0; --i) border.push_back(number(i, cells));
  for (int i = cells; i > 0; --i) border.push_back(number(0, i));
  return border;
}

// Sweeps follow one another along z; a later one starts on the last level of the one before.
void sweep(const Section& section, const std::vector<Sweep>& sweeps,
           dealii::Triangulation<3>& mesh) {
  std::vector<Point<3>> points;
  std::vector<dealii::CellData<3>> cells;
  unsigned below = 0;  // first point of the level below
  for (const Sweep& part : sweeps)
    for (std::size_t level = 0; level < part.levels.size(); ++level) {
      if (level == 0 && !points.empty()) continue;
      const auto here = static_cast<unsigned>(points.size());
      for (unsigned i = 0; i < part.points; ++i)
        points.emplace_back(section.points[i][0], section.points[i][1], part.levels[level]);
      if (level > 0)
        for (unsigned i = 0; i < part.quadrilaterals; ++i) {
          dealii::CellData<3> cell;
          for (unsigned k = 0; k < 4; ++k) {
            cell.vertices[k] = below + section.quadrilaterals[i][k];
            cell.vertices[k + 4] = here + section.quadrilaterals[i][k];
          }
          cells.push_back(cell);
        }
      below = here;
    }
  mesh.create_triangulation(points, cells, dealii::SubCellData());
}

double distance_to_axis(const Point<3>& p) {
  return std::hypot(p[0], p[1]);
}

// Makes every edge that follows a circle of at least `radius` [m] about the axis an arc.
void round_edges(dealii::Triangulation<3>& mesh, double radius) {
  const double margin = 1e-9 * radius;  // far above rounding, far below an edge
  for (const auto& cell : mesh.active_cell_iterators())
    for (const unsigned i : cell->line_indices()) {
      const auto line = cell->line(i);
      const double first = distance_to_axis(line->vertex(0));
      const double second = distance_to_axis(line->vertex(1));
      const bool level = std::abs(line->vertex(0)[2] - line->vertex(1)[2]) < margin;
      if (level && std::abs(first - second) < margin && first > radius - margin)
        line->set_manifold_id(round);
    }
  mesh.set_manifold(round, dealii::CylindricalManifold<3>(2));
}

template <typename IsLoaded, typename IsSupport>
void mark_boundary(dealii::Triangulation<3>& mesh, IsLoaded is_loaded, IsSupport is_support) {
  for (const auto& cell : mesh.active_cell_iterators())
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary()) continue;
      const Point<3> centre = face->center();
      face->set_boundary_id(is_loaded(centre)    ? loaded_part
                            : is_support(centre) ? support_part
                                                 : free_part);
    }
}

int parts(MeshSize size) {
  return 1 << size.refinement;
}

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

void check(const Steel& steel) {
  require(steel.young > 0, "steel: young must be positive");
  require(steel.poisson > -1 && steel.poisson < 0.5, "steel: poisson must be in (-1, 0.5)");
  require(steel.density > 0, "steel: density must be positive");
}

void check(MeshSize size) {
  require(size.refinement >= 0 && size.refinement <= 4, "mesh: refinement must be 0 to 4");
  require(size.degree == 1 || size.degree == 2, "mesh: degree must be 1 or 2");
}

}  // namespace

void make_mesh(const Head& head, MeshSize size, dealii::Triangulation<3>& mesh) {
  check(head.steel);
  check(size);
  require(head.shaft_diameter > 0, "head: shaft_diameter must be positive");
  require(head.shaft_diameter < head.plate_diameter,
          "head: shaft_diameter must be below plate_diameter");
  require(head.plate_thickness > 0, "head: plate_thickness must be positive");
  require(head.shaft_length > 0, "head: shaft_length must be positive");

  const double shaft = head.shaft_diameter / 2;
  const double plate = head.plate_diameter / 2;
  const double thickness = head.plate_thickness;
  const double top = thickness + head.shaft_length;
  constexpr double core = 0.65;        // core's share of the shaft's radius
  constexpr double slenderness = 1.2;  // a shaft element's length over the shaft's diameter
  // Elements shrink towards the corner of plate and shaft, where stress is singular.
  const double corner = 0.08 * std::min(thickness, shaft);
  const Grading to_core{corner, shaft}, to_rim{corner, plate / 3}, to_face{corner, thickness / 2},
      to_root{corner, slenderness * head.shaft_diameter},
      from_root{0.2 * shaft, slenderness * head.shaft_diameter};

  auto radii = graded(shaft, core * shaft, to_core);
  std::reverse(radii.begin(), radii.end());
  auto layers = graded(thickness, 0, to_face);
  std::reverse(layers.begin(), layers.end());
  // The clamped root hinders the section's contraction: smaller elements there, too.
  const double middle = thickness + head.shaft_length / 2;
  auto levels = graded(thickness, middle, to_root);
  auto upper = graded(top, middle, from_root);
  levels.insert(levels.end(), std::next(upper.rbegin()), upper.rend());

  Section section;
  const auto core_border = add_core(section, core * shaft, 3 * parts(size));
  const auto shaft_border = add_rings(section, core_border, subdivided(radii, parts(size)));
  const auto shaft_points = static_cast<unsigned>(section.points.size());
  const auto shaft_quadrilaterals = static_cast<unsigned>(section.quadrilaterals.size());
  add_rings(section, shaft_border, subdivided(graded(shaft, plate, to_rim), parts(size)));

  sweep(section,
        {{static_cast<unsigned>(section.points.size()),
          static_cast<unsigned>(section.quadrilaterals.size()), subdivided(layers, parts(size))},
         {shaft_points, shaft_quadrilaterals, subdivided(levels, parts(size))}},
        mesh);
  round_edges(mesh, shaft);
  const double margin = 1e-9 * top;
  mark_boundary(
      mesh, [&](const Point<3>& p) { return p[2] < margin; },
      [&](const Point<3>& p) { return p[2] > top - margin; });
}

void make_mesh(const Mould& mould, MeshSize size, dealii::Triangulation<3>& mesh) {
  check(mould.steel);
  check(size);
  require(mould.inner_diameter > 0, "mould: inner_diameter must be positive");
  require(mould.wall_thickness > 0, "mould: wall_thickness must be positive");
  require(mould.height > 0, "mould: height must be positive");

  const double inner = mould.inner_diameter / 2;
  const double outer = inner + mould.wall_thickness;
  // Length over which a shell's edge disturbance decays; Timoshenko & Woinowsky-Krieger (1959), 15.
  const double nu = mould.steel.poisson;
  const double decay =
      std::sqrt((inner + outer) / 2 * mould.wall_thickness) / std::pow(3 * (1 - nu * nu), 0.25);
  const int sectors = 24 * parts(size);
  const double wall = mould.wall_thickness;
  // One element through a thin wall, more where the stress is far from linear across it.
  const double slice = wall / std::clamp(std::ceil(std::sqrt(8 * wall / inner)), 1.0, 4.0);
  const Grading across{slice, slice};
  const double layer = mould.height / std::clamp(std::ceil(mould.height / decay), 6.0, 20.0);
  const Grading along{std::min(wall / 4, layer), layer};  // small where the base holds the wall

  Section section;
  std::vector<unsigned> border(sectors);
  for (int k = 0; k < sectors; ++k) {
    const double angle = 2 * std::numbers::pi * k / sectors;
    section.points.emplace_back(inner * std::cos(angle), inner * std::sin(angle));
    border[k] = k;
  }
  add_rings(section, border, subdivided(graded(inner, outer, across), parts(size)));

  sweep(section,
        {{static_cast<unsigned>(section.points.size()),
          static_cast<unsigned>(section.quadrilaterals.size()),
          subdivided(graded(0, mould.height, along), parts(size))}},
        mesh);
  round_edges(mesh, inner);
  const double margin = 1e-9 * mould.height;
  // A flat face's centre lies inside its arc, by far less than half a wall.
  const double middle = (inner + outer) / 2;
  mark_boundary(
      mesh,
      [&](const Point<3>& p) {
        return distance_to_axis(p) < middle && p[2] > margin && p[2] < mould.height - margin;
      },
      [&](const Point<3>& p) { return p[2] < margin; });
}

}  // namespace fem

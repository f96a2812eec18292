#include "fem/sweep_mesh.h"

#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace fem {
namespace {

using dealii::Point;

constexpr dealii::types::manifold_id round = 1;

}  // namespace

std::vector<double> subdivided(const std::vector<double>& levels, int parts) {
  std::vector<double> finer;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i)
    for (int k = 0; k < parts; ++k)
      finer.push_back(levels[i] + (levels[i + 1] - levels[i]) * k / parts);
  finer.push_back(levels.back());
  return finer;
}

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

std::vector<double> graded(double from, double to, Grading at_from, Grading at_to) {
  const double middle = (from + to) / 2;
  auto levels = graded(from, middle, at_from);
  const auto upper = graded(to, middle, at_to);
  levels.insert(levels.end(), std::next(upper.rbegin()), upper.rend());
  return levels;
}

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

}  // namespace fem

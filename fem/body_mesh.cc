#include "fem/body_mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "fem/sweep_mesh.h"

namespace fem {
namespace {

using dealii::Point;

template <typename PartOf>
void mark_boundary(dealii::Triangulation<3>& mesh, PartOf part_of) {
  for (const auto& cell : mesh.active_cell_iterators())
    for (const auto& face : cell->face_iterators())
      if (face->at_boundary()) face->set_boundary_id(part_of(face->center()));
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
  require(size.at_centre >= 0, "mesh: at_centre must not be negative");
}

// Levels of a mould, small where the base holds the wall and about the levels asked for.
std::vector<double> mould_levels(const Mould& mould, std::vector<double> asked, double decay) {
  const double layer = mould.height / std::clamp(std::ceil(mould.height / decay), 6.0, 20.0);
  const Grading fine{std::min(mould.wall_thickness / 4, layer), layer};
  if (asked.empty()) return graded(0, mould.height, fine);
  std::sort(asked.begin(), asked.end());
  require(asked.front() > 0 && asked.back() < mould.height, "mesh: levels must lie in the mould");
  asked.push_back(mould.height);
  std::vector<double> levels = {0};
  for (const double next : asked) {
    const auto more =
        graded(levels.back(), next, fine, next < mould.height ? fine : Grading{layer, layer});
    levels.insert(levels.end(), std::next(more.begin()), more.end());
  }
  return levels;
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
  constexpr double core_share = 0.65;       // core's radius over the shaft's
  constexpr double core_per_element = 1.6;  // core's radius over the size of its elements
  constexpr double gentle = 1.5;            // growth where a field falls off as 1 / distance
  constexpr double slenderness = 1.2;       // a shaft element's length over the shaft's diameter
  constexpr double slender_plate = 3;       // a plate element's width over the plate's thickness
  // Elements shrink towards the corner of plate and shaft, where stress is singular.
  const double corner = 0.08 * std::min(thickness, shaft);
  const Grading to_core{corner, shaft},
      to_rim{corner, std::min(plate / 3, slender_plate * thickness)},
      to_face{corner, thickness / 2}, to_root{corner, slenderness * head.shaft_diameter},
      from_root{0.2 * shaft, slenderness * head.shaft_diameter};

  const double core = size.at_centre > 0 ? core_per_element * size.at_centre : core_share * shaft;
  require(core < shaft, "mesh: at_centre must be well below the shaft's radius");
  auto radii = graded(shaft, core, to_core);
  std::reverse(radii.begin(), radii.end());
  auto layers = graded(thickness, 0, to_face);
  std::reverse(layers.begin(), layers.end());
  if (size.at_centre > 0) {
    const Grading from_centre{size.at_centre, shaft / 3, gentle};
    const Grading from_face{size.at_centre, thickness / 4, gentle};
    radii = graded(core, shaft, from_centre, to_core);
    layers = graded(0, thickness, from_face, to_face);
  }
  // The clamped root hinders the section's contraction: smaller elements there, too.
  const auto levels = graded(thickness, top, to_root, from_root);

  Section section;
  const auto core_border = add_core(section, core, 3 * parts(size));
  const auto shaft_border = add_rings(section, core_border, subdivided(radii, parts(size)));
  const auto shaft_points = static_cast<unsigned>(section.points.size());
  const auto shaft_quadrilaterals = static_cast<unsigned>(section.quadrilaterals.size());
  add_rings(section, shaft_border, subdivided(graded(shaft, plate, to_rim), parts(size)));

  sweep(section,
        {{static_cast<unsigned>(section.points.size()),
          static_cast<unsigned>(section.quadrilaterals.size()), subdivided(layers, parts(size))},
         {shaft_points, shaft_quadrilaterals, subdivided(levels, parts(size))}},
        mesh);
  round_edges(mesh, size.at_centre > 0 ? radii[1] : shaft);
  const double margin = 1e-9 * top;
  mark_boundary(mesh, [&](const Point<3>& p) {
    return p[2] < margin ? loaded_part : p[2] > top - margin ? support_part : free_part;
  });
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
  // A thin wall between the two Gauss points of a long arc hardly resists: arcs of 1.6 sqrt(a t).
  const double arcs = std::ceil(3.9 * std::sqrt(inner / mould.wall_thickness));
  const int sectors = std::max(24, static_cast<int>(arcs)) * parts(size);
  // Radii grow in equal ratios: Lame's stresses go with 1 / r^2, and what an element leaves out of
  // them goes with the square of its ratio less one.
  constexpr double largest_ratio = 1.1, rounding = 1e-9;
  const int slices = static_cast<int>(
      std::max(1.0, std::ceil(std::log(outer / inner) / std::log(largest_ratio) - rounding)));
  std::vector<double> radii;
  for (int i = 0; i <= slices; ++i)
    radii.push_back(inner * std::pow(outer / inner, static_cast<double>(i) / slices));

  Section section;
  std::vector<unsigned> border(sectors);
  for (int k = 0; k < sectors; ++k) {
    const double angle = 2 * std::numbers::pi * k / sectors;
    section.points.emplace_back(inner * std::cos(angle), inner * std::sin(angle));
    border[k] = k;
  }
  add_rings(section, border, subdivided(radii, parts(size)));

  sweep(section,
        {{static_cast<unsigned>(section.points.size()),
          static_cast<unsigned>(section.quadrilaterals.size()),
          subdivided(mould_levels(mould, size.levels, decay), parts(size))}},
        mesh);
  round_edges(mesh, inner);
  const double margin = 1e-9 * mould.height;
  // A flat face's centre lies inside its arc, by far less than half a wall.
  const double middle = (inner + outer) / 2;
  mark_boundary(mesh, [&](const Point<3>& p) {
    if (p[2] < margin) return support_part;
    if (p[2] > mould.height - margin) return free_part;
    // Inside a thick wall only its faces are boundary.
    return distance_to_axis(p) < middle ? loaded_part : back_part;
  });
}

}  // namespace fem

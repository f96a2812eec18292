// Beds of dry stones at rest in a cylinder against statics: what the floor carries, and what the
// wall takes from it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "apps/bed.h"
#include "tests/physics/check.h"

namespace dem {
namespace {

using apps::DampedDry;
using checks::at_least, checks::check, checks::relative;

constexpr double gravity = 9.81;                       // [m/s2]
constexpr double smallest = 1.1e-3, largest = 1.4e-3;  // radii of the stones [m]
enum Part { base, ring };                              // the walls, in the order they are added

// A bed at rest, filled as a gas. Soft stones take longer steps: they overlap by a percent.
Simulation<DampedDry> settled(int count, double cylinder, double friction, double wall_friction) {
  apps::StonesScene scene;
  scene.young = 10e6;
  scene.poisson = 0.2;
  scene.density = 2650;
  scene.friction = friction;
  scene.restitution = 0.3;
  apps::Mix mix;
  for (int k = 0; k < count; ++k)
    mix.radius.push_back(smallest + (largest - smallest) * (k + 0.5) / count);
  const apps::LawBook book(scene, std::nullopt, mix);
  apps::FillScene fill;
  fill.rest_energy = 1e-4;
  apps::NumericsScene numerics;
  numerics.mass_scale = 1;
  auto bed = apps::make_bed<DampedDry>(scene, mix, book, fill, numerics, 1, RoundMould{cylinder});
  const DampedDry law = book.law<DampedDry>({apps::rigid, wall_friction}, false);
  bed.add_wall({"floor", Plane{}, {}}, law);
  bed.add_wall({"cylinder", CylinderInside{cylinder}, {}}, law);
  apps::settle(bed, fill, [](double) {});
  return bed;
}

double weight_of(const ParticleStore& stones) {
  double weight = 0;
  for (const double mass : stones.mass) weight += gravity * mass;
  return weight;
}

TEST(statics, the_floor_of_a_frictionless_bed_carries_its_whole_weight) {
  // Closed form: smooth walls carry no weight. What is left of motion when the bed counts as at
  // rest averages out over half a time of free fall; 0.1 % is what the task asks for.
  auto bed = settled(200, 7e-3, 0, 0);
  const double end = bed.time() + 0.05;
  double impulse = 0, span = 0;
  while (bed.time() < end) {
    bed.step();
    impulse += bed.walls()[base].push * bed.time_step();
    span += bed.time_step();
  }
  check({"floor force of a frictionless bed / its weight", "1",
         impulse / span / weight_of(bed.stones()), 1, relative(1e-3), "closed form"});
}

// Means over time and over the rows of a letterbox on the wall of a column.
struct Column {
  double radius, depth, weight;       // [m], [m], [N]
  double base_push = 0;               // [N]
  std::vector<double> height;         // of the rows [m]
  std::vector<double> push, carried;  // of the stones on each row, outwards and downwards [N]
  double pressed() const {            // normal force on the whole wall [N]
    return std::accumulate(push.begin(), push.end(), 0.0);
  }
  double held() const {  // weight that the whole wall carries [N]
    return std::accumulate(carried.begin(), carried.end(), 0.0);
  }
};

// The wall is drawn up by a tenth of a stone, so that its friction is mobilised, and watched while
// it moves on.
Column drawn_up(Simulation<DampedDry>& bed, double cylinder) {
  Column column = {cylinder, mean_of_highest(bed.stones(), 10), weight_of(bed.stones())};
  constexpr int rows = 24, sectors = 32;
  const double top = 1.1 * column.depth;
  Wall& wall = bed.walls()[ring];
  wall.field.emplace(CylinderGrid{cylinder, top, rows, sectors});
  column.push.assign(rows + 1, 0);
  column.carried.assign(rows + 1, 0);
  for (int row = 0; row <= rows; ++row) column.height.push_back(top * row / rows);
  const double duration = 6 * std::sqrt(2 * column.depth / gravity);
  wall.motion = Driven{{0, 0, 0.2 * 2 * smallest / duration}};
  const double start = bed.time(), watch = start + 0.5 * duration;
  double span = 0;
  while (bed.time() < start + duration) {
    bed.step();
    if (bed.time() > watch) {
      span += bed.time_step();
      column.base_push += bed.walls()[base].push * bed.time_step();
      for (std::size_t n = 0; n < wall.field->size(); ++n) {
        const Vec3d& x = wall.field->node[n];
        const Vec3d& impulse = wall.field->impulse[n];
        const auto row = static_cast<std::size_t>(std::lround(x.z / top * rows));
        column.push[row] += (impulse.x * x.x + impulse.y * x.y) / cylinder;
        column.carried[row] -= impulse.z;
      }
    }
    std::ranges::fill(wall.field->impulse, Vec3d{0, 0, 0});
  }
  column.base_push /= span;
  for (double& push : column.push) push /= span;
  for (double& carried : column.carried) carried /= span;
  return column;
}

// Janssen (1895): decay length of a column whose base bears `share` of its weight, / its depth,
// from share = x (1 - exp(-1/x)), by bisection.
double decay_length(double share) {
  double low = 1e-3, high = 1e3;
  for (int k = 0; k < 100; ++k) {
    const double x = 0.5 * (low + high);
    (x * (1 - std::exp(-1 / x)) < share ? low : high) = x;
  }
  return low;
}

TEST(statics, a_column_rests_on_its_wall_as_janssen_says) {
  // Janssen (1895): lambda = R / (2 mu K). mu is the friction that is mobilised, wall friction /
  // normal force, K is wall pressure / vertical stress, both means over the depth, the stress from
  // the weight above and what the wall above carries; lambda is that of the base's share of the
  // weight. 15 %: the column is three stones from axis to wall, and K varies with height.
  constexpr double cylinder = 8e-3, wall_friction = 0.2;
  auto bed = settled(700, cylinder, 0.6, wall_friction);
  const Column column = drawn_up(bed, cylinder);
  check({"floor and wall force of a column / its weight", "1",
         (column.base_push + column.held()) / column.weight, 1, relative(5e-3), "balance"});
  const double mobilised = column.held() / column.pressed();
  check({"wall friction of a column drawn along / mu N", "1", mobilised / wall_friction, 0.8,
         at_least, "nearly all of it slides; stones at rest on the wall may roll"});
  const double area = std::numbers::pi * cylinder * cylinder;
  double stress = 0;  // mean over the depth of the vertical stress [Pa]
  const auto& stones = bed.stones();
  for (std::size_t k = 0; k < stones.size(); ++k)
    stress += gravity * stones.mass[k] * stones.position[k].z / column.depth / area;
  for (std::size_t row = 0; row < column.height.size(); ++row)
    stress -= column.carried[row] * std::min(1.0, column.height[row] / column.depth) / area;
  const double pressure = column.pressed() / (2 * std::numbers::pi * cylinder * column.depth);
  const double predicted = cylinder / (2 * mobilised * pressure / stress);
  const double found = column.depth * decay_length(column.base_push / column.weight);
  check({"Janssen's decay length of a column, wall friction mobilised", "m", found, predicted,
         relative(0.15), "R / (2 mu K), Janssen (1895), mu and K measured"});
}

}  // namespace
}  // namespace dem

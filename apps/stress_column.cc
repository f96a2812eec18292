#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "apps/bed.h"
#include "apps/errors.h"
#include "apps/steel_answers.h"
#include "apps/stress_cases.h"
#include "coupling/elastic_wall.h"

namespace apps {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

constexpr int sectors = 32;  // of the letterbox
enum Part { base, ring };    // the walls, in the order they are added

Mix mix_of(const ColumnOfStones& stones) {
  Mix mix;
  for (int k = 0; k < stones.count; ++k) {
    const double share = (k + 0.5) / stones.count;
    mix.radius.push_back((stones.smallest + share * (stones.largest - stones.smallest)) / 2);
  }
  return mix;
}

StonesScene scene_of(const ColumnOfStones& stones) {
  StonesScene scene;
  scene.count = stones.count;
  scene.density = stones.density;
  scene.young = stones.young;
  scene.poisson = stones.poisson;
  scene.friction = stones.friction;
  scene.restitution = stones.restitution;
  return scene;
}

// Means over the time that the column is watched.
struct Watch {
  double span = 0;            // [s]
  double base_push = 0;       // [N]
  dem::Vec3d ring_force{};    // [N]
  double ring_push = 0;       // [N]
  Eigen::Matrix3Xd nodal;     // of the letterbox [N]
  Eigen::VectorXd amplitude;  // of the modes [m]

  void finish() {
    base_push /= span;
    ring_force = ring_force * (1 / span);
    ring_push /= span;
    nodal /= span;
    amplitude /= span;
  }
};

// Janssen (1895): decay length / depth of a column whose base bears `share` of its weight, from
// share = x (1 - exp(-1/x)), by bisection.
double janssen_length(double share) {
  double low = 1e-3, high = 1e3;
  for (int k = 0; k < 200; ++k) {
    const double x = 0.5 * (low + high);
    (x * (1 - std::exp(-1 / x)) < share ? low : high) = x;
  }
  return low;
}

// Share of the wall's normal force that acts on the lower half, p ~ 1 - exp(-z / lambda).
double janssen_lower_half(double length) {
  const auto integral = [=](double z) { return z + length * std::exp(-z / length); };
  return (integral(1) - integral(0.5)) / (integral(1) - integral(0));
}

// Hoop force through a section, mean over all sections: (1 / 2 pi) integral of stress / r dV, by
// the cells' corners.
double hoop_force(const fem::ElasticBody& body, const Eigen::VectorXd& displacement) {
  const Eigen::VectorXd hoop = hoop_stress(body, displacement);
  const fem::CellMesh& cells = body.cells();
  double sum = 0;
  for (std::size_t first = 0; first < cells.hexahedra.size(); first += 8) {
    double mean = 0;
    std::array<Vector3d, 8> x;
    for (int k = 0; k < 8; ++k) {
      const int point = cells.hexahedra[first + k];
      x[k] = cells.points.col(point);
      mean += hoop[cells.node[point]] / std::hypot(x[k][0], x[k][1]) / 8;
    }
    const Vector3d along = (x[1] + x[2] + x[5] + x[6] - x[0] - x[3] - x[4] - x[7]) / 4;
    const Vector3d across = (x[2] + x[3] + x[6] + x[7] - x[0] - x[1] - x[4] - x[5]) / 4;
    const Vector3d up = (x[4] + x[5] + x[6] + x[7] - x[0] - x[1] - x[2] - x[3]) / 4;
    sum += mean * std::abs(along.cross(across).dot(up));
  }
  return sum / (2 * pi);
}

}  // namespace

// The column settles in a rigid mould; the mould, elastic from now on, is drawn up slowly so that
// wall friction is mobilised, and watched while it moves.
StressReport settle_column(const StressCase& given) {
  const ColumnOfStones& stones = given.stones;
  const double inner = given.mould.inner_diameter / 2;
  const Mix mix = mix_of(stones);
  const StonesScene scene = scene_of(stones);
  const LawBook book(scene, std::nullopt, mix);
  NumericsScene numerics;
  numerics.mass_scale = stones.mass_scale;
  auto column = make_bed<DampedDry>(scene, mix, book, FillScene{}, numerics, stones.seed,
                                    dem::RoundMould{inner});
  const dem::Material steel = {given.mould.steel.young, given.mould.steel.poisson};
  const auto wall_law = book.law<DampedDry>({steel, stones.wall_friction}, false);
  dem::Wall floor, wall;
  floor.name = "floor";
  floor.surface = dem::Plane{};
  wall.name = "mould";
  wall.surface = dem::CylinderInside{inner};
  column.add_wall(floor, wall_law);
  column.add_wall(wall, wall_law);
  settle(column, FillScene{}, [](double) {});

  const double depth = dem::mean_of_highest(column.stones(), 5);
  if (depth > given.mould.height)
    throw InputError({given.path + ": expected stones that fit into the mould, found a column of " +
                      std::to_string(depth) + " m; lower stones.count or raise mould.height"});
  const fem::ElasticBody body(given.mould, given.mesh);
  dem::Wall& mould = column.walls()[ring];
  const double cell = 2 * pi * inner / sectors;
  const int rows = std::max(4, static_cast<int>(std::lround(given.mould.height / cell)));
  mould.field.emplace(dem::CylinderGrid{inner, given.mould.height, rows, sectors});
  coupling::ExchangeSettings exchange;
  exchange.interval = 1;
  exchange.inertia_scale = stones.mass_scale;
  coupling::ElasticWall elastic(
      reduced_mould(body, stones.modes, coupling::letterbox_points(mould)), mould, exchange);

  double weight = 0;
  for (const double m : column.stones().mass) weight += dem::earth_gravity * m;
  const double fall =
      std::sqrt(2 * depth * stones.mass_scale / dem::earth_gravity);  // [s], of scaled stones
  const double stroke = 0.1 * stones.smallest, start = column.time(), end = start + 10 * fall;
  mould.motion = dem::Driven{{0, 0, stroke / (end - start)}};
  const auto nodes = static_cast<Eigen::Index>(mould.field->size());
  Watch watch;
  watch.nodal = Eigen::Matrix3Xd::Zero(3, nodes);
  watch.amplitude = Eigen::VectorXd::Zero(elastic.amplitude().size());
  while (column.time() < end) {
    column.step();
    const double dt = column.last_step();
    const bool watched = column.time() > start + 0.5 * (end - start);
    if (watched) {
      watch.span += dt;
      watch.base_push += column.walls()[base].push * dt;
      watch.ring_force += mould.force * dt;
      watch.ring_push += mould.push * dt;
      watch.nodal += Eigen::Map<const Eigen::Matrix3Xd>(&mould.field->impulse.front().x, 3, nodes);
    }
    elastic.exchange(mould, {dt, column.time_step()});
    if (watched) watch.amplitude += elastic.amplitude() * dt;
  }
  watch.finish();

  Eigen::VectorXd load = Eigen::VectorXd::Zero(body.unknowns());
  const double row = given.mould.height / rows;
  double radial = 0, lower = 0;  // a node's force is that of half a row on either side
  for (Eigen::Index n = 0; n < nodes; ++n) {
    if (watch.nodal.col(n).isZero(0)) continue;
    const dem::Vec3d& x = mould.field->node[n];
    const double outwards = (watch.nodal(0, n) * x.x + watch.nodal(1, n) * x.y) / inner;
    radial += outwards;
    lower += outwards * std::clamp((depth / 2 - x.z) / row + 0.5, 0.0, 1.0);
    load += body.point_load({x.x, x.y, x.z}, watch.nodal.col(n));
  }
  const Eigen::VectorXd displacement = body.solve(load);
  const fem::ReducedBody& modes = elastic.body();
  const Eigen::VectorXd answer =
      (modes.shape.transpose() * watch.nodal.reshaped()).cwiseQuotient(modes.stiffness);
  const double length = janssen_length(watch.base_push / weight);

  StressReport report{
      {{"vertical_force", "N", watch.base_push - watch.ring_force.z, weight, "weight of the stones",
        0.01},
       {"traction_resultant", "N", watch.nodal.row(2).sum(), watch.ring_force.z,
        "sum of the contact forces, of the wall's push", 1e-9, watch.ring_push},
       {"radial_resultant", "N", radial, watch.ring_push,
        "sum of the contacts' normal forces; chords of the letterbox lose up to 1-cos(pi/32)",
        0.005},
       {"fe_reaction", "N", -body.reaction(displacement, load)[2], watch.ring_force.z,
        "balance, of the wall's push", 1e-8, watch.ring_push},
       {"hoop_force", "N", hoop_force(body, displacement), radial / (2 * pi),
        "balance of half a ring, sum of radial forces / 2 pi", 0.02},
       {"modal_answer", "m", watch.amplitude.norm(), answer.norm(),
        "static answer of the modes to the mean load", 0.02},
       {"wall_force_lower_half", "1", lower / radial, janssen_lower_half(length),
        "a plausible profile: Janssen's at the base's share of the weight; tolerance 15 %: the "
        "column is a few stones wide, hydrostatic pressure passes too",
        0.15}},
      loaded_body(body, displacement),
      {}};
  const Eigen::VectorXd hoop =
      body.face_values(hoop_stress(body, displacement), coupling::letterbox_points(mould));
  for (Eigen::Index n = 0; n < nodes; ++n) {
    const dem::Vec3d& x = mould.field->node[n];
    const double outwards = (watch.nodal(0, n) * x.x + watch.nodal(1, n) * x.y) / inner;
    report.map.push_back({std::atan2(x.y, x.x), x.z, outwards / mould.field->area[n], hoop[n]});
  }
  return report;
}

}  // namespace apps

// The parts of a step, each alone, on a bed of about 5000 stones on a lattice: three stone contacts
// for each, as in a settled bed. Items are contacts, stones or, for the laws, contacts in
// registers.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <cmath>
#include <random>
#include <vector>

#include "dem/integrator.h"
#include "dem/laws/binder.h"
#include "dem/laws/fracture.h"
#include "dem/laws/mindlin.h"
#include "dem/laws/sum.h"
#include "dem/pair_contacts.h"
#include "dem/spatial_order.h"
#include "dem/wall_contacts.h"

namespace {

using dem::Pack, dem::Vec3d;
using Dry = dem::Mindlin<dem::Hertz<dem::Damping::restitution>>;
using Asphalt = dem::Sum<dem::Fracture<dem::Mindlin<>>, dem::Binder<2>>;
constexpr double dt = 1e-6;       // [s]
constexpr double skin = 2e-5;     // [m]
constexpr double spacing = 5e-3;  // of the lattice [m]
constexpr int side = 17;          // stones along an edge

// Shells are inside of the radii, so that all laws touch at the same pairs.
template <class Law>
struct Case;

template <>
struct Case<Dry> {
  static constexpr double shell = 0;
  static Dry law() { return {{5.1e8, 0.3}, 1.2e8, 0.7}; }
};

template <>
struct Case<Asphalt> {
  static constexpr double shell = 0.5e-3;
  static Asphalt law() {
    return {{{{5.1e8}, 1.2e8, 0.7, 2 * shell}},
            {6.65e6, {0.22, 0.21}, {0.0948, 105.9}, 8.0 / 3, 2 * shell, {1e4}}};
  }
};

template <class Law>
struct Bed {
  dem::ParticleStore stones;
  dem::NeighborList list;
  dem::PairContacts<Law> pairs;
  std::vector<double> outer;
  dem::Wall floor;
  dem::WallContacts<Law> at_floor;

  Bed() {
    constexpr double shell = Case<Law>::shell;
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> any(-1, 1);
    std::vector<Vec3d> position;
    std::vector<double> radius;
    for (int k = 0; k < side * side * side; ++k) {
      const Vec3d place = {1.0 * (k % side), 1.0 * (k / side % side), 1.0 * (k / side / side)};
      position.push_back((place + Vec3d{0, 0, 0.5}) * spacing +
                         Vec3d{any(engine), any(engine), any(engine)} * 2e-6);
      radius.push_back(spacing / 2 - shell + 3e-6);
    }
    stones = dem::make_stones(position, radius, {2650, shell}, 1);
    stones.softness.assign(stones.size(), 1);
    for (Vec3d& v : stones.velocity) v = Vec3d{any(engine), any(engine), any(engine)} * 1e-3;
    dem::reorder(stones, dem::spatial_order(stones.position, 2 * spacing));
    for (std::size_t k = 0; k < stones.size(); ++k) outer.push_back(stones.outer_radius(k));
    pairs.law = at_floor.law = Case<Law>::law();
    pairs.law.set_time_step(dt);
    at_floor.law.set_time_step(dt);
    floor.surface = dem::Plane{};
    make_list();
    at_floor.find(stones, floor, skin,
                  dem::leashes(stones, skin, dem::extra_skin(stones, skin, dt)));
    dem::weigh(stones, 9.81);
  }

  void make_list() {
    list.build({stones.position, outer, stones.id}, skin);
    pairs.take(list, stones);
  }
};

template <class T, class Law>
void law(benchmark::State& state) {
  Law law = Case<Law>::law();
  law.set_time_step(dt);
  dem::Contact<T> contact;
  contact.overlap = T(2 * Case<Law>::shell + 5e-6);
  contact.outer_radius = contact.stone_radius = T(1.2e-3);
  contact.mass = T(1e-4);
  contact.softness = T(1.0);
  contact.normal = {T(0.0), T(0.0), T(1.0)};
  contact.closing = T(1e-3);
  contact.sliding = {T(1e-9), T(0.0), T(0.0)};
  contact.turn = {T(0.0), T(1e-7), T(0.0)};
  contact.horizon = T(0.0);
  typename Law::template Memory<T> memory = {};
  for (auto _ : state) benchmark::DoNotOptimize(law(contact, memory));
  state.SetItemsProcessed(state.iterations() * dem::width<T>);
}

template <class T, class Law>
void pair_stage(benchmark::State& state) {
  Bed<Law> bed;
  for (auto _ : state) bed.pairs.template evaluate<T>(bed.stones, dt);
  state.SetItemsProcessed(state.iterations() * bed.pairs.slots());
}

void wall_stage(benchmark::State& state) {
  Bed<Dry> bed;
  for (auto _ : state) bed.at_floor.evaluate(bed.stones, bed.floor, dt);
  state.SetItemsProcessed(state.iterations() * bed.at_floor.slots());
}

void motion(benchmark::State& state) {
  Bed<Dry> bed;
  const auto leashes = dem::leashes(bed.stones, skin, dem::extra_skin(bed.stones, skin, dt));
  for (auto _ : state)
    benchmark::DoNotOptimize(dem::advance_stones(bed.stones, {dt, dt}, 0, 9.81, leashes));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(bed.stones.size()));
}

// From the stock of candidates, memories included.
void list_sifted(benchmark::State& state) {
  Bed<Dry> bed;
  for (auto _ : state) bed.make_list();
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(bed.stones.size()));
}

void list_searched(benchmark::State& state) {
  Bed<Dry> bed;
  for (auto _ : state) {
    bed.list.candidates.id.clear();  // covers nothing any more
    bed.make_list();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(bed.stones.size()));
}

BENCHMARK_TEMPLATE(law, double, Dry);
BENCHMARK_TEMPLATE(law, Pack, Dry);
BENCHMARK_TEMPLATE(law, double, Asphalt);
BENCHMARK_TEMPLATE(law, Pack, Asphalt);
BENCHMARK_TEMPLATE(pair_stage, double, Dry)->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(pair_stage, Pack, Dry)->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(pair_stage, double, Asphalt)->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(pair_stage, Pack, Asphalt)->Unit(benchmark::kMicrosecond);
BENCHMARK(wall_stage)->Unit(benchmark::kMicrosecond);
BENCHMARK(motion)->Unit(benchmark::kMicrosecond);
BENCHMARK(list_sifted)->Unit(benchmark::kMicrosecond);
BENCHMARK(list_searched)->Unit(benchmark::kMicrosecond);

}  // namespace

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}

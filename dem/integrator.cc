#include "dem/integrator.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "dem/records.h"
#include "dem/trouble.h"

namespace dem {
namespace {

void set_to_weight(Load& load, double weight) {
  store_quad(Quad{0, 0, -weight, 0}, &load.force.x);
  store_quad(Quad{}, &load.torque.x);
}

}  // namespace

std::vector<double> extra_skin(const ParticleStore& stones, double skin, double dt) {
  struct Reach {
    double steps, skins;  // at most
  };
  constexpr Reach usual = {256, 3}, of_fastest = {1024, 12};
  constexpr std::size_t stones_per_fast = 512;
  const std::size_t count = stones.size();
  std::vector<double> way(count);  // in a step [m]
  for (std::size_t i = 0; i < count; ++i) way[i] = norm(stones.velocity[i]) * dt;
  std::vector<double> ranked = way;
  const auto fast =
      ranked.end() - static_cast<std::ptrdiff_t>(std::min(count, count / stones_per_fast + 2));
  std::ranges::nth_element(ranked, fast);
  std::vector<double> extra(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Reach reach = way[i] > *fast ? of_fastest : usual;
    extra[i] = std::clamp(way[i] * reach.steps - skin / 2, 0.0, reach.skins * skin);
  }
  return extra;
}

std::vector<Leash> leashes(const ParticleStore& stones, double skin,
                           std::span<const double> extra) {
  std::vector<Leash> leash(stones.size());
  for (std::size_t i = 0; i < leash.size(); ++i)
    leash[i] = {stones.position[i], skin / 2 + extra[i]};
  return leash;
}

void weigh(ParticleStore& stones, double gravity) {
  for (std::size_t i = 0; i < stones.size(); ++i)
    set_to_weight(stones.load[i], gravity * stones.mass[i]);
}

Travel advance_stones(ParticleStore& stones, Steps steps, double drag, double gravity,
                      std::span<const Leash> leash) {
  const auto count = static_cast<std::int64_t>(stones.size());
  const double dt = steps.now, kick = steps.kick();
  const double kept = std::exp(-drag * kick);
  bool strayed = false, finite = true;
#pragma omp parallel if (count > 64) reduction(|| : strayed) reduction(&& : finite)
  {
    Quad none = {};  // not a number once something was not finite
#pragma omp for schedule(static) nowait
    for (std::int64_t i = 0; i < count; ++i) {
      const double inertia = stones.inertia[i];
      const double moment = inertia * stones.turning[i];
      Load& load = stones.load[i];
      const Quad v =
          load_vector(stones.velocity[i]) * kept + load_vector(load.force) * (kick / inertia);
      const Quad w =
          load_vector(stones.spin[i]) * kept + load_vector(load.torque) * (kick / moment);
      const Quad x = load_vector(stones.position[i]) + v * dt;
      store_vector(v, stones.velocity[i]);
      store_vector(w, stones.spin[i]);
      store_vector(x, stones.position[i]);
      set_to_weight(load, gravity * stones.mass[i]);
      const Quad moved = x - load_vector(leash[i].from), square = moved * moved;
      strayed |= square[0] + square[1] + square[2] > leash[i].length * leash[i].length;
      none += (moved + w) * 0.0;
    }
    finite = none[0] + none[1] + none[2] == 0;
  }
  return {strayed, finite};
}

void stop_at_first_not_finite(const ParticleStore& stones, double time) {
  const auto unsound = [](const Vec3d& v) { return !std::isfinite(v.x + v.y + v.z); };
  for (std::size_t k = 0; k < stones.size(); ++k)
    if (unsound(stones.position[k]) || unsound(stones.velocity[k]) || unsound(stones.spin[k]))
      throw NumericalTrouble("stone is not at a finite place", stones.id[k], time,
                             std::numeric_limits<double>::quiet_NaN());
}

}  // namespace dem

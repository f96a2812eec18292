#include "dem/integrator.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace dem {
namespace {

Load weight(const ParticleStore& stones, std::int64_t i, double gravity) {
  return {{{0, 0, -gravity * stones.mass[i]}, 0, {0, 0, 0}, 0}};
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
  const auto fast = ranked.end() - static_cast<std::ptrdiff_t>(count / stones_per_fast + 1);
  std::ranges::nth_element(ranked, fast);
  std::vector<double> extra(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Reach reach = way[i] < *fast ? usual : of_fastest;
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
  for (std::size_t i = 0; i < stones.size(); ++i) stones.load[i] = weight(stones, i, gravity);
}

Travel advance_stones(ParticleStore& stones, Steps steps, double drag, double gravity,
                      std::span<const Leash> leash) {
  const auto count = static_cast<std::int64_t>(stones.size());
  const double dt = steps.now, kick = steps.kick();
  const double kept = std::exp(-drag * kick);
  bool strayed = false, finite = true;
#pragma omp parallel for schedule(static) if (count > 64) reduction(|| : strayed) reduction(&& : finite)
  for (std::int64_t i = 0; i < count; ++i) {
    const double inertia = stones.inertia[i];
    const double moment = 0.4 * inertia * stones.radius[i] * stones.radius[i];
    Vec3d& v = stones.velocity[i];
    Vec3d& w = stones.spin[i];
    v = v * kept + stones.load[i].force * (kick / inertia);
    w = w * kept + stones.load[i].torque * (kick / moment);
    stones.load[i] = weight(stones, i, gravity);
    stones.position[i] += v * dt;
    const Vec3d moved = stones.position[i] - leash[i].from;
    const double distance = dot(moved, moved);
    finite = finite && std::isfinite(distance + dot(w, w));
    strayed = strayed || distance > leash[i].length * leash[i].length;
  }
  return {strayed, finite};
}

}  // namespace dem

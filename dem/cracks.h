// The broken stones of a bed: found by their loads, and softer from then on. The rule is in
// dem/fracture.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "dem/fracture.h"
#include "dem/pair_contacts.h"
#include "dem/wall_contacts.h"

namespace dem {

// The contacts of a bed, whose stones bear their forces.
template <ContactLaw Law>
struct Contacts {
  const PairContacts<Law>& pairs;
  const std::vector<WallContacts<Law>>& walls;

  // The stone contact forces on each of the stones at `places`.
  std::vector<std::vector<StoneLoad>> loads_on(const std::vector<std::int32_t>& places,
                                               const ParticleStore& stones) const;
};

// The load of a contact on the line of centres, with its effective radius [m].
inline StoneLoad load_along(const Vec3d& line, double crush, double radius) {
  return {line * (1 / norm(line)), crush * radius * radius, crush};
}

class Cracks {
 public:
  explicit Cracks(FractureRule rule) : rule_(rule) {}

  const std::vector<Crack>& all() const { return cracks_; }

  // Breaks the whole stones whose load exceeds their strength, at `time` [s].
  template <ContactLaw Law>
  void open(ParticleStore& stones, const Contacts<Law>& contacts, double time);

  // Turns the cracks with their stones and takes those a step nearer to the stiffness that the rule
  // gives them now, where that is less than they have: what is broken does not heal.
  template <ContactLaw Law>
  void soften(ParticleStore& stones, const Contacts<Law>& contacts, double time);

  // See dem/state.h.
  template <class Visit>
  void visit_state(Visit& visit) {
    visit("cracks", cracks_);
    visit("cracks.turned", turned_);
  }

 private:
  FractureRule rule_;
  std::vector<Crack> cracks_;
  double turned_ = 0;  // until when the cracks have turned [s]
};

template <ContactLaw Law>
void Cracks::open(ParticleStore& stones, const Contacts<Law>& contacts, double time) {
  const std::vector<std::int32_t> places = overloaded(stones);
  if (places.empty()) return;
  const auto loads = contacts.loads_on(places, stones);
  for (std::size_t n = 0; n < places.size(); ++n) {
    cracks_.push_back(crack_of(stones.id[places[n]], time, loads[n]));
    // Cracked; soften goes on from here.
    stones.softness[places[n]] = std::nextafter(1.0, 2.0);
  }
}

template <ContactLaw Law>
void Cracks::soften(ParticleStore& stones, const Contacts<Law>& contacts, double time) {
  const double last = std::exchange(turned_, time);
  if (cracks_.empty()) return;
  std::vector<std::int32_t> place(stones.size()), cracked;
  for (std::size_t k = 0; k < place.size(); ++k) place[stones.id[k]] = static_cast<std::int32_t>(k);
  for (const Crack& crack : cracks_) cracked.push_back(place[crack.stone]);
  const auto loads = contacts.loads_on(cracked, stones);
  for (std::size_t n = 0; n < cracks_.size(); ++n) {
    Crack& crack = cracks_[n];
    const std::int32_t k = cracked[n];
    const double since = time - std::max(last, crack.time);
    const Vec3d turned = crack.direction + cross(stones.spin[k], crack.direction) * since;
    crack.direction = turned * (1 / norm(turned));
    const double share = 1 / stones.softness[k];
    const double target = stiffness_share(rule_, crack, loads[n]);
    if (target < share) stones.softness[k] = 1 / (share + rule_.lag * (target - share));
  }
}

template <ContactLaw Law>
std::vector<std::vector<StoneLoad>> Contacts<Law>::loads_on(const std::vector<std::int32_t>& places,
                                                            const ParticleStore& stones) const {
  std::vector<std::vector<StoneLoad>> loads(places.size());
  std::vector<std::int32_t> asked(stones.size(), -1);
  for (std::size_t n = 0; n < places.size(); ++n) asked[places[n]] = static_cast<std::int32_t>(n);
  const std::vector<SlotForce> forces = pairs.forces(stones);
  for (std::size_t s = 0; s < forces.size(); ++s) {
    const double crush = forces[s].crush;
    const std::int32_t i = pairs.first(s), j = pairs.second(s);
    if (crush <= 0 || (asked[i] < 0 && asked[j] < 0)) continue;
    const Vec3d apart = stones.position[i] - stones.position[j];
    const double radius =
        stones.radius[i] * stones.radius[j] / (stones.radius[i] + stones.radius[j]);
    for (const std::int32_t k : {i, j})
      if (asked[k] >= 0) loads[asked[k]].push_back(load_along(apart, crush, radius));
  }
  for (const WallContacts<Law>& wall : walls)
    for (std::int64_t s = 0; s < wall.slots(); ++s) {
      const std::int32_t k = wall.stones[s];
      const double crush = wall.touch(s).action.crush;
      if (crush <= 0 || asked[k] < 0) continue;
      const Vec3d arm = stones.position[k] - wall.touch(s).point;
      loads[asked[k]].push_back(load_along(arm, crush, stones.radius[k]));
    }
  return loads;
}

}  // namespace dem

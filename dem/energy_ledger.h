// The energy ledger: watches a bed from outside, after every step, and writes nothing into it.
//
// The steps are a leapfrog, which is velocity Verlet seen at whole steps: kinetic energy is that of
// v_n = v_(n-1/2) + F_n dt/2m, and its change is the work of the mean of the forces at both ends of
// the step over the displacement in between, up to a term F^2 dt^2/8m that does not add up. So
// every work here is mean force x displacement. Kinetic energy comes from the stones, work of walls
// from forces and displacements at the walls, stored energy from the contacts' memories, losses
// from their mechanisms (contact_energy.h): the residual checks each against the others.
#pragma once

#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "dem/energies.h"
#include "dem/laws/binder_energy.h"
#include "dem/laws/stone_energy.h"
#include "dem/laws/sum_energy.h"
#include "dem/simulation.h"

namespace dem {

template <ContactLaw Law>
class EnergyLedger {
 public:
  // To be called after every step, before anybody else moves or bends a wall. The first look opens
  // the book.
  void look(const Simulation<Law>& bed);

  // Closes the book; the next look opens a new one.
  void restart() { *this = {}; }

  const Energies& energies() const { return energies_; }

  // See dem/state.h.
  template <class Visit>
  void visit_state(Visit& visit, const std::string& in) {
    visit(in + "energies", energies_);
    visit(in + "open", open_);
    visit(in + "potential", potential_);
    visit(in + "rebuilds", rebuilds_);
    visit(in + "pair", pair_);
    visit(in + "seen", seen_);
    visit(in + "frame", frame_);
    visit(in + "softness", softness_);
    at_wall_.resize(frame_.size());
    for (std::size_t w = 0; w < frame_.size(); ++w)
      visit(in + "wall" + std::to_string(w), at_wall_[w]);
  }

 private:
  // A contact at the last look; all zero: the bodies do not meet.
  struct Entry {
    Contact<double> contact = {};
    typename Law::template Memory<double> memory = {};
    bool alive = false;
  };
  struct WallEntry : Entry {
    Vec3d force, point;  // on the stone [N], of contact [m]
    Stencil stencil;
  };

  void follow_rebuild(const Simulation<Law>& bed);
  void look_at_stones(const Simulation<Law>& bed);
  void look_at_pairs(const Simulation<Law>& bed);
  void look_at_wall(const Simulation<Law>& bed, std::size_t wall);
  void enter(const Law& law, Entry& entry, const Entry& now, double dt);
  Contact<double> pair_contact(const ParticleStore& stones, std::size_t i, std::size_t j,
                               double dt) const;
  Contact<double> wall_contact(const ParticleStore& stones, std::size_t i, const Wall& wall,
                               const Stencil& stencil, double dt) const;
  double softness_of(const ParticleStore& stones, std::size_t place) const {
    if (!softness_.empty()) return softness_[stones.id[place]];
    return stones.softness.empty() ? 1 : stones.softness[place];
  }

  Energies energies_;
  bool open_ = false;
  double potential_ = 0;  // of the weights at the opening [J]
  std::int64_t rebuilds_ = -1;
  std::vector<std::uint64_t> pair_;              // ids of the stones of each slot
  std::vector<Entry> seen_;                      // by slot
  std::vector<std::vector<WallEntry>> at_wall_;  // by wall, then by stone id
  std::vector<Frame> frame_;                     // of the walls at the last look
  std::vector<double> softness_;                 // by stone id, that the last forces knew
};

template <ContactLaw Law>
void EnergyLedger<Law>::look(const Simulation<Law>& bed) {
  const ParticleStore& stones = bed.stones();
  for (std::size_t w = frame_.size(); w < bed.walls().size(); ++w)
    frame_.push_back(bed.walls()[w].frame);
  at_wall_.resize(bed.walls().size(), std::vector<WallEntry>(stones.size()));
  if (rebuilds_ != bed.rebuilds()) follow_rebuild(bed);
  energies_.stored = {};
  look_at_pairs(bed);
  for (std::size_t w = 0; w < bed.walls().size(); ++w) look_at_wall(bed, w);
  look_at_stones(bed);
  softness_.resize(stones.softness.size());
  for (std::size_t k = 0; k < stones.softness.size(); ++k)
    softness_[stones.id[k]] = stones.softness[k];
  if (open_) return;
  open_ = true;
  const Energies& now = energies_;
  const double sum = now.kinetic + now.stored.stone + now.stored.binder;
  energies_ = {now.kinetic, now.spin, now.mass_scaling, now.stored, sum};
}

template <ContactLaw Law>
void EnergyLedger<Law>::follow_rebuild(const Simulation<Law>& bed) {
  std::unordered_map<std::uint64_t, std::size_t> old;
  for (std::size_t s = 0; s < pair_.size(); ++s)
    if (seen_[s].alive) old.emplace(pair_[s], s);
  const auto slots = static_cast<std::size_t>(bed.pairs().slots());
  std::vector<Entry> seen(slots);
  pair_.resize(slots);
  const auto& id = bed.stones().id;
  for (std::size_t s = 0; s < slots; ++s) {
    pair_[s] = std::uint64_t{id[bed.pairs().first(s)]} << 32 | id[bed.pairs().second(s)];
    if (const auto found = old.find(pair_[s]); found != old.end()) seen[s] = seen_[found->second];
  }
  seen_ = std::move(seen);
  rebuilds_ = bed.rebuilds();
}

template <ContactLaw Law>
void EnergyLedger<Law>::look_at_stones(const Simulation<Law>& bed) {
  const ParticleStore& stones = bed.stones();
  const double dt = bed.last_step();
  double moving = 0, turning = 0, scaled = 0, dragged = 0, potential = 0;
  for (std::size_t k = 0; k < stones.size(); ++k) {
    const double inertia = stones.inertia[k];
    const double moment = inertia * stones.turning[k];
    const Vec3d velocity = stones.velocity[k] + stones.load[k].force * (0.5 * dt / inertia);
    const Vec3d spin = stones.spin[k] + stones.load[k].torque * (0.5 * dt / moment);
    const double along = 0.5 * inertia * dot(velocity, velocity);
    const double around = 0.5 * moment * dot(spin, spin);
    moving += along;
    turning += around;
    scaled += (1 - stones.mass[k] / inertia) * (along + around);
    dragged += inertia * dot(stones.velocity[k], stones.velocity[k]) +
               moment * dot(stones.spin[k], stones.spin[k]);
    potential += bed.gravity() * stones.mass[k] * stones.position[k].z;
  }
  if (!open_) potential_ = potential;
  energies_.kinetic = moving + turning;
  energies_.spin = turning;
  energies_.mass_scaling = scaled;
  energies_.drag += bed.drag() * dragged * dt;
  energies_.gravity = potential_ - potential;
}

// Takes what is seen now in place of what was seen before.
template <ContactLaw Law>
void EnergyLedger<Law>::enter(const Law& law, Entry& entry, const Entry& now, double dt) {
  if (!entry.alive) entry.contact.overlap = now.contact.overlap - now.contact.closing * dt;
  const Seen<Law> before{entry.contact, entry.memory}, after{now.contact, now.memory};
  energies_.lost += lost(law, before, after);
  if (now.alive) energies_.stored = energies_.stored + stored(law, after);
  entry = now.alive ? now : Entry{};
}

template <ContactLaw Law>
void EnergyLedger<Law>::look_at_pairs(const Simulation<Law>& bed) {
  const PairContacts<Law>& pairs = bed.pairs();
  const ParticleStore& stones = bed.stones();
  const double dt = bed.last_step();
  Law law = pairs.law;
  law.set_time_step(dt);
  for (std::int64_t s = 0; s < pairs.slots(); ++s) {
    Entry& before = seen_[s];
    const std::size_t i = pairs.first(s), j = pairs.second(s);
    const double reach = stones.outer_radius(i) + stones.outer_radius(j);
    const Vec3d apart = stones.position[i] - stones.position[j];
    if (!before.alive && dot(apart, apart) >= reach * reach) continue;
    Entry now;
    now.contact = pair_contact(stones, i, j, dt);
    now.alive = now.contact.overlap > 0 || Law::template holds<double>(before.memory);
    if (now.alive) now.memory = pairs.history.slot(s);
    enter(law, before, now, dt);
  }
}

template <ContactLaw Law>
void EnergyLedger<Law>::look_at_wall(const Simulation<Law>& bed, std::size_t w) {
  const Wall& wall = bed.walls()[w];
  const WallContacts<Law>& contacts = bed.wall_contacts(w);
  const ParticleStore& stones = bed.stones();
  const double dt = bed.last_step();
  Law law = contacts.law;
  law.set_time_step(dt);
  const bool moves = wall.field || !std::holds_alternative<Fixed>(wall.motion);
  // How far a material point of the wall, at x before or after the step, has come in it.
  const auto come = [&](const Frame& from, const Frame& to, const Vec3d& x, const Stencil& at) {
    Vec3d way = to.origin + to.to_laboratory(from.to_frame(x - from.origin)) - x;
    if (&from == &wall.frame) way = -way;
    if (wall.field) way += wall.frame.to_laboratory(wall.field->velocity_at(at)) * dt;
    return way;
  };
  for (std::int64_t s = 0; s < contacts.slots(); ++s) {
    const auto place = static_cast<std::size_t>(contacts.stones[s]);
    const auto& touch = contacts.touch(s);
    WallEntry& before = at_wall_[w][stones.id[place]];
    Entry now;
    now.contact = wall_contact(stones, place, wall, touch.stencil, dt);
    now.alive = now.contact.overlap > 0 || Law::template holds<double>(before.memory);
    if (now.alive) now.memory = contacts.history.slot(s);
    if (!now.alive && !before.alive) continue;
    const bool was_alive = before.alive;
    enter(law, before, now, dt);
    if (moves && was_alive)
      energies_.walls +=
          0.5 * dot(before.force, come(frame_[w], wall.frame, before.point, before.stencil));
    if (moves && open_)
      energies_.walls +=
          0.5 * dot(touch.action.force, come(wall.frame, frame_[w], touch.point, touch.stencil));
    before.force = touch.action.force;
    before.point = touch.point;
    before.stencil = touch.stencil;
  }
  frame_[w] = wall.frame;
}

// The words of meeting.h and WallContacts once more, slow and obvious, so that the ledger does not
// repeat their mistakes.
template <ContactLaw Law>
Contact<double> EnergyLedger<Law>::pair_contact(const ParticleStore& stones, std::size_t i,
                                                std::size_t j, double dt) const {
  const Vec3d apart = stones.position[i] - stones.position[j];
  const double distance = norm(apart);
  const double outer_i = stones.outer_radius(i), outer_j = stones.outer_radius(j);
  const double stone_i = stones.radius[i], stone_j = stones.radius[j];
  Contact<double> contact = {};
  contact.overlap = outer_i + outer_j - distance;
  contact.outer_radius = outer_i * outer_j / (outer_i + outer_j);
  contact.stone_radius = stone_i * stone_j / (stone_i + stone_j);
  contact.mass = stones.inertia[i] * stones.inertia[j] / (stones.inertia[i] + stones.inertia[j]);
  contact.softness = 0.5 * (softness_of(stones, i) + softness_of(stones, j));
  contact.normal = apart * (1 / distance);
  const Vec3d& n = contact.normal;
  const Vec3d rate = stones.velocity[i] - stones.velocity[j];
  const double half = 0.5 * contact.overlap;
  const Vec3d rolling = (outer_i - half) * stones.spin[i] + (outer_j - half) * stones.spin[j];
  const double closing = -dot(rate, n);
  const Vec3d middle = n - (rate + n * closing) * (0.5 * dt / distance);  // of the step
  const Vec3d surface = rate - cross(rolling, middle);
  contact.closing = closing;
  contact.sliding = (surface - n * dot(surface, n)) * dt;
  const Vec3d twist = n * (0.5 * dot(stones.spin[i] + stones.spin[j], n));
  contact.turn = (cross(n, rate) * (1 / distance) + twist) * dt;
  return contact;
}

template <ContactLaw Law>
Contact<double> EnergyLedger<Law>::wall_contact(const ParticleStore& stones, std::size_t i,
                                                const Wall& wall, const Stencil& stencil,
                                                double dt) const {
  const Vec3d local = wall.frame.to_frame(stones.position[i] - wall.frame.origin);
  const Nearest<double> nearest =
      std::visit([&](const auto& surface) { return surface.nearest(local); }, wall.surface);
  const double outer = stones.outer_radius(i);
  Contact<double> contact = {};
  contact.normal = wall.frame.to_laboratory(nearest.normal);
  const Vec3d& n = contact.normal;
  contact.overlap = outer - nearest.distance;
  Vec3d bending = {0, 0, 0};
  if (wall.field) {
    bending = wall.frame.to_laboratory(wall.field->velocity_at(stencil));
    contact.overlap += dot(nearest.normal, wall.field->displacement_at(stencil));
  }
  contact.outer_radius = outer;
  contact.stone_radius = stones.radius[i];
  contact.mass = stones.inertia[i];
  contact.softness = softness_of(stones, i);
  const double inset = contact.overlap - 0.5 * std::max(contact.overlap - stones.shell, 0.0);
  const double arm = outer - inset;
  const Vec3d point = stones.position[i] - n * arm;
  const Vec3d rate = stones.velocity[i] - wall.frame.velocity_at(point) - bending;
  const Vec3d surface = rate - cross(arm * stones.spin[i], n);
  contact.closing = -dot(rate, n);
  contact.sliding = (surface - n * dot(surface, n)) * dt;
  const Vec3d& turning = wall.frame.spin;
  contact.turn = (turning + n * (0.5 * dot(stones.spin[i] - turning, n))) * dt;
  return contact;
}

}  // namespace dem

// A bed of stones between walls, one step after the other. This is the header other rooms read.
//
// Law is the contact law of pairs; walls have laws of the same kind with their own constants.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "dem/cracks.h"
#include "dem/integrator.h"
#include "dem/neighbor_list.h"
#include "dem/pair_contacts.h"
#include "dem/spatial_order.h"
#include "dem/stage_times.h"
#include "dem/state.h"
#include "dem/step_bound.h"
#include "dem/time_step.h"
#include "dem/trouble.h"
#include "dem/wall.h"
#include "dem/wall_contacts.h"

namespace dem {

struct Settings {
  double gravity = earth_gravity;  // [m/s2]
  double safety = 0.2;  // time step / sqrt(inertia / stiffness) of the stiffest contact [-]
  double largest_step;  // [s], used while nothing stiffer is in contact
  double largest_overlap = 0.5;  // of stones, / radius of the smaller: beyond it the run stops [-]
  double skin;                   // search range beyond contact [m]
  FractureRule fracture;
};

template <ContactLaw Law>
class Simulation {
 public:
  Simulation(ParticleStore stones, const Law& pair_law, Settings settings)
      : settings_(settings),
        stones_(std::move(stones)),
        cracks_(settings.fracture),
        clock_(settings.safety, settings.largest_step) {
    pairs_.law = pair_law;
  }

  // Walls are named in the order they are added; the reference stays valid until the next call.
  Wall& add_wall(Wall wall, const Law& law) {
    if (const auto* driven = std::get_if<Driven>(&wall.motion))
      wall.frame.velocity = driven->velocity;
    walls_.push_back(std::move(wall));
    wall_contacts_.emplace_back().law = law;
    stale_ = true;
    return walls_.back();
  }

  // One time step. Throws NumericalTrouble.
  void step();

  // The laws from here on, e.g. once stones may bond; memories are kept.
  void set_laws(const Law& pair_law, const std::vector<Law>& wall_laws);
  // What resists acceleration from here on, by place [kg]; velocities are kept.
  void set_inertia(std::vector<double> inertia) {
    stones_.inertia = std::move(inertia);
    stale_ = true;
  }
  void set_drag(double rate) { drag_ = rate; }          // [1/s], see advance_stones
  double drag() const { return drag_; }                 // [1/s]
  double gravity() const { return settings_.gravity; }  // [m/s2]

  double time() const { return time_; }               // [s]
  double time_step() const { return clock_.step(); }  // of the next step [s]
  double last_step() const { return last_step_; }     // length of the step before [s]
  std::int64_t steps() const { return steps_; }
  std::int64_t rebuilds() const { return rebuilds_; }
  std::string limiting_contact() const { return limiting_; }
  const ParticleStore& stones() const { return stones_; }
  std::vector<Wall>& walls() { return walls_; }
  const std::vector<Wall>& walls() const { return walls_; }
  const std::vector<Crack>& cracks() const { return cracks_.all(); }
  const PairContacts<Law>& pairs() const { return pairs_; }
  const WallContacts<Law>& wall_contacts(std::size_t wall) const { return wall_contacts_[wall]; }
  std::size_t bytes() const;           // of all arrays of stones, lists, contacts
  std::size_t bytes_of_slots() const;  // of those of lists and pairs

  // From here on adds up the time of each stage in `times`, which must outlive the steps.
  void time_stages(StageTimes& times) { times_ = &times; }

  // See dem/state.h; the walls must have been added.
  template <class Visit>
  void visit_state(Visit& visit);

 private:
  void move_walls(Steps steps);
  void stop_at_wall_not_finite() const;
  void refresh_neighbors();
  void find_forces(double dt, bool check);
  void inspect(const Extremes& at_pairs);
  void stop_at_deep_overlap(const Extremes& at_pairs) const;
  void set_time_step(double dt);  // of the laws, 0 for a jump [s]
  void enter(Stage stage) {
    if (times_) times_->enter(stage);
  }

  Settings settings_;
  ParticleStore stones_;
  std::vector<Wall> walls_;
  PairContacts<Law> pairs_;
  std::vector<WallContacts<Law>> wall_contacts_;
  std::vector<WallExtremes> at_walls_;  // of the last forces
  NeighborList list_;
  std::vector<Leash> leash_;  // since the lists were made
  Cracks cracks_;
  StepClock clock_;
  std::string limiting_ = "nothing in contact";
  double time_ = 0, drag_ = 0;
  double last_step_ = 0;  // length of the step before [s]
  std::int64_t steps_ = 0, rebuilds_ = 0;
  bool stale_ = true;  // lists must be made before the next forces
  StageTimes* times_ = nullptr;
};

template <ContactLaw Law>
void Simulation<Law>::step() {
  enter(Stage::lists);
  if (stale_) {
    refresh_neighbors();
    set_time_step(0);
    weigh(stones_, settings_.gravity);
    find_forces(0, true);  // no time has passed: nothing has slid or relaxed
    stop_at_wall_not_finite();
    set_time_step(clock_.step());
  }
  const double dt = clock_.step();
  const Steps steps = {last_step_, dt};
  enter(Stage::motion);
  move_walls(steps);
  const Travel travel = advance_stones(stones_, steps, drag_, settings_.gravity, leash_);
  last_step_ = dt;
  time_ += dt;
  ++steps_;
  if (!travel.finite) stop_at_first_not_finite(stones_, time_);
  stop_at_wall_not_finite();

  // What comes new to a list may come fast: it is looked at before it has come much closer.
  bool check = steps_ % check_interval == 0 || travel.strayed;
  enter(Stage::lists);
  if (travel.strayed) refresh_neighbors();
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    if (walls_[w].moved <= settings_.skin / 2) continue;
    wall_contacts_[w].find(stones_, walls_[w], settings_.skin, leash_);
    check = true;
  }
  find_forces(dt, check);
  stop_at_wall_not_finite();
  enter(Stage::rest);
}

template <ContactLaw Law>
void Simulation<Law>::find_forces(double dt, bool check) {
  const double horizon = check ? check_interval * clock_.step() : 0;
  enter(Stage::pairs);
  const Extremes pair = pairs_.evaluate(stones_, dt, horizon);
  enter(Stage::walls);
  at_walls_.clear();
  for (std::size_t w = 0; w < walls_.size(); ++w)
    at_walls_.push_back(wall_contacts_[w].evaluate(stones_, walls_[w], dt, horizon));
  enter(Stage::fracture);
  if constexpr (Law::breaks) {
    const Contacts<Law> contacts = {pairs_, wall_contacts_};
    cracks_.open(stones_, contacts, time_);
    if (dt > 0 && steps_ % check_interval == 0) cracks_.soften(stones_, contacts, time_);
  }
  enter(Stage::rest);
  if (check) inspect(pair);
}

template <ContactLaw Law>
void Simulation<Law>::move_walls(Steps steps) {
  const double dt = steps.now;
  for (Wall& wall : walls_) {
    advance(wall.motion, wall.frame, wall.force, time_, steps);
    const double reach =
        std::visit([](const auto& surface) { return surface.extent(); }, wall.surface);
    wall.moved += dt * (norm(wall.frame.velocity) + norm(wall.frame.spin) * reach);
    if (!wall.field) continue;
    wall.field->drift(dt);
    wall.moved += dt * wall.field->fastest;
  }
}

// A wall has no number: the stone that it last met is named, or the first.
template <ContactLaw Law>
void Simulation<Law>::stop_at_wall_not_finite() const {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const auto& met = wall_contacts_[w].stones;
    stop_if_not_finite(walls_[w], stones_.id[met.empty() ? 0 : met.front()], time_);
  }
}

template <ContactLaw Law>
void Simulation<Law>::refresh_neighbors() {
  constexpr int sort_interval = 50;  // rebuilds between two spatial sortings
  std::vector<std::uint32_t> order;
  std::vector<std::int32_t> place(stones_.size());
  if (rebuilds_++ % sort_interval == 0) {
    double mean = 0;
    for (double r : stones_.radius) mean += r / static_cast<double>(stones_.size());
    order = spatial_order(stones_.position, 4 * (mean + stones_.shell));
    reorder(stones_, order);
  }
  for (std::size_t k = 0; k < place.size(); ++k)
    place[order.empty() ? k : order[k]] = static_cast<std::int32_t>(k);

  std::vector<double> radius(stones_.size());
  for (std::size_t k = 0; k < radius.size(); ++k) radius[k] = stones_.outer_radius(k);
  std::vector<StonePair> keep;
  for (std::int64_t s = 0; s < pairs_.slots(); ++s) {
    if (!pairs_.history.holds(s)) continue;
    const auto i = static_cast<std::uint32_t>(place[pairs_.first(s)]);
    const auto j = static_cast<std::uint32_t>(place[pairs_.second(s)]);
    const double apart = norm(stones_.position[i] - stones_.position[j]) - radius[i] - radius[j];
    if (apart >= settings_.skin) keep.push_back({i, j});
  }
  const std::vector<double> extra = extra_skin(stones_, settings_.skin, clock_.step());
  list_.build({stones_.position, radius, stones_.id, extra}, settings_.skin, keep, order);
  pairs_.take(list_, stones_);
  leash_ = leashes(stones_, settings_.skin, extra);
  for (std::size_t w = 0; w < walls_.size(); ++w)
    wall_contacts_[w].find(stones_, walls_[w], settings_.skin, leash_, order);
  stale_ = false;
}

template <ContactLaw Law>
void Simulation<Law>::set_laws(const Law& pair_law, const std::vector<Law>& wall_laws) {
  pairs_.law = pair_law;
  for (std::size_t w = 0; w < walls_.size(); ++w) wall_contacts_[w].law = wall_laws[w];
  set_time_step(clock_.step());
}

template <ContactLaw Law>
void Simulation<Law>::set_time_step(double dt) {
  pairs_.law.set_time_step(dt);
  for (auto& contacts : wall_contacts_) contacts.law.set_time_step(dt);
}

template <ContactLaw Law>
void Simulation<Law>::inspect(const Extremes& at_pairs) {
  stop_at_deep_overlap(at_pairs);
  StepBound bound = bound_by_stones(pairs_, at_pairs, stones_);
  const double until_next = check_interval * clock_.step();
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    bound.meet(bound_by_stones(wall_contacts_[w], at_walls_[w], stones_, walls_[w]));
    bound.meet(bound_by_load(walls_[w], at_walls_[w].stiffness));
    bound.meet(bound_by_speed(walls_[w], until_next, settings_.skin, settings_.safety));
  }
  if (bound.rate > 0) limiting_ = bound.by;
  if (clock_.look(bound.rate)) set_time_step(clock_.step());
}

template <ContactLaw Law>
void Simulation<Law>::stop_at_deep_overlap(const Extremes& at_pairs) const {
  const auto deep = [&](const Extremes& at) { return at.overlap > settings_.largest_overlap; };
  if (deep(at_pairs))
    throw NumericalTrouble("stone overlap / radius",
                           stones_.id[pairs_.first(at_pairs.overlap_slot)], time_,
                           at_pairs.overlap);
  for (std::size_t w = 0; w < walls_.size(); ++w)
    if (const WallExtremes& at = at_walls_[w]; deep(at))
      throw NumericalTrouble("stone overlap with wall " + walls_[w].name + " / radius",
                             stones_.id[wall_contacts_[w].stones[at.overlap_slot]], time_,
                             at.overlap);
}

template <ContactLaw Law>
template <class Visit>
void Simulation<Law>::visit_state(Visit& visit) {
  dem::visit_state(visit, "stones.", stones_);
  dem::visit_state(visit, "list.", list_);
  pairs_.visit_state(visit, "pairs.", stones_);
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    dem::visit_state(visit, walls_[w].name + '.', walls_[w]);
    wall_contacts_[w].visit_state(visit, walls_[w].name + ".contacts.");
  }
  visit("leash", leash_);
  cracks_.visit_state(visit);
  visit("clock", clock_);
  visit("limiting", limiting_);
  visit("time", time_);
  visit("drag", drag_);
  visit("last_step", last_step_);
  visit("steps", steps_);
  visit("rebuilds", rebuilds_);
  visit("stale", stale_);
  set_time_step(clock_.step());
}

template <ContactLaw Law>
std::size_t Simulation<Law>::bytes_of_slots() const {
  return list_.bytes() + pairs_.bytes();
}

template <ContactLaw Law>
std::size_t Simulation<Law>::bytes() const {
  std::size_t bytes = stones_.bytes() + bytes_of_slots() + bytes_of(leash_);
  for (const auto& contacts : wall_contacts_) bytes += contacts.bytes();
  return bytes;
}

}  // namespace dem

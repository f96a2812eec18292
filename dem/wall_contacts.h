// The contacts of one wall. A stone touches a wall at most once, so that forces can be added to the
// stones in any order of slots with the same bits; the wall's own sums run in slot order, within
// chunks of slots first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "dem/bytes.h"
#include "dem/extremes.h"
#include "dem/integrator.h"
#include "dem/meeting.h"
#include "dem/pair_contacts.h"
#include "dem/wall.h"

namespace dem {

template <ContactLaw Law>
class WallContacts {
 public:
  struct Touch {
    SlotForce action;  // on the stone
    Vec3d point;       // of contact [m]
    double push;       // [N]
    Stencil stencil;   // of an elastic wall
  };
  static_assert(offsetof(Touch, push) == 11 * sizeof(double));  // three times four numbers

  Law law;
  ContactHistory<Law> history;
  std::vector<std::int32_t> stones;  // one per slot (padded), in rising store order

  // Lists the stones that may touch before the wall has moved by half a skin [m] or a stone is at
  // the end of its leash, wherever on that it is now, and those whose contact lives on. The way of
  // the wall begins anew. old_index: where the stone that is now at k was stored when the last list
  // was made; empty if nothing moved places.
  void find(const ParticleStore& particles, Wall& wall, double skin, std::span<const Leash> leash,
            std::span<const std::uint32_t> old_index = {});

  // Adds the contact forces to the stones and renews the wall's force, moment, push and impulses.
  // dt and horizon as of the pairs.
  template <class T = Pack>
  WallExtremes evaluate(ParticleStore& particles, Wall& wall, double dt, double horizon = 0);

  // Power of the stones on the bending of an elastic wall's face [W].
  double bending_power(const Wall& wall) const;

  std::int64_t slots() const { return slots_; }
  std::size_t bytes() const { return bytes_of(stones, touches_, sums_, history.raw()); }
  const Touch& touch(std::int64_t slot) const { return touches_[slot]; }

  // See dem/state.h.
  template <class Visit>
  void visit_state(Visit& visit, const std::string& in) {
    history.visit_state(visit, in);
    visit(in + "stones", stones);
    visit(in + "touches", touches_);
    visit(in + "slots", slots_);
  }

 private:
  template <class T>
  void evaluate_at(ParticleStore& particles, const Wall& wall, double dt, double horizon,
                   std::int64_t slot, WallExtremes& extremes);
  // What the slots from `slot` on have found, one after the other.
  template <class T>
  struct Results {
    alignas(64) Quad force[width<T>];                     // and inset
    alignas(64) Quad moment[width<T>], torque[width<T>];  // and crush
    alignas(64) Quad point[width<T>];                     // and push
  };
  template <class T>
  void put(ParticleStore& particles, std::int64_t slot, const Results<T>& results);
  // Of the stones at `position`; leaves the stencils of an elastic wall.
  template <class T>
  Face<T> face_at(const Wall& wall, const Vec3<T>& position, Touch* touch) const;
  // Adds what an elastic wall yields at its own points `foot`.
  template <class T>
  void bend(const Wall& wall, const Vec3<T>& foot, Touch* touch, Face<T>& face) const;
  struct Sum {
    Vec3d force, moment;  // on the wall, about its origin [N], [N m]
    double push;          // [N]
    double stiffness;     // of the contacts [N/m], where asked for
  };
  Sum sum_of(const Wall& wall, std::int64_t begin, std::int64_t end) const;
  void add_impulses(Wall& wall, double dt) const;

  static constexpr std::int64_t slots_per_chunk = 64;  // a multiple of the lanes

  std::vector<Touch> touches_;  // written by evaluate_at
  std::vector<Sum> sums_;       // by chunk
  std::int64_t slots_ = 0;
};

template <ContactLaw Law>
void WallContacts<Law>::find(const ParticleStore& particles, Wall& wall, double skin,
                             std::span<const Leash> leash,
                             std::span<const std::uint32_t> old_index) {
  wall.moved = 0;
  const std::size_t count = particles.size();
  std::vector<std::int32_t> old_slot(count, -1);
  for (std::int64_t s = 0; s < slots_; ++s) old_slot[stones[s]] = static_cast<std::int32_t>(s);
  stones.clear();
  std::vector<std::int32_t> previous;
  for (std::size_t k = 0; k < count; ++k) {
    const std::int32_t before = old_slot[old_index.empty() ? k : old_index[k]];
    const bool near = distance_to(wall, particles.position[k]) <
                      particles.outer_radius(k) + skin / 2 + 2 * leash[k].length;
    if (!near && (before < 0 || !history.holds(before))) continue;
    stones.push_back(static_cast<std::int32_t>(k));
    previous.push_back(before);
  }
  slots_ = static_cast<std::int64_t>(stones.size());
  stones.resize((stones.size() + lanes - 1) / lanes * lanes, 0);
  touches_.assign(stones.size(), Touch{});
  history.carry(previous);
}

template <ContactLaw Law>
template <class T>
WallExtremes WallContacts<Law>::evaluate(ParticleStore& particles, Wall& wall, double dt,
                                         double horizon) {
  WallExtremes found;
  sums_.resize((slots_ + slots_per_chunk - 1) / slots_per_chunk);
#pragma omp parallel if (sums_.size() > 1)
  {
    WallExtremes mine;
#pragma omp for schedule(static) nowait
    for (std::int64_t chunk = 0; chunk < std::ssize(sums_); ++chunk) {
      const std::int64_t begin = chunk * slots_per_chunk;
      const std::int64_t end = std::min(slots_, begin + slots_per_chunk);
      mine.stiffness = 0;
      for (std::int64_t s = begin; s < end; s += width<T>)
        evaluate_at<T>(particles, wall, dt, horizon, s, mine);
      sums_[chunk] = sum_of(wall, begin, end);
      sums_[chunk].stiffness = mine.stiffness;
    }
    if (horizon > 0) {
#pragma omp critical
      found.merge(mine);
    }
  }
  wall.force = wall.moment = Vec3d{0, 0, 0};
  wall.push = 0;
  for (const Sum& sum : sums_) {
    wall.force += sum.force;
    wall.moment += sum.moment;
    wall.push += sum.push;
    found.stiffness += sum.stiffness;
  }
  if (wall.field) add_impulses(wall, dt);
  return found;
}

template <ContactLaw Law>
template <class T>
Face<T> WallContacts<Law>::face_at(const Wall& wall, const Vec3<T>& position, Touch* touch) const {
  const Vec3<T> local = wall.frame.to_frame(position - Frame::wide<T>(wall.frame.origin));
  const Nearest<T> nearest =
      std::visit([&](const auto& surface) { return surface.nearest(local); }, wall.surface);
  const T zero(0.0);
  Face<T> face = {nearest.distance, wall.frame.to_laboratory(nearest.normal), {zero, zero, zero}};
  if (wall.field) bend(wall, local - nearest.normal * nearest.distance, touch, face);
  return face;
}

template <ContactLaw Law>
template <class T>
void WallContacts<Law>::bend(const Wall& wall, const Vec3<T>& foot, Touch* touch,
                             Face<T>& face) const {
  const Vec3<T>& normal = face.normal;
  T nearer(0.0);
  for (int k = 0; k < width<T>; ++k) {
    touch[k].stencil = wall.field->stencil({lane(foot.x, k), lane(foot.y, k), lane(foot.z, k)});
    const Vec3d u = wall.frame.to_laboratory(wall.field->displacement_at(touch[k].stencil));
    const Vec3d v = wall.frame.to_laboratory(wall.field->velocity_at(touch[k].stencil));
    set_lane(nearer, k,
             u.x * lane(normal.x, k) + u.y * lane(normal.y, k) + u.z * lane(normal.z, k));
    set_lane(face.bending.x, k, v.x);
    set_lane(face.bending.y, k, v.y);
    set_lane(face.bending.z, k, v.z);
  }
  face.distance -= nearer;
}

template <ContactLaw Law>
template <class T>
void WallContacts<Law>::evaluate_at(ParticleStore& particles, const Wall& wall, double dt,
                                    double horizon, std::int64_t slot, WallExtremes& extremes) {
  const std::int32_t* i = &stones[slot];
  const Visitor<T> stone = {gather<T>(particles.position, i), gather<T>(particles.velocity, i),
                            gather<T>(particles.spin, i), gather<T>(particles.radius.data(), i, 1),
                            gather<T>(particles.inertia.data(), i, 1)};
  const Face<T> face = face_at<T>(wall, stone.position, &touches_[slot]);
  WallMeeting<T> pair = meet(stone, face, wall.frame, particles.shell, dt);
  Contact<T>& contact = pair.contact;
  contact.softness = T(1.0);
  if constexpr (Law::breaks) contact.softness = gather<T>(particles.softness.data(), i, 1);
  contact.horizon = T(horizon);

  MemoryOf<Law, T> memory(history, slot);
  const auto listed = lanes_below<T>(slots_ - slot);
  const auto alive = listed & ((contact.overlap > T(0.0)) | Law::template holds<T>(memory.value));
  const Response<T> response = law(contact, memory.value);
  forget<T>(!alive, memory.value);
  memory.keep(history, slot);

  const T zero(0.0);
  const Vec3<T> none = {zero, zero, zero};
  const Vec3<T> force = select(alive, contact.normal * response.push + response.shear, none);
  const Vec3<T> moment = select(alive, cross(response.shear, contact.normal), none);
  T crush = zero;
  if constexpr (Law::breaks)
    crush = select(alive, response.stone / (stone.radius * stone.radius), zero);
  Results<T> results;
  quads(force, select(alive, pair.inset, zero), results.force);
  quads(moment, crush, results.moment);
  quads(pair.point, select(alive, response.push, zero), results.point);
  quads(moment * pair.arm, crush, results.torque);
  put(particles, slot, results);

  if (horizon > 0) {
    const T rate = select(listed, response.stiffness / stone.inertia, zero);
    const T deep = select(alive, (contact.overlap - T(particles.shell)) / stone.radius, zero);
    for (int k = 0; k < width<T>; ++k) {
      if (!lane(listed, k)) continue;
      extremes.merge({lane(rate, k), slot + k, lane(deep, k), slot + k});
      extremes.stiffness += lane(response.stiffness, k);
    }
  }
}

template <ContactLaw Law>
template <class T>
void WallContacts<Law>::put(ParticleStore& particles, std::int64_t slot,
                            const Results<T>& results) {
  const std::int64_t count = std::min<std::int64_t>(width<T>, slots_ - slot);
  for (int k = 0; k < count; ++k) {
    const int at = width<T> == 1 ? 0 : quad_place(k);
    Touch& touch = touches_[slot + k];
    store_quad(results.force[at], &touch.action.force.x);
    store_quad(results.moment[at], &touch.action.moment.x);
    store_quad(results.point[at], &touch.point.x);
    double* const load = &particles.load[stones[slot + k]].force.x;
    Quad force = results.force[at];
    force[3] = 0;
    store_quad(load_quad(load) + force, load);
    store_quad(joined<Law::breaks>(load_quad(load + 4), results.torque[at]), load + 4);
  }
}

template <ContactLaw Law>
double WallContacts<Law>::bending_power(const Wall& wall) const {
  double power = 0;
  for (std::int64_t s = 0; s < slots_; ++s)
    power -= dot(wall.frame.to_frame(touches_[s].action.force),
                 wall.field->velocity_at(touches_[s].stencil));
  return power;
}

template <ContactLaw Law>
typename WallContacts<Law>::Sum WallContacts<Law>::sum_of(const Wall& wall, std::int64_t begin,
                                                          std::int64_t end) const {
  Sum sum = {};
  for (std::int64_t s = begin; s < end; ++s) {
    const Touch& touch = touches_[s];
    const Vec3d on_wall = -touch.action.force;
    sum.force += on_wall;
    sum.moment += cross(touch.point - wall.frame.origin, on_wall);
    sum.push += touch.push;
  }
  return sum;
}

template <ContactLaw Law>
void WallContacts<Law>::add_impulses(Wall& wall, double dt) const {
  for (std::int64_t s = 0; s < slots_; ++s) {
    const Touch& touch = touches_[s];
    wall.field->add_impulse(touch.stencil, wall.frame.to_frame(-touch.action.force) * dt);
  }
}

}  // namespace dem

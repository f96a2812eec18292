// A bed of stones in the compactor: floor and mould from the start, the inclined head and the
// elastic steel once it is closed.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "apps/archive.h"
#include "apps/bed.h"
#include "apps/errors.h"
#include "apps/machine.h"
#include "apps/steel.h"

namespace apps {

template <class Law>
class Compactor {
 public:
  enum Part { floor, mould, head };  // the walls, in the order they are added

  Compactor(const GyratoryScene& scene, const Mix& mix, const LawBook& book,
            const Machine& machine);

  // Puts the inclined head on the bed as it is now; from now on shells bond and inertia may be
  // selected. Throws InputError if the bed is higher than an elastic mould.
  void close();
  // Between letterboxes and steel; after every step of a closed bed.
  void exchange();

  bool closed() const { return closed_; }
  double closed_at() const { return closed_at_; }           // when the plate came down [s]
  double turns_from() const { return ram().turns_from(); }  // [s]
  double gyration() const;                                  // done, negative before the first
  double last_turn_ends() const;                            // [s]
  double head_mass() const { return head_mass_; }           // [kg]

  dem::Simulation<Law>& bed() { return bed_; }
  const dem::Simulation<Law>& bed() const { return bed_; }
  const dem::Wall& plate() const { return bed_.walls()[head]; }
  const dem::Wall& ring() const { return bed_.walls()[mould]; }
  // None where they are rigid.
  const SteelPart* elastic_head() const { return elastic_head_.get(); }
  const SteelPart* elastic_mould() const { return elastic_mould_.get(); }

  // See dem/state.h. First whether it is closed, and how: restored, it is closed again. Then, with
  // all letterboxes in place, the rest.
  void visit_closing(Archive& item);
  void visit_state(Archive& item);

 private:
  Law wall_law(Part part, bool bonds) const;
  double height_of_plate() const;
  dem::Ram ram() const;
  void mount_head();

  const GyratoryScene& scene_;
  const LawBook& book_;
  const Machine& machine_;
  dem::Simulation<Law> bed_;
  Steel elastic_mould_, elastic_head_;
  double head_mass_ = 0;  // [kg]
  bool closed_ = false;
  double closed_at_ = 0;    // [s]
  double plate_start_ = 0;  // middle of the plate then [m]
};

template <class Law>
Compactor<Law>::Compactor(const GyratoryScene& scene, const Mix& mix, const LawBook& book,
                          const Machine& machine)
    : scene_(scene),
      book_(book),
      machine_(machine),
      bed_(make_bed<Law>(scene.stones, mix, book, scene.fill, scene.numerics, scene.run.seed,
                         dem::RoundMould{machine.mould_radius})) {
  dem::Wall base, ring;
  base.name = "floor";
  base.surface = dem::Plane{};
  ring.name = "mould";
  ring.surface = dem::CylinderInside{machine.mould_radius};
  bed_.add_wall(base, wall_law(floor, scene.fill.bonds));
  bed_.add_wall(ring, wall_law(mould, scene.fill.bonds));
}

template <class Law>
void Compactor<Law>::visit_closing(Archive& item) {
  item("closed", closed_);
  item("closed_at", closed_at_);
  item("plate_start", plate_start_);
  if (closed_ && item.restores()) mount_head();
}

template <class Law>
void Compactor<Law>::visit_state(Archive& item) {
  bed_.visit_state(item);
  if (elastic_head_) elastic_head_->visit_state(item, "head.modes.");
  if (elastic_mould_) elastic_mould_->visit_state(item, "mould.modes.");
}

template <class Law>
Law Compactor<Law>::wall_law(Part part, bool bonds) const {
  const auto& ring = scene_.mould.elastic;
  const auto& plate = scene_.head.elastic;
  dem::Material material = rigid;
  if (part == mould && ring) material = {ring->young, ring->poisson};
  if (part == head && plate) material = {plate->young, plate->poisson};
  const double friction = part == head ? scene_.head.friction : scene_.mould.wall_friction;
  return book_.law<Law>({material, friction}, bonds);
}

template <class Law>
void Compactor<Law>::close() {
  closed_ = true;
  closed_at_ = bed_.time();
  plate_start_ = height_of_plate();
  const auto& steel = scene_.mould.elastic;
  if (steel && plate_start_ > steel->height)
    throw InputError({fmt::format(
        "{}: expected a mould as high as the settled bed, {:.4g} mm, found "
        "{:.4g} mm; make it higher",
        scene_.where("mould.elastic.height"), 1e3 * plate_start_, 1e3 * steel->height)});
  mount_head();
}

// At which the inclined plate touches the highest stone.
template <class Law>
double Compactor<Law>::height_of_plate() const {
  dem::Frame frame;
  orient(ram(), frame, closed_at_);
  const dem::ParticleStore& stones = bed_.stones();
  double height = 0;
  for (std::size_t k = 0; k < stones.size(); ++k)
    height =
        std::max(height, (dot(stones.position[k], frame.ez) + stones.outer_radius(k)) / frame.ez.z);
  return height;
}

template <class Law>
dem::Ram Compactor<Law>::ram() const {
  const GyrationScene& gyration = scene_.gyration;
  return {head_mass_ * scene_.numerics.head_mass_scale,
          head_mass_ * dem::earth_gravity,
          gyration.pressure * machine_.section,
          closed_at_,
          gyration.ramp,
          gyration.angle,
          gyration.speed,
          gyration.spin,
          gyration.dwell,
          gyration.approach_speed};
}

template <class Law>
void Compactor<Law>::mount_head() {
  dem::Wall plate;
  plate.name = "head";
  plate.surface = dem::Disc{machine_.plate_radius};
  elastic_head_ = make_steel(scene_.head.elastic, machine_, scene_.numerics, plate);
  head_mass_ =
      elastic_head_ ? elastic_head_->outline().mass : rigid_head_mass(scene_.head, machine_);
  plate.motion = ram();
  orient(ram(), plate.frame, closed_at_);
  plate.frame.origin = {0, 0, plate_start_};
  bed_.add_wall(plate, wall_law(head, true));
  elastic_mould_ = make_steel(scene_.mould.elastic, machine_, scene_.numerics, bed_.walls()[mould]);
  const Law law = book_.law<Law>({std::nullopt, scene_.stones.friction}, true);
  bed_.set_laws(law, {wall_law(floor, true), wall_law(mould, true), wall_law(head, true)});
  if (scene_.numerics.selective_mass) bed_.set_inertia(selected_inertia(law, bed_.stones()));
}

template <class Law>
void Compactor<Law>::exchange() {
  const dem::Steps steps = {bed_.last_step(), bed_.time_step()};
  if (elastic_head_) elastic_head_->exchange(bed_.walls()[head], steps);
  if (elastic_mould_) elastic_mould_->exchange(bed_.walls()[mould], steps);
}

template <class Law>
double Compactor<Law>::gyration() const {
  return (bed_.time() - turns_from()) * scene_.gyration.speed;
}

template <class Law>
double Compactor<Law>::last_turn_ends() const {
  return turns_from() + scene_.gyration.count / scene_.gyration.speed;
}

}  // namespace apps

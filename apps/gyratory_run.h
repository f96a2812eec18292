// One gyratory compaction: fill, close, press, gyrate; what is measured on the way.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <optional>

#include "apps/gyratory_findings.h"
#include "apps/gyratory_history.h"
#include "apps/gyratory_pictures.h"
#include "apps/machine.h"
#include "apps/progress.h"
#include "apps/run_watch.h"
#include "apps/session.h"
#include "apps/steel.h"
#include "apps/wall_outputs.h"

namespace apps {

template <class Law>
class GyratoryRun {
 public:
  GyratoryRun(const GyratoryScene& scene, const Mix& mix, const LawBook& book,
              const Machine& machine);

  // The stages in their order; each does what is left of it in a continued run. `pulse` is called
  // after every step.
  void fill(Recorder& recorder, Progress& progress, const Pulse& pulse);
  void close();
  void compact(Recorder& recorder, GyratoryPictures& pictures, Progress& progress,
               const Pulse& pulse);
  std::vector<Finding> findings(double wall_seconds) const;

  void visit_state(Archive& item);  // see dem/state.h

 private:
  enum Part { floor, mould, head };          // the walls, in the order they are added
  static constexpr int movie_pictures = 16;  // of the last gyration

  Law wall_law(Part part, bool bonds) const;
  double air_voids(double plate_height) const;
  double gyration() const;        // gyrations done, negative during the ramp
  double last_turn_ends() const;  // [s]
  double picture_after(double time) const;
  double height_of_plate() const;
  dem::Ram ram() const;
  void mount_head();
  void step();
  GyratoryHistory::Moment moment() const;
  void record(Recorder& recorder);
  void draw(Recorder& recorder, GyratoryPictures& pictures);

  const GyratoryScene& scene_;
  const Mix& mix_;
  const LawBook& book_;
  const Machine& machine_;
  dem::Simulation<Law> bed_;
  std::optional<SteelPart> elastic_mould_, elastic_head_;
  double head_mass_ = 0;  // [kg]
  RunWatch<Law> watch_;
  bool closed_ = false;
  double closed_at_ = 0;       // when the plate came down [s]
  double plate_start_ = 0;     // middle of the plate then [m]
  double settled_height_ = 0;  // of the bed then, mean of its highest points [m]
  std::int64_t settled_steps_ = 0;
  GyratoryHistory history_;
  double next_row_ = 0, next_picture_ = 0;  // [s]
  WallOutputs wall_outputs_;
};

template <class Law>
GyratoryRun<Law>::GyratoryRun(const GyratoryScene& scene, const Mix& mix, const LawBook& book,
                              const Machine& machine)
    : scene_(scene),
      mix_(mix),
      book_(book),
      machine_(machine),
      bed_(make_bed<Law>(scene.stones, mix, book, scene.fill, scene.numerics, scene.run.seed,
                         dem::RoundMould{machine.mould_radius})),
      wall_outputs_(scene, machine) {
  dem::Wall base, ring;
  base.name = "floor";
  base.surface = dem::Plane{};
  ring.name = "mould";
  ring.surface = dem::CylinderInside{machine.mould_radius};
  bed_.add_wall(base, wall_law(floor, scene.fill.bonds));
  bed_.add_wall(ring, wall_law(mould, scene.fill.bonds));
  watch_.begin(bed_, scene.fill, scene.output.energy_ledger);
}

template <class Law>
void GyratoryRun<Law>::visit_state(Archive& item) {
  watch_.visit_state(item);
  item("closed", closed_);
  item("closed_at", closed_at_);
  item("plate_start", plate_start_);
  if (closed_ && item.restores()) mount_head();
  bed_.visit_state(item);
  if (closed_) wall_outputs_.visit_state(item, "outputs.");
  if (elastic_head_) elastic_head_->visit_state(item, "head.modes.");
  if (elastic_mould_) elastic_mould_->visit_state(item, "mould.modes.");
  item("settled_height", settled_height_);
  item("settled_steps", settled_steps_);
  history_.visit_state(item);
  item("next_row", next_row_);
  item("next_picture", next_picture_);
}

template <class Law>
Law GyratoryRun<Law>::wall_law(Part part, bool bonds) const {
  const auto& ring = scene_.mould.elastic;
  const auto& plate = scene_.head.elastic;
  dem::Material material = rigid;
  if (part == mould && ring) material = {ring->young, ring->poisson};
  if (part == head && plate) material = {plate->young, plate->poisson};
  const double friction = part == head ? scene_.head.friction : scene_.mould.wall_friction;
  return book_.law<Law>({material, friction}, bonds);
}

template <class Law>
void GyratoryRun<Law>::fill(Recorder& recorder, Progress& progress, const Pulse& pulse) {
  watch_.settle(bed_, recorder, progress, pulse);
}

template <class Law>
void GyratoryRun<Law>::close() {
  if (closed_) return;
  closed_ = true;
  closed_at_ = bed_.time();
  settled_steps_ = bed_.steps();
  watch_.end_settling();
  settled_height_ = dem::mean_of_highest(bed_.stones(), highest_points);
  next_row_ = row_after(closed_at_, scene_.output.history_interval, closed_at_);
  next_picture_ = picture_after(closed_at_);
  plate_start_ = height_of_plate();
  mount_head();
}

// At which the inclined plate touches the highest stone.
template <class Law>
double GyratoryRun<Law>::height_of_plate() const {
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
dem::Ram GyratoryRun<Law>::ram() const {
  const GyrationScene& gyration = scene_.gyration;
  return {head_mass_ * scene_.numerics.head_mass_scale,
          head_mass_ * 9.81,
          gyration.pressure * machine_.section,
          closed_at_,
          gyration.ramp,
          gyration.angle,
          gyration.speed,
          gyration.spin,
          gyration.dwell,
          gyration.approach_speed};
}

// Puts the inclined head on the bed; from now on shells bond and inertia may be selected.
template <class Law>
void GyratoryRun<Law>::mount_head() {
  const TimeBudget::Phase before = watch_.budget.enter(TimeBudget::steel_setup);
  dem::Wall plate;
  plate.name = "head";
  plate.surface = dem::Disc{machine_.plate_radius};
  if (scene_.head.elastic) {
    elastic_head_.emplace(*scene_.head.elastic, machine_, scene_.numerics, plate);
    head_mass_ = elastic_head_->mass();
  } else {
    head_mass_ = rigid_head_mass(scene_.head, machine_);
  }
  plate.motion = ram();
  orient(ram(), plate.frame, closed_at_);
  plate.frame.origin = {0, 0, plate_start_};
  bed_.add_wall(plate, wall_law(head, true));
  if (scene_.mould.elastic)
    elastic_mould_.emplace(*scene_.mould.elastic, machine_, scene_.numerics, bed_.walls()[mould]);
  watch_.budget.enter(before);
  wall_outputs_.begin(bed_.walls(), elastic_mould_);
  const Law law = book_.law<Law>({std::nullopt, scene_.stones.friction}, true);
  bed_.set_laws(law, {wall_law(floor, true), wall_law(mould, true), wall_law(head, true)});
  if (scene_.numerics.selective_mass) bed_.set_inertia(selected_inertia(law, bed_.stones()));
}

template <class Law>
double GyratoryRun<Law>::gyration() const {
  return (bed_.time() - ram().turns_from()) * scene_.gyration.speed;
}

template <class Law>
double GyratoryRun<Law>::last_turn_ends() const {
  return ram().turns_from() + scene_.gyration.count / scene_.gyration.speed;
}

template <class Law>
double GyratoryRun<Law>::picture_after(double time) const {
  const double interval = scene_.output.picture_interval;
  double next = interval > 0 ? time + interval : std::numeric_limits<double>::infinity();
  if (scene_.movie) {
    const double turn = 1 / scene_.gyration.speed;
    const double last = std::max(ram().turns_from(), last_turn_ends() - turn);
    next = std::min(next, std::max(time + turn / movie_pictures, last));
  }
  return next;
}

template <class Law>
double GyratoryRun<Law>::air_voids(double plate_height) const {
  return 1 - (mix_.stone_volume + mix_.binder_volume) / machine_.specimen_volume(plate_height);
}

template <class Law>
void GyratoryRun<Law>::step() {
  const bool timed = bed_.steps() % TimeBudget::sampling == 0;
  const double began = timed ? wall_clock() : 0;
  bed_.step();
  const double stepped = timed ? wall_clock() : 0;
  watch_.look(bed_);
  const double dt = bed_.time_step();
  dem::Wall& plate = bed_.walls()[head];
  dem::Wall& ring = bed_.walls()[mould];
  wall_outputs_.look(bed_.walls(), bed_.last_step(), plate.frame.origin.z, [this](int part) {
    return bed_.wall_contacts(part).bending_power(bed_.walls()[part]);
  });
  const double looked = timed ? wall_clock() : 0;
  if (elastic_head_) elastic_head_->exchange(plate, dt);
  if (elastic_mould_) elastic_mould_->exchange(ring, dt);
  if (timed) {
    watch_.budget.sample(TimeBudget::stones, stepped - began);
    watch_.budget.sample(TimeBudget::outputs, looked - stepped);
    watch_.budget.sample(TimeBudget::steel, wall_clock() - looked);
  }
  history_.look(plate, ring, bed_.time(), dt);
}

template <class Law>
GyratoryHistory::Moment GyratoryRun<Law>::moment() const {
  const dem::PlateFace face = dem::plate_face(bed_.walls()[head]);
  const dem::ParticleStore& stones = bed_.stones();
  return {.time = bed_.time() - closed_at_,
          .gyration = gyration(),
          .height = face.mean_height,
          .air_voids = air_voids(face.mean_height),
          .internal_angle = face.angle,
          .fractured = static_cast<double>(bed_.cracks().size()),
          .bonds = static_cast<double>(bed_.pairs().held()),
          .coordination = 2.0 * static_cast<double>(bed_.pairs().touching(stones)) /
                          static_cast<double>(stones.size()),
          .kinetic_energy = dem::kinetic_energy(stones),
          .time_step = bed_.time_step()};
}

template <class Law>
void GyratoryRun<Law>::record(Recorder& recorder) {
  const GyratoryHistory::Moment now = moment();
  std::vector<double> row = history_.end_row(now, scene_, machine_.section);
  watch_.add_to(row);
  std::ranges::copy(wall_outputs_.row(), std::back_inserter(row));
  wall_outputs_.turn(now.gyration, bed_.walls()[mould], elastic_mould_, recorder);
  if (now.gyration < 0)
    watch_.filling.record(recorder, bed_.time(), bed_.stones(), row[GyratoryHistory::ram_pressure]);
  history_.record(recorder, now, scene_.gyration.count, std::move(row));
}

template <class Law>
void GyratoryRun<Law>::compact(Recorder& recorder, GyratoryPictures& pictures, Progress& progress,
                               const Pulse& pulse) {
  const double end = last_turn_ends(), length = end - closed_at_;
  watch_.budget.enter(TimeBudget::stepping);
  const double began = wall_clock();
  const std::int64_t first_step = bed_.steps();
  for (;;) {
    while (bed_.time() < std::min(next_row_, end)) {
      step();
      pulse();
    }
    next_row_ = row_after(next_row_, scene_.output.history_interval, bed_.time());
    record(recorder);
    if (bed_.time() >= end) break;
    if (bed_.time() >= next_picture_) {
      draw(recorder, pictures);
      next_picture_ = picture_after(next_picture_);
    }
    const double height = dem::plate_face(bed_.walls()[head]).mean_height;
    const double rate =
        static_cast<double>(bed_.steps() - first_step) / (wall_clock() - began + 1e-9);
    progress.report(
        (bed_.time() - closed_at_) / length,
        fmt::format("time {:.2f} s, gyration {:.2f}, height {:.2f} mm, air voids {:.2f} %, "
                    "{:.0f} steps/s",
                    bed_.time() - closed_at_, std::max(0.0, gyration()), 1e3 * height,
                    1e2 * air_voids(height), rate));
  }
  draw(recorder, pictures);
  watch_.budget.enter(TimeBudget::other);
  recorder.flush();
  progress.finish();
}

template <class Law>
void GyratoryRun<Law>::draw(Recorder& recorder, GyratoryPictures& pictures) {
  const TimeBudget::Phase before = watch_.budget.enter(TimeBudget::pictures);
  pictures.draw(bed_.time() - closed_at_, bed_.stones(), bed_.coordination(),
                {bed_.walls()[head], elastic_head_}, {bed_.walls()[mould], elastic_mould_});
  write_bed(recorder, bed_, closed_at_);
  const dem::PlateFace face = dem::plate_face(bed_.walls()[head]);
  const dem::Vec3d& centre = bed_.walls()[head].frame.origin;
  recorder.write("/head/centre", std::array{centre.x, centre.y, face.mean_height}, "m");
  recorder.write("/head/normal", std::array{face.normal.x, face.normal.y, face.normal.z}, "1");
  watch_.budget.enter(before);
}

template <class Law>
std::vector<Finding> GyratoryRun<Law>::findings(double wall_seconds) const {
  const GyratoryOutcome outcome = {
      report_on(bed_), wall_seconds,   settled_steps_,
      settled_height_, head_mass_,     history_.voids_at_start(),
      elastic_head_,   elastic_mould_, {GyratoryHistory::columns(scene_), history_.last_rows()}};
  std::vector<Finding> found = gyratory_findings(scene_, mix_, machine_, outcome);
  watch_.add_to(found);
  return found;
}

}  // namespace apps

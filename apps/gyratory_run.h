// One gyratory compaction: fill, close, press, gyrate; what is measured on the way and when.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

#include "apps/compactor.h"
#include "apps/gyratory_findings.h"
#include "apps/gyratory_history.h"
#include "apps/gyratory_pictures.h"
#include "apps/progress.h"
#include "apps/run_watch.h"
#include "apps/session.h"
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
  std::vector<Finding> findings(const Spent& spent) const;

  void visit_state(Archive& item);  // see dem/state.h

 private:
  static constexpr int movie_pictures = 16;  // of the last gyration

  double air_voids(double plate_height) const;
  double picture_after(double time) const;
  void step();
  GyratoryHistory::Moment moment() const;
  void record(Recorder& recorder);
  void draw(Recorder& recorder, GyratoryPictures& pictures);

  const GyratoryScene& scene_;
  const Mix& mix_;
  const Machine& machine_;
  Compactor<Law> compactor_;
  dem::Simulation<Law>& bed_;
  RunWatch<Law> watch_;
  double settled_height_ = 0;  // mean of the highest points of the bed [m]
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
      machine_(machine),
      compactor_(scene, mix, book, machine),
      bed_(compactor_.bed()),
      wall_outputs_(scene, machine) {
  watch_.begin(bed_, scene.fill, scene.output.energy_ledger);
}

template <class Law>
void GyratoryRun<Law>::visit_state(Archive& item) {
  watch_.visit_state(item);
  const TimeBudget::Phase before = watch_.budget.enter(TimeBudget::steel_setup);
  compactor_.visit_closing(item);
  if (compactor_.closed() && item.restores())
    wall_outputs_.begin(bed_.walls(), compactor_.elastic_mould());
  watch_.budget.enter(before);
  compactor_.visit_state(item);
  if (compactor_.closed()) wall_outputs_.visit_state(item, "outputs.");
  item("settled_height", settled_height_);
  item("settled_steps", settled_steps_);
  history_.visit_state(item);
  item("next_row", next_row_);
  item("next_picture", next_picture_);
}

template <class Law>
void GyratoryRun<Law>::fill(Recorder& recorder, Progress& progress, const Pulse& pulse) {
  watch_.settle(bed_, recorder, progress, pulse);
}

template <class Law>
void GyratoryRun<Law>::close() {
  if (compactor_.closed()) return;
  settled_steps_ = bed_.steps();
  watch_.end_settling();
  settled_height_ = dem::mean_of_highest(bed_.stones(), highest_points);
  const TimeBudget::Phase before = watch_.budget.enter(TimeBudget::steel_setup);
  compactor_.close();
  wall_outputs_.begin(bed_.walls(), compactor_.elastic_mould());
  watch_.budget.enter(before);
  const double now = bed_.time();
  next_row_ = row_after(now, scene_.output.history_interval, now);
  next_picture_ = picture_after(now);
}

template <class Law>
double GyratoryRun<Law>::picture_after(double time) const {
  const double interval = scene_.output.picture_interval;
  double next = interval > 0 ? time + interval : std::numeric_limits<double>::infinity();
  if (scene_.movie) {
    const double turn = 1 / scene_.gyration.speed;
    const double last = std::max(compactor_.turns_from(), compactor_.last_turn_ends() - turn);
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
  const double height = compactor_.plate().frame.origin.z;
  wall_outputs_.look(bed_.walls(), bed_.last_step(), height, [this](int part) {
    return bed_.wall_contacts(part).bending_power(bed_.walls()[part]);
  });
  const double looked = timed ? wall_clock() : 0;
  compactor_.exchange();
  if (timed) {
    watch_.budget.sample(TimeBudget::stones, stepped - began);
    watch_.budget.sample(TimeBudget::outputs, looked - stepped);
    watch_.budget.sample(TimeBudget::steel, wall_clock() - looked);
  }
  history_.look(compactor_.plate(), compactor_.ring(), bed_.time(), bed_.last_step());
}

template <class Law>
GyratoryHistory::Moment GyratoryRun<Law>::moment() const {
  const dem::PlateFace face = dem::plate_face(compactor_.plate());
  const dem::ParticleStore& stones = bed_.stones();
  return {.time = bed_.time() - compactor_.closed_at(),
          .gyration = compactor_.gyration(),
          .height = face.mean_height,
          .air_voids = air_voids(face.mean_height),
          .internal_angle = face.angle,
          .fractured = static_cast<double>(bed_.cracks().size()),
          .bonds = bonds(bed_, scene_.binder),
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
  wall_outputs_.turn(now.gyration, compactor_.ring(), compactor_.elastic_mould(), recorder);
  if (now.gyration < 0)
    watch_.filling.record(recorder, bed_.time(), bed_.stones(), row[GyratoryHistory::ram_pressure]);
  history_.record(recorder, now, scene_.gyration.count, std::move(row));
}

template <class Law>
void GyratoryRun<Law>::compact(Recorder& recorder, GyratoryPictures& pictures, Progress& progress,
                               const Pulse& pulse) {
  const double end = compactor_.last_turn_ends(), length = end - compactor_.closed_at();
  watch_.budget.enter(TimeBudget::stepping);
  const double began = wall_clock();
  const std::int64_t first_step = bed_.steps();
  for (;;) {
    // A row ends where the gyrations begin, however long rows are: changes are counted from there.
    constexpr double apart = 1e-9;  // [s]
    const double begin = compactor_.turns_from();
    const bool begins = !history_.began() && begin < next_row_ - apart;
    while (bed_.time() < std::min(begins ? begin : next_row_, end)) {
      step();
      pulse();
    }
    const double interval = begins ? 0 : scene_.output.history_interval;
    next_row_ = row_after(next_row_, interval, bed_.time());
    record(recorder);
    if (bed_.time() >= end) break;
    if (bed_.time() >= next_picture_) {
      draw(recorder, pictures);
      next_picture_ = picture_after(next_picture_);
    }
    const double height = dem::plate_face(compactor_.plate()).mean_height;
    const double rate =
        static_cast<double>(bed_.steps() - first_step) / (wall_clock() - began + 1e-9);
    progress.report(
        (bed_.time() - compactor_.closed_at()) / length,
        fmt::format("time {:.2f} s, gyration {:.2f}, height {:.2f} mm, air voids {:.2f} %, "
                    "{:.0f} steps/s",
                    bed_.time() - compactor_.closed_at(), std::max(0.0, compactor_.gyration()),
                    1e3 * height, 1e2 * air_voids(height), rate));
  }
  draw(recorder, pictures);
  watch_.budget.enter(TimeBudget::other);
  recorder.flush();
  progress.finish();
}

template <class Law>
void GyratoryRun<Law>::draw(Recorder& recorder, GyratoryPictures& pictures) {
  const TimeBudget::Phase before = watch_.budget.enter(TimeBudget::pictures);
  pictures.draw(bed_.time() - compactor_.closed_at(), bed_.stones(),
                dem::coordination(bed_.pairs(), bed_.stones()),
                {compactor_.plate(), compactor_.elastic_head()},
                {compactor_.ring(), compactor_.elastic_mould()});
  write_bed(recorder, bed_, compactor_.closed_at());
  const dem::PlateFace face = dem::plate_face(compactor_.plate());
  const dem::Vec3d& centre = compactor_.plate().frame.origin;
  recorder.write("/head/centre", std::array{centre.x, centre.y, face.mean_height}, "m");
  recorder.write("/head/normal", std::array{face.normal.x, face.normal.y, face.normal.z}, "1");
  watch_.budget.enter(before);
}

template <class Law>
std::vector<Finding> GyratoryRun<Law>::findings(const Spent& spent) const {
  const GyratoryOutcome outcome = {report_on(bed_),
                                   spent,
                                   settled_steps_,
                                   settled_height_,
                                   compactor_.head_mass(),
                                   history_.voids_at_start(),
                                   compactor_.elastic_head(),
                                   compactor_.elastic_mould(),
                                   {GyratoryHistory::columns(scene_), history_.last_rows()}};
  std::vector<Finding> found = gyratory_findings(scene_, mix_, machine_, outcome);
  watch_.add_to(found);
  return found;
}

}  // namespace apps

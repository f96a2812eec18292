// One compaction flow test: fill a rigid box, press a strip into one side of the mix, watch the
// force and how the rest rises. Nothing of the elastic steel is known here.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

#include "apps/errors.h"
#include "apps/findings.h"
#include "apps/pictures.h"
#include "apps/progress.h"
#include "apps/run_watch.h"
#include "apps/session.h"
#include "apps/stone_picture.h"

namespace apps {

template <class Law>
class FlowRun {
 public:
  FlowRun(const FlowTestScene& scene, const Mix& mix, const LawBook& book,
          const std::string& folder);

  // The stages in their order; each does what is left of it in a continued run. `pulse` is called
  // after every step.
  void fill(Recorder& recorder, Progress& progress, const Pulse& pulse);
  void press(Recorder& recorder, Progress& progress, const Pulse& pulse);
  std::vector<Finding> findings(const Spent& spent) const;

  void visit_state(Archive& item);  // see dem/state.h

  static std::vector<Column> columns(const FlowTestScene& scene);

 private:
  // Means over the time since the last row.
  struct Means {
    double span = 0, impulse = 0;  // [s], of the stones on the strip [N s]
  };

  void lower_strip();  // throws InputError if it is to go deeper than the mix
  double height_under_strip() const;
  void mount_strip();
  void record(Recorder& recorder);
  void step();
  void draw(Recorder& recorder);
  double displacement() const {  // of the strip [m]
    return scene_.flow.speed * (bed_.time() - started_at_);
  }
  double strip_area() const { return scene_.flow.strip_length * scene_.flow.width; }  // [m2]

  const FlowTestScene& scene_;
  const Mix& mix_;
  const LawBook& book_;
  Law wall_law_;
  dem::Simulation<Law> bed_;
  std::string folder_;
  std::size_t strip_ = 0;  // its place among the walls
  RunWatch<Law> watch_;
  bool lowered_ = false;                        // has the strip begun
  double started_at_ = 0;                       // [s]
  double bed_height_ = 0;                       // mean of the highest points of the settled bed [m]
  double pressure_ = 0, largest_pressure_ = 0;  // under the strip [Pa]
  double uplift_ = 0, lowest_uplift_ = 0;       // [m]
  Means means_;
  double next_row_ = 0, next_picture_ = 0;  // [s]
  int pictures_ = 0;
  double last_picture_ = -std::numeric_limits<double>::infinity();  // its time [s]
  Series stone_series_, strip_series_;
};

template <class Law>
FlowRun<Law>::FlowRun(const FlowTestScene& scene, const Mix& mix, const LawBook& book,
                      const std::string& folder)
    : scene_(scene),
      mix_(mix),
      book_(book),
      wall_law_(book.law<Law>({rigid, scene.flow.wall_friction}, scene.fill.bonds)),
      bed_(make_bed<Law>(scene.stones, mix, book, scene.fill, scene.numerics, scene.run.seed,
                         dem::RectangularMould{scene.flow.length, scene.flow.width})),
      folder_(folder),
      stone_series_(folder + "/stones.pvd"),
      strip_series_(folder + "/strip.pvd") {
  const dem::Vec3d x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
  // A wall that looks along `axis`: its frame's z.
  const auto add = [&](const char* name, const dem::Vec3d& origin, const dem::Vec3d& axis,
                       const dem::Vec3d& across) {
    dem::Wall wall;
    wall.name = name;
    wall.surface = dem::Plane{};
    wall.frame.origin = origin;
    wall.frame.ez = axis;
    wall.frame.ex = across;
    wall.frame.ey = cross(axis, across);
    bed_.add_wall(wall, wall_law_);
  };
  add("floor", {0, 0, 0}, z, x);
  add("left", {0, 0, 0}, x, y);
  add("right", {scene.flow.length, 0, 0}, -x, y);
  add("front", {0, 0, 0}, y, z);
  add("back", {0, scene.flow.width, 0}, -y, z);
  watch_.begin(bed_, scene.fill, scene.output.energy_ledger);
}

template <class Law>
void FlowRun<Law>::visit_state(Archive& item) {
  watch_.visit_state(item);
  item("lowered", lowered_);
  item("started_at", started_at_);
  if (lowered_ && item.restores()) mount_strip();
  bed_.visit_state(item);
  item("bed_height", bed_height_);
  item("largest_pressure", largest_pressure_);
  item("lowest_uplift", lowest_uplift_);
  item("means", means_);
  item("next_row", next_row_);
  item("next_picture", next_picture_);
  item("pictures.drawn", pictures_);
  item("pictures.last_time", last_picture_);
  if (!item.restores()) return;
  stone_series_ = Series(folder_ + "/stones.pvd", last_picture_);
  strip_series_ = Series(folder_ + "/strip.pvd", last_picture_);
}

template <class Law>
void FlowRun<Law>::fill(Recorder& recorder, Progress& progress, const Pulse& pulse) {
  watch_.settle(bed_, recorder, progress, pulse);
}

template <class Law>
void FlowRun<Law>::lower_strip() {
  if (lowered_) return;
  lowered_ = true;
  started_at_ = bed_.time();
  watch_.end_settling();
  bed_height_ = dem::mean_of_highest(bed_.stones(), highest_points);
  next_row_ = row_after(started_at_, scene_.output.history_interval, started_at_);
  next_picture_ = started_at_ + scene_.output.picture_interval;
  if (const double low = height_under_strip(); scene_.flow.displacement >= low)
    throw InputError({fmt::format(
        "{}: expected less than the height of the mix under the strip, {:.4g} mm, found {:.4g} mm; "
        "make it less or take more stones",
        scene_.where("flow.displacement"), 1e3 * low, 1e3 * scene_.flow.displacement)});
  mount_strip();
}

// Of the highest stone there [m].
template <class Law>
double FlowRun<Law>::height_under_strip() const {
  const dem::ParticleStore& stones = bed_.stones();
  double low = 0;
  for (std::size_t k = 0; k < stones.size(); ++k)
    if (stones.position[k].x < scene_.flow.strip_length + stones.outer_radius(k))
      low = std::max(low, stones.position[k].z + stones.outer_radius(k));
  return low;
}

// Puts the strip on the highest stone below it; from now on shells bond and inertia may be
// selected.
template <class Law>
void FlowRun<Law>::mount_strip() {
  const FlowScene& flow = scene_.flow;
  const dem::Vec3d half = {flow.strip_length / 2, flow.width / 2, flow.height};
  dem::Wall strip;
  strip.name = "strip";
  strip.surface = dem::Block{half};
  strip.frame.origin = {half.x, half.y, height_under_strip() + half.z};
  strip.motion = dem::Driven{{0, 0, -flow.speed}};
  strip_ = bed_.walls().size();
  wall_law_ = book_.law<Law>({rigid, flow.wall_friction}, true);
  bed_.add_wall(strip, wall_law_);
  const Law law = book_.law<Law>({std::nullopt, scene_.stones.friction}, true);
  bed_.set_laws(law, std::vector<Law>(bed_.walls().size(), wall_law_));
  if (scene_.numerics.selective_mass) bed_.set_inertia(selected_inertia(law, bed_.stones()));
}

template <class Law>
std::vector<Column> FlowRun<Law>::columns(const FlowTestScene& scene) {
  std::vector<Column> all = {{"time", "s"},      {"displacement", "m"}, {"force", "N"},
                             {"pressure", "Pa"}, {"uplift", "m"},       {"fractured", "1"},
                             {"bonds", "1"},     {"coordination", "1"}, {"kinetic_energy", "J"},
                             {"time_step", "s"}};
  if (scene.output.energy_ledger) add_energy_columns(all);
  return all;
}

template <class Law>
void FlowRun<Law>::step() {
  const bool timed = bed_.steps() % TimeBudget::sampling == 0;
  const double began = timed ? wall_clock() : 0;
  bed_.step();
  const double stepped = timed ? wall_clock() : 0;
  watch_.look(bed_);
  means_.span += bed_.last_step();
  means_.impulse += bed_.walls()[strip_].force.z * bed_.last_step();
  if (!timed) return;
  watch_.budget.sample(TimeBudget::stones, stepped - began);
  watch_.budget.sample(TimeBudget::outputs, wall_clock() - stepped);
}

template <class Law>
void FlowRun<Law>::record(Recorder& recorder) {
  const double force = means_.impulse / means_.span;
  pressure_ = force / strip_area();
  uplift_ = dem::mean_of_highest(bed_.stones(), highest_points) - bed_height_;
  largest_pressure_ = std::max(largest_pressure_, pressure_);
  lowest_uplift_ = std::min(lowest_uplift_, uplift_);
  const double coordination = 2.0 * static_cast<double>(bed_.pairs().touching(bed_.stones())) /
                              static_cast<double>(bed_.stones().size());
  std::vector<double> row = {bed_.time() - started_at_,
                             displacement(),
                             force,
                             pressure_,
                             uplift_,
                             static_cast<double>(bed_.cracks().size()),
                             bonds(bed_, scene_.binder),
                             coordination,
                             dem::kinetic_energy(bed_.stones()),
                             bed_.time_step()};
  watch_.add_to(row);
  recorder.append(row);
  means_ = {};
}

template <class Law>
void FlowRun<Law>::press(Recorder& recorder, Progress& progress, const Pulse& pulse) {
  lower_strip();
  watch_.budget.enter(TimeBudget::stepping);
  const double length = scene_.flow.displacement / scene_.flow.speed;
  const double end = started_at_ + length;
  for (;;) {
    while (bed_.time() < std::min(next_row_, end)) {
      step();
      pulse();
    }
    next_row_ = row_after(next_row_, scene_.output.history_interval, bed_.time());
    record(recorder);
    if (bed_.time() >= end) break;
    if (scene_.output.picture_interval > 0 && bed_.time() >= next_picture_) {
      draw(recorder);
      next_picture_ += scene_.output.picture_interval;
    }
    progress.report(
        (bed_.time() - started_at_) / length,
        fmt::format("time {:.2f} s, displacement {:.2f} mm, pressure {:.1f} kPa, uplift "
                    "{:+.2f} mm, step {:.1e} s",
                    bed_.time() - started_at_, 1e3 * displacement(), 1e-3 * pressure_,
                    1e3 * uplift_, bed_.time_step()));
  }
  draw(recorder);
  watch_.budget.enter(TimeBudget::other);
  recorder.flush();
  progress.finish();
}

template <class Law>
void FlowRun<Law>::draw(Recorder& recorder) {
  const TimeBudget::Phase before = watch_.budget.enter(TimeBudget::pictures);
  const double time = bed_.time() - started_at_;
  const dem::Vec3d& o = bed_.walls()[strip_].frame.origin;
  const dem::Vec3d& h = std::get<dem::Block>(bed_.walls()[strip_].surface).half;
  const std::string stones = fmt::format("stones_{:04d}.vtp", pictures_);
  const std::string strip = fmt::format("strip_{:04d}.vtp", pictures_++);
  draw_stones(folder_ + "/" + stones, bed_.stones(),
              dem::coordination(bed_.pairs(), bed_.stones()));
  write_polygons(folder_ + "/" + strip,
                 box({o.x - h.x, o.y - h.y, o.z - h.z}, {o.x + h.x, o.y + h.y, o.z + h.z}), {});
  stone_series_.add(time, stones);
  strip_series_.add(time, strip);
  last_picture_ = time;
  write_bed(recorder, bed_, started_at_);
  recorder.write("/strip/low", std::array{o.x - h.x, o.y - h.y, o.z - h.z}, "m");
  recorder.write("/strip/high", std::array{o.x + h.x, o.y + h.y, o.z + h.z}, "m");
  watch_.budget.enter(before);
}

template <class Law>
std::vector<Finding> FlowRun<Law>::findings(const Spent& spent) const {
  std::vector<Finding> found =
      bed_findings(report_on(bed_), mix_, scene_.numerics, scene_.run.seed, spent);
  const std::vector<Finding> own = {{"bed_height_m", bed_height_},
                                    {"displacement_m", scene_.flow.displacement},
                                    {"pressure_largest_Pa", largest_pressure_},
                                    {"uplift_lowest_m", lowest_uplift_},
                                    {"uplift_end_m", uplift_}};
  found.insert(found.end(), own.begin(), own.end());
  watch_.add_to(found);
  return found;
}

}  // namespace apps

// One compaction flow test: fill a rigid box, press a strip into one side of the mix, watch the
// force and how the rest rises. Nothing of the elastic steel is known here.
#pragma once

#include <fmt/format.h>

#include <optional>

#include "apps/bed.h"
#include "apps/pictures.h"
#include "apps/progress.h"
#include "apps/recorder.h"
#include "apps/stone_picture.h"
#include "apps/summary.h"

namespace apps {

template <class Law>
class FlowRun {
 public:
  FlowRun(const FlowTestScene& scene, const Mix& mix, const LawBook& book);

  void fill(Progress& progress);
  void press(Recorder& recorder, const std::string& folder, Progress& progress);
  std::vector<Finding> findings(double wall_seconds) const;

  static std::vector<Column> columns(const FlowTestScene& scene);

 private:
  void lower_strip();
  void draw(const std::string& folder);
  double strip_area() const { return scene_.flow.strip_length * scene_.flow.width; }  // [m2]

  const FlowTestScene& scene_;
  const Mix& mix_;
  const LawBook& book_;
  Law wall_law_;
  dem::Simulation<Law> bed_;
  std::optional<dem::EnergyLedger<Law>> ledger_;
  double settling_residual_ = 0;  // of the ledger, as a share of the work [-]
  std::size_t strip_ = 0;         // its place among the walls
  double started_at_ = 0;         // [s]
  double bed_height_ = 0;         // mean of the highest points of the settled bed [m]
  double largest_pressure_ = 0, lowest_uplift_ = 0, uplift_ = 0;  // [Pa], [m], [m]
  int pictures_ = 0;
  std::optional<Series> stone_series_, strip_series_;
};

template <class Law>
FlowRun<Law>::FlowRun(const FlowTestScene& scene, const Mix& mix, const LawBook& book)
    : scene_(scene),
      mix_(mix),
      book_(book),
      wall_law_(book.law<Law>({rigid, scene.flow.wall_friction}, scene.fill.bonds)),
      bed_(make_bed<Law>(scene.stones, mix, book, scene.fill, scene.numerics, scene.run.seed,
                         dem::RectangularMould{scene.flow.length, scene.flow.width})) {
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
}

template <class Law>
void FlowRun<Law>::fill(Progress& progress) {
  if (scene_.output.energy_ledger) ledger_.emplace();
  const auto report = [&](double rest) {
    progress.report(rest, fmt::format("settling: time {:.2f} s, rest {:.1e}", bed_.time(), rest));
  };
  settle(bed_, scene_.fill, report, ledger_ ? &*ledger_ : nullptr);
  if (!ledger_) return;
  settling_residual_ = ledger_->energies().residual_share();
  ledger_->restart();
}

// Puts the strip on the highest stone below it and lets shells bond from now on.
template <class Law>
void FlowRun<Law>::lower_strip() {
  const FlowScene& flow = scene_.flow;
  const dem::ParticleStore& stones = bed_.stones();
  double low = 0;
  for (std::size_t k = 0; k < stones.size(); ++k)
    if (stones.position[k].x < flow.strip_length + stones.outer_radius(k))
      low = std::max(low, stones.position[k].z + stones.outer_radius(k));
  const dem::Vec3d half = {flow.strip_length / 2, flow.width / 2, flow.height};
  dem::Wall strip;
  strip.name = "strip";
  strip.surface = dem::Block{half};
  strip.frame.origin = {half.x, half.y, low + half.z};
  strip.motion = dem::Driven{{0, 0, -flow.speed}};
  strip_ = bed_.walls().size();
  wall_law_ = book_.law<Law>({rigid, flow.wall_friction}, true);
  bed_.add_wall(strip, wall_law_);
  bed_.set_laws(book_.law<Law>({std::nullopt, scene_.stones.friction}, true),
                std::vector<Law>(bed_.walls().size(), wall_law_));
  started_at_ = bed_.time();
  bed_height_ = dem::mean_of_highest(stones, highest_points);
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
void FlowRun<Law>::press(Recorder& recorder, const std::string& folder, Progress& progress) {
  lower_strip();
  const FlowScene& flow = scene_.flow;
  const double length = flow.displacement / flow.speed;
  const double end = started_at_ + length;
  double next_row = started_at_ + scene_.output.history_interval;
  double next_picture = started_at_ + scene_.output.picture_interval;
  double next_flush = wall_clock() + 5;
  while (bed_.time() < end) {
    double span = 0, impulse = 0;
    while (bed_.time() < std::min(next_row, end)) {
      bed_.step();
      if (ledger_) ledger_->look(bed_);
      span += bed_.time_step();
      impulse += bed_.walls()[strip_].force.z * bed_.time_step();
    }
    next_row += scene_.output.history_interval;
    const double displacement = flow.speed * (bed_.time() - started_at_);
    const double force = impulse / span;
    const double pressure = force / strip_area();
    uplift_ = dem::mean_of_highest(bed_.stones(), highest_points) - bed_height_;
    largest_pressure_ = std::max(largest_pressure_, pressure);
    lowest_uplift_ = std::min(lowest_uplift_, uplift_);
    const double coordination = 2.0 * static_cast<double>(bed_.pairs().touching(bed_.stones())) /
                                static_cast<double>(bed_.stones().size());
    std::vector<double> row = {bed_.time() - started_at_,
                               displacement,
                               force,
                               pressure,
                               uplift_,
                               static_cast<double>(bed_.cracks().size()),
                               static_cast<double>(bed_.pairs().held()),
                               coordination,
                               dem::kinetic_energy(bed_.stones()),
                               bed_.time_step()};
    if (ledger_) add_energies(row, ledger_->energies());
    recorder.append(row);
    if (scene_.output.picture_interval > 0 && bed_.time() >= next_picture) {
      draw(folder);
      next_picture += scene_.output.picture_interval;
    }
    if (wall_clock() > next_flush) {
      recorder.flush();
      next_flush = wall_clock() + 5;
    }
    progress.report(
        (bed_.time() - started_at_) / length,
        fmt::format("time {:.2f} s, displacement {:.2f} mm, pressure {:.1f} kPa, uplift "
                    "{:+.2f} mm, step {:.1e} s",
                    bed_.time() - started_at_, 1e3 * displacement, 1e-3 * pressure, 1e3 * uplift_,
                    bed_.time_step()));
  }
  draw(folder);
  recorder.flush();
  progress.finish();
}

template <class Law>
void FlowRun<Law>::draw(const std::string& folder) {
  const double time = bed_.time() - started_at_;
  const dem::Vec3d& o = bed_.walls()[strip_].frame.origin;
  const dem::Vec3d& h = std::get<dem::Block>(bed_.walls()[strip_].surface).half;
  const std::string stones = fmt::format("stones_{:04d}.vtp", pictures_);
  const std::string strip = fmt::format("strip_{:04d}.vtp", pictures_++);
  if (!stone_series_) stone_series_.emplace(folder + "/stones.pvd");
  if (!strip_series_) strip_series_.emplace(folder + "/strip.pvd");
  draw_stones(folder + "/" + stones, bed_.stones(), bed_.coordination());
  write_polygons(folder + "/" + strip,
                 box({o.x - h.x, o.y - h.y, o.z - h.z}, {o.x + h.x, o.y + h.y, o.z + h.z}), {});
  stone_series_->add(time, stones);
  strip_series_->add(time, strip);
}

template <class Law>
std::vector<Finding> FlowRun<Law>::findings(double wall_seconds) const {
  const auto stones = static_cast<std::int64_t>(bed_.stones().size());
  std::vector<Finding> found = {
      {"stones", stones},
      {"steps", bed_.steps()},
      {"time_step_s", bed_.time_step()},
      {"limiting_contact", bed_.limiting_contact()},
      {"mass_scale", scene_.numerics.mass_scale},
      {"wall_seconds", wall_seconds},
      {"particle_steps_per_second",
       static_cast<double>(stones) * static_cast<double>(bed_.steps()) / wall_seconds},
      {"bed_height_m", bed_height_},
      {"displacement_m", scene_.flow.displacement},
      {"pressure_largest_Pa", largest_pressure_},
      {"uplift_lowest_m", lowest_uplift_},
      {"uplift_end_m", uplift_},
      {"fractured_stones", static_cast<std::int64_t>(bed_.cracks().size())},
      {"shell_thickness_m", mix_.shell},
      {"bitumen_fraction", mix_.bitumen_fraction},
      {"neighbor_rebuilds", bed_.rebuilds()},
      {"seed", static_cast<std::int64_t>(scene_.run.seed)}};
  if (ledger_) {
    found.push_back({"settling_energy_residual_share", settling_residual_});
    add_energies(found, ledger_->energies());
  }
  return found;
}

}  // namespace apps

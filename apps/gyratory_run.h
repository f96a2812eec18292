// One gyratory compaction: fill, close, press, gyrate; what is measured on the way.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <numbers>
#include <optional>

#include "apps/bed.h"
#include "apps/gyratory_pictures.h"
#include "apps/machine.h"
#include "apps/progress.h"
#include "apps/recorder.h"
#include "apps/steel.h"
#include "apps/summary.h"
#include "apps/wall_outputs.h"

namespace apps {

template <class Law>
class GyratoryRun {
 public:
  GyratoryRun(const GyratoryScene& scene, const Mix& mix, const LawBook& book,
              const Machine& machine);

  void fill(Progress& progress);
  void close();
  void compact(Recorder& recorder, GyratoryPictures& pictures, Progress& progress);
  std::vector<Finding> findings(double wall_seconds) const;

  static std::vector<Column> columns();  // those of WallOutputs follow

 private:
  enum Part { floor, mould, head };  // the walls, in the order they are added

  // Means over the time since the last row, so that a row carries balance and not chatter.
  struct Means {
    double span = 0;                                   // [s]
    dem::Vec3d force = {0, 0, 0}, moment = {0, 0, 0};  // on the head [N s], [N m s]
    double mould_push = 0, ram_force = 0;              // [N s]
  };

  Law wall_law(Part part, bool bonds) const;
  double air_voids(double plate_height) const;
  double gyration() const;  // gyrations done, negative during the ramp
  void step();
  std::vector<double> row();
  void record(Recorder& recorder);
  void draw(GyratoryPictures& pictures);

  const GyratoryScene& scene_;
  const Mix& mix_;
  const LawBook& book_;
  const Machine& machine_;
  dem::Simulation<Law> bed_;
  std::optional<SteelPart> elastic_mould_, elastic_head_;
  double head_mass_ = 0;       // [kg]
  double closed_at_ = 0;       // when the plate came down [s]
  double settled_height_ = 0;  // of the bed then, mean of its highest points [m]
  std::int64_t settled_steps_ = 0;
  Means means_;
  WallOutputs wall_outputs_;
  double setup_seconds_ = 0;                    // from the meshes to the reduced bodies
  double exchanging_ = 0, stepping_ = 0;        // wall clock of sampled steps [s]
  std::vector<std::vector<double>> ramp_rows_;  // held until air_voids_decrease has its reference
  std::vector<std::vector<double>> rows_;       // of the last two gyrations, for the findings
  std::optional<double> voids_at_start_;        // when the gyrations begin [-]
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
void GyratoryRun<Law>::fill(Progress& progress) {
  settle(bed_, scene_.fill, [&](double rest) {
    progress.report(rest, fmt::format("settling: time {:.2f} s, rest {:.1e}", bed_.time(), rest));
  });
  settled_steps_ = bed_.steps();
}

// Puts the inclined head on the highest stone and lets shells bond from now on.
template <class Law>
void GyratoryRun<Law>::close() {
  closed_at_ = bed_.time();
  const double began = wall_clock();
  settled_height_ = dem::mean_of_highest(bed_.stones(), highest_points);
  dem::Wall plate;
  plate.name = "head";
  plate.surface = dem::Disc{machine_.plate_radius};
  if (scene_.head.elastic) {
    elastic_head_.emplace(*scene_.head.elastic, machine_, scene_.numerics, plate);
    head_mass_ = elastic_head_->mass();
  } else {
    head_mass_ = rigid_head_mass(scene_.head, machine_);
  }
  const GyrationScene& gyration = scene_.gyration;
  const dem::Ram ram = {head_mass_ * scene_.numerics.head_mass_scale,
                        head_mass_ * 9.81,
                        gyration.pressure * machine_.section,
                        closed_at_,
                        gyration.ramp,
                        gyration.angle,
                        gyration.speed,
                        gyration.spin};
  orient(ram, plate.frame, closed_at_);
  const dem::ParticleStore& stones = bed_.stones();
  double height = 0;
  for (std::size_t k = 0; k < stones.size(); ++k)
    height = std::max(height, (dot(stones.position[k], plate.frame.ez) + stones.outer_radius(k)) /
                                  plate.frame.ez.z);
  plate.frame.origin = {0, 0, height};
  plate.motion = ram;
  bed_.add_wall(plate, wall_law(head, true));
  if (scene_.mould.elastic)
    elastic_mould_.emplace(*scene_.mould.elastic, machine_, scene_.numerics, bed_.walls()[mould]);
  setup_seconds_ = wall_clock() - began;
  wall_outputs_.begin(bed_.walls(), elastic_mould_);
  bed_.set_laws(book_.law<Law>({std::nullopt, scene_.stones.friction}, true),
                {wall_law(floor, true), wall_law(mould, true), wall_law(head, true)});
}

template <class Law>
double GyratoryRun<Law>::gyration() const {
  return (bed_.time() - closed_at_ - scene_.gyration.ramp) * scene_.gyration.speed;
}

template <class Law>
double GyratoryRun<Law>::air_voids(double plate_height) const {
  return 1 - (mix_.stone_volume + mix_.binder_volume) / machine_.specimen_volume(plate_height);
}

template <class Law>
void GyratoryRun<Law>::step() {
  constexpr std::int64_t sampling = 64;  // steps between those that are timed
  const bool timed = bed_.steps() % sampling == 0;
  const double began = timed ? wall_clock() : 0;
  bed_.step();
  const double dt = bed_.time_step();
  dem::Wall& plate = bed_.walls()[head];
  dem::Wall& ring = bed_.walls()[mould];
  wall_outputs_.look(bed_.walls(), dt, plate.frame.origin.z, [this](int part) {
    return bed_.wall_contacts(part).bending_power(bed_.walls()[part]);
  });
  const double stepped = timed ? wall_clock() : 0;
  if (elastic_head_) elastic_head_->exchange(plate, dt);
  if (elastic_mould_) elastic_mould_->exchange(ring, dt);
  if (timed) {
    stepping_ += stepped - began;
    exchanging_ += wall_clock() - stepped;
  }
  means_.span += dt;
  means_.force += plate.force * dt;
  means_.moment += plate.moment * dt;
  means_.mould_push += ring.push * dt;
  means_.ram_force += std::get<dem::Ram>(plate.motion).force_at(bed_.time()) * dt;
}

template <class Law>
std::vector<Column> GyratoryRun<Law>::columns() {
  return {{"time", "s"},
          {"gyration", "1"},
          {"height", "m"},
          {"air_voids", "1"},
          {"ram_pressure", "Pa"},
          {"head_force", "N"},
          {"head_lateral_x", "N"},
          {"head_lateral_y", "N"},
          {"head_moment_x", "N m"},
          {"head_moment_y", "N m"},
          {"commanded_angle", "deg"},
          {"internal_angle", "deg"},
          {"fractured", "1"},
          {"bonds", "1"},
          {"coordination", "1"},
          {"kinetic_energy", "J"},
          {"mould_force", "N"},
          {"time_step", "s"},
          {"air_voids_decrease", "1"}};
}

// One value per column but the last.
template <class Law>
std::vector<double> GyratoryRun<Law>::row() {
  const double degree = 180 / std::numbers::pi;
  const dem::PlateFace face = dem::plate_face(bed_.walls()[head]);
  const double span = means_.span;
  const std::vector<double> values = {bed_.time() - closed_at_,
                                      std::max(0.0, gyration()),
                                      face.mean_height,
                                      air_voids(face.mean_height),
                                      means_.ram_force / span / machine_.section,
                                      means_.force.z / span,
                                      means_.force.x / span,
                                      means_.force.y / span,
                                      means_.moment.x / span,
                                      means_.moment.y / span,
                                      scene_.gyration.angle * degree,
                                      face.angle * degree,
                                      static_cast<double>(bed_.cracks().size()),
                                      static_cast<double>(bed_.pairs().held()),
                                      2.0 * static_cast<double>(bed_.pairs().touching(bed_.stones())) /
                                          static_cast<double>(bed_.stones().size()),
                                      dem::kinetic_energy(bed_.stones()),
                                      means_.mould_push / span,
                                      bed_.time_step()};
  means_ = {};
  return values;
}

template <class Law>
void GyratoryRun<Law>::record(Recorder& recorder) {
  std::vector<double> values = row();
  const double voids = values[3];
  std::ranges::copy(wall_outputs_.row(), std::back_inserter(values));
  wall_outputs_.turn(gyration(), bed_.walls()[mould], elastic_mould_, recorder);
  const auto put = [&](std::vector<double> r) {
    r.insert(r.begin() + columns().size() - 1, *voids_at_start_ - r[3]);
    recorder.append(r);
  };
  if (gyration() < 0) {
    ramp_rows_.push_back(std::move(values));
    return;
  }
  if (!voids_at_start_) {
    voids_at_start_ = voids;
    for (auto& held : ramp_rows_) put(std::move(held));
  }
  if (gyration() >= scene_.gyration.count - 2) rows_.push_back(values);
  put(std::move(values));
}

template <class Law>
void GyratoryRun<Law>::compact(Recorder& recorder, GyratoryPictures& pictures, Progress& progress) {
  const double length = scene_.gyration.ramp + scene_.gyration.count / scene_.gyration.speed;
  const double end = closed_at_ + length;
  double next_row = closed_at_ + scene_.output.history_interval;
  double next_picture = closed_at_ + scene_.output.picture_interval;
  double next_flush = wall_clock() + 5;
  const double began = wall_clock();
  const std::int64_t first_step = bed_.steps();
  while (bed_.time() < end) {
    while (bed_.time() < std::min(next_row, end)) step();
    next_row += scene_.output.history_interval;
    record(recorder);
    if (scene_.output.picture_interval > 0 && bed_.time() >= next_picture) {
      draw(pictures);
      next_picture += scene_.output.picture_interval;
    }
    if (wall_clock() > next_flush) {
      recorder.flush();
      next_flush = wall_clock() + 5;
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
  draw(pictures);
  recorder.flush();
  progress.finish();
}

template <class Law>
void GyratoryRun<Law>::draw(GyratoryPictures& pictures) {
  pictures.draw(bed_.time() - closed_at_, bed_.stones(), bed_.coordination(),
                {bed_.walls()[head], elastic_head_}, {bed_.walls()[mould], elastic_mould_});
}

template <class Law>
std::vector<Finding> GyratoryRun<Law>::findings(double wall_seconds) const {
  const auto mean = [&](int column) {
    double sum = 0;
    for (const auto& r : rows_) sum += r[column] / static_cast<double>(rows_.size());
    return sum;
  };
  const auto stones = static_cast<std::int64_t>(bed_.stones().size());
  std::vector<Finding> found = {
      {"stones", stones},
      {"gyrations", scene_.gyration.count},
      {"steps", bed_.steps()},
      {"settling_steps", settled_steps_},
      {"time_step_s", bed_.time_step()},
      {"limiting_contact", bed_.limiting_contact()},
      {"mass_scale", scene_.numerics.mass_scale},
      {"wall_seconds", wall_seconds},
      {"particle_steps_per_second",
       static_cast<double>(stones) * static_cast<double>(bed_.steps()) / wall_seconds},
      {"air_voids_start", voids_at_start_.value()},
      {"air_voids_end", rows_.back()[3]},
      {"settled_height_m", settled_height_},
      {"height_end_m", rows_.back()[2]},
      {"mould_diameter_m", 2 * machine_.mould_radius},
      {"ram_pressure_mean_Pa", mean(4)},
      {"head_force_mean_N", mean(5)},
      {"head_weight_N", head_mass_ * 9.81},
      {"commanded_angle_deg", mean(10)},
      {"internal_angle_deg", mean(11)},
      {"fractured_stones", static_cast<std::int64_t>(bed_.cracks().size())},
      {"shell_thickness_m", mix_.shell},
      {"bitumen_fraction", mix_.bitumen_fraction},
      {"steel_setup_seconds", setup_seconds_},
      {"coupling_share_of_step", exchanging_ / stepping_},
      {"neighbor_rebuilds", bed_.rebuilds()},
      {"seed", static_cast<std::int64_t>(scene_.run.seed)}};
  if (elastic_head_) {
    const SteelPart::Tilt tilt = elastic_head_->tilt();
    found.push_back({"head_tilt_per_moment_rad_per_Nm", tilt.per_moment});
    found.push_back({"head_tilt_per_force_rad_per_N", tilt.per_force});
    found.push_back({"head_unknowns", static_cast<std::int64_t>(elastic_head_->body().unknowns())});
    found.push_back({"head_gain", elastic_head_->coupled().largest_gain()});
    found.push_back({"head_truncation_error", elastic_head_->coupled().body().truncation_error});
  }
  if (elastic_mould_) {
    found.push_back(
        {"mould_unknowns", static_cast<std::int64_t>(elastic_mould_->body().unknowns())});
    found.push_back({"mould_gain", elastic_mould_->coupled().largest_gain()});
    found.push_back({"mould_truncation_error", elastic_mould_->coupled().body().truncation_error});
  }
  return found;
}

}  // namespace apps

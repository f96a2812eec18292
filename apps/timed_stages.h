// The steps of dem_speed with a clock between their stages, which dem::Simulation has not.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <nlohmann/json.hpp>
#include <vector>

#include "dem/simulation.h"

namespace apps {

inline constexpr double bed_gravity = 196.2;   // 20 g [m/s2]
inline constexpr double bed_time_step = 1e-6;  // [s]

template <class Law>
struct Bed {
  dem::ParticleStore stones;
  std::vector<dem::Wall> walls;
  Law pair_law, wall_law;
};

inline double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The stages of a step, called one by one with their times added up.
template <class Law>
class Stages {
 public:
  enum Stage { motion, lists, pairs, wall_contacts, fracture, stage_count };
  static constexpr std::array<const char*, stage_count> names = {"motion", "lists", "pair contacts",
                                                                 "wall contacts", "fracture"};

  Stages(Bed<Law> bed, double skin) : bed_(std::move(bed)), skin_(skin) {
    bed_.pair_law.set_time_step(bed_time_step);
    bed_.wall_law.set_time_step(bed_time_step);
    pairs_.law = bed_.pair_law;
    at_walls_.resize(bed_.walls.size());
    for (auto& contacts : at_walls_) contacts.law = bed_.wall_law;
    constexpr double cell = 4e-3;  // near the diameter of a stone [m]
    dem::reorder(bed_.stones, dem::spatial_order(bed_.stones.position, cell));
    make_lists();
    dem::weigh(bed_.stones, bed_gravity);
  }

  void step() {
    constexpr dem::Steps steps = {bed_time_step, bed_time_step};
    bool check = ++steps_ % dem::check_interval == 0;
    dem::Travel travel;
    timed(motion, [&] {
      for (dem::Wall& wall : bed_.walls) move(wall);
      travel = dem::advance_stones(bed_.stones, steps, 0, bed_gravity, leash_);
    });
    timed(lists, [&] {
      if (travel.strayed) make_lists();
      check |= travel.strayed;
      for (std::size_t w = 0; w < bed_.walls.size(); ++w) {
        if (bed_.walls[w].moved <= skin_ / 2) continue;
        at_walls_[w].find(bed_.stones, bed_.walls[w], skin_, leash_);
        check = true;
      }
    });
    const double horizon = check ? dem::check_interval * bed_time_step : 0;
    timed(pairs, [&] { pairs_.evaluate(bed_.stones, bed_time_step, horizon); });
    timed(wall_contacts, [&] {
      for (std::size_t w = 0; w < bed_.walls.size(); ++w)
        at_walls_[w].evaluate(bed_.stones, bed_.walls[w], bed_time_step, horizon);
    });
    if constexpr (Law::breaks)
      timed(fracture, [&] { cracked_ += !overloaded(bed_.stones).empty(); });
  }

  void forget_times() { spent_.fill(0); }

  // Of the time spent [-].
  nlohmann::ordered_json shares() const {
    double all = 0;
    for (double spent : spent_) all += spent;
    nlohmann::ordered_json shares;
    for (int k = 0; k < stage_count; ++k) shares[names[k]] = spent_[k] / all;
    return shares;
  }

  // Of a slot, in all arrays that hold one entry a slot [B].
  double bytes_per_slot() const {
    const double lists = list_.first.size() * 3.0 * sizeof(std::uint32_t) +  // and previous
                         list_.candidates.second.size() * sizeof(std::uint32_t);
    return (lists + pairs_.bytes()) / static_cast<double>(pairs_.slots());
  }

  // Of a stone, lists, history and what it leaves at walls included [B].
  double bytes_per_stone() const {
    const dem::ParticleStore& stones = bed_.stones;
    const double numbers =  // radius, and that of the stock; mass, inertia, turning
        5.0 * stones.size() + stones.strength.size() + stones.softness.size();
    const double vectors = 4.0 * stones.size();  // position, and that of the stock; velocity, spin
    const double rows = 4.0 * stones.size() * sizeof(std::uint32_t);  // two ids, two row starts
    double at_walls = 0;
    for (const auto& wall : at_walls_) at_walls += wall.bytes();
    return (numbers * sizeof(double) + vectors * sizeof(dem::Vec3d) + rows +
            stones.size() * sizeof(dem::Leash) + stones.size() * sizeof(dem::Load) +
            bytes_per_slot() * static_cast<double>(pairs_.slots()) + at_walls) /
           static_cast<double>(stones.size());
  }

 private:
  template <class Work>
  void timed(Stage stage, Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    spent_[stage] += seconds_since(start);
  }

  void move(dem::Wall& wall) const {
    constexpr dem::Steps steps = {bed_time_step, bed_time_step};
    const double time = static_cast<double>(steps_ - 1) * bed_time_step;
    dem::advance(wall.motion, wall.frame, wall.force, time, steps);
    const double reach = std::visit([](const auto& face) { return face.extent(); }, wall.surface);
    wall.moved += steps.now * (norm(wall.frame.velocity) + norm(wall.frame.spin) * reach);
  }

  void make_lists() {
    dem::ParticleStore& stones = bed_.stones;
    std::vector<double> radius(stones.size());
    for (std::size_t k = 0; k < radius.size(); ++k) radius[k] = stones.outer_radius(k);
    const std::vector<double> extra = dem::extra_skin(stones, skin_, bed_time_step);
    list_.build({stones.position, radius, stones.id, extra}, skin_);
    pairs_.take(list_, bed_.stones);
    leash_ = dem::leashes(stones, skin_, extra);
    for (std::size_t w = 0; w < bed_.walls.size(); ++w)
      at_walls_[w].find(stones, bed_.walls[w], skin_, leash_);
  }

  Bed<Law> bed_;
  double skin_;
  dem::NeighborList list_;
  dem::PairContacts<Law> pairs_;
  std::vector<dem::WallContacts<Law>> at_walls_;
  std::vector<dem::Leash> leash_;
  std::array<double, stage_count> spent_ = {};  // [s]
  std::int64_t steps_ = 0, cracked_ = 0;
};

}  // namespace apps

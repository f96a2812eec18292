// Where the time of the steps goes.
#pragma once

#include <array>
#include <chrono>

namespace dem {

enum class Stage { motion, lists, pairs, walls, fracture, rest };
inline constexpr int stages = static_cast<int>(Stage::rest) + 1;

class StageTimes {
 public:
  // What runs from now on.
  void enter(Stage stage) {
    const auto now = Clock::now();
    spent_[static_cast<int>(stage_)] += std::chrono::duration<double>(now - since_).count();
    since_ = now;
    stage_ = stage;
  }
  double spent(Stage stage) const { return spent_[static_cast<int>(stage)]; }  // [s]

 private:
  using Clock = std::chrono::steady_clock;
  std::array<double, stages> spent_ = {};
  Stage stage_ = Stage::rest;
  Clock::time_point since_ = Clock::now();
};

}  // namespace dem

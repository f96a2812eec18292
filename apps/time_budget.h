// Where the wall-clock time of a run goes, phase by phase. A time step is too short for a clock in
// each: of the steps some are timed, and their shares are those of all.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "apps/clocks.h"
#include "apps/summary.h"

namespace apps {

class TimeBudget {
 public:
  enum Phase { other, settling, steel_setup, stepping, pictures, phases };
  static constexpr int sampling = 61;           // steps between timed ones, prime to all intervals
  enum Part { stones, outputs, steel, parts };  // of a time step

  // Begins a phase and ends the one before, which is returned.
  Phase enter(Phase phase) {
    const double now = wall_clock();
    spent_[phase_] += now - since_;
    since_ = now;
    return std::exchange(phase_, phase);
  }

  // Adds a time that was taken in a timed step [s].
  void sample(Part part, double seconds) { sampled_[part] += seconds; }

  double seconds(Phase phase) const { return spent_[phase]; }
  double share(Part part) const;  // of the time steps [-]

  // `seconds_...`, one for each phase; time steps by their parts.
  std::vector<Finding> findings() const;

  // See dem/state.h.
  template <class Visit>
  void visit_state(Visit& visit) {
    enter(phase_);
    visit("budget.spent", spent_);
    visit("budget.sampled", sampled_);
  }

 private:
  Phase phase_ = other;
  double since_ = wall_clock();
  std::array<double, phases> spent_ = {};   // [s]
  std::array<double, parts> sampled_ = {};  // in timed steps [s]
};

}  // namespace apps

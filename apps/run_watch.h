// What every run of a bed does beside its own matter: it fills, keeps account of the energy where
// the scene asks for it, and of the wall-clock time.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <vector>

#include "apps/bed.h"
#include "apps/bed_results.h"
#include "apps/ledger.h"
#include "apps/progress.h"
#include "apps/session.h"
#include "apps/time_budget.h"

namespace apps {

// When a row of a history is due after the one that was due before: an interval later, but not
// before another step [s].
inline double row_after(double due, double interval, double now) {
  return std::max(due + interval, std::nextafter(now, std::numeric_limits<double>::infinity()));
}

// Steps after which a settling bed tells how far it is.
inline constexpr int told_after = 100;

template <class Law>
class RunWatch {
 public:
  TimeBudget budget;
  FillingHistory filling;

  // To be made once all walls are there that the bed settles between.
  void begin(dem::Simulation<Law>& bed, const FillScene& fill, bool with_ledger) {
    settling_ = begin_settling(bed, fill);
    if (with_ledger) ledger_.emplace();
  }

  // Lets the bed settle, or what is left of it in a continued run; `pulse` after every step.
  void settle(dem::Simulation<Law>& bed, Recorder& recorder, Progress& progress,
              const Pulse& pulse) {
    budget.enter(TimeBudget::settling);
    double rest = 0;
    const auto tell = [&] {
      progress.report(rest, fmt::format("settling: time {:.2f} s, rest {:.1e}", bed.time(), rest));
    };
    const auto report = [&](double now) {
      filling.record(recorder, bed.time(), bed.stones(), 0);
      rest = now;
      tell();
    };
    apps::settle(bed, settling_, report, [&] {
      look(bed);
      if (bed.steps() % told_after == 0) tell();  // the next report may be minutes away
      pulse();
    });
    budget.enter(TimeBudget::other);
  }

  // After every step.
  void look(const dem::Simulation<Law>& bed) {
    if (ledger_) ledger_->look(bed);
  }

  // The ledger begins anew: what follows has an account of its own.
  void end_settling() {
    if (!ledger_) return;
    settling_residual_ = ledger_->energies().residual_share();
    ledger_->restart();
  }

  void add_to(std::vector<double>& row) const {
    if (ledger_) add_energies(row, ledger_->energies());
  }
  void add_to(std::vector<Finding>& found) const {
    std::ranges::copy(budget.findings(), std::back_inserter(found));
    if (!ledger_) return;
    found.push_back({"settling_energy_residual_share", settling_residual_});
    add_energies(found, ledger_->energies());
  }

  void visit_state(Archive& item) {  // see dem/state.h
    budget.visit_state(item);
    filling.visit_state(item);
    item("settling", settling_);
    item("settling_residual", settling_residual_);
    if (ledger_) ledger_->visit_state(item, "ledger.");
  }

 private:
  Settling settling_;
  std::optional<dem::EnergyLedger<Law>> ledger_;
  double settling_residual_ = 0;  // of the ledger, as a share of the work [-]
};

}  // namespace apps

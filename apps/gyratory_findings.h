// The summary of a gyratory run.
#pragma once

#include "apps/findings.h"
#include "apps/machine.h"
#include "apps/recorder.h"
#include "apps/steel.h"

namespace apps {

// Rows of a history, one value per column (of the first columns).
struct Rows {
  std::vector<Column> columns;
  const std::vector<std::vector<double>>& values;

  double mean(const std::string& column) const;
  double last(const std::string& column) const;

 private:
  std::size_t place(const std::string& column) const;
};

struct GyratoryOutcome {
  BedReport bed;
  Spent spent;
  std::int64_t settled_steps;
  double settled_height;          // [m]
  double head_mass;               // [kg]
  double voids_at_start;          // [-]
  const SteelPart *head, *mould;  // none: rigid
  Rows last_gyrations;
};

std::vector<Finding> gyratory_findings(const GyratoryScene& scene, const Mix& mix,
                                       const Machine& machine, const GyratoryOutcome& outcome);

}  // namespace apps

// What a study found: time and errors of every setting, as a table, as a file, and as advice.
#pragma once

#include <string>
#include <vector>

#include "apps/study.h"
#include "apps/study_errors.h"
#include "apps/study_runs.h"

namespace apps {

class StudyReport {
 public:
  // Reads the results of the runs, which are those of every seed of every setting, in that order.
  StudyReport(const Study& study, const std::vector<StudyRun>& runs);

  std::string table() const;  // Markdown
  // Of every setting with a finished run: /settings/<word>/seconds by seed, and of every quantity
  // error, noise, by_seed, or for a curve its mean; throws OutputError.
  void record(const std::string& path) const;
  // The setting that takes the least time of those whose errors beyond noise are all below.
  std::string cheapest(double tolerance) const;

 private:
  struct Row {
    const Setting* setting;
    std::vector<double> seconds, steps;  // of the runs that finished
    std::vector<Found> found;            // of the same
    std::vector<std::string> trouble;    // of those that did not
    std::vector<Judgement> judgement;    // by quantity
    double mean_seconds() const;
    double worst() const;  // error beyond noise [-]
  };

  const Row& reference() const;
  std::string line(const Row& row) const;
  std::string line_of_means(const Row& row) const;

  const Study& study_;
  Interest interest_;
  std::vector<Row> rows_;
};

}  // namespace apps

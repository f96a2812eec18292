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
  // The seeds asked for, /study/seeds. Of every setting with a finished run: /settings/<word>/seeds, and seconds and steps by
  // seed; of every quantity error, noise, and seed_<n>, its points. Throws OutputError.
  void record(const std::string& path) const;
  // The setting that takes the least time of those whose errors are known wherever the reference's
  // noise is, and below where they are beyond it.
  std::string cheapest(double tolerance) const;

 private:
  struct Row {
    const Setting* setting;
    std::vector<int> seeds;              // of the runs that finished
    std::vector<double> seconds, steps;  // of the same; seconds of a processor
    std::vector<Found> found;            // of the same
    std::vector<std::string> trouble;    // of those that did not
    std::vector<Judgement> judgement;    // by quantity
    double mean_seconds() const;
    double worst() const;  // error beyond noise [-]
  };

  const Row& reference() const;
  bool is_known(const Row& row) const;
  std::string line(const Row& row) const;
  std::string line_of_means(const Row& row) const;

  const Study& study_;
  Interest interest_;
  std::vector<Row> rows_;
  std::size_t of_other_builds_ = 0;  // runs
};

}  // namespace apps

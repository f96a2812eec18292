#include "apps/study_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "apps/recorder.h"

namespace apps {
namespace {

nlohmann::json summary_of(const std::string& folder) {
  std::ifstream file(folder + "/summary.json");
  return nlohmann::json::parse(file);
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::string in_percent(double share) {
  return share < 0.0995 ? fmt::format("{:.1f}", 100 * share) : fmt::format("{:.0f}", 100 * share);
}

std::string percent(double share) {
  return in_percent(share) + " %";
}

// "-3.6 ± 28 %": the error and the noise of the two.
std::string told(const Judgement& j) {
  if (j.none_in > 0) return fmt::format("none in {} runs", j.none_in);
  const char* sign = j.sign < 0 ? "-" : j.sign > 0 ? "+" : "";
  const std::string error =
      fmt::format("{}{} ± {} %", sign, in_percent(j.error), in_percent(j.noise));
  return j.beyond() ? "**" + error + "**" : error;
}

}  // namespace

double StudyReport::Row::mean_seconds() const {
  return mean_of(seconds);
}

double StudyReport::Row::worst() const {
  double worst = 0;
  for (const Judgement& j : judgement)
    if (j.beyond()) worst = std::max(worst, j.error);
  return worst;
}

StudyReport::StudyReport(const Study& study, const std::vector<StudyRun>& runs)
    : study_(study), interest_(interest_of(study.program)) {
  auto next = runs.begin();
  for (const Setting& setting : study.settings) {
    Row row{&setting};
    for (const int seed : study.seeds) {
      const auto run = next++;
      of_other_builds_ += run->other_build;
      if (!run->finished) {
        row.trouble.push_back(run->trouble);
        continue;
      }
      const nlohmann::json summary = summary_of(run->folder);
      row.seeds.push_back(seed);
      row.seconds.push_back(summary.at("processor_seconds"));
      row.steps.push_back(summary.at("steps"));
      row.found.push_back(read_found(run->folder + "/results.h5", interest_));
    }
    rows_.push_back(std::move(row));
  }
  const auto of_quantity = [](const Row& row, std::size_t q) {
    BySeed points;
    for (std::size_t k = 0; k < row.seeds.size(); ++k) points[row.seeds[k]] = row.found[k][q];
    return points;
  };
  for (Row& row : rows_)
    for (std::size_t q = 0; q < interest_.quantities.size(); ++q) {
      const double least = interest_.quantities[q].least_size;
      const BySeed expected = of_quantity(reference(), q);
      row.judgement.push_back(&row == &reference() ? scatter(expected, least)
                                                   : judge(of_quantity(row, q), expected, least));
    }
}

const StudyReport::Row& StudyReport::reference() const {
  return *std::ranges::find_if(
      rows_, [&](const Row& row) { return row.setting->name == study_.reference; });
}

// In every quantity that the reference is known in, of which there are some.
bool StudyReport::is_known(const Row& row) const {
  const std::vector<Judgement>& wanted = reference().judgement;
  bool all = std::ranges::any_of(wanted, &Judgement::known);
  for (std::size_t q = 0; q < wanted.size(); ++q)
    all = all && row.judgement[q].known >= wanted[q].known;
  return all;
}

std::string StudyReport::line(const Row& row) const {
  std::string line = "| " + row.setting->name;
  if (row.seconds.empty()) return line + " | " + row.trouble.front() + " |\n";
  if (!row.trouble.empty())
    line += fmt::format(" ({} of {} runs {})", row.trouble.size(), study_.seeds.size(),
                        row.trouble.front());
  line += " | ";
  const double all = reference().seconds.empty() ? 0 : reference().mean_seconds();
  line += fmt::format("{:.3g} | {:.2g} | {:.2g} | ", row.mean_seconds(), mean_of(row.steps),
                      all / row.mean_seconds());
  for (const Judgement& j : row.judgement) {
    if (!j.known)
      line += "- | ";
    else if (&row == &reference() && j.none_in == 0)
      line += fmt::format("± {} | ", percent(j.noise));
    else
      line += told(j) + " | ";
  }
  return line + "\n";
}

std::string StudyReport::line_of_means(const Row& row) const {
  std::string line = "| its means | | | | ";
  for (std::size_t q = 0; q < interest_.quantities.size(); ++q) {
    double sum = 0;
    bool number = true;
    for (const Found& found : row.found) {
      number &= found[q].size() == 1;
      if (number) sum += found[q].front();
    }
    const auto runs = static_cast<double>(row.found.size());
    line += number ? fmt::format("{:.3g} | ", sum / runs) : " | ";
  }
  return line + "\n";
}

std::string StudyReport::table() const {
  std::string seeds;
  for (const int seed : study_.seeds) seeds += (seeds.empty() ? "" : ", ") + std::to_string(seed);
  std::string text = fmt::format(
      "Errors against `{}`, seeds {}, paired by seed. Behind ± stands the noise: what the mean of "
      "such pairs is off by at most, in 19 of 20 cases, if only chance tells them apart; in the "
      "line of the reference, what two means of seeds of their own would be. Below it stand its "
      "means, angles in degrees, all else in SI units. Errors beyond the noise are bold; the "
      "others are not told from chance, and may be as large as error and noise together. What none "
      "of n runs shows may still happen 3 / n times in a run.\n\n",
      study_.reference, seeds);
  if (of_other_builds_ > 0)
    text +=
        fmt::format("{} of the runs are of another build of the program.\n\n", of_other_builds_);
  text += "| setting | CPU s | steps | times faster |";
  std::string rule = "\n| --- | ---: | ---: | ---: |";
  for (const Quantity& quantity : interest_.quantities) {
    text += ' ' + quantity.name + " |";
    rule += " ---: |";
  }
  text += rule + '\n';
  for (const Row& row : rows_) {
    text += line(row);
    if (&row == &reference() && !row.found.empty()) text += line_of_means(row);
  }
  return text;
}

void StudyReport::record(const std::string& path) const {
  std::filesystem::remove(path);
  Provenance origin;
  origin.program = "trade";
  origin.scene_text = study_.text;
  Recorder recorder(path, origin, {});
  recorder.write("/study/seeds", std::vector<double>(study_.seeds.begin(), study_.seeds.end()),
                 "1");
  for (const Row& row : rows_) {
    if (row.seconds.empty()) continue;
    const std::string in = "/settings/" + row.setting->word + '/';
    recorder.write(in + "seeds", std::vector<double>(row.seeds.begin(), row.seeds.end()), "1");
    recorder.write(in + "seconds", row.seconds, "s");
    recorder.write(in + "steps", row.steps, "1");
    for (std::size_t q = 0; q < interest_.quantities.size(); ++q) {
      const std::string of = in + as_word(interest_.quantities[q].name) + '/';
      const Judgement& j = row.judgement[q];
      if (!j.known) continue;
      recorder.write(of + "error", std::vector{j.error}, "1");
      recorder.write(of + "noise", std::vector{j.noise}, "1");
      for (std::size_t k = 0; k < row.found.size(); ++k)
        recorder.write(of + "seed_" + std::to_string(row.seeds[k]), row.found[k][q],
                       "as history/" + interest_.quantities[q].column);
    }
  }
  recorder.flush();
}

std::string StudyReport::cheapest(double tolerance) const {
  const Row* best = nullptr;
  for (const Row& row : rows_) {
    if (row.seconds.size() < study_.seeds.size()) continue;
    if (!is_known(row) || row.worst() > tolerance) continue;
    if (!best || row.mean_seconds() < best->mean_seconds()) best = &row;
  }
  if (!best)
    return fmt::format(
        "no setting is known to show no error above {}{}", percent(tolerance),
        reference().seconds.size() < 2 ? "; two seeds of the reference must finish" : "");
  std::string text = fmt::format(
      "cheapest that shows no error above {}: {} ({:.3g} s, {:.2g} times faster than {})",
      percent(tolerance), best->setting->name, best->mean_seconds(),
      reference().mean_seconds() / best->mean_seconds(), study_.reference);
  for (std::size_t q = 0; q < interest_.quantities.size(); ++q) {
    const Judgement& j = best->judgement[q];
    if (!j.known || j.noise <= tolerance) continue;
    text += "\n  " + interest_.quantities[q].name + ": ";
    text += j.none_in > 0 ? fmt::format("none in {} runs, there may be {:.2g} in one", j.none_in,
                                        3.0 / j.none_in)
                          : fmt::format("the noise, {}, hides more than that", percent(j.noise));
    text += "; take more seeds";
  }
  return text;
}

}  // namespace apps

// What speed costs in accuracy: runs a scene under several settings and seeds, and tells the time
// and the errors of each.
#include <fmt/format.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <thread>

#include "apps/errors.h"
#include "apps/folder_lock.h"
#include "apps/program.h"
#include "apps/progress.h"
#include "apps/study.h"
#include "apps/study_report.h"
#include "apps/study_runs.h"
#include "apps/text.h"
#include "apps/whole_file.h"

namespace {

struct Options {
  std::string study, out = "study", tolerance;
  std::vector<std::string> overrides;
  int processes = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  bool check = false, quiet = false;
};

// 0.01 or 1%, absent: 0. A number of 1 or more needs its sign: it is hardly meant as a share.
double tolerance_of(const std::string& text) {
  if (text.empty()) return 0;
  char* rest = nullptr;
  const double number = std::strtod(text.c_str(), &rest);
  const std::string unit = rest;
  const bool in_percent = unit == "%" || unit == " %";
  const bool whole = unit.empty() && number >= 1 && std::isfinite(number);
  if (!(number > 0) || !std::isfinite(number) || whole || (!unit.empty() && !in_percent))
    throw apps::InputError(
        {"--tolerance: expected a share above 0, from 1 on with a percent sign, "
         "found \"" +
         text + "\"; write " + (whole ? text + '%' : "it like 1%")});
  return in_percent ? number / 100 : number;
}

std::vector<apps::StudyRun> runs_of(const apps::Study& study, const std::string& out) {
  const std::filesystem::path programs = std::filesystem::canonical("/proc/self/exe").parent_path();
  std::vector<apps::StudyRun> runs;
  for (const apps::Setting& setting : study.settings)
    for (const int seed : study.seeds) {
      apps::StudyRun run;
      run.folder = fmt::format("{}/runs/{}/seed_{}", out, setting.word, seed);
      run.setting = setting.name;
      run.places = setting.places;
      run.command = {programs / study.program, study.scene};
      std::vector<std::string> overrides = setting.overrides;
      overrides.push_back(fmt::format("run.seed={}", seed));
      for (const std::string& key : overrides)
        run.command.insert(run.command.end(), {"--set", key});
      run.asked = study.program + '\n' + apps::all_of_scene(study.scene, overrides);
      runs.push_back(std::move(run));
    }
  return runs;
}

// A folder is that of one study, known by its name.
void claim(const std::string& out, const apps::Study& study) {
  const std::string name = std::filesystem::path(study.path).filename(), file = out + "/study";
  const std::string found = apps::read_text(file).value_or(name);
  if (found != name)
    throw apps::OutputError(out + ": expected a folder without another study, found that of " +
                            found + "; choose another --out");
  apps::write_whole_file(file, name);
}

// Each setting by its first seed: steel takes seconds to prepare.
void foretell(const apps::Study& study, const std::vector<apps::StudyRun>& runs) {
  std::cout << fmt::format("{} settings, {} seeds: {} runs\n", study.settings.size(),
                           study.seeds.size(), runs.size());
  for (std::size_t k = 0; k < runs.size(); k += study.seeds.size()) {
    std::cout << runs[k].setting << ": " << std::flush;
    std::cout << apps::forecast(runs[k]) << std::endl;
  }
}

int trade(const Options& options) {
  const double tolerance = tolerance_of(options.tolerance);
  const apps::Study study = apps::read_study(options.study, options.overrides);
  std::vector<apps::StudyRun> runs = runs_of(study, options.out);
  const std::vector<std::string> objections = apps::objections(runs);
  if (!objections.empty()) throw apps::InputError(objections);
  if (options.check && !options.quiet) foretell(study, runs);
  if (options.check) return apps::ok;
  const apps::FolderLock lock(options.out);
  claim(options.out, study);
  apps::Progress progress(std::cout, isatty(STDOUT_FILENO), options.quiet);
  apps::carry_out(runs, options.processes, [&](std::size_t over) {
    progress.report(static_cast<double>(over) / static_cast<double>(runs.size()),
                    fmt::format("{} of {} runs", over, runs.size()));
  });
  progress.finish();
  const apps::StudyReport report(study, runs);
  apps::write_whole_file(options.out + "/table.md", report.table());
  report.record(options.out + "/study.h5");
  std::cout << report.table();
  if (tolerance > 0) std::cout << '\n' << report.cheapest(tolerance) << '\n';
  const bool any = std::ranges::any_of(runs, &apps::StudyRun::finished);
  return any ? apps::ok : apps::numerical_trouble;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app(
      "Runs a scene under several settings and seeds: time and error of each, against the "
      "reference and the scatter over seeds. Called again it goes on where it was.");
  app.add_option("study", options.study, "study file (TOML)")->required();
  app.add_option("--out", options.out, "folder of the runs, table.md and study.h5");
  app.add_option("--set", options.overrides, "key=value: overrides any key of the study")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--processes", options.processes, "runs at once")->check(CLI::Range(1, 1024));
  app.add_option(
      "--tolerance", options.tolerance,
      "as 1%: name the cheapest setting that shows no error above, and what the noise hides");
  app.add_flag("--check", options.check, "read and check the study, say what its runs will be");
  app.add_flag("--quiet", options.quiet, "print no progress");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? apps::ok : apps::bad_input;
  }
  return apps::exit_status_of([&] { return trade(options); });
}

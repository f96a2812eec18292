// Validates the stresses and displacements of the steel: runs cases with known answers, prints what
// was computed beside what was expected, and fails if a row does.
#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <set>

#include "apps/errors.h"
#include "apps/program.h"
#include "apps/stress_cases.h"

namespace {

constexpr int a_row_fails = 1;

struct Options {
  std::vector<std::string> cases, overrides;
  std::string folder;
  bool all = false, json = false, refined = false, describe = false;
};

std::vector<std::string> shipped_cases() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(WALL_CASES))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
  std::ranges::sort(paths);
  return paths;
}

// The rows of a case against the same on elements half as large: 1 % is what default meshes
// promise, or a tenth of what theory is known to where that is more.
apps::StressReport compare_with_refined(const apps::StressCase& given) {
  apps::StressCase finer = given;
  ++finer.mesh.refinement;
  apps::StressReport report = apps::run_stress_case(given);
  const apps::StressReport converged = apps::run_stress_case(finer);
  for (std::size_t i = 0; i < report.rows.size(); ++i) {
    apps::StressRow& row = report.rows[i];
    row.reference = converged.rows[i].computed;
    row.source = "the same on elements half as large";
    row.tolerance = std::max(0.01, 0.1 * row.tolerance);
    row.measure = std::abs(row.reference);
  }
  return report;
}

// The pictures of a case must not take the place of those of another, nor of a case.
void expect_own_pictures(const std::vector<apps::StressCase>& cases, const Options& options) {
  std::set<std::string> names;
  for (const apps::StressCase& given : cases) {
    if (!names.insert(given.name()).second)
      throw apps::InputError({given.path +
                              ": expected a case of another name than those before it, whose "
                              "pictures it would replace, found " +
                              given.name() + "; rename it, or give it another --out"});
    for (const char* ending : {".vtu", ".csv"})
      apps::expect_another_file(options.folder + '/' + given.name() + ending, options.cases);
  }
}

int validate(const Options& options) {
  omp_set_num_threads(1);  // what the stones of a case need; more only wait for each other
  std::vector<apps::StressCase> cases;
  for (const std::string& path : options.cases)
    cases.push_back(apps::read_stress_case(path, options.overrides));
  if (!options.folder.empty()) {
    expect_own_pictures(cases, options);
    std::error_code error;
    std::filesystem::create_directories(options.folder, error);
    if (error) throw apps::OutputError(options.folder + ": cannot be created: " + error.message());
  }
  std::vector<apps::StressRow> rows;
  bool pass = true;
  for (const apps::StressCase& given : cases) {
    // With stones the mesh is not the question, and what they do is chaos.
    if (options.refined && given.load.kind == "stones") continue;
    const apps::StressReport report =
        options.refined ? compare_with_refined(given) : apps::run_stress_case(given);
    if (!options.json)
      std::cout << apps::as_table(given.name() + " (" + given.load.kind + ")", report.rows)
                << std::endl;
    if (!options.folder.empty()) apps::draw(report, options.folder, given.name());
    rows.insert(rows.end(), report.rows.begin(), report.rows.end());
    pass = pass && report.pass();
  }
  if (rows.empty())
    throw apps::InputError(
        {"--refined: expected a case without stones, found none; with them the "
         "mesh is not the question"});
  if (options.json) std::cout << apps::as_json(rows);
  return pass ? apps::ok : a_row_fails;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app(
      "Validates the stresses of mould and head against known answers; status 1 if a row fails.");
  app.add_option("case", options.cases, "case files (TOML)");
  app.add_flag("--all", options.all, "run every case that comes with the program");
  app.add_flag("--refined", options.refined,
               "compare with elements half as large instead of theory (minutes)");
  app.add_flag("--json", options.json, "print the rows as JSON");
  app.add_flag("--describe", options.describe,
               "print a complete case with the meaning of every key");
  app.add_option(
      "--out", options.folder,
      "folder for pictures: deformed bodies (.vtu), unrolled maps (.csv, see stress_maps.py)");
  app.add_option("--set", options.overrides, "key=value: overrides any key of the cases")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? apps::ok : apps::bad_input;
  }
  if (options.describe) {
    std::cout << apps::stress_case_manual();
    return apps::ok;
  }
  if (options.all == !options.cases.empty()) {
    std::cerr << "expected case files or --all, found " << (options.all ? "both" : "neither")
              << "; give one of the two\n";
    return apps::bad_input;
  }
  return apps::exit_status_of([&] {
    if (options.all) options.cases = shipped_cases();
    return validate(options);
  });
}

// Feeds bytes to each reader of users' files. Any bytes may come: a reader takes them or reports
// mistakes, every one with its place and advice; it never ends otherwise.
#pragma once

#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>

#include "apps/errors.h"
#include "apps/path_case.h"
#include "apps/scene_checks.h"
#include "apps/sections.h"
#include "apps/sieve_table.h"
#include "tests/unit/written_file.h"

namespace tests {

inline constexpr std::string_view fed_sieves = "sieve_mm,passing_percent\n2,25\n8,57.5\n16,100\n";

// One folder for all that is fed, and the tables of units read once, for speed.
struct Place {
  WrittenFiles files;
  apps::UnitSystem units;
};

inline void require(bool promise) {
  if (!promise) std::abort();
}

inline void require_told(const apps::InputError& error) {
  require(!error.mistakes.empty());
  for (const std::string& line : error.mistakes)
    require(line.find(": expected ") != std::string::npos && line.find("; ") != std::string::npos);
}

inline void feed_scene(std::string_view bytes, const Place& place) {
  place.files.write("gradations/sma11.csv", std::string(fed_sieves));
  const std::string path = place.files.write("scene.toml", std::string(bytes));
  try {
    apps::Mistakes mistakes;
    const apps::Document document = apps::read_document(path, {}, mistakes);
    apps::GyratoryScene scene;
    apps::read_sections(apps::describe(scene), document, place.units, mistakes);
    apps::check(scene, document, mistakes);
    if (mistakes.any()) throw apps::InputError(mistakes.lines());
    require(scene.stones.count > 0 && scene.gyration.pressure > 0);
  } catch (const apps::InputError& error) {
    require_told(error);
  }
}

inline void feed_option(std::string_view bytes, const Place& place) {
  place.files.write("gradations/sma11.csv", std::string(fed_sieves));
  const std::string path = place.files.write(
      "scene.toml", "[stones]\ncount = 1\ngradation = \"gradations/sma11.csv\"\n");
  try {
    apps::Mistakes mistakes;
    const apps::Document document = apps::read_document(path, {std::string(bytes)}, mistakes);
    apps::GyratoryScene scene;
    apps::read_sections(apps::describe(scene), document, place.units, mistakes);
    if (mistakes.any()) throw apps::InputError(mistakes.lines());
  } catch (const apps::InputError& error) {
    require_told(error);
  }
}

inline void feed_gradation(std::string_view bytes, const Place& place) {
  const std::string path = place.files.write("sieves.csv", std::string(bytes));
  apps::Mistakes mistakes;
  const dem::SieveTable table = apps::read_sieve_table(path, {"scene.toml", 1, 1}, mistakes);
  require(table.sieve.size() == table.passing.size());
  if (mistakes.any()) return require_told(apps::InputError(mistakes.lines()));
  require(table.sieve.size() >= 2 && table.passing.back() >= 1);
  for (std::size_t k = 1; k < table.sieve.size(); ++k)
    require(table.sieve[k] > table.sieve[k - 1] && table.passing[k] >= table.passing[k - 1]);
}

inline void feed_path(std::string_view bytes, const Place& place) {
  const std::string path = place.files.write("path.csv", std::string(bytes));
  apps::Mistakes mistakes;
  const auto points = apps::read_path(path, {"case.toml", 1, 1}, mistakes);
  if (mistakes.any()) return require_told(apps::InputError(mistakes.lines()));
  require(!points.empty());
  for (std::size_t k = 1; k < points.size(); ++k) require(points[k].time >= points[k - 1].time);
}

}  // namespace tests

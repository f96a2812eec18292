#include "apps/run_folder.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <regex>

#include "apps/errors.h"
#include "apps/text.h"
#include "apps/whole_file.h"

namespace apps {
namespace {

namespace fs = std::filesystem;

bool holds(const fs::path& folder, const char* name) {
  std::error_code error;
  return fs::exists(folder / name, error);
}

// As scene_record.cc begins it; any other is somebody's.
bool holds_scene_of_run(const fs::path& folder) {
  const std::string text = read_text(folder / stored_scene_file).value_or("");
  return text.starts_with("# The complete scene of a run");
}

bool holds_run(const fs::path& folder) {
  return holds_scene_of_run(folder) ||
         std::ranges::any_of(
             std::array{"results.h5", "summary.json", "checkpoint", "checkpoint.older"},
             [&](const char* name) { return holds(folder, name); });
}

// A sieve table does not tell whose it is: one beside a run is the run's, and one that is equal may
// be what a kill left of a beginning.
void expect_nothing_of_others(const fs::path& folder, const StoredScene& scene) {
  const auto refuse = [&](const std::string& name) {
    throw OutputError(folder.string() + ": expected a folder without a " + name +
                      " that is not of a run, found one; choose another --out");
  };
  if (holds(folder, stored_scene_file) && !holds_scene_of_run(folder)) refuse(stored_scene_file);
  if (holds(folder, stored_gradation_file) && !holds_run(folder) &&
      read_text(folder / stored_gradation_file) != scene.gradation)
    refuse(stored_gradation_file);
}

// What else lies in the folder is somebody's. The sieve table goes first: after a kill it must not
// be left without the rest.
void remove_run(const fs::path& folder) {
  std::error_code error;
  fs::remove(folder / stored_gradation_file, error);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (!is_of_run(entry.path().filename())) continue;
    if (!fs::remove(entry.path(), error))
      throw OutputError("cannot remove '" + entry.path().string() + "': " + error.message());
  }
}

}  // namespace

bool is_of_run(const std::string& name) {
  static const std::regex ours(
      R"((results\.h5|summary\.json|scene\.toml|gradation\.csv|checkpoint(\.older)?(\.refused)?)"
      R"(|(stones|head|mould|strip)(_\d{4,}\.vt[pu]|\.pvd))(\.part)?)");
  return std::regex_match(name, ours);
}

RunFolder::RunFolder(const std::string& path, const StoredScene& scene, bool overwrite)
    : path_(path), lock_(path) {
  expect_nothing_of_others(path_, scene);
  if (holds_run(path_)) {
    if (!overwrite)
      throw OutputError(path_ +
                        ": expected a folder without a run, found one; go on with "
                        "--resume " +
                        path_ + ", replace it with --overwrite, or choose another --out");
    remove_run(path_);
  }
  write_whole_file(file(stored_gradation_file), scene.gradation);
  write_whole_file(file(stored_scene_file), scene.text);
}

RunFolder::RunFolder(const std::string& path) : path_(path), lock_(path) {}

}  // namespace apps

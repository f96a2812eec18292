#include "apps/run_folder.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <regex>

#include "apps/errors.h"
#include "apps/whole_file.h"

namespace apps {
namespace {

namespace fs = std::filesystem;

bool holds_run(const fs::path& folder) {
  std::error_code error;
  return std::ranges::any_of(std::array{"results.h5", stored_scene_file, stored_gradation_file,
                                        "summary.json", "checkpoint"},
                             [&](const char* name) { return fs::exists(folder / name, error); });
}

// Only what a run writes; what else lies in the folder is somebody's.
void remove_run(const fs::path& folder) {
  const std::regex ours(
      R"((results\.h5|summary\.json|scene\.toml|gradation\.csv|checkpoint(\.older)?(\.refused)?)"
      R"(|(stones|head|mould|strip)(_\d{4,}\.vt[pu]|\.pvd))(\.part)?)");
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (!std::regex_match(entry.path().filename().string(), ours)) continue;
    if (!fs::remove(entry.path(), error))
      throw OutputError("cannot remove '" + entry.path().string() + "': " + error.message());
  }
}

}  // namespace

RunFolder::RunFolder(const std::string& path, const StoredScene& scene, bool overwrite)
    : path_(path), lock_(path) {
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

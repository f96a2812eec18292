// The folder of a run: claimed by one process at a time, holding the scene that it runs.
//
//   scene.toml, gradation.csv        all of the scene, so that the run can be continued or repeated
//   results.h5, summary.json, *.pvd  what it found
//   checkpoint, checkpoint.older     where it was (checkpoint.h)
//   lock                             held while a process runs here
#pragma once

#include <string>

#include "apps/folder_lock.h"

namespace apps {

// A scene as text, with everything that it refers to.
struct StoredScene {
  std::string text;       // every key of the scene, naming gradation.csv
  std::string gradation;  // the sieve table

  friend bool operator==(const StoredScene&, const StoredScene&) = default;
};

inline constexpr const char* stored_scene_file = "scene.toml";
inline constexpr const char* stored_gradation_file = "gradation.csv";

// Of a file that a run writes, and that goes when the run is replaced.
bool is_of_run(const std::string& name);

class RunFolder {
 public:
  // Begins a run. A folder that holds one already is refused, or emptied of it with `overwrite`;
  // one with a scene or a sieve table of somebody else, in the place of the run's own, is refused.
  // Throws OutputError, as it does where another process runs in the folder.
  RunFolder(const std::string& path, const StoredScene& scene, bool overwrite);
  // Goes on with the run of a folder.
  explicit RunFolder(const std::string& path);

  std::string file(const std::string& name) const { return path_ + '/' + name; }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  FolderLock lock_;
};

}  // namespace apps

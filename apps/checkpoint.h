// The checkpoints of a run: its state on the disk, the newest and the one before, so that at every
// moment, also of a kill or a full disk, a sound one is there once the first was written.
//
// A file is a line that names the format, the length and a checksum (FNV-1a, 64 bits: Fowler, Noll,
// Vo) of what follows: the items of an Archive, among them the scene of the run.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "apps/archive.h"
#include "apps/run_folder.h"

namespace apps {

class Checkpoints {
 public:
  // Those of a run of `scene` in `folder`.
  Checkpoints(std::string folder, StoredScene scene);

  // Puts the archive beside the others, then in the place of the newest. Throws OutputError and
  // keeps those that are there.
  void write(Archive archive) const;

  // The newest that is sound and of this scene; why another was not taken is told, and a damaged
  // one put aside. Throws OutputError if there are checkpoints of another scene only.
  std::optional<Archive> newest(const std::function<void(const std::string&)>& tell) const;

 private:
  Archive read(const std::string& path) const;  // throws Unfit

  std::string folder_;
  StoredScene scene_;
};

}  // namespace apps

// What every program has in common: its command line, its folder of results, how it ends.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/recorder.h"

namespace apps {

struct Options {
  std::string scene;                   // path of the scene file
  std::vector<std::string> overrides;  // key=value
  std::string out;                     // --out: the folder of the results, or the file
  int threads = 0;                     // 0: as many as are worth their waiting, see use_threads
  bool check = false;                  // read and check the scene, run nothing
  bool quiet = false;
  std::string command_line;
};

// Runs `body` with the options of the command line and turns what it throws into messages on
// standard error and an exit status (errors.h; 0 for --help). `purpose` is the line shown by
// --help, `default_out` what --out is without being given.
int run_program(int argc, char** argv, const std::string& purpose, const std::string& default_out,
                const std::function<void(const Options&)>& body);

// Sets the number of threads of a run: as asked for, else one per thousand stones, at most one per
// processor. The results do not depend on it.
void use_threads(const Options& options, int stones);

// Creates the folder of results; it must not hold a run already. Throws OutputError.
void claim_folder(const std::string& folder);

// Where a result comes from, as far as the program itself knows.
Provenance provenance(const std::string& program, const Options& options,
                      const std::string& scene_text, int seed);

}  // namespace apps

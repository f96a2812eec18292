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
  bool resume = false;                 // --resume: go on with the run in the folder `out`
  bool overwrite = false;              // a run that is in the folder may be replaced
  bool check = false;                  // read and check the scene, run nothing
  bool quiet = false;
  std::vector<std::string> command_line;
};

struct Program {
  std::string purpose;      // the line shown by --help
  std::string default_out;  // what --out is without being given
  // Of its scene, for --describe and --schema. A program without them makes no run that takes its
  // time in a folder: it has neither --resume nor --overwrite.
  std::function<std::string()> manual{}, schema{};
};

// Runs `body`, which returns its exit status, and turns what it throws into messages on standard
// error and a status (errors.h).
int exit_status_of(const std::function<int()>& body);

// The same with the options of the command line; 0 for --help.
int run_program(int argc, char** argv, const Program& program,
                const std::function<void(const Options&)>& body);

// Throws InputError where `out` is one of the files that are read.
void expect_another_file(const std::string& out, const std::vector<std::string>& read);

// Sets the number of threads of a run: as asked for, else one per thousand stones, at most one per
// processor. The results do not depend on it. Of several, begins the program anew if they would
// spin for long while they wait for each other.
void use_threads(const Options& options, int stones);

// Goes on as that program with these words; comes back only if that fails.
void become(const std::string& program, const std::vector<std::string>& command_line);

// A run to be resumed that has its summary already; says so.
bool is_finished(const Options& options);

// By which two builds of a program are told apart.
std::string build_of(const std::string& program);

// Where a result comes from, as far as the program itself knows.
Provenance provenance(const std::string& program, const Options& options,
                      const std::string& scene_text, int seed);

}  // namespace apps

// The runs of a study: processes side by side, each in its own folder. Runs that are there already
// are not repeated, interrupted ones go on.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace apps {

struct StudyRun {
  std::string folder;
  std::vector<std::string> command;  // program, scene and --set options

  // Afterwards.
  bool finished = false;
  double seconds = 0;   // of a processor, over all sessions
  std::string trouble;  // why it stopped by itself, as it said
};

// Runs at most `at_once` processes together. `look` is called now and then with the number of runs
// that are over. Throws InputError where a run refuses its scene, OutputError where files make
// trouble, and Stopped, after all runs have left their checkpoints, where it is asked to stop.
void carry_out(std::vector<StudyRun>& runs, int at_once,
               const std::function<void(std::size_t over)>& look);

// What --check of every run says against it, a line each, none twice.
std::vector<std::string> objections(const std::vector<StudyRun>& runs);

}  // namespace apps

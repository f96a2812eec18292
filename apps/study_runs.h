// The runs of a study: processes side by side, each in its own folder. Runs that are there already
// are not repeated, interrupted ones go on, and those that were asked something else, or came to
// grief with another build of the program, are run anew.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "apps/mistakes.h"

namespace apps {

struct StudyRun {
  std::string folder;
  std::vector<std::string> command;  // program, scene and --set options
  std::string asked;                 // program and all of the scene: by this a run is known again
  std::string setting;               // its name
  std::map<std::string, Place> places;  // in the study, of the keys of the --set options

  // Afterwards.
  bool finished = false;
  bool other_build = false;  // of the program made it, or began it
  std::string trouble;       // why it stopped by itself, as it said
};

// Runs at most `at_once` processes together. `look` is called now and then with the number of runs
// that are over. A run that stops in numerical trouble, or refuses its scene on the way, is in
// trouble, and the others go on. Throws OutputError where files make trouble, and Stopped where it
// is asked to stop; both after all runs have left their checkpoints.
void carry_out(std::vector<StudyRun>& runs, int at_once,
               const std::function<void(std::size_t over)>& look);

// A mistake that a program tells of its --set option, with the place of the key in the study.
std::string placed_in_study(const std::string& line, const std::map<std::string, Place>& places);

// What --check of every run says against it, a line each, none twice; with the settings that it is
// about where it is not about all.
std::vector<std::string> objections(const std::vector<StudyRun>& runs);

// What --check of a run says of its steps and of the time that they take.
std::string forecast(const StudyRun& run);

}  // namespace apps

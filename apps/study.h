// A study: one scene under several settings of its keys, each with several seeds.
//
//   [study]                           program, scene, seeds, and the setting that errors count from
//   [base]                            keys of the scene, for all settings
//   [[setting]] name = "..."          keys of the scene, for this one
#pragma once

#include <map>
#include <string>
#include <vector>

#include "apps/mistakes.h"

namespace apps {

struct Setting {
  std::string name;
  std::string word;                     // the name as part of a path
  std::vector<std::string> overrides;   // key=value, those of the base first
  std::map<std::string, Place> places;  // of their keys in the study
};

// All that a run of a scene depends on but its program: sections and keys that are given, one a
// line, and the sieve table.
std::string all_of_scene(const std::string& path, const std::vector<std::string>& overrides);

// A name as part of a path: letters, digits, dots and hyphens, no commas, else underscores.
std::string as_word(const std::string& name);

struct Study {
  std::string path, text;
  std::string program;  // "gyratory" or "flow_test"
  std::string scene;    // path, resolved
  std::vector<int> seeds;
  std::string reference;  // name of a setting
  std::vector<Setting> settings;

  const Setting& reference_setting() const;
};

// Throws InputError with every mistake found; the keys of the scene are for its program to check.
Study read_study(const std::string& path, const std::vector<std::string>& overrides);

}  // namespace apps

// Scenes written for a test, beside a sieve table.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "apps/errors.h"
#include "apps/scene.h"
#include "tests/unit/written_file.h"

namespace tests {

inline constexpr const char* sieves = "sieve_mm,passing_percent\n0.063,10\n2,25\n8,57.5\n16,100\n";

// Three sections that are right; a test adds its own text below line 9.
inline constexpr const char* least =
    "[stones]\n"
    "count = 450\n"
    "gradation = \"sieves.csv\"\n"
    "[binder]\n"
    "content = \"6.6 %\"\n"
    "temperature = \"150 degC\"\n"
    "[mould]\n"
    "diameter = \"50 mm\"\n"
    "\n";

class SceneTest : public testing::Test {
 protected:
  SceneTest() { files_.write("sieves.csv", sieves); }

  apps::GyratoryScene read(const std::string& text, const std::vector<std::string>& options = {}) {
    return apps::read_gyratory_scene(files_.write("scene.toml", text), options);
  }

  std::vector<std::string> mistakes(const std::string& text,
                                    const std::vector<std::string>& options = {}) {
    try {
      read(text, options);
    } catch (const apps::InputError& error) {
      return error.mistakes;
    }
    return {};
  }

  std::string at(const std::string& position) const {
    return files_.path("scene.toml") + ':' + position + ": expected ";
  }

  WrittenFiles files_;
};

}  // namespace tests

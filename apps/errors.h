// The ways a program ends badly, and the exit status each means.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace apps {

// A run that is stopped by a signal ends with 128 + its number.
enum ExitStatus { ok = 0, bad_input = 2, numerical_trouble = 3, output_trouble = 4, stopped = 128 };

// Mistakes of the user, all found at once: one `file:line:column: expected, found, what to do`
// each.
struct InputError : std::runtime_error {
  explicit InputError(std::vector<std::string> lines)
      : std::runtime_error(lines.empty() ? "" : lines.front()), mistakes(std::move(lines)) {}
  std::vector<std::string> mistakes;
};

// The disk is full, a folder cannot be written, a file vanished.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace apps

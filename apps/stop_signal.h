// Asked to stop: SIGINT and SIGTERM are noted, and acted upon between two steps.
#pragma once

#include <stdexcept>

namespace apps {

// Notes the two signals from here on; the third one ends the process at once.
void note_stop_signals();

// The signal that was noted, 0 if none.
int stop_signal();

// A run that was asked to stop and has left its checkpoint.
struct Stopped : std::runtime_error {
  Stopped(int which, const std::string& text) : std::runtime_error(text), signal(which) {}
  int signal;
};

}  // namespace apps

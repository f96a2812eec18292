#include "apps/stop_signal.h"

#include <csignal>

namespace apps {
namespace {

constexpr int patience = 3;  // signals, the last of which ends the process

// A signal handler can reach nothing else.
volatile std::sig_atomic_t noted = 0;
volatile std::sig_atomic_t times = 0;

void note(int signal) {
  noted = signal;
  times = times + 1;
  if (times + 1 >= patience) std::signal(signal, SIG_DFL);
}

}  // namespace

void note_stop_signals() {
  struct sigaction action = {};
  action.sa_handler = note;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

int stop_signal() {
  return noted;
}

}  // namespace apps

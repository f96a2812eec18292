// One run of a program in its folder, begun or continued: its results, its checkpoints, its end.
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/checkpoint.h"
#include "apps/clocks.h"
#include "apps/program.h"
#include "apps/recorder.h"
#include "apps/run_folder.h"

namespace apps {

// To be called after every time step.
using Pulse = std::function<void()>;
// Shows everything that a run must find again, see dem/state.h.
using State = std::function<void(Archive&)>;

class Session {
 public:
  // Throws OutputError where the folder does not allow it.
  Session(const Options& options, const StoredScene& scene, const Provenance& origin,
          std::vector<Column> columns);
  // Tells, after trouble, from where the run can be continued.
  ~Session();

  std::string file(const std::string& name) const { return folder_.file(name); }
  Recorder& recorder() { return *recorder_; }
  Spent spent() const;  // on the run

  // Puts back the state of the checkpoint that the run is continued from, if there is one.
  void restore(const State& state);

  // Flushes the history every few seconds; writes a checkpoint every `interval` [s] of wall time,
  // and when asked to stop, which it then does by throwing Stopped.
  Pulse pulse(State state, double interval);

 private:
  void take(const State& state);  // from the checkpoint; throws OutputError where it does not fit
  void write_checkpoint(const State& state);

  RunFolder folder_;
  Checkpoints checkpoints_;
  std::string build_ = build_of("/proc/self/exe");
  std::optional<Archive> checkpoint_;  // that the run is continued from
  std::optional<Recorder> recorder_;
  int exceptions_ = std::uncaught_exceptions();
  Spent began_;    // what the clocks showed
  Spent earlier_;  // in earlier sessions
};

}  // namespace apps

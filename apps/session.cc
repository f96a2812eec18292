#include "apps/session.h"

#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>

#include "apps/errors.h"
#include "apps/stop_signal.h"

namespace apps {
namespace {

constexpr double flush_interval = 5;  // [s] of wall time

void tell(const std::string& line) {
  std::cerr << line << '\n';
}

// The results of an interrupted run; empty or missing where it was interrupted at its beginning.
bool has_results(const std::string& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error) return false;
  if (size > 0) return true;
  std::filesystem::remove(path, error);
  return false;
}

}  // namespace

Session::Session(const Options& options, const StoredScene& scene, const Provenance& origin,
                 std::vector<Column> columns)
    : folder_(options.resume ? RunFolder(options.out)
                             : RunFolder(options.out, scene, options.overwrite)),
      checkpoints_(options.out, scene),
      began_{wall_clock(), processor_clock()} {
  const std::string results = folder_.file("results.h5");
  std::size_t rows = 0;
  std::string build = build_;
  if (options.resume) checkpoint_ = checkpoints_.newest(tell);
  if (checkpoint_)
    take([&](Archive& item) {
      item("build", build);
      item("rows", rows);
      item("wall_seconds", earlier_.wall);
      item("processor_seconds", earlier_.processor);
    });
  if (build != build_)
    tell(folder_.path() + ": begun by another build of the program; from here on it is this one's");
  if (options.resume && (checkpoint_ || has_results(results)))
    recorder_.emplace(results, std::move(columns), rows);
  else
    recorder_.emplace(results, origin, std::move(columns));
  note_stop_signals();
}

Session::~Session() {
  std::error_code error;
  if (std::uncaught_exceptions() > exceptions_ &&
      std::filesystem::exists(folder_.file("checkpoint"), error))
    tell(folder_.path() + ": kept up to its last checkpoint; go on from there with --resume " +
         folder_.path());
  if (recorder_->replaced() > 0)
    tell(folder_.path() + ": " + std::to_string(recorder_->replaced()) +
         " rows of the history were not what the run had found before it was interrupted; bits are "
         "the same only for the same program, libraries and processor");
}

Spent Session::spent() const {
  return {earlier_.wall + wall_clock() - began_.wall,
          earlier_.processor + processor_clock() - began_.processor};
}

void Session::restore(const State& state) {
  if (!checkpoint_) return;
  take(state);
  checkpoint_.reset();
}

void Session::take(const State& state) {
  try {
    state(*checkpoint_);
  } catch (const Unfit& reason) {
    throw OutputError(folder_.path() + ": its checkpoint is of another program: " + reason.what());
  }
}

void Session::write_checkpoint(const State& state) {
  recorder_->flush();  // first, so that the history has no fewer rows than the checkpoint says
  Archive archive;
  std::size_t rows = recorder_->rows();
  Spent until_now = spent();
  archive("build", build_);
  archive("rows", rows);
  archive("wall_seconds", until_now.wall);
  archive("processor_seconds", until_now.processor);
  state(archive);
  checkpoints_.write(std::move(archive));
}

Pulse Session::pulse(State state, double interval) {
  struct Due {
    double flush, checkpoint;  // on the wall clock [s]
  };
  const double now = wall_clock();
  return [this, state = std::move(state), interval,
          due = Due{now + flush_interval, now + interval}]() mutable {
    const int signal = stop_signal();
    const double clock = wall_clock();
    if (signal != 0 || clock > due.checkpoint) {
      write_checkpoint(state);
      due.checkpoint = wall_clock() + interval;
    }
    if (signal != 0) throw Stopped(signal, "stopped by signal " + std::to_string(signal));
    if (clock > due.flush) {
      recorder_->flush();
      due.flush = wall_clock() + flush_interval;
    }
  };
}

}  // namespace apps

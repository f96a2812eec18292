#include "apps/study_runs.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <thread>

#include "apps/errors.h"
#include "apps/program.h"
#include "apps/stop_signal.h"
#include "apps/text.h"
#include "apps/whole_file.h"

namespace apps {
namespace {

namespace fs = std::filesystem;

// With that of the program which it hands elastic steel on to.
std::string whole_build_of(const std::string& program) {
  return build_of(program) + ' ' + build_of(program + "_elastic");
}

// Starts a process whose words on both channels go to a file.
pid_t start(const std::vector<std::string>& words, const std::string& log) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t process = -1;
  const int error = posix_spawn(&process, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw OutputError(words[0] + ": cannot be run");
  return process;
}

// The files by which a study knows a run again, beside the folder that the run itself owns.
struct Traces {
  explicit Traces(const std::string& folder)
      : asked(folder + ".asked"),
        build(folder + ".build"),
        stopped(folder + ".stopped"),
        log(folder + ".log"),
        scene(folder + "/scene.toml"),
        summary(folder + "/summary.json") {}
  std::string asked, build, stopped, log;
  std::string scene, summary;  // of the run: begun, finished

  void forget() const {
    for (const std::string& file : {asked, build, stopped, scene, summary}) fs::remove(file);
  }
};

std::string last_line(const std::string& log) {
  const std::string text = trimmed(read_text(log).value_or(""));
  return text.substr(text.rfind('\n') + 1);
}

struct Answer {
  bool accepted = false;
  std::vector<std::string> lines;
};

Answer checked(const StudyRun& run, const std::vector<std::string>& options) {
  const std::string log =
      fs::temp_directory_path() / ("trade_check_" + std::to_string(getpid()) + ".log");
  std::vector<std::string> words = run.command;
  words.insert(words.end(), options.begin(), options.end());
  int status = 0;
  waitpid(start(words, log), &status, 0);
  Answer answer = {WIFEXITED(status) && WEXITSTATUS(status) == ok, {}};
  std::istringstream text(read_text(log).value_or(""));
  for (std::string line; std::getline(text, line);) answer.lines.push_back(line);
  fs::remove(log);
  return answer;
}

class Fleet {
 public:
  explicit Fleet(std::vector<StudyRun>& runs) : runs_(runs) {}
  // Only where something was thrown are there some left.
  ~Fleet() {
    if (!told_) tell_to_stop();
    for (const auto& [process, run] : afloat_) waitpid(process, nullptr, 0);
  }

  // False if the run is over already.
  bool launch(std::size_t k) {
    StudyRun& run = runs_[k];
    const Traces traces(run.folder);
    const std::string build = whole_build_of(run.command[0]);
    const auto of_other_build = [&] { return read_text(traces.build).value_or(build) != build; };
    const bool stopped_by_other = fs::exists(traces.stopped) && of_other_build();
    if (read_text(traces.asked) != run.asked || stopped_by_other) traces.forget();
    run.other_build = of_other_build();
    run.finished = fs::exists(traces.summary);
    if (const auto trouble = read_text(traces.stopped))
      run.trouble = placed_in_study(trimmed(*trouble), run.places);
    if (run.finished || !run.trouble.empty()) return false;
    const bool begun = fs::exists(traces.asked) && fs::exists(traces.scene);
    std::vector<std::string> words = run.command;
    fs::create_directories(fs::path(run.folder).parent_path());
    if (begun) {
      words = {run.command[0], "--resume", run.folder};
    } else {
      words.insert(words.end(), {"--out", run.folder, "--overwrite"});
      write_whole_file(traces.build, build);
      write_whole_file(traces.asked, run.asked);
    }
    words.insert(words.end(), {"--threads", "1", "--quiet"});
    afloat_[start(words, traces.log)] = k;
    return true;
  }

  // Takes in one process that has ended, if there is one.
  bool land() {
    int status = 0;
    const pid_t process = waitpid(-1, &status, WNOHANG);
    const auto found = afloat_.find(process);
    if (process <= 0 || found == afloat_.end()) return false;
    StudyRun& run = runs_[found->second];
    afloat_.erase(found);
    const Traces traces(run.folder);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : stopped + WTERMSIG(status);
    run.finished = code == ok;
    if (code == numerical_trouble || code == bad_input) {
      const std::string trouble = last_line(traces.log);
      run.trouble = placed_in_study(trouble, run.places);
      write_whole_file(traces.stopped, trouble);
    } else if (code != ok && !told_ && !(stop_signal() && code >= stopped)) {
      trouble_ = run.folder + ": " + last_line(traces.log) + " (status " + std::to_string(code) +
                 "; all of it in " + traces.log + ')';
    }
    return true;
  }

  void tell_to_stop() {
    told_ = true;
    for (const auto& [process, run] : afloat_) kill(process, SIGTERM);
  }

  std::size_t size() const { return afloat_.size(); }
  const std::string& trouble() const { return trouble_; }

 private:
  std::vector<StudyRun>& runs_;
  std::map<pid_t, std::size_t> afloat_;
  std::string trouble_;  // of files, or a crash
  bool told_ = false;    // to stop
};

}  // namespace

void carry_out(std::vector<StudyRun>& runs, int at_once,
               const std::function<void(std::size_t over)>& look) {
  note_stop_signals();
  Fleet fleet(runs);
  std::size_t next = 0, over = 0;
  bool told = false;
  while (fleet.size() > 0 || (next < runs.size() && !told)) {
    while (!told && next < runs.size() && fleet.size() < static_cast<std::size_t>(at_once))
      if (!fleet.launch(next++)) ++over;
    if (fleet.land())
      ++over;
    else
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    look(over);
    if (!told && (stop_signal() || !fleet.trouble().empty())) {
      fleet.tell_to_stop();
      told = true;
    }
  }
  if (!fleet.trouble().empty()) throw OutputError(fleet.trouble());
  if (stop_signal())
    throw Stopped(stop_signal(), "stopped; the same command goes on where the runs were");
}

std::string placed_in_study(const std::string& line, const std::map<std::string, Place>& places) {
  const std::string option = "--set ";
  const auto end = line.find(": ");
  if (!line.starts_with(option) || end == std::string::npos) return line;
  const auto found = places.find(line.substr(option.size(), end - option.size()));
  return found == places.end() ? line : found->second.text() + line.substr(end);
}

std::vector<std::string> objections(const std::vector<StudyRun>& runs) {
  std::vector<std::string> lines;
  std::map<std::string, std::set<std::string>> settings;  // by line
  std::set<std::string> all;
  for (const StudyRun& run : runs) {
    all.insert(run.setting);
    const Answer answer = checked(run, {"--check", "--quiet"});
    if (answer.accepted) continue;
    for (const std::string& told : answer.lines) {
      const std::string line = placed_in_study(told, run.places);
      if (!settings.contains(line)) lines.push_back(line);
      settings[line].insert(run.setting);
    }
  }
  for (std::string& line : lines) {
    const std::set<std::string>& of = settings.at(line);
    if (of.size() == all.size()) continue;
    std::string names;
    for (const std::string& name : of) names += (names.empty() ? "" : ", ") + name;
    line += " (setting " + names + ')';
  }
  return lines;
}

std::string forecast(const StudyRun& run) {
  std::string told;
  for (const std::string& line : checked(run, {"--check", "--threads", "1"}).lines)
    for (const std::string name : {"steps ", "time to take "})
      if (line.starts_with(name))
        told += (told.empty() ? "" : ", ") + name + trimmed(line.substr(name.size()));
  return told;
}

}  // namespace apps

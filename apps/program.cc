#include "apps/program.h"

#include <omp.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>

#include "apps/document.h"
#include "apps/errors.h"
#include "apps/run_folder.h"
#include "apps/stop_signal.h"
#include "apps/text.h"
#include "dem/trouble.h"

namespace apps {

namespace {

// Asked for a text about scenes instead of a run.
struct Answer {
  std::string text;
};

void add_run_options(CLI::App& app, Options& options, const Program& program) {
  app.add_flag("--overwrite", options.overwrite, "replace the run that is in the folder");
  auto* resume = app.add_option_function<std::string>(
      "--resume",
      [&options](const std::string& folder) {
        options.resume = true;
        options.out = folder;
        options.scene = folder + '/' + stored_scene_file;
      },
      "go on with the run in this folder");
  resume->type_name("DIR");
  for (const char* other : {"scene", "--out", "--set", "--overwrite"}) resume->excludes(other);
  const auto answer = [&app](const char* name, const auto& text, const char* meaning) {
    app.add_flag_callback(
        name, [&text] { throw Answer{text()}; }, meaning);
  };
  answer("--describe", program.manual, "print a complete scene with the meaning of every key");
  answer("--schema", program.schema, "print a JSON Schema of scenes, for editors");
}

void add_options(CLI::App& app, Options& options, const Program& program) {
  app.add_option("scene", options.scene, "scene file (TOML)");
  app.add_option("--out", options.out, "where the results go")->default_val(program.default_out);
  app.add_option("--set", options.overrides, "key=value: overrides any key of the scene")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  app.add_option("--threads", options.threads, "threads of the run")->check(CLI::Range(1, 1024));
  app.add_flag("--check", options.check, "read and check the scene, say what the run will be");
  app.add_flag("--quiet", options.quiet, "print no progress");
  if (program.manual) add_run_options(app, options, program);
}

}  // namespace

int exit_status_of(const std::function<int()>& body) {
  try {
    return body();
  } catch (const InputError& error) {
    for (const std::string& line : error.mistakes) std::cerr << line << '\n';
    return bad_input;
  } catch (const dem::NumericalTrouble& trouble) {
    std::cerr << "stopped: stone " << trouble.stone << ", time " << trouble.time
              << " s: " << trouble.what() << " = " << trouble.value << '\n';
    return numerical_trouble;
  } catch (const NotANumber& trouble) {
    std::cerr << "stopped: " << trouble.what() << '\n';
    return numerical_trouble;
  } catch (const OutputError& error) {
    std::cerr << error.what() << '\n';
    return output_trouble;
  } catch (const std::filesystem::filesystem_error& error) {
    std::cerr << error.what() << '\n';
    return output_trouble;
  } catch (const Stopped& stop) {
    std::cerr << stop.what() << '\n';
    return stopped + stop.signal;
  } catch (const std::exception& error) {  // of the libraries: out of memory, a singular matrix
    std::cerr << "stopped: " << error.what() << '\n';
    return numerical_trouble;
  }
}

namespace {

bool same_place(const std::filesystem::path& one, const std::filesystem::path& other) {
  std::error_code error;
  return std::filesystem::equivalent(one, other, error);
}

// The files that the scene, or the case, is read from. What is wrong with them its program tells. A
// pipe can be read but once, and is left to it.
std::vector<std::string> sources_of(const Options& options) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(options.scene, error)) return {options.scene};
  Mistakes told_by_its_program;
  const Document document = read_document(options.scene, options.overrides, told_by_its_program);
  std::vector<std::string> files = document.files;
  for (const char* key : {"stones.gradation", "path.file"}) {
    const Value* value = document.find(key);
    const std::string* table = value ? std::get_if<std::string>(&value->content) : nullptr;
    if (table) files.push_back(document.path_from(key, *table));
  }
  return files;
}

// What a program writes must not take the place of what it reads.
void expect_another_place(const Options& options) {
  if (options.check || options.resume) return;
  const std::vector<std::string> sources = sources_of(options);
  expect_another_file(options.out, sources);
  for (const std::string& source : sources) {
    const std::filesystem::path file = std::filesystem::absolute(source);
    if (same_place(file.parent_path(), options.out) && is_of_run(file.filename()))
      throw InputError({"--out: expected a folder without " + source +
                        ", which is read and whose name is that of a run's own, found " +
                        options.out + "; choose another folder"});
  }
}

}  // namespace

void expect_another_file(const std::string& out, const std::vector<std::string>& read) {
  if (std::ranges::any_of(read, [&](const std::string& file) { return same_place(file, out); }))
    throw InputError({"--out: expected another file than those that are read, found " + out +
                      "; choose another name"});
}

int run_program(int argc, char** argv, const Program& program,
                const std::function<void(const Options&)>& body) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is trouble with files like others
  Options options;
  options.command_line.assign(argv, argv + argc);
  CLI::App app(program.purpose);
  add_options(app, options, program);
  try {
    app.parse(argc, argv);
    if (options.scene.empty()) throw CLI::RequiredError("scene");
  } catch (const Answer& answer) {
    std::cout << answer.text;
    return ok;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ok : bad_input;
  }
  return exit_status_of([&] {
    expect_another_place(options);
    body(options);
    return static_cast<int>(ok);
  });
}

namespace {

// GNU OpenMP's threads spin for milliseconds before they sleep: beside other work, on the processor
// that the other thread waits for. It takes a number of rounds from the environment, once, before
// main.
void spin_briefly(const std::vector<std::string>& command_line) {
  if (std::getenv("GOMP_SPINCOUNT") || std::getenv("OMP_WAIT_POLICY")) return;
  setenv("GOMP_SPINCOUNT", "1000", 0);  // measured in tests/speed/README.md
  std::error_code error;
  become(std::filesystem::read_symlink("/proc/self/exe", error), command_line);
}

}  // namespace

void use_threads(const Options& options, int stones) {
  const int worthwhile = std::clamp(stones / 1000, 1, omp_get_num_procs());
  const int threads = options.threads > 0 ? options.threads : worthwhile;
  if (threads > 1) spin_briefly(options.command_line);
  omp_set_num_threads(threads);
}

void become(const std::string& program, const std::vector<std::string>& command_line) {
  std::vector<char*> words;
  for (const std::string& word : command_line) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execv(program.c_str(), words.data());
}

bool is_finished(const Options& options) {
  std::error_code error;
  if (!options.resume || !std::filesystem::exists(options.out + "/summary.json", error))
    return false;
  if (!options.quiet) std::cout << options.out << ": this run is finished (summary.json)\n";
  return true;
}

std::string build_of(const std::string& program) {
  return std::to_string(std::hash<std::string>()(read_text(program).value_or("")));
}

Provenance provenance(const std::string& program, const Options& options,
                      const std::string& scene_text, int seed) {
  Provenance origin;
  origin.program = program;
  origin.version = GYRATORY_VERSION;
  origin.compiler = GYRATORY_COMPILER;
  origin.flags = GYRATORY_FLAGS;
  char host[256] = {};
  if (gethostname(host, sizeof host - 1) == 0) origin.host = host;
  for (const std::string& word : options.command_line)
    origin.command_line += (origin.command_line.empty() ? "" : " ") + word;
  origin.scene_text = scene_text;
  for (const std::string& line : options.overrides) origin.overrides += line + '\n';
  origin.seed = seed;
  origin.threads = omp_get_max_threads();
  return origin;
}

}  // namespace apps

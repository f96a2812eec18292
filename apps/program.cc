#include "apps/program.h"

#include <omp.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "apps/errors.h"
#include "dem/trouble.h"

namespace apps {

int run_program(int argc, char** argv, const std::string& purpose, const std::string& default_out,
                const std::function<void(const Options&)>& body) {
  Options options;
  for (int k = 0; k < argc; ++k) options.command_line += (k ? " " : "") + std::string(argv[k]);
  CLI::App app(purpose);
  app.add_option("scene", options.scene, "scene file (TOML)")->required();
  app.add_option("--out", options.out, "where the results go")->default_val(default_out);
  app.add_option("--set", options.overrides, "key=value: overrides any key of the scene")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  app.add_option("--threads", options.threads, "threads of the run")->check(CLI::Range(1, 1024));
  app.add_flag("--check", options.check, "read and check the scene, then stop");
  app.add_flag("--quiet", options.quiet, "print no progress");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ok : bad_input;
  }
  try {
    body(options);
    return ok;
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
  }
}

void use_threads(const Options& options, int stones) {
  const int worthwhile = std::clamp(stones / 1000, 1, omp_get_num_procs());
  omp_set_num_threads(options.threads > 0 ? options.threads : worthwhile);
}

void claim_folder(const std::string& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::exists(fs::path(folder) / "results.h5", error))
    throw OutputError(folder +
                      ": expected a folder without results, found results.h5; "
                      "choose another --out or move the old run away");
  fs::create_directories(folder, error);
  if (error) throw OutputError(folder + ": cannot be created: " + error.message());
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
  origin.command_line = options.command_line;
  origin.scene_text = scene_text;
  for (const std::string& line : options.overrides) origin.overrides += line + '\n';
  origin.seed = seed;
  origin.threads = omp_get_max_threads();
  return origin;
}

}  // namespace apps

// The main job: gyratory compaction of a mix, coupled with the elastic steel that the scene names.
#include <unistd.h>

#include <iostream>

#include "apps/gyratory_run.h"
#include "apps/program.h"

namespace {

void compact(const apps::Options& options) {
  const apps::GyratoryScene scene = apps::read_gyratory_scene(options.scene, options.overrides);
  const apps::Mix mix = apps::prepare_mix(scene.stones, scene.binder, scene.run.seed);
  const apps::Machine machine = apps::size_machine(scene, mix);
  const apps::LawBook book(scene.stones, scene.binder, mix);
  book.check(scene.source);
  if (options.check) return;

  apps::use_threads(options, scene.stones.count);
  const double began = apps::wall_clock();
  apps::claim_folder(options.out);
  apps::with_law(book, [&]<class Law>() {
    std::vector<apps::Column> columns = apps::GyratoryRun<Law>::columns();
    std::ranges::copy(apps::WallOutputs::columns(scene), std::back_inserter(columns));
    apps::Recorder recorder(
        options.out + "/results.h5",
        apps::provenance("gyratory", options, scene.source.text, scene.run.seed), columns);
    apps::Progress progress(std::cout, isatty(STDOUT_FILENO), options.quiet);
    apps::GyratoryRun<Law> run(scene, mix, book, machine);
    run.fill(progress);
    progress.finish();
    run.close();
    recorder.write("/mould/diameter", std::array{2 * machine.mould_radius}, "m");
    recorder.write("/stones/radius", mix.radius, "m");
    apps::Progress compaction(std::cout, isatty(STDOUT_FILENO), options.quiet);
    apps::GyratoryPictures pictures(options.out);
    run.compact(recorder, pictures, compaction);
    apps::write_summary(options.out + "/summary.json", run.findings(apps::wall_clock() - began));
  });
}

}  // namespace

int main(int argc, char** argv) {
  return apps::run_program(argc, argv,
                           "Gyratory compaction of hot asphalt mix in a steel mould (DEM + FE).",
                           "run", compact);
}

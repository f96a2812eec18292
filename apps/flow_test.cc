// The compaction flow test in a rigid box: DEM only.
#include <unistd.h>

#include <iostream>

#include "apps/flow_box.h"
#include "apps/flow_run.h"
#include "apps/program.h"

namespace {

void press(const apps::Options& options) {
  const apps::FlowTestScene scene = apps::read_flow_scene(options.scene, options.overrides);
  const apps::Mix mix = apps::prepare_mix(scene.stones, scene.binder, scene.run.seed);
  const apps::LawBook book(scene.stones, scene.binder, mix);
  book.check(scene.source);
  apps::check_box(scene, mix);
  if (options.check) return;

  apps::use_threads(options, scene.stones.count);
  const double began = apps::wall_clock();
  apps::claim_folder(options.out);
  apps::with_law(book, [&]<class Law>() {
    apps::Recorder recorder(
        options.out + "/results.h5",
        apps::provenance("flow_test", options, scene.source.text, scene.run.seed),
        apps::FlowRun<Law>::columns(scene));
    apps::Progress progress(std::cout, isatty(STDOUT_FILENO), options.quiet);
    apps::FlowRun<Law> run(scene, mix, book);
    run.fill(progress);
    progress.finish();
    recorder.write("/stones/radius", mix.radius, "m");
    apps::Progress pressing(std::cout, isatty(STDOUT_FILENO), options.quiet);
    run.press(recorder, options.out, pressing);
    apps::write_summary(options.out + "/summary.json", run.findings(apps::wall_clock() - began));
  });
}

}  // namespace

int main(int argc, char** argv) {
  return apps::run_program(argc, argv, "Compaction flow test of hot asphalt mix in a rigid box.",
                           "run", press);
}

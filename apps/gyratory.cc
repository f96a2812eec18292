// The main job: gyratory compaction of a mix, coupled with the elastic steel that the scene names.
#include <unistd.h>

#include <iostream>

#include "apps/gyratory_run.h"
#include "apps/program.h"
#include "apps/scene_manual.h"
#include "apps/scene_record.h"

namespace {

void compact(const apps::Options& options) {
  const apps::GyratoryScene scene = apps::read_gyratory_scene(options.scene, options.overrides);
  const apps::Mix mix = apps::prepare_mix(scene.stones, scene.binder, scene.run.seed);
  const apps::Machine machine = apps::size_machine(scene, mix);
  const apps::LawBook book(scene.stones, scene.binder, mix);
  book.check(scene.source);
  if (options.check) return;
  if (apps::is_finished(options)) return;

  apps::use_threads(options, scene.stones.count);
  apps::with_law(book, [&]<class Law>() {
    apps::Session session(options, apps::stored_scene(scene, options),
                          apps::provenance("gyratory", options, scene.source.text, scene.run.seed),
                          apps::GyratoryRun<Law>::columns());
    apps::GyratoryRun<Law> run(scene, mix, book, machine);
    apps::GyratoryPictures pictures(options.out);
    const apps::State state = [&](apps::Archive& item) {
      run.visit_state(item);
      pictures.visit_state(item);
    };
    session.restore(state);
    const apps::Pulse pulse = session.pulse(state, scene.output.checkpoint_interval);

    apps::Progress settling(std::cout, isatty(STDOUT_FILENO), options.quiet);
    run.fill(settling, pulse);
    settling.finish();
    run.close();
    session.recorder().write("/mould/diameter", std::array{2 * machine.mould_radius}, "m");
    session.recorder().write("/stones/radius", mix.radius, "m");
    apps::Progress compaction(std::cout, isatty(STDOUT_FILENO), options.quiet);
    run.compact(session.recorder(), pictures, compaction, pulse);
    apps::write_summary(session.file("summary.json"), run.findings(session.wall_seconds()));
  });
}

}  // namespace

int main(int argc, char** argv) {
  const apps::Program program = {
      "Gyratory compaction of hot asphalt mix in a steel mould (DEM + FE).", "run",
      apps::gyratory_scene_manual, apps::gyratory_scene_schema};
  return apps::run_program(argc, argv, program, compact);
}

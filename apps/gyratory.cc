// The main job: gyratory compaction of a mix, coupled with the elastic steel that the scene names.
#include <unistd.h>

#include <iostream>

#include "apps/fidelity.h"
#include "apps/gyratory_forecast.h"
#include "apps/gyratory_run.h"
#include "apps/inertia_price.h"
#include "apps/program.h"
#include "apps/scene_manual.h"
#include "apps/scene_record.h"
#include "apps/steel.h"

namespace {

void foretell(const apps::GyratoryScene& scene, const apps::Mix& mix, const apps::Machine& machine,
              const apps::LawBook& book) {
  const apps::BedPlan plan = {scene.stones,   scene.binder,
                              scene.fill,     scene.numerics,
                              scene.run.seed, dem::RoundMould{machine.mould_radius}};
  const apps::Loading loading = apps::gyratory_loading(scene, machine);
  const apps::SteelForecast steel = apps::steel_forecast(scene, machine);
  for (const std::string& line : apps::mould_lines(machine, scene.stones.count))
    std::cout << line << '\n';
  apps::with_law(book, [&]<class Law>() {
    apps::BedForecast told = apps::forecast_bed<Law>(plan, mix, book, loading);
    told.steel_seconds = steel.seconds;
    told.steel_seconds_per_step = steel.seconds_per_step;
    for (const std::string& line : apps::forecast_lines(told, scene.numerics))
      std::cout << line << '\n';
    std::cout << apps::inertia_line(told.inertial_number) << '\n';
    for (const std::string& line : apps::steel_lines(steel, scene, told.loaded_step))
      std::cout << line << '\n';
  });
}

void compact(const apps::Options& options) {
  const apps::GyratoryScene asked = apps::read_gyratory_scene(options.scene, options.overrides);
  apps::use_program_of(asked, options.command_line);
  const apps::GyratoryScene scene = apps::compressed(asked);
  const apps::Mix mix = apps::prepare_mix(scene.stones, scene.binder, scene.run.seed);
  const apps::Machine machine = apps::size_machine(scene, mix);
  const apps::LawBook book(scene.stones, scene.binder, mix);
  book.check(scene.source);
  if (options.check && options.quiet) return;
  apps::use_threads(options, scene.stones.count);
  if (options.check) return foretell(scene, mix, machine, book);
  if (apps::is_finished(options)) return;

  apps::with_law(book, [&]<class Law>() {
    apps::Session session(options, apps::stored_scene(asked, options),
                          apps::provenance("gyratory", options, scene.source.text, scene.run.seed),
                          apps::GyratoryHistory::columns(scene));
    apps::GyratoryRun<Law> run(scene, mix, book, machine);
    apps::GyratoryPictures pictures(options.out);
    const apps::State state = [&](apps::Archive& item) {
      run.visit_state(item);
      pictures.visit_state(item);
    };
    session.restore(state);
    const apps::Pulse pulse = session.pulse(state, scene.output.checkpoint_interval);

    apps::Progress settling(std::cout, isatty(STDOUT_FILENO), options.quiet);
    session.recorder().write("/mould/diameter", std::array{2 * machine.mould_radius}, "m");
    session.recorder().write("/stones/radius", mix.radius, "m");
    session.recorder().write("/stones/shell_thickness", std::array{mix.shell}, "m");
    run.fill(session.recorder(), settling, pulse);
    settling.finish();
    run.close();
    apps::Progress compaction(std::cout, isatty(STDOUT_FILENO), options.quiet);
    run.compact(session.recorder(), pictures, compaction, pulse);
    apps::write_summary(session.file("summary.json"), run.findings(session.spent()));
  });
}

}  // namespace

int main(int argc, char** argv) {
  const apps::Program program = {
      "Gyratory compaction of hot asphalt mix in a steel mould (DEM + FE).", "run",
      apps::gyratory_scene_manual, apps::gyratory_scene_schema};
  return apps::run_program(argc, argv, program, compact);
}

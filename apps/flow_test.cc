// The compaction flow test in a rigid box: DEM only.
#include <unistd.h>

#include <iostream>

#include "apps/fidelity.h"
#include "apps/flow_box.h"
#include "apps/flow_run.h"
#include "apps/forecast.h"
#include "apps/program.h"
#include "apps/scene_manual.h"
#include "apps/scene_record.h"

namespace {

void foretell(const apps::FlowTestScene& scene, const apps::Mix& mix, const apps::LawBook& book) {
  constexpr double usual_pressure = 100e3;  // under the strip, a guess: deep in a box it is tenfold
  const apps::FlowScene& flow = scene.flow;
  const apps::BedPlan plan = {scene.stones,   scene.binder,
                              scene.fill,     scene.numerics,
                              scene.run.seed, dem::RectangularMould{flow.length, flow.width}};
  constexpr double quasi_static = 7e-4;  // measured, trade.md: coordination is 5 % off at 1e-3
  const apps::Loading loading = {usual_pressure,
                                 flow.speed / flow.strip_length,
                                 flow.displacement / flow.speed,
                                 std::min(flow.length, flow.width),
                                 quasi_static,
                                 "box",
                                 "lower flow.speed"};
  apps::with_law(book, [&]<class Law>() {
    const apps::BedForecast told = apps::forecast_bed<Law>(plan, mix, book, loading);
    for (const std::string& line : apps::forecast_lines(told, scene.numerics))
      std::cout << line << '\n';
  });
}

void press(const apps::Options& options) {
  const apps::FlowTestScene asked = apps::read_flow_scene(options.scene, options.overrides);
  const apps::FlowTestScene scene = apps::compressed(asked);
  const apps::Mix mix = apps::prepare_mix(scene.stones, scene.binder, scene.run.seed);
  const apps::LawBook book(scene.stones, scene.binder, mix);
  book.check(scene.source);
  apps::check_box(scene, mix);
  if (options.check && options.quiet) return;
  apps::use_threads(options, scene.stones.count);
  if (options.check) return foretell(scene, mix, book);
  if (apps::is_finished(options)) return;

  apps::with_law(book, [&]<class Law>() {
    apps::Session session(options, apps::stored_scene(asked, options),
                          apps::provenance("flow_test", options, scene.source.text, scene.run.seed),
                          apps::FlowRun<Law>::columns(scene));
    apps::FlowRun<Law> run(scene, mix, book, options.out);
    const apps::State state = [&](apps::Archive& item) { run.visit_state(item); };
    session.restore(state);
    const apps::Pulse pulse = session.pulse(state, scene.output.checkpoint_interval);

    apps::Progress settling(std::cout, isatty(STDOUT_FILENO), options.quiet);
    session.recorder().write("/stones/radius", mix.radius, "m");
    session.recorder().write("/stones/shell_thickness", std::array{mix.shell}, "m");
    session.recorder().write(
        "/box/size", std::array{scene.flow.length, scene.flow.width, scene.flow.height}, "m");
    run.fill(session.recorder(), settling, pulse);
    settling.finish();
    apps::Progress pressing(std::cout, isatty(STDOUT_FILENO), options.quiet);
    run.press(session.recorder(), pressing, pulse);
    apps::write_summary(session.file("summary.json"), run.findings(session.spent()));
  });
}

}  // namespace

int main(int argc, char** argv) {
  const apps::Program program = {"Compaction flow test of hot asphalt mix in a rigid box.", "run",
                                 apps::flow_scene_manual, apps::flow_scene_schema};
  return apps::run_program(argc, argv, program, press);
}

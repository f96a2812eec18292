#include "apps/fidelity.h"

namespace apps {
namespace {

void take_fidelity(const std::string& fidelity, NumericsScene& numerics) {
  if (fidelity == "standard") return;
  numerics.selective_mass = false;
  if (fidelity == "draft") {
    numerics.mass_scale = 1e4;
    numerics.safety = 0.4;
  } else {
    numerics.mass_scale = 100;
    numerics.safety = 0.1;
    numerics.exchange_interval = 5;
  }
}

void compress(std::optional<BinderScene>& binder, OutputScene& output, double factor) {
  if (binder)
    for (double& tau : binder->tau) tau /= factor;
  output.history_interval /= factor;
  output.picture_interval /= factor;
}

}  // namespace

void take_fidelity(const std::string& fidelity, GyratoryScene& scene) {
  take_fidelity(fidelity, scene.numerics);
  if (fidelity == "standard") return;
  const bool draft = fidelity == "draft";
  scene.mould.elastic.emplace().modes = draft ? 20 : 100;  // dropped where the scene has none
  scene.head.elastic.emplace().modes = draft ? 10 : 40;
}

void take_fidelity(const std::string& fidelity, FlowTestScene& scene) {
  take_fidelity(fidelity, scene.numerics);
}

GyratoryScene compressed(const GyratoryScene& scene) {
  GyratoryScene faster = scene;
  const double factor = scene.numerics.time_compression;
  compress(faster.binder, faster.output, factor);
  faster.gyration.ramp /= factor;
  faster.gyration.dwell /= factor;
  faster.gyration.speed *= factor;
  faster.gyration.approach_speed *= factor;
  return faster;
}

FlowTestScene compressed(const FlowTestScene& scene) {
  FlowTestScene faster = scene;
  const double factor = scene.numerics.time_compression;
  compress(faster.binder, faster.output, factor);
  faster.flow.speed *= factor;
  return faster;
}

}  // namespace apps

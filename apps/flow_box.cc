#include "apps/flow_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "apps/errors.h"

namespace apps {

void check_box(const FlowTestScene& scene, const Mix& mix) {
  constexpr double reference_voids = 0.04;       // of the height that the mix would fill [-]
  constexpr double lowest = 0.5, highest = 1.5;  // filled height / height of the box
  const FlowScene& flow = scene.flow;
  std::vector<std::string> mistakes;
  const double volume = (mix.stone_volume + mix.binder_volume) / (1 - reference_voids);
  const double filled = volume / (flow.length * flow.width) / flow.height;
  if (filled < lowest || filled > highest) {
    const double per_stone = filled / scene.stones.count;
    mistakes.push_back(fmt::format(
        "{}: expected {:.0f} to {:.0f} stones for a box of {:.4g} x {:.4g} x {:.4g} mm, found {}; "
        "change the count or the box",
        scene.where("stones.count"), lowest / per_stone, highest / per_stone, 1e3 * flow.length,
        1e3 * flow.width, 1e3 * flow.height, scene.stones.count));
  }
  const double largest = 2 * (mix.largest_radius() + mix.shell);
  if (std::min(flow.length, flow.width) < 2 * largest)
    mistakes.push_back(fmt::format(
        "{}: expected a box at least {:.4g} mm wide for a largest stone of {:.4g} mm, found {:.4g} "
        "mm; take a wider box",
        scene.where("flow.width"), 2e3 * largest, 1e3 * largest,
        1e3 * std::min(flow.length, flow.width)));
  if (!mistakes.empty()) throw InputError(mistakes);
}

}  // namespace apps

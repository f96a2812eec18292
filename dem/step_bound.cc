#include "dem/step_bound.h"

#include <cmath>
#include <variant>

namespace dem {

StepBound bound_by_load(const Wall& wall, double stiffness) {
  const auto* ram = std::get_if<Ram>(&wall.motion);
  if (!ram) return {};
  // It bears all of them at once, a stone some twelve, of which the stiffest is asked.
  constexpr double around_a_stone = 12;
  return {stiffness / ram->inertia / around_a_stone, "wall " + wall.name + " on its stones"};
}

StepBound bound_by_speed(const Wall& wall, double within, double skin, double safety) {
  const auto* ram = std::get_if<Ram>(&wall.motion);
  if (!ram || !std::isfinite(ram->valve_speed)) return {};
  constexpr double skins_a_step = 2;
  const double fastest = ram->fastest(norm(wall.frame.velocity), within);
  const double hasty = safety * fastest / (skins_a_step * skin);
  return {hasty * hasty, "the speed of wall " + wall.name};
}

}  // namespace dem

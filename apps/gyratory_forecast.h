// What a gyratory run will be, see forecast.h.
#pragma once

#include "apps/forecast.h"
#include "apps/machine.h"
#include "apps/steel.h"

namespace apps {

Loading gyratory_loading(const GyratoryScene& scene, const Machine& machine);

// Its width, and a warning where it is too wide for so many stones.
std::vector<std::string> mould_lines(const Machine& machine, int stones);

// Of the elastic bodies, which are meshed and reduced for it.
struct SteelForecast {
  struct Part {
    const char* name;
    SteelPart::Outline outline;
  };
  std::vector<Part> parts;
  double seconds = 0;           // of the wall clock, for all that [s]
  double seconds_per_step = 0;  // of the wall clock, to exchange with all of them
};

SteelForecast steel_forecast(const GyratoryScene& scene, const Machine& machine);

// How the modes of each body will move in time steps of that length [s], and a warning where they
// are too slow for the gyrations.
std::vector<std::string> steel_lines(const SteelForecast& steel, const GyratoryScene& scene,
                                     double time_step);

}  // namespace apps

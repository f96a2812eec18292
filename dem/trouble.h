// Why a run cannot go on: the stone, the time and the value that went wrong.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace dem {

struct NumericalTrouble : std::runtime_error {
  NumericalTrouble(const std::string& what, std::uint32_t stone, double time, double value)
      : std::runtime_error(what), stone(stone), time(time), value(value) {}
  std::uint32_t stone;  // id
  double time;          // [s]
  double value;         // of the quantity that `what` names, SI
};

}  // namespace dem

#include "apps/clocks.h"

#include <chrono>
#include <ctime>

namespace apps {

double wall_clock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double processor_clock() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace apps

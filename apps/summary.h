// summary.json of a run: the few numbers that answer the question it was started for.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace apps {

struct Finding {
  std::string key;  // with its unit, e.g. "air_voids [1]"
  std::variant<std::int64_t, double, std::string> value;
};

// Keys keep their order and must differ. A value that is not finite throws NotANumber (recorder.h).
void write_summary(const std::string& path, const std::vector<Finding>& findings);

}  // namespace apps

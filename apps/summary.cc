#include "apps/summary.h"

#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/recorder.h"
#include "apps/whole_file.h"

namespace apps {

void write_summary(const std::string& path, const std::vector<Finding>& findings) {
  using Json = nlohmann::ordered_json;
  Json summary = Json::object();
  for (const Finding& finding : findings) {
    assert(!summary.contains(finding.key));
    const double* number = std::get_if<double>(&finding.value);
    if (number && !std::isfinite(*number))
      throw NotANumber(finding.key + " is " + std::to_string(*number));
    std::visit([&](const auto& value) { summary[finding.key] = value; }, finding.value);
  }
  // Host names and command lines need not be UTF-8: what JSON cannot hold is replaced.
  write_whole_file(path, summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace apps

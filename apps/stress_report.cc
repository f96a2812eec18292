#include "apps/stress_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "apps/pictures.h"
#include "apps/whole_file.h"

namespace apps {

bool StressReport::pass() const {
  return std::ranges::all_of(rows, &StressRow::pass);
}

LoadedBody loaded_body(const fem::ElasticBody& body, const Eigen::VectorXd& displacement) {
  LoadedBody loaded{body.cells(), {}, {}};
  const fem::StressField stress = body.stress(displacement);
  loaded.displacement =
      displacement.reshaped(3, displacement.size() / 3)(Eigen::all, loaded.cells.node);
  loaded.stress = stress(Eigen::all, loaded.cells.node);
  return loaded;
}

std::string as_table(const std::string& headline, const std::vector<StressRow>& rows) {
  std::string table = headline + '\n';
  table += fmt::format("  {:<34}{:<11}{:>12}{:>12}{:>10}{:>10}  {:<5} {}\n", "quantity", "unit",
                       "computed", "reference", "error", "tolerance", "pass", "source");
  for (const StressRow& row : rows)
    table += fmt::format("  {:<34}{:<11}{:>12.5g}{:>12.5g}{:>9.2g}%{:>9.2g}%  {:<5} {}\n",
                         row.quantity, row.unit, row.computed, row.reference, 100 * row.error(),
                         100 * row.tolerance, row.pass() ? "yes" : "NO", row.source);
  return table;
}

std::string as_json(const std::vector<StressRow>& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const StressRow& row : rows)
    list.push_back({{"quantity", row.quantity},
                    {"unit", row.unit},
                    {"computed", row.computed},
                    {"reference", row.reference},
                    {"source", row.source},
                    {"error", row.error()},
                    {"tolerance", row.tolerance},
                    {"pass", row.pass()}});
  return nlohmann::ordered_json({{"rows", list}}).dump(2) + '\n';
}

void draw(const StressReport& report, const std::string& folder, const std::string& name) {
  if (report.body) {
    const LoadedBody& body = *report.body;
    const auto flat = [](const auto& columns) {
      return std::vector<double>(columns.data(), columns.data() + columns.size());
    };
    write_hexahedra(folder + '/' + name + ".vtu", body.cells.points + body.displacement,
                    body.cells.hexahedra,
                    {{"displacement [m]", 3, flat(body.displacement)},
                     {"stress [Pa]", 6, flat(body.stress), {"xx", "yy", "zz", "yz", "zx", "xy"}}});
  }
  if (report.map.empty()) return;
  std::string map = "angle_deg,height_m,traction_Pa,hoop_stress_Pa\n";
  for (const MapPoint& point : report.map)
    map += fmt::format("{},{},{},{}\n", point.angle * 180 / std::numbers::pi, point.height,
                       point.traction, point.hoop_stress);
  write_whole_file(folder + '/' + name + ".csv", map);
}

}  // namespace apps

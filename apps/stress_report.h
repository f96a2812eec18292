// What a case for the validation of wall stresses finds: rows that pass or fail, and pictures.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "fem/elastic_body.h"

namespace apps {

struct StressRow {
  std::string quantity, unit;
  double computed, reference;  // in `unit`
  std::string source;          // of the reference, with the reason of a tolerance above 2 %
  double tolerance;            // of the error [-]
  double measure = std::abs(reference);  // of the error: what 100 % of it is, in `unit`

  double error() const { return (computed - reference) / measure; }  // [-]
  bool pass() const { return std::abs(error()) <= tolerance; }
};

// A place of the mould's inner face, unrolled.
struct MapPoint {
  double angle, height;  // [rad], [m]
  double traction;       // outwards, of what is inside on the wall [Pa]
  double hoop_stress;    // tension positive [Pa]
};

// A loaded body, at the points of its cells.
struct LoadedBody {
  fem::CellMesh cells;
  Eigen::Matrix3Xd displacement;  // (3, points) [m]
  fem::StressField stress;        // (6, points) [Pa]
};

struct StressReport {
  std::vector<StressRow> rows;
  std::optional<LoadedBody> body;
  std::vector<MapPoint> map;  // of a mould

  bool pass() const;
};

LoadedBody loaded_body(const fem::ElasticBody& body, const Eigen::VectorXd& displacement);

// The rows as an aligned table with a headline, and as {"rows": [...]}.
std::string as_table(const std::string& headline, const std::vector<StressRow>& rows);
std::string as_json(const std::vector<StressRow>& rows);

// Writes FOLDER/NAME.vtu (deformed body, displacement, stress) and, of a mould, FOLDER/NAME.csv
// (the unrolled map, for stress_maps.py). Throws OutputError.
void draw(const StressReport& report, const std::string& folder, const std::string& name);

}  // namespace apps

// The rows of a gyratory run: its columns, the means between two rows, and what waits for its
// reference, the air voids when the gyrations begin.
#pragma once

#include <optional>
#include <vector>

#include "apps/archive.h"
#include "apps/recorder.h"
#include "apps/scene.h"
#include "dem/wall.h"

namespace apps {

class GyratoryHistory {
 public:
  static std::vector<Column> columns(const GyratoryScene& scene);

  static constexpr std::size_t air_voids = 3, ram_pressure = 4;  // places of columns

  // What a run is at the end of a row.
  struct Moment {
    double time;            // since the plate came down [s]
    double gyration;        // done, negative before the first
    double height;          // mean, of the bent plate [m]
    double air_voids;       // [-]
    double internal_angle;  // of the bent plate [rad]
    double fractured, bonds, coordination;
    double kinetic_energy;  // [J]
    double time_step;       // [s]
  };

  // Adds a step of dt [s] to the means of the row.
  void look(const dem::Wall& head, const dem::Wall& mould, double time, double dt);
  // The first columns of the row that ends now; begins the next. section: of the mould [m2].
  std::vector<double> end_row(const Moment& moment, const GyratoryScene& scene, double section);
  // A whole row but for its last column. Those before the first gyration are held until then.
  void record(Recorder& recorder, const Moment& moment, double gyrations, std::vector<double> row);

  // Of the last two gyrations, after the row that ends where they begin.
  const std::vector<std::vector<double>>& last_rows() const { return last_rows_; }
  bool began() const { return voids_at_start_.has_value(); }         // have the gyrations
  double voids_at_start() const { return voids_at_start_.value(); }  // of the gyrations [-]

  void visit_state(Archive& item);  // see dem/state.h

 private:
  // Means over the time since the last row, so that a row carries balance and not chatter.
  struct Means {
    double span = 0;                                   // [s]
    dem::Vec3d force = {0, 0, 0}, moment = {0, 0, 0};  // on the head [N s], [N m s]
    double mould_push = 0, ram_force = 0;              // [N s]
  };

  Means means_;
  std::vector<std::vector<double>> held_rows_, last_rows_;
  std::optional<double> voids_at_start_;
};

}  // namespace apps

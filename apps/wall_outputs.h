// What a run tells of its walls: resultants, mean tractions, virtual strain gauges, unrolled maps,
// and whether the letterbox loses anything that the stones' contacts give it.
//
// Signs, everywhere: forces and tractions are those of the mix on the wall. Normal traction is
// positive where the mix presses on the wall; axial traction is positive along +z, the axis of the
// mould, upwards; strain and stress are positive in tension.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "apps/machine.h"
#include "apps/recorder.h"
#include "apps/steel.h"
#include "dem/wall.h"

namespace apps {

class WallOutputs {
 public:
  enum Part { floor, mould, head, parts };  // the walls of a run, in their order

  WallOutputs(const GyratoryScene& scene, const Machine& machine);

  static std::vector<Column> columns(const GyratoryScene& scene);

  // To be called once the steel is there, if it is elastic. A map of a rigid mould needs a
  // letterbox, which its wall is given here.
  void begin(std::vector<dem::Wall>& walls, const SteelPart* steel_mould);

  // To be called after every time step, before letterboxes are emptied.
  // `power(part)`: of the stones on a bent face [W], asked for now and then.
  template <class Power>
  void look(std::vector<dem::Wall>& walls, double dt, double specimen_height, Power power) {
    const bool row_begins = sums_.span == 0;
    add_up(walls, dt, specimen_height);
    if (looks_++ % residual_interval != 0 && !row_begins) return;
    for (const int part : {mould, head})
      if (elastic_[part]) compare_sides(walls[part], part, dt, power(part));
  }

  // To be called after begin(). See dem/state.h.
  template <class Visit>
  void visit_state(Visit& visit, const std::string& in) {
    visit(in + "sums", sums_);
    visit(in + "residual", residual_);
    visit(in + "row_impulse", row_impulse_);
    visit(in + "gyration_impulse", gyration_impulse_);
    visit(in + "gyration_span", gyration_span_);
    visit(in + "turns", turns_);
    visit(in + "looks", looks_);
    visit(in + "map.gyration", map_.gyration);
    visit(in + "map.angle", map_.angle);
    visit(in + "map.height", map_.height);
    visit(in + "map.normal", map_.normal);
    visit(in + "map.axial", map_.axial);
    visit(in + "map.hoop", map_.hoop);
  }

  std::vector<double> row();  // means since the last row, one value per column
  // Maps each gyration once it is done; `gyration` counts from the end of the dwell.
  void turn(double gyration, const dem::Wall& mould_wall, const SteelPart* steel_mould,
            Recorder& recorder);

 private:
  static constexpr int residual_interval = 100;  // steps

  struct Sums {
    double span = 0;                           // [s]
    std::array<dem::Vec3d, parts> force = {};  // [N s]
    std::array<double, parts> traction = {};   // normal [Pa s]
    double axial_traction = 0;                 // on the mould [Pa s]
  };
  struct Residual {
    double force = 0, moment = 0, work = 0;  // the largest since the last row [-]
  };
  struct Map {
    std::vector<double> gyration, angle, height, normal, axial, hoop;
  };

  void add_up(std::vector<dem::Wall>& walls, double dt, double specimen_height);
  void compare_sides(const dem::Wall& wall, int part, double dt, double power_of_stones);
  void add_map(const dem::SurfaceField& field, const SteelPart* steel_mould);
  void write(Recorder& recorder) const;

  std::vector<GaugeScene> gauges_;
  bool maps_;
  Machine machine_;
  std::array<bool, parts> elastic_ = {};
  bool rigid_letterbox_ = false;            // a letterbox that nobody else empties
  std::vector<Eigen::VectorXd> influence_;  // (gauges) strain by a force at the letterbox [1/N]
  Sums sums_;
  std::array<Residual, parts> residual_;
  Eigen::VectorXd row_impulse_, gyration_impulse_;  // on the mould's letterbox [N s]
  double gyration_span_ = 0;                        // [s]
  double turns_ = -1;                               // gyrations that are done, -1 before them
  Map map_;
  std::int64_t looks_ = 0;
};

}  // namespace apps

// A scene: what a run models, in SI. A section that is absent is not modelled and costs nothing.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dem/gradation.h"

namespace apps {

// Where a scene was read: for the record of a run, and for mistakes that show only later.
struct SceneSource {
  std::string path;
  std::string text;                           // of the file, as read
  std::vector<std::string> overrides;         // the --set options, in their order
  std::map<std::string, std::string> places;  // "stones.count" -> "scene.toml:7:9"

  // The place of a key, else of the nearest section above it, else the file.
  std::string where(const std::string& key) const;
};

struct RunScene {
  int seed = 1;
  std::string fidelity = "standard";  // or "draft", "reference"; see fidelity.h
};

struct FractureScene {
  double scale = 386.5e6;            // Weibull scale sigma0 [Pa]
  double exponent = 3.87;            // Weibull exponent m [-]
  double reference_volume = 244e-9;  // V_ref [m3]
};

struct StonesScene {
  int count = 0;
  std::string gradation;                          // path of the sieve table, resolved
  dem::SieveTable sieves;                         // what that file holds
  std::string distribution = "truncated_normal";  // or "log_linear"
  double smallest = 2e-3;                         // finer stones are in the binder phase [m]
  double density = 2650;                          // [kg/m3]
  double young = 74e9;                            // [Pa]
  double poisson = 0.15;                          // [-]
  double friction = 0.7;                          // between stones [-]
  std::optional<double> restitution;              // absent: no contact damping [-]
  std::optional<FractureScene> fracture;          // absent: stones never break
};

struct BinderScene {
  double content = 0;                 // bitumen mass / mix mass [-]
  double density = 1020;              // of the bitumen [kg/m3]
  std::optional<double> temperature;  // [K]; given: the next three are from binder_table.h
  double shear_modulus = 0;           // G0 [Pa]
  std::vector<double> alpha;          // [-], sum <= 1, before the bitumen fraction is applied
  std::vector<double> tau;            // [s], as many as alpha
  double bond_energy = 1e4;           // w, work of separation [J/m2]
  bool wall_bonds = false;    // do shells bond to walls too; false: steel with release agent
  std::string film = "even";  // or "rings": how it forgets where its area shrinks
};

struct FillScene {
  double packing_density = 0.30;  // of the gas [-]
  bool bonds = false;             // may stones bond while they settle
  double rest_energy = 1e-3;      // kinetic energy at rest / (sum of m g R) [-]
};

struct ElasticMouldScene {
  double wall_thickness = 7.5e-3;  // [m]
  double height = 0.25;            // [m]
  double young = 210e9;            // [Pa]
  double poisson = 0.3;            // [-]
  double density = 7850;           // [kg/m3]
  double modes = 60;               // below 1: the largest share of compliance to leave out
  bool full = false;               // what the modes leave out answers, too
};

struct MouldScene {
  std::optional<double> diameter;      // [m]; exactly one of the two
  std::optional<double> aspect_ratio;  // of the specimen at 4 % air voids [-]
  double wall_friction = 0.3;          // [-]
  std::optional<ElasticMouldScene> elastic;
};

struct ElasticHeadScene {
  double plate_thickness = 20e-3;  // [m]
  double shaft_diameter = 50e-3;   // [m]
  double shaft_length = 0.25;      // [m]
  double young = 210e9;            // [Pa]
  double poisson = 0.3;            // [-]
  double density = 7850;           // [kg/m3]
  double modes = 20;               // below 1: the largest share of compliance to leave out
  bool full = false;               // what the modes leave out answers, too
};

struct HeadScene {
  std::optional<double> mass;  // of a rigid head [kg]; absent: that of a steel plate
  double friction = 0.3;       // [-]
  std::optional<ElasticHeadScene> elastic;
};

struct GyrationScene {
  double angle = 0.017453292519943295;  // tilt imposed at the ram root [rad]
  double pressure = 600e3;              // ram force / mould cross section [Pa]
  double ramp = 1.0;                    // linear pressure ramp before the gyrations [s]
  double dwell = 0.5;                   // at full pressure, before the gyrations [s]
  double speed = 0.5;                   // [rev/s]
  double count = 100;                   // gyrations
  bool spin = false;                    // true: the plate turns with the tilt direction
  double approach_speed = 0.1;          // where oil loses all pressure on its way to the ram [m/s]
};

struct FlowScene {
  double length = 0.150;        // of the box [m]
  double width = 0.100;         // of the box and the strip [m]
  double height = 0.100;        // of the box [m]
  double strip_length = 0.050;  // along the box length, at its low-x end [m]
  double speed = 15e-3 / 60;    // of the strip, downwards [m/s]
  double displacement = 0.020;  // of the strip at the end [m]
  double wall_friction = 0.3;   // [-]
};

struct NumericsScene {
  double mass_scale = 1e3;       // inertia / true inertia; weight is never scaled [-]
  bool selective_mass = true;    // less for stones that need less of it for the same time step
  double safety = 0.2;           // time step / sqrt(m / k) of the stiffest contact [-]
  double head_mass_scale = 100;  // inertia / true inertia of the head and the modes of the steel
  int exchange_interval = 20;    // steps between exchanges with the static wall modes
  double time_compression = 1;   // how many times faster than asked for a process is run [-]
  double largest_overlap = 0.5;  // of stones, at which a run stops / smaller radius [-]
};

struct OutputScene {
  double history_interval = 0.01;    // [s]
  double picture_interval = 0;       // [s]; 0: pictures of the end only
  bool energy_ledger = false;        // where the work goes, in the history
  double checkpoint_interval = 600;  // of wall time [s]
};

// A virtual strain gauge, glued to the outside of an elastic mould along its circumference.
struct GaugeScene {
  double angle = 0;       // from the x axis [rad]
  double height = 0;      // above the mould's base [m]
  double length = 10e-3;  // along the circumference [m]
};

struct GyratoryScene {
  SceneSource source;
  RunScene run;
  StonesScene stones;
  std::optional<BinderScene> binder;
  FillScene fill;
  MouldScene mould;
  HeadScene head;
  GyrationScene gyration;
  NumericsScene numerics;
  OutputScene output;
  std::vector<GaugeScene> gauges;  // [[output.gauge]]
  bool maps = false;               // of the traction on the mould, averaged over each gyration
  bool movie = false;              // pictures of the last gyration, whatever the interval

  std::string where(const std::string& key) const { return source.where(key); }
};

struct FlowTestScene {
  SceneSource source;
  RunScene run;
  StonesScene stones;
  std::optional<BinderScene> binder;
  FillScene fill;
  FlowScene flow;
  NumericsScene numerics = {.mass_scale = 3e3, .selective_mass = false};  // the strip is slow
  OutputScene output;

  std::string where(const std::string& key) const { return source.where(key); }
};

// Read the scene file, lay the overrides (`gyration.pressure=300 kPa`) over it, read the sieve
// table it names, and check all of it. Throw InputError with every mistake found, and OutputError
// where the tables of units cannot be read.
GyratoryScene read_gyratory_scene(const std::string& path,
                                  const std::vector<std::string>& overrides);
FlowTestScene read_flow_scene(const std::string& path, const std::vector<std::string>& overrides);

}  // namespace apps

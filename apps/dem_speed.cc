// Times the steps of a settled bed of stones in a rigid cylinder, open at the top, under a gravity
// that stands for a confining load. Material, walls and load are those that other codes are timed
// with on the same bed (tests/speed/compare_peers.sh).
#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "apps/bed_file.h"
#include "apps/laws.h"
#include "apps/program.h"
#include "apps/whole_file.h"
#include "dem/strength.h"

namespace {

struct Options {
  std::string bed, law, out;
  double cylinder_radius = 0;  // [m]; 0: as the bed says
  double skin = 2e-5;          // [m]
  double gyrate = 0;           // revolutions of a lid [1/s]; 0: no lid
  int threads = 1, steps = 0, warmup = 0;
  bool json = false;
};

constexpr double gravity = 196.2;        // 20 g [m/s2]
constexpr double time_step = 1e-6;       // [s]
constexpr double shell = 0.5e-3;         // of the asphalt [m]
constexpr double largest_overlap = 0.5;  // / radius of the smaller stone [-]

// What a bed is made of, as a scene would say it; walls are of stone.
struct Material {
  apps::StonesScene stones;
  std::optional<apps::BinderScene> binder;
  apps::Mix mix;
};

// The shells are inside of the radii of the bed, so that both laws touch at the same pairs at
// first.
Material material_of(const std::string& law, const apps::BedFile& bed) {
  Material material;
  material.stones.young = 1e9;
  material.stones.poisson = 0.15;
  material.stones.friction = 0.7;
  material.mix.radius = bed.radius;
  if (law == "dry") {
    material.stones.restitution = 0.3;
    return material;
  }
  // Binder of the mix SMA 11 at 150 degrees, Olsson, Jelagin & Partl (2019), table 1.
  apps::BinderScene binder;
  binder.shear_modulus = 6.65e6;
  binder.alpha = {0.513, 0.487};
  binder.tau = {0.0948, 105.9};
  binder.wall_bonds = true;
  material.binder = binder;
  constexpr double bitumen = 0.43;  // of the binder phase, the rest are fines
  material.mix.bitumen_fraction = bitumen;
  material.mix.shell_density = bitumen * binder.density + (1 - bitumen) * material.stones.density;
  material.mix.shell = shell;
  for (double& radius : material.mix.radius) radius -= shell;
  const auto& weibull = material.stones.fracture.emplace();
  for (std::uint32_t id = 0; id < bed.radius.size(); ++id)
    material.mix.strength.push_back(
        dem::strength({weibull.scale, weibull.exponent, weibull.reference_volume},
                      material.mix.radius[id], 1, id));
  return material;
}

template <class Law>
struct Bed {
  dem::ParticleStore stones;
  std::vector<dem::Wall> walls;
  Law pair_law, wall_law;
};

template <class Law>
Bed<Law> bed_of(const apps::BedFile& file, const Material& material, const apps::LawBook& book) {
  const apps::StonesScene& scene = material.stones;
  Bed<Law> bed;
  bed.stones = dem::make_stones(file.position, material.mix.radius, material.mix.layers(scene), 1);
  if (scene.fracture) dem::make_breakable(bed.stones, material.mix.strength);
  bed.walls.resize(2);
  bed.walls[0].name = "floor";
  bed.walls[0].surface = dem::Plane{};
  bed.walls[1].name = "cylinder";
  bed.walls[1].surface = dem::CylinderInside{file.cylinder_radius.value()};
  bed.pair_law = book.law<Law>({std::nullopt, scene.friction}, true);
  bed.wall_law = book.law<Law>({dem::Material{scene.young, scene.poisson}, scene.friction}, true);
  return bed;
}

// A lid that presses as a gyratory compactor's head does, from the end of the warm-up on
// gyrating.
dem::Wall lid_of(const dem::ParticleStore& stones, const Options& options) {
  constexpr double pressure = 600e3, angle = 1.25 * std::numbers::pi / 180;  // [Pa], [rad]
  const double radius = options.cylinder_radius;
  double mass = 0, top = 0;
  for (std::size_t k = 0; k < stones.size(); ++k) {
    mass += stones.mass[k];
    top = std::max(top, stones.position[k].z + stones.outer_radius(k));
  }
  dem::Wall lid;
  lid.name = "lid";
  lid.surface = dem::Disc{radius};
  lid.frame.origin = {0, 0, top + radius * std::sin(angle)};
  const dem::Ram ram = {.inertia = mass,
                        .weight = 0,
                        .force = pressure * std::numbers::pi * radius * radius,
                        .ramp_start = 0,
                        .ramp = options.warmup * time_step,
                        .angle = angle,
                        .speed = options.gyrate,
                        .spin = false};
  dem::orient(ram, lid.frame, 0);
  lid.motion = ram;
  return lid;
}

// Stones that touch a wall of the cylinder, once for each wall.
std::int64_t touching_walls(const dem::ParticleStore& stones, double cylinder_radius) {
  std::int64_t count = 0;
  for (std::size_t k = 0; k < stones.size(); ++k) {
    const dem::Vec3d& x = stones.position[k];
    count += x.z < stones.outer_radius(k);
    count += std::hypot(x.x, x.y) + stones.outer_radius(k) > cylinder_radius;
  }
  return count;
}

// The stones as a bed file, in the order of the one that was read.
std::string table_of(const dem::ParticleStore& stones, double cylinder_radius) {
  std::vector<std::size_t> place(stones.size());
  for (std::size_t k = 0; k < place.size(); ++k) place[stones.id[k]] = k;
  std::string rows = fmt::format("# cylinder_radius={}\n# x,y,z,radius (m)\n", cylinder_radius);
  for (const std::size_t k : place) {
    const dem::Vec3d& x = stones.position[k];
    rows += fmt::format("{},{},{},{}\n", x.x, x.y, x.z, stones.outer_radius(k));
  }
  return rows;
}

// Of the time that all stages took [-].
nlohmann::ordered_json shares(const dem::StageTimes& times) {
  constexpr std::array<const char*, dem::stages> names = {
      "motion", "lists", "pair contacts", "wall contacts", "fracture", "rest"};
  double all = 0;
  for (int k = 0; k < dem::stages; ++k) all += times.spent(static_cast<dem::Stage>(k));
  nlohmann::ordered_json shares;
  for (int k = 0; k < dem::stages; ++k)
    shares[names[k]] = times.spent(static_cast<dem::Stage>(k)) / all;
  return shares;
}

template <class Law>
nlohmann::ordered_json time_steps(Bed<Law> bed, const Options& options) {
  using Clock = std::chrono::steady_clock;
  if (options.gyrate > 0) bed.walls.push_back(lid_of(bed.stones, options));
  dem::Settings settings;
  settings.gravity = gravity;
  settings.largest_step = time_step;
  settings.largest_overlap = largest_overlap;
  settings.skin = options.skin;
  dem::Simulation<Law> simulation(bed.stones, bed.pair_law, settings);
  for (const dem::Wall& wall : bed.walls) simulation.add_wall(wall, bed.wall_law);
  for (int k = 0; k < options.warmup; ++k) simulation.step();
  const std::int64_t rebuilds_before = simulation.rebuilds();
  dem::StageTimes times;
  simulation.time_stages(times);
  const auto start = Clock::now();
  const std::clock_t cpu_start = std::clock();
  for (int k = 0; k < options.steps; ++k) simulation.step();
  const double per_step =
      std::chrono::duration<double>(Clock::now() - start).count() / options.steps;
  const double cpu = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;

  if (!options.out.empty())
    apps::write_whole_file(options.out, table_of(simulation.stones(), options.cylinder_radius));

  const std::int64_t stones = std::ssize(bed.stones.id);
  const std::int64_t pairs = simulation.pairs().touching(simulation.stones());
  const std::int64_t at_walls = touching_walls(simulation.stones(), options.cylinder_radius);
  nlohmann::ordered_json result;
  result["law"] = options.law;
  result["stones"] = stones;
  result["threads"] = options.threads;
  result["steps"] = options.steps;
  result["time_step_s"] = simulation.time_step();
  result["skin_m"] = options.skin;
  result["ms_per_step"] = 1e3 * per_step;
  result["cpu_ms_per_step"] = 1e3 * cpu / options.steps;  // of all threads
  result["touching_stones"] = pairs;
  result["touching_walls"] = at_walls;
  result["slots"] = simulation.pairs().slots();
  result["contact_steps_per_s"] = static_cast<double>(pairs + at_walls) / per_step;
  result["particle_steps_per_s"] = static_cast<double>(stones) / per_step;
  result["rebuilds"] = simulation.rebuilds() - rebuilds_before;
  result["bytes_per_stone"] = static_cast<double>(simulation.bytes()) / stones;
  result["bytes_per_slot"] =
      static_cast<double>(simulation.bytes_of_slots()) / simulation.pairs().slots();
  result["share"] = shares(times);
  return result;
}

nlohmann::ordered_json run(Options options) {
  apps::expect_another_file(options.out, {options.bed});
  apps::Mistakes mistakes;
  apps::BedFile bed = apps::read_bed_file(options.bed, mistakes);
  if (options.cylinder_radius > 0) bed.cylinder_radius = options.cylinder_radius;
  if (!bed.cylinder_radius)
    mistakes.add({options.bed}, "a comment with cylinder_radius=", "none",
                 "give --radius, in metres");
  else if (!mistakes.any())
    apps::check_overlaps(bed, *bed.cylinder_radius, largest_overlap, mistakes);
  if (options.law == "asphalt" && !mistakes.any()) {
    const auto smallest = std::ranges::min_element(bed.radius);
    if (*smallest <= shell)
      mistakes.add({bed.path, bed.line[smallest - bed.radius.begin()], 1},
                   fmt::format("a radius above the shell's {} m", shell),
                   fmt::format("{}", *smallest), "leave such stones to the binder");
  }
  if (mistakes.any()) throw apps::InputError(mistakes.lines());

  omp_set_num_threads(options.threads);
  options.cylinder_radius = *bed.cylinder_radius;
  const Material material = material_of(options.law, bed);
  const apps::LawBook book(material.stones, material.binder, material.mix);
  if (options.law == "dry")
    return time_steps(bed_of<apps::DampedDry>(bed, material, book), options);
  return time_steps(bed_of<apps::BreakingAsphalt<2>>(bed, material, book), options);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Times the steps of a settled bed of stones in a cylinder.");
  app.add_option("--bed", options.bed, "table of stones: x,y,z,radius (CSV, in metres)")
      ->required();
  app.add_option("--law", options.law, "dry, or asphalt: with binder shells inside the radii")
      ->required()
      ->check(CLI::IsMember({"dry", "asphalt"}));
  app.add_option("--threads", options.threads)->check(CLI::Range(1, 1024));
  app.add_option("--steps", options.steps, "steps to time")->required()->check(CLI::PositiveNumber);
  app.add_option("--warmup", options.warmup, "steps before")->check(CLI::NonNegativeNumber);
  app.add_option("--radius", options.cylinder_radius,
                 "of the cylinder [m], if the bed does not say")
      ->check(CLI::PositiveNumber);
  app.add_option("--skin", options.skin, "search range beyond contact [m]")
      ->check(CLI::PositiveNumber);
  app.add_option(
         "--gyrate", options.gyrate,
         "press a lid at 600 kPa during the warm-up, then gyrate it by 1.25 degrees at this "
         "speed [1/s]")
      ->check(CLI::PositiveNumber);
  app.add_option("--out", options.out, "write the stones after the last step as a bed (CSV)");
  app.add_flag("--json", options.json, "print one JSON object");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? apps::ok : apps::bad_input;
  }
  try {
    const nlohmann::ordered_json result = run(options);
    if (options.json) {
      std::cout << result.dump() << '\n';
      return apps::ok;
    }
    for (const auto& [name, value] : result.items()) {
      if (!value.is_object()) std::cout << fmt::format("{:<22}{}\n", name, value.dump());
    }
    for (const auto& [stage, share] : result["share"].items())
      std::cout << fmt::format("share of {:<15}{:.1f} %\n", stage, 100 * share.get<double>());
    return apps::ok;
  } catch (const apps::InputError& error) {
    for (const std::string& line : error.mistakes) std::cerr << line << '\n';
    return apps::bad_input;
  } catch (const dem::NumericalTrouble& trouble) {
    std::cerr << fmt::format("stopped: stone {}, time {} s: {} = {}\n", trouble.stone, trouble.time,
                             trouble.what(), trouble.value);
    return apps::numerical_trouble;
  } catch (const apps::OutputError& error) {
    std::cerr << error.what() << '\n';
    return apps::output_trouble;
  }
}

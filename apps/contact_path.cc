// Drives one contact along a prescribed path and records its force: a look at a contact law before
// a run is trusted to it. Every row of the path is one time step of a run, and one row of the
// table.
#include <fmt/format.h>

#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "apps/bed.h"
#include "apps/path_case.h"
#include "apps/program.h"
#include "apps/whole_file.h"
#include "dem/laws/slip_rings.h"
#include "dem/strength.h"

namespace {

// One stone of the contact, as far as it may break.
struct Stone {
  double strength;      // [Pa]
  double softness = 1;  // [-]
  std::optional<dem::Crack> crack;
};

// The law of the case under way along its path.
template <class Law>
class Drive {
 public:
  Drive(const apps::PathCase& the_case, const Law& law) : law_(law) {
    const std::vector<double>& r = the_case.radius;
    const auto reduced = [&](double a, double b) {
      return the_case.at_wall() ? a : a * b / (a + b);
    };
    contact_.outer_radius = reduced(r.front() + the_case.shell, r.back() + the_case.shell);
    contact_.stone_radius = reduced(r.front(), r.back());
    contact_.normal = {0, 0, 1};
    contact_.softness = 1;
    if (!the_case.stone) return;
    const auto mass = [&](double radius) {
      return the_case.stone->density * 4.0 / 3 * std::numbers::pi * radius * radius * radius;
    };
    contact_.mass = reduced(mass(r.front()), mass(r.back()));
    if (!the_case.stone->fracture) return;
    const apps::FractureScene& fracture = *the_case.stone->fracture;
    const dem::Weibull weibull = {fracture.scale, fracture.exponent, fracture.reference_volume};
    for (std::uint32_t id = 0; id < r.size(); ++id)
      stones_.push_back({dem::strength(weibull, r[id], the_case.seed, id)});
  }

  // The table's row of the step that ends at `point`; the first step is a jump onto the path.
  std::string step_to(const apps::PathPoint& point) {
    const apps::PathPoint before = steps_ == 0 ? point : last_;
    const double dt = point.time - before.time;
    law_.set_time_step(dt);
    contact_.overlap = point.overlap;
    contact_.closing = dt > 0 ? (point.overlap - before.overlap) / dt : 0;
    contact_.sliding = {point.shear - before.shear, 0, 0};
    const dem::Response<double> response = law_(contact_, memory_);
    if constexpr (Law::breaks) break_stones(response.stone, point.time);
    ++steps_;
    last_ = point;
    return fmt::format("{},{},{},{},{},{},{},{:d},{}\n", point.time, point.overlap, point.shear,
                       response.push, response.push - response.stone, response.stone,
                       0.0 - response.shear.x, bool(Law::template holds<double>(memory_)),
                       broken());
  }

 private:
  // As a simulation does it: stones break at once, and soften every so many steps.
  void break_stones(double force, double time) {
    const double crush = force / (contact_.stone_radius * contact_.stone_radius);
    const std::vector<dem::StoneLoad> loads = {{contact_.normal, force, crush}};
    double softness = 0;
    for (std::uint32_t id = 0; id < stones_.size(); ++id) {
      Stone& stone = stones_[id];
      if (!stone.crack && crush > stone.strength) stone.crack = dem::crack_of(id, time, loads);
      if (stone.crack && steps_ % dem::check_interval == 0) {
        const double share = 1 / stone.softness;
        const double target = dem::stiffness_share(rule_, *stone.crack, loads);
        if (target < share) stone.softness = 1 / (share + rule_.lag * (target - share));
      }
      softness += stone.softness / static_cast<double>(stones_.size());
    }
    contact_.softness = softness;
  }

  std::ptrdiff_t broken() const {
    return std::count_if(stones_.begin(), stones_.end(),
                         [](const Stone& stone) { return stone.crack.has_value(); });
  }

  Law law_;
  dem::Contact<double> contact_ = {};
  typename Law::template Memory<double> memory_ = {};
  std::vector<Stone> stones_;
  dem::FractureRule rule_;
  apps::PathPoint last_ = {};
  std::int64_t steps_ = 0;
};

template <class Law>
std::string table(const apps::PathCase& the_case, const Law& law) {
  std::string rows = "time_s,overlap_m,shear_m,force_N,binder_N,stone_N,shear_N,bonded,broken\n";
  Drive<Law> drive(the_case, law);
  for (const apps::PathPoint& point : the_case.path) rows += drive.step_to(point);
  return rows;
}

// Laws of dry stones that runs do not have.
template <class Law>
Law other_shear(const apps::DampedDry& dry) {
  return {dry.normal, dry.shear_modulus, dry.friction, dry.cover};
}

void follow(const apps::Options& options) {
  const apps::PathCase the_case = apps::read_path_case(options.scene, options.overrides);
  if (options.check) return;
  apps::Mix mix;
  mix.shell = the_case.shell;
  mix.bitumen_fraction = the_case.bitumen_fraction;
  apps::StonesScene stone = the_case.stone.value_or(apps::StonesScene{});
  if (the_case.shear != "force" && !stone.restitution) stone.restitution = 1;
  const apps::LawBook book(stone, the_case.binder, mix);
  constexpr double sticking = std::numeric_limits<double>::max();
  apps::Counterpart counterpart = {std::nullopt, the_case.stone ? stone.friction : sticking};
  if (the_case.at_wall()) counterpart.wall = the_case.wall.value_or(apps::rigid);

  using Damped = dem::Hertz<dem::Damping::restitution>;
  using WholeSpring = dem::Mindlin<Damped, dem::Carries::displacement>;
  const auto dry = [&] { return book.law<apps::DampedDry>(counterpart, false); };
  std::string rows;
  if (the_case.shear == "displacement") {
    rows = table(the_case, other_shear<WholeSpring>(dry()));
  } else if (the_case.shear == "rings") {
    rows = table(the_case, other_shear<dem::SlipRings<Damped>>(dry()));
  } else if (the_case.stone) {
    rows = apps::with_law(
        book, [&]<class Law>() { return table(the_case, book.law<Law>(counterpart, true)); });
  } else if (book.rings()) {
    rows = table(the_case, book.law<dem::Binder<2, apps::film_rings>>(counterpart, true));
  } else {
    using Shells = dem::Binder<apps::most_prony_terms>;
    rows = table(the_case, book.law<Shells>(counterpart, true));
  }
  apps::write_whole_file(options.out, rows);
}

}  // namespace

int main(int argc, char** argv) {
  const apps::Program program = {
      "Drives one contact along a path and writes its force as a table (CSV): force_N and its "
      "parts "
      "push the bodies apart, shear_N resists shear_m.",
      "path_forces.csv"};
  return apps::run_program(argc, argv, program, follow);
}

#include "apps/path_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "apps/laws.h"
#include "apps/sections.h"
#include "apps/text.h"

namespace apps {
namespace {

constexpr Unit millimetre{"mm", "m"}, megapascal{"MPa", "Pa"}, gigapascal{"GPa", "Pa"};
constexpr Unit second{"s", "s"}, energy_per_area{"J/mm2", "J/m2"}, density_unit{"kg/m3", "kg/m3"};
constexpr const char* header = "time_s,overlap_m,shear_m";

std::vector<Section> describe(PathCase& the_case, std::string& file) {
  BinderScene& binder = the_case.binder.emplace();
  binder.wall_bonds = true;  // of one contact everything is shown
  StonesScene& stone = the_case.stone.emplace();
  dem::Material& wall = the_case.wall.emplace(dem::Material{210e9, 0.3});
  Section fracture = describe(stone.fracture);
  fracture.name = "stone.fracture";
  fracture.parameters.push_back({&the_case.seed, "seed", pure, at_least(0),
                                 "of the strengths that the stones are given", ""});
  return {{"contact",
           "What meets what.",
           {{&the_case.kind,
             "kind",
             pure,
             unbounded,
             "of the contact",
             "",
             required("\"pair\""),
             {"pair", "wall"}},
            {&the_case.radius, "radius", millimetre, positive,
             "of the bare stones: two of a pair, one at a wall", "",
             required("[\"4 mm\", \"2.5 mm\"]")}}},
          {"binder",
           "The shells; absent: dry stones.",
           {{&the_case.shell, "shell_thickness", millimetre, positive, "of each shell", "",
             required("\"0.5 mm\"")},
            {&binder.shear_modulus, "shear_modulus", megapascal, shear_modulus_range,
             "G0, instantaneous", "", required("\"6.65 MPa\"")},
            {&binder.alpha, "alpha", pure, above_zero_to(1),
             "shares of G0 that relax if all of the phase is bitumen, sum at most 1", "",
             required("[0.513, 0.487]")},
            {&binder.tau, "tau", second, positive, "relaxation times, one for each alpha", "",
             required("[\"0.0948 s\", \"105.9 s\"]")},
            {&the_case.bitumen_fraction, "bitumen_fraction", pure, between(0, 1),
             "of the binder phase; alpha is multiplied by it", ""},
            {&binder.bond_energy, "bond_energy", energy_per_area, bond_energy_range,
             "work of separating two shells, per area", ""},
            {&binder.film,
             "film",
             pure,
             unbounded,
             "what a film forgets where its area shrinks: an even share of its shear, or ring by "
             "ring what its rim has been sheared by",
             "",
             {},
             {"even", "rings"}}},
           [&the_case] { the_case.binder.reset(); }},
          {"stone",
           "The stones inside; absent: none is met.",
           {{&stone.young, "young", gigapascal, young_range, "Young's modulus", ""},
            {&stone.poisson, "poisson", pure, poisson_range, "Poisson's ratio", ""},
            {&stone.friction, "friction", pure, friction_range,
             "Coulomb coefficient of stones, and of the film on a wall", ""},
            {&stone.density, "density", density_unit, positive, "what damping is scaled with", ""},
            {&stone.restitution, "restitution", pure, restitution_range,
             "speed after / before a dry impact; absent: no damping", "", optional("0.5")},
            {&the_case.shear,
             "shear",
             pure,
             unbounded,
             "what carries the shear: a spring that keeps its force, as in a run, or its "
             "displacement, as in other codes; or rings that slip one by one, as Mindlin's exact "
             "solution",
             "",
             {},
             {"force", "displacement", "rings"}}},
           [&the_case] { the_case.stone.reset(); }},
          std::move(fracture),
          {"wall",
           "What a wall is made of; absent: rigid.",
           {{&wall.young, "young", gigapascal, positive, "Young's modulus", ""},
            {&wall.poisson, "poisson", pure, poisson_range, "Poisson's ratio", ""}},
           [&the_case] { the_case.wall.reset(); }},
          {"path",
           "How the contact moves.",
           {{&file, "file", pure, unbounded,
             std::string("table with the header ") + header + ", from the folder of the case", "",
             required("\"path.csv\"")}}}};
}

class CaseCheck {
 public:
  CaseCheck(const Document& document, Mistakes& mistakes)
      : document_(document), mistakes_(mistakes) {}

  void check(const PathCase& the_case) const {
    const std::size_t bodies = the_case.at_wall() ? 1 : 2;
    if (!the_case.radius.empty() && the_case.radius.size() != bodies)
      refuse("contact.radius", bodies == 1 ? "one radius" : "two radii",
             "give two radii for a pair, one for a wall");
    if (!given("binder") && !given("stone"))
      mistakes_.add({document_.path, 1, 1}, "a section [binder] or [stone]", "neither",
                    "add what the contact is made of");
    if (given("stone.fracture") && !given("stone"))
      refuse("stone.fracture", "a section [stone] beside it", "add [stone]");
    if (given("wall") && !the_case.at_wall())
      refuse("wall", "kind = \"wall\"", "remove the section, or change the kind");
    if (document_.find("stone.restitution") && (given("binder") || given("stone.fracture")))
      refuse("stone.restitution", "no restitution where stones have binder or may break",
             "remove it, binder and fracture dissipate by themselves");
    if (the_case.shear != "force" && (given("binder") || given("stone.fracture")))
      refuse("stone.shear", "\"force\" where stones have binder or may break",
             "remove it, or the sections [binder] and [stone.fracture]");
    if (the_case.binder) check(*the_case.binder);
    if (the_case.binder && !the_case.radius.empty() &&
        the_case.shell > thickest_shell * std::ranges::min(the_case.radius))
      refuse("binder.shell_thickness", "a shell no thicker than 1.25 x the smaller stone's radius",
             "lower it, or raise contact.radius");
  }

  Place place(const std::string& key) const { return document_.place(key); }

 private:
  bool given(const std::string& section) const { return document_.sections.contains(section); }

  void check(const BinderScene& binder) const {
    if (binder.alpha.empty() || binder.tau.empty()) return;
    if (binder.alpha.size() != binder.tau.size())
      refuse("binder.tau", "one tau for each alpha", "make the two lists equally long");
    if (binder.alpha.size() > most_prony_terms)
      refuse("binder.alpha", "at most " + std::to_string(most_prony_terms) + " Prony terms",
             "leave out the least weights");
    if (binder.film == "rings" && binder.alpha.size() > 2)
      mistakes_.add(place("binder.film"), "at most 2 Prony terms with rings",
                    std::to_string(binder.alpha.size()), "take \"even\", or leave out terms");
    constexpr double rounding = 1e-9;  // of decimals that sum to 1
    if (std::accumulate(binder.alpha.begin(), binder.alpha.end(), 0.0) > 1 + rounding)
      refuse("binder.alpha", "alpha with a sum of at most 1",
             "lower them: no more than the whole modulus can relax");
  }

  void refuse(const std::string& key, const std::string& expected,
              const std::string& advice) const {
    const Value* value = document_.find(key);
    mistakes_.add(place(key), "for " + key + ' ' + expected, value ? value->written : "otherwise",
                  advice);
  }

  const Document& document_;
  Mistakes& mistakes_;
};

// The three numbers of a row; the mistake is added otherwise.
std::optional<PathPoint> point_of(const std::string& line, const Place& place, Mistakes& mistakes) {
  std::vector<double> numbers;
  std::size_t from = 0;
  while (from <= line.size()) {
    const std::size_t to = std::min(line.find(',', from), line.size());
    const std::string field = trimmed(line.substr(from, to - from));
    double number = 0;
    const char* end = field.data() + field.size();
    const auto [rest, error] = std::from_chars(field.data(), end, number);
    if (error != std::errc() || rest != end || !std::isfinite(number)) break;
    numbers.push_back(number);
    from = to + 1;
  }
  if (from <= line.size() || numbers.size() != 3) {
    mistakes.add(place, std::string("three numbers, ") + header, '"' + line + '"',
                 "write one row for each evaluation, in s and m");
    return std::nullopt;
  }
  return PathPoint{numbers[0], numbers[1], numbers[2]};
}

}  // namespace

std::vector<PathPoint> read_path(const std::string& file, const Place& asked, Mistakes& mistakes) {
  std::vector<PathPoint> path;
  const std::optional<std::string> text = read_text(file);
  if (!text) {
    mistakes.add(asked, "a path", "no file to read at " + file,
                 "give the path from the folder of the case");
    return path;
  }
  constexpr int most_shown = 10;  // more of the same would bury the rest
  bool headed = false;
  int number = 0, wrong = 0;
  for (std::size_t begin = 0; begin < text->size();) {
    const std::size_t end = std::min(text->find('\n', begin), text->size());
    const std::string line = trimmed(text->substr(begin, end - begin));
    const Place place{file, ++number, 1};
    begin = end + 1;
    if (line.empty() || line.front() == '#') continue;
    if (!headed) {
      headed = true;
      if (line == header) continue;
      mistakes.add(place, std::string("the header ") + header, '"' + line + '"',
                   "put the header before the first row");
      return path;
    }
    const std::optional<PathPoint> point = point_of(line, place, mistakes);
    if (!point) {
      if (++wrong == most_shown) return path;
      continue;
    }
    if (!path.empty() && point->time < path.back().time)
      mistakes.add(place, "a time not before that of the row above", '"' + line + '"',
                   "order the rows by time; equal times are a jump");
    path.push_back(*point);
  }
  if (path.empty() && wrong == 0)
    mistakes.add({file, number, 1}, "rows of " + std::string(header), "none", "add some");
  return path;
}

PathCase read_path_case(const std::string& path, const std::vector<std::string>& overrides) {
  const UnitSystem units;
  Mistakes mistakes;
  const Document document = read_document(path, overrides, mistakes);
  PathCase the_case;
  std::string file;
  read_sections(describe(the_case, file), document, units, mistakes);
  const CaseCheck cross(document, mistakes);
  cross.check(the_case);
  if (!file.empty())
    the_case.path =
        read_path(document.path_from("path.file", file), cross.place("path.file"), mistakes);
  if (!the_case.path.empty() && !the_case.radius.empty()) {
    const double most = std::ranges::min(the_case.radius) + the_case.shell;
    const double found = std::ranges::max(the_case.path, {}, &PathPoint::overlap).overlap;
    if (found > most)
      mistakes.add(
          cross.place("path.file"),
          fmt::format("for path.file overlaps of at most {:g} m, the smaller radius", most),
          fmt::format("{:g} m", found), "write metres");
  }
  if (mistakes.any()) throw InputError(mistakes.lines());
  return the_case;
}

}  // namespace apps

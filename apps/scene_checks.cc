#include "apps/scene_checks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "apps/binder_table.h"
#include "apps/sections.h"
#include "apps/sieve_table.h"
#include "dem/gradation.h"

namespace apps {
namespace {

class CrossCheck {
 public:
  CrossCheck(const Document& document, Mistakes& mistakes)
      : document_(document), mistakes_(mistakes) {}

  void check(StonesScene& stones) const {
    if (!sound("stones.gradation") || stones.gradation.empty()) return;
    stones.gradation = document_.path_from("stones.gradation", stones.gradation);
    Mistakes in_table;
    stones.sieves = read_sieve_table(stones.gradation, place("stones.gradation"), in_table);
    mistakes_.add(in_table);
    if (in_table.any() || !sound("stones.smallest")) return;
    const std::vector<double>& sieve = stones.sieves.sieve;
    if (stones.smallest < sieve.front() || stones.smallest >= sieve.back() ||
        dem::passing_at(stones.sieves, stones.smallest) >= 1)
      refuse("stones.smallest", "a size within its table that not all of the mix passes",
             "choose one within " + stones.gradation);
  }

  void check(BinderScene& binder) const {
    if (given("binder.temperature")) {
      for (const char* key : {"binder.shear_modulus", "binder.alpha", "binder.tau"})
        exclude("binder.temperature", key);
      if (binder.temperature) take_row(binder);
      return;
    }
    for (const char* key : {"binder.shear_modulus", "binder.alpha", "binder.tau"}) {
      if (!given(key) && !document_.in_part)
        mistakes_.add(place(key), "the key " + std::string(key), "none",
                      "add it, or in place of all three temperature = \"150 degC\"");
    }
    if (binder.alpha.empty() || binder.tau.empty()) return;
    if (binder.tau.size() != binder.alpha.size())
      refuse("binder.tau",
             "one tau for each of the " + std::to_string(binder.alpha.size()) + " alpha",
             "make the two lists equally long");
    constexpr double rounding = 1e-9;  // of decimals that sum to 1
    if (std::accumulate(binder.alpha.begin(), binder.alpha.end(), 0.0) > 1 + rounding)
      refuse("binder.alpha", "alpha with a sum of at most 1",
             "lower them: no more than the whole modulus can relax");
  }

  void check(const MouldScene& mould, const StonesScene& stones) const {
    exclude("mould.diameter", "mould.aspect_ratio");
    if (!given("mould.diameter") && !given("mould.aspect_ratio") && !document_.in_part)
      mistakes_.add(place("mould"), "mould.diameter or mould.aspect_ratio", "neither",
                    "add diameter = \"150 mm\", or aspect_ratio = 1 to scale it to the stones");
    if (mould.diameter) larger_than_stones("mould.diameter", *mould.diameter, stones);
    if (mould.elastic) whole_above_one("mould.elastic.modes", mould.elastic->modes);
  }

  void check(const HeadScene& head) const {
    if (!head.elastic) return;
    whole_above_one("head.elastic.modes", head.elastic->modes);
    if (given("head.mass"))
      mistakes_.add(document_.find("head.mass")->key, "either head.mass or [head.elastic]", "both",
                    "remove the mass: an elastic head has that of its steel");
  }

  void check(const GaugeScene& gauge, const std::string& section, const MouldScene& mould) const {
    if (!mould.elastic) {
      if (document_.in_part) return;
      mistakes_.add(place(section), "[mould.elastic], which a gauge is glued to", "a rigid mould",
                    "add that section, or remove the gauge");
      return;
    }
    if (sound(section + ".height") && sound("mould.elastic.height") &&
        gauge.height >= mould.elastic->height)
      refuse(section + ".height", "a height below that of the mould", "lower it");
  }

  // Maps are averaged from row to row.
  void check_rows_of_maps(const GyratoryScene& scene) const {
    if (!scene.maps || !sound("output.history_interval") || !sound("gyration.speed")) return;
    const double rows = 1 / (scene.gyration.speed * scene.output.history_interval);
    constexpr double rounding = 1e-6;
    if (std::round(rows) < 1 || std::abs(rows - std::round(rows)) > rounding * rows)
      refuse("output.history_interval", "a whole number of rows in a gyration, for output.maps",
             "make it a whole part of a gyration's time, 1 / gyration.speed");
  }

  void check(const FlowScene& flow, const StonesScene& stones) const {
    if (sound("flow.strip_length") && sound("flow.length") && flow.strip_length >= flow.length)
      refuse("flow.strip_length", "a strip shorter than the box",
             "make it less than flow.length, so that the mix can flow out");
    if (sound("flow.displacement") && sound("flow.height") && flow.displacement >= flow.height)
      refuse("flow.displacement", "a displacement below the height of the box",
             "make it less than flow.height");
    larger_than_stones("flow.length", flow.length, stones);
    larger_than_stones("flow.width", flow.width, stones);
    larger_than_stones("flow.height", flow.height, stones);
  }

 private:
  bool given(const std::string& key) const { return document_.find(key) != nullptr; }
  Place place(const std::string& key) const { return document_.place(key); }

  // Not refused already: what is wrong in itself is not compared with anything.
  bool sound(const std::string& key) const {
    const Value* value = document_.find(key);
    return !value ||
           (!std::holds_alternative<Broken>(value->content) && !mistakes_.any_at(value->place));
  }

  void refuse(const std::string& key, const std::string& expected,
              const std::string& advice) const {
    const Value* value = document_.find(key);
    mistakes_.add(place(key), "for " + key + ' ' + expected, value ? value->written : "its default",
                  advice);
  }

  void whole_above_one(const std::string& key, double modes) const {
    if (sound(key) && modes >= 1 && modes != std::floor(modes))
      refuse(key, "a whole number, or a share below 1", "write 20 or \"1e-3\"");
  }

  void exclude(const std::string& first, const std::string& second) const {
    if (given(first) && given(second))
      mistakes_.add(document_.find(second)->key, "either " + first + " or " + second, "both",
                    "remove one of the two");
  }

  void larger_than_stones(const std::string& key, double length, const StonesScene& stones) const {
    const auto& [sieve, passing] = stones.sieves;
    const auto all = std::ranges::find(passing, 1.0);  // the first that the largest stone passes
    if (sound(key) && all != passing.end() && length <= sieve[all - passing.begin()])
      refuse(key, "more than the first sieve that all stones pass",
             "make it several times the largest stone");
  }

  void take_row(BinderScene& binder) const {
    constexpr double rounding = 1e-6;  // of a conversion from degC [K]
    for (const BinderRow& row : binder_table) {
      if (std::abs(*binder.temperature - row.temperature) > rounding) continue;
      binder.shear_modulus = row.shear_modulus;
      binder.alpha.assign(row.alpha.begin(), row.alpha.end());
      binder.tau.assign(row.tau.begin(), row.tau.end());
      return;
    }
    refuse("binder.temperature", "110 degC or 150 degC, the rows of the table",
           "for another temperature give shear_modulus, alpha and tau instead");
  }

  const Document& document_;
  Mistakes& mistakes_;
};

}  // namespace

void check(GyratoryScene& scene, const Document& document, Mistakes& mistakes) {
  const CrossCheck cross(document, mistakes);
  cross.check(scene.stones);
  if (scene.binder) cross.check(*scene.binder);
  cross.check(scene.mould, scene.stones);
  cross.check(scene.head);
  for (std::size_t i = 0; i < scene.gauges.size(); ++i)
    cross.check(scene.gauges[i], gauge_section(i), scene.mould);
  cross.check_rows_of_maps(scene);
}

void check(FlowTestScene& scene, const Document& document, Mistakes& mistakes) {
  const CrossCheck cross(document, mistakes);
  cross.check(scene.stones);
  if (scene.binder) cross.check(*scene.binder);
  cross.check(scene.flow, scene.stones);
}

}  // namespace apps

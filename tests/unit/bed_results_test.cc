// What results.h5 tells of a bed, against what the bed itself holds.
#include "apps/bed_results.h"

#include <gtest/gtest.h>

#include <map>

#include "apps/laws.h"
#include "apps/time_budget.h"

namespace {

using apps::Dry;

Dry law() {
  const dem::Material soft = {1e8, 0.2};
  return {{1 / (2 * dem::normal_compliance(soft))}, 1 / (2 * dem::shear_compliance(soft)), 0.5};
}

// A stone upon another upon a floor, and one that touches nothing.
dem::Simulation<Dry> pile() {
  dem::Settings settings;
  settings.largest_step = 1e-6;
  settings.skin = 0.1e-3;
  const double r = 2e-3;
  dem::Simulation<Dry> bed(
      dem::make_stones({{0, 0, 0.999 * r}, {0.1 * r, 0, 2.99 * r}, {0.05, 0, 0.1}}, {r, r, r},
                       {2650}, 1),
      law(), settings);
  dem::Wall floor;
  floor.surface = dem::Plane{};
  bed.add_wall(floor, law());
  for (int step = 0; step < 10; ++step) bed.step();
  return bed;
}

std::map<std::string, std::vector<double>> by_name(const apps::Table& table) {
  std::map<std::string, std::vector<double>> found;
  for (const apps::TableColumn& column : table) found[column.name] = column.values;
  return found;
}

// Newton's third law: with its weight, the forces of the tables are those that move each stone.
// 1e-12 is rounding.
TEST(bed_results, tell_all_forces_on_a_stone) {
  const dem::Simulation<Dry> bed = pile();
  auto pairs = by_name(apps::table_of_contacts(bed));
  auto walls = by_name(apps::table_of_wall_contacts(bed));
  ASSERT_EQ(pairs["first"].size(), 1u);
  ASSERT_EQ(walls["stone"].size(), 1u);
  EXPECT_EQ(walls["wall"][0], 0);
  EXPECT_GT(pairs["normal_force"][0], 0);
  EXPECT_LT(walls["force_z"][0], 0);  // the stone presses the floor down
  const dem::ParticleStore& stones = bed.stones();
  for (std::size_t k = 0; k < stones.size(); ++k) {
    const double id = stones.id[k];
    double force = -stones.mass[k] * bed.gravity();
    if (pairs["first"][0] == id) force += pairs["force_z"][0];
    if (pairs["second"][0] == id) force -= pairs["force_z"][0];
    if (walls["stone"][0] == id) force -= walls["force_z"][0];
    EXPECT_NEAR(force, stones.load[k].force.z, 1e-12 * std::abs(walls["force_z"][0])) << id;
  }
}

TEST(bed_results, list_stones_by_their_ids) {
  dem::ParticleStore stones =
      dem::make_stones({{1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {1, 1, 1}, {2650}, 1);
  dem::reorder(stones, {2, 0, 1});
  auto table = by_name(apps::table_of_stones(stones, {20, 0, 10}));
  EXPECT_EQ(table["x"], (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(table["coordination"], (std::vector<double>{0, 10, 20}));
  EXPECT_EQ(table["stiffness_share"], (std::vector<double>{1, 1, 1}));
}

TEST(bed_results, count_fractures_from_the_beginning_of_the_history) {
  auto table = by_name(apps::table_of_fractures({{7, 3.5, 1e6, {0, 0, 1}, 120}}, 3));
  EXPECT_EQ(table["stone"], std::vector<double>{7});
  EXPECT_EQ(table["time"], std::vector<double>{0.5});
  EXPECT_EQ(table["force"], std::vector<double>{120});
}

TEST(time_budget, shares_out_the_time_steps_by_those_that_were_timed) {
  apps::TimeBudget budget;
  EXPECT_EQ(budget.enter(apps::TimeBudget::stepping), apps::TimeBudget::other);
  const double began = apps::wall_clock();
  while (apps::wall_clock() < began + 0.01) continue;
  budget.sample(apps::TimeBudget::stones, 3);
  budget.sample(apps::TimeBudget::steel, 1);
  EXPECT_EQ(budget.enter(apps::TimeBudget::other), apps::TimeBudget::stepping);
  const double stepping = budget.seconds(apps::TimeBudget::stepping);
  EXPECT_GE(stepping, 0.01);
  for (const apps::Finding& finding : budget.findings()) {
    const double share = finding.key == "seconds_stones"  ? 0.75
                         : finding.key == "seconds_steel" ? 0.25
                                                          : 0;
    if (finding.key == "seconds_other") continue;
    EXPECT_DOUBLE_EQ(std::get<double>(finding.value), share * stepping) << finding.key;
  }
}

}  // namespace

#include "dem/neighbor_list.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "dem/random.h"

namespace dem {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

constexpr double skin = 1e-3;  // [m], as wide as the smallest stone, to be noticed

double number(int seed, std::uint32_t id, std::uint32_t draw) {
  return uniform(seed, Purpose::position, id, draw);
}

struct Stones {
  std::vector<Vec3d> position;
  std::vector<double> radius;
  std::vector<std::uint32_t> id;
  std::vector<double> extra = {};

  Spheres spheres() const { return {position, radius, id, extra}; }
};

// A permutation of 0 ... count - 1.
std::vector<std::uint32_t> shuffled(int count, int seed) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t k) { return number(seed, k, 9); });
  return order;
}

// Radii from 1 to 8 mm, uniform in their logarithm, in a cube that they fill `filling` times over,
// stored in an order that is not that of the ids. Some fly far off.
Stones random_stones(int count, double filling, int outliers, int seed) {
  Stones stones;
  double volume = 0;
  for (int k = 0; k < count; ++k) {
    stones.radius.push_back(1e-3 * std::pow(8.0, number(seed, k, 0)));
    volume += 4.2 * std::pow(stones.radius.back(), 3);
  }
  const double side = std::cbrt(volume / filling);
  for (int k = 0; k < count; ++k) {
    const double scale = k < outliers ? 1e4 * side : side;
    stones.position.push_back(scale * Vec3d{number(seed, k, 1) - 0.5, number(seed, k, 2) - 0.5,
                                            number(seed, k, 3) - 0.5});
  }
  stones.id = shuffled(count, seed);
  return stones;
}

Stones in_order(const Stones& stones, const std::vector<std::uint32_t>& order) {
  Stones moved;
  for (const std::uint32_t k : order) {
    moved.position.push_back(stones.position[k]);
    moved.radius.push_back(stones.radius[k]);
    moved.id.push_back(stones.id[k]);
  }
  return moved;
}

StonePair oriented(const Stones& s, std::uint32_t i, std::uint32_t j) {
  return comes_first(s.radius[i], s.id[i], s.radius[j], s.id[j]) ? StonePair{i, j}
                                                                 : StonePair{j, i};
}

// Every pair against every other, in the order of the slots.
Pairs by_brute_force(const Stones& s) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < s.id.size(); ++i) {
    for (std::uint32_t j = 0; j < i; ++j) {
      const double extra = s.extra.empty() ? 0 : s.extra[i] + s.extra[j];
      if (norm(s.position[i] - s.position[j]) < s.radius[i] + s.radius[j] + skin + extra) {
        const StonePair pair = oriented(s, i, j);
        pairs.emplace_back(pair.first, pair.second);
      }
    }
  }
  std::ranges::sort(pairs);
  return pairs;
}

Pairs pairs_of(const NeighborList& list) {
  Pairs pairs;
  for (std::size_t slot = 0; slot < list.first.size(); ++slot) {
    pairs.emplace_back(list.first[slot], list.second[slot]);
  }
  return pairs;
}

Pairs with_ids(const Pairs& pairs, const Stones& stones) {
  Pairs named;
  for (const auto& [first, second] : pairs) named.emplace_back(stones.id[first], stones.id[second]);
  return named;
}

NeighborList list_of(const Stones& stones) {
  NeighborList list;
  list.build(stones.spheres(), skin);
  return list;
}

TEST(neighbor_list, it_holds_the_pairs_of_a_search_of_all_against_all) {
  // Reference: the slow and obvious search, slot by slot.
  for (const int count : {1, 2, 3, 10, 100, 700, 2000}) {
    for (const double filling : {0.001, 0.3, 0.6, 5.0}) {
      for (int seed = 0; seed < 3; ++seed) {
        const Stones stones = random_stones(count, filling, count / 100, seed);
        EXPECT_EQ(pairs_of(list_of(stones)), by_brute_force(stones))
            << count << " stones, filling " << filling << ", seed " << seed;
      }
    }
  }
}

TEST(neighbor_list, it_stays_complete_while_stones_move) {
  // Reference: the slow and obvious search, over small moves that the stock of candidates covers
  // and large ones that it does not.
  Stones stones = random_stones(700, 0.6, 5, 1);
  NeighborList list;
  int searches = 0;
  for (int n = 0; n < 40; ++n) {
    const std::vector<Vec3d> stock = list.candidates.position;
    list.build(stones.spheres(), skin);
    ASSERT_EQ(pairs_of(list), by_brute_force(stones)) << "after " << n << " moves";
    searches += stock.empty() || norm(stock[0] - list.candidates.position[0]) > 0;
    for (std::uint32_t k = 0; k < 700; ++k)
      stones.position[k] +=
          (n % 10 == 9 ? 8 : 0.3) * skin * Vec3d{number(n, k, 1), number(n, k, 2), number(n, k, 3)};
  }
  EXPECT_GT(searches, 3);
  EXPECT_LT(searches, 20);
}

TEST(neighbor_list, it_stays_complete_while_few_stones_stray_without_a_search_for_all) {
  // Reference: the slow and obvious search. As many of 700 stones stray as may without a search.
  Stones stones = random_stones(700, 0.6, 5, 1);
  NeighborList list = list_of(stones);
  const std::vector<Vec3d> stock = list.candidates.position;
  const double side = 2 * norm(stones.position[0] - stones.position[1]);
  for (int n = 0; n < 20; ++n) {
    for (const std::uint32_t k : {3, 77, 310, 311, 699})
      stones.position[k] = stones.position[n] + side * Vec3d{number(n, k, 1), number(n, k, 2), 0};
    list.build(stones.spheres(), skin);
    ASSERT_EQ(pairs_of(list), by_brute_force(stones)) << "after " << n << " moves";
    ASSERT_EQ(norm(list.candidates.position[3] - stock[3]), 0);
  }
}

TEST(neighbor_list, it_holds_what_fast_stones_may_reach) {
  // Reference: the slow and obvious search; the extras are wider than the stock of candidates.
  Stones stones = random_stones(700, 0.1, 0, 1);
  stones.extra.assign(700, 0.5 * skin);
  for (const std::uint32_t k : {3, 77, 310}) stones.extra[k] = 20 * skin;
  EXPECT_EQ(pairs_of(list_of(stones)), by_brute_force(stones));
}

TEST(neighbor_list, stones_all_in_one_place_are_all_neighbors) {
  // Closed form: n (n - 1) / 2 pairs.
  Stones stones = random_stones(300, 1, 0, 1);
  std::ranges::fill(stones.position, Vec3d{1, 2, 3});
  EXPECT_EQ(list_of(stones).first.size(), 300u * 299u / 2u);
}

TEST(neighbor_list, a_stone_whose_place_is_not_a_number_has_no_neighbors) {
  // From the definition: no distance to it is below any limit; the others keep their pairs.
  Stones stones = random_stones(200, 0.6, 0, 1);
  stones.position[17].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(pairs_of(list_of(stones)), by_brute_force(stones));
}

TEST(neighbor_list, rows_begin_where_row_start_says) {
  // From the definition of the rows.
  const Stones stones = random_stones(500, 0.6, 0, 1);
  const NeighborList list = list_of(stones);
  ASSERT_EQ(list.row_start.size(), 501u);
  EXPECT_EQ(list.row_start.front(), 0u);
  EXPECT_EQ(list.row_start.back(), list.first.size());
  for (std::uint32_t i = 0; i < 500; ++i) {
    for (std::uint32_t slot = list.row_start[i]; slot < list.row_start[i + 1]; ++slot) {
      ASSERT_EQ(list.first[slot], i);
    }
  }
}

TEST(neighbor_list, the_orientation_of_a_pair_does_not_depend_on_the_store) {
  // Reference: the same stones in another order give the same pairs of ids.
  const Stones stones = random_stones(1000, 0.6, 0, 1);
  const Stones moved = in_order(stones, shuffled(1000, 5));
  Pairs before = with_ids(pairs_of(list_of(stones)), stones);
  Pairs after = with_ids(pairs_of(list_of(moved)), moved);
  std::ranges::sort(before);
  std::ranges::sort(after);
  EXPECT_EQ(before, after);
}

TEST(neighbor_list, pairs_to_keep_stay_however_far_apart) {
  // Reference: the union of the near pairs and the kept ones, each once.
  const Stones stones = random_stones(400, 0.5, 4, 1);
  std::vector<StonePair> keep;
  Pairs expected = by_brute_force(stones);
  for (int k = 0; k < 50; ++k) keep.push_back({expected[k].first, expected[k].second});
  for (std::uint32_t k = 0; k < 200; ++k) {
    const StonePair pair = oriented(stones, k, 399 - k);
    keep.push_back(pair);
    expected.emplace_back(pair.first, pair.second);
  }
  std::ranges::sort(expected);
  expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
  NeighborList list;
  list.build(stones.spheres(), skin, keep);
  EXPECT_EQ(pairs_of(list), expected);
}

// The pair of stone ids in each slot must be the one of its previous slot, if it had one.
void expect_same_pairs(const Pairs& now, const Pairs& before, const NeighborList& list) {
  ASSERT_EQ(list.previous.size(), now.size());
  int carried = 0, fresh = 0;
  for (std::size_t slot = 0; slot < now.size(); ++slot) {
    const auto found = std::ranges::find(before, now[slot]);
    const std::ptrdiff_t expected = found == before.end() ? -1 : found - before.begin();
    ASSERT_EQ(list.previous[slot], expected);
    ++(expected < 0 ? fresh : carried);
  }
  EXPECT_GT(carried, 0);
  EXPECT_GT(fresh, 0);
}

void shake(Stones& stones) {
  for (std::uint32_t k = 0; k < stones.id.size(); ++k) {
    stones.position[k] += 1e-3 * Vec3d{number(8, k, 1), number(8, k, 2), number(8, k, 3)};
  }
}

TEST(neighbor_list, a_slot_knows_the_slot_of_its_pair_in_the_list_before) {
  // Reference: a search for the pair of ids in the whole list before; also in a reordered store.
  for (const bool reordered : {false, true}) {
    Stones stones = random_stones(800, 0.6, 0, 1);
    NeighborList list = list_of(stones);
    EXPECT_EQ(list.previous, std::vector<std::int32_t>(list.first.size(), -1));
    const Pairs before = with_ids(pairs_of(list), stones);
    shake(stones);
    std::vector<std::uint32_t> order;
    if (reordered) {
      order = shuffled(800, 6);
      stones = in_order(stones, order);
    }
    list.build(stones.spheres(), skin, {}, order);
    expect_same_pairs(with_ids(pairs_of(list), stones), before, list);
  }
}

TEST(neighbor_list, slot_of_finds_each_pair_and_no_other) {
  // From the definition.
  const Stones stones = random_stones(200, 0.6, 0, 1);
  const NeighborList list = list_of(stones);
  const Pairs pairs = pairs_of(list);
  for (std::uint32_t i = 0; i < 200; ++i) {
    for (std::uint32_t j = 0; j < 200; ++j) {
      const auto found = std::ranges::find(pairs, std::pair(i, j));
      ASSERT_EQ(list.slot_of(i, j), found == pairs.end() ? -1 : found - pairs.begin());
    }
  }
}

TEST(neighbor_list, the_number_of_threads_changes_nothing) {
  // From the promise: same bits for any thread count.
  const Stones stones = random_stones(3000, 0.6, 5, 1);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  NeighborList one = list_of(stones);
  one.build(stones.spheres(), skin);
  for (const int count : {2, 3, 7}) {
    omp_set_num_threads(count);
    NeighborList many = list_of(stones);
    many.build(stones.spheres(), skin);
    EXPECT_EQ(one.row_start, many.row_start);
    EXPECT_EQ(one.first, many.first);
    EXPECT_EQ(one.second, many.second);
    EXPECT_EQ(one.previous, many.previous);
  }
  omp_set_num_threads(threads);
}

}  // namespace
}  // namespace dem

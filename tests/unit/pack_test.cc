#include "dem/pack.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "dem/laws/binder.h"
#include "dem/laws/fracture.h"
#include "dem/laws/mindlin.h"
#include "dem/laws/sum.h"
#include "dem/records.h"

namespace dem {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
const std::array<double, lanes> a_values = {-3, -0.0, 0, 1e-300, 2, 7, 1e300, inf};
const std::array<double, lanes> b_values = {2, 3, -1, 1e-300, 2, -7, 1e-300, 1};

const Pack a = load(a_values.data()), b = load(b_values.data());

TEST(pack, arithmetic_is_that_of_doubles_lane_by_lane) {
  // By definition: IEEE 754 in every lane, bit for bit.
  const Pack sum = a + b, difference = a - b, product = a * b, quotient = a / b, negative = -a;
  const Pack root = sqrt(a * a);
  for (int k = 0; k < lanes; ++k) {
    EXPECT_EQ(sum[k], a_values[k] + b_values[k]);
    EXPECT_EQ(difference[k], a_values[k] - b_values[k]);
    EXPECT_EQ(product[k], a_values[k] * b_values[k]);
    EXPECT_EQ(quotient[k], a_values[k] / b_values[k]);
    EXPECT_EQ(negative[k], -a_values[k]);
    EXPECT_EQ(root[k], std::sqrt(a_values[k] * a_values[k]));
  }
}

TEST(pack, choices_are_those_of_doubles_lane_by_lane) {
  // By definition, equal values and both zeros included.
  for (int k = 0; k < lanes; ++k) {
    const double x = a_values[k], y = b_values[k];
    EXPECT_EQ(lane(a < b, k), x < y);
    EXPECT_EQ(lane(a > b, k), x > y);
    EXPECT_EQ(lane(a <= b, k), x <= y);
    EXPECT_EQ(lane((a < b) | (a > b), k), x != y);
    EXPECT_EQ(lane((a <= b) & !(a < b), k), x == y);
    EXPECT_EQ(larger(a, b)[k], larger(x, y));
    EXPECT_EQ(smaller(a, b)[k], smaller(x, y));
    EXPECT_EQ(magnitude(a)[k], std::abs(x));
    EXPECT_EQ(select(a < b, a, b)[k], x < y ? x : y);
  }
}

TEST(pack, any_sees_a_single_yes_in_every_lane) {
  // By definition.
  for (int k = 0; k < lanes; ++k) {
    Pack one(0.0);
    set_lane(one, k, 1);
    EXPECT_TRUE(any(one > Pack(0.5)));
    EXPECT_FALSE(any(one > Pack(1.5)));
  }
}

TEST(pack, lanes_below_a_count_are_the_first_ones) {
  // By definition, for counts below none and beyond all.
  for (int count : {-3, 0, 1, 5, 8, 100})
    for (int k = 0; k < lanes; ++k) EXPECT_EQ(lane(lanes_below<Pack>(count), k), k < count);
  EXPECT_TRUE(lanes_below<double>(1));
  EXPECT_FALSE(lanes_below<double>(0));
}

TEST(pack, gathering_reads_the_indexed_numbers) {
  // By definition, for the strides of scalars and of vectors.
  std::vector<double> numbers(300);
  for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = std::sin(double(k));
  const std::array<std::int32_t, lanes> index = {99, 0, 3, 3, 57, 98, 1, 42};
  for (int stride : {1, 3}) {
    const Pack read = gather<Pack>(numbers.data(), index.data(), stride);
    for (int k = 0; k < lanes; ++k) EXPECT_EQ(read[k], numbers[stride * index[k]]);
    EXPECT_EQ(gather<double>(numbers.data(), index.data(), stride), numbers[stride * index[0]]);
  }
}

// One random step of a contact, the same for a lane of a pack and for a double.
struct Draw {
  double overlap, closing, turn[3], sliding[2];
};

template <class T>
void set(Contact<T>& contact, int k, const Draw& draw) {
  set_lane(contact.overlap, k, draw.overlap);
  set_lane(contact.closing, k, draw.closing);
  set_lane(contact.sliding.x, k, draw.sliding[0]);
  set_lane(contact.sliding.y, k, draw.sliding[1]);
  set_lane(contact.turn.x, k, draw.turn[0]);
  set_lane(contact.turn.y, k, draw.turn[1]);
  set_lane(contact.turn.z, k, draw.turn[2]);
}

template <class T>
Contact<T> contact_at_rest() {
  Contact<T> contact;
  contact.outer_radius = T(1.2e-3);
  contact.stone_radius = T(1e-3);
  contact.mass = T(1e-4);
  contact.softness = T(1.5);
  contact.normal = {T(0.0), T(0.0), T(1.0)};
  contact.sliding = contact.turn = {T(0.0), T(0.0), T(0.0)};
  contact.overlap = contact.closing = T(0.0);
  contact.horizon = T(1e-5);
  return contact;
}

TEST(pack, a_contact_law_answers_eight_contacts_as_it_answers_one) {
  // Reference: the same law with T = double. The compiler fuses multiplications and additions of
  // the two differently, which costs a few units of the last place at each of 300 steps.
  using Law = Sum<Fracture<Mindlin<Hertz<Damping::restitution>>>, Binder<2>>;
  Law law = {{{{3.8e10, 0.3}, 8e9, 0.7, 1e-3}, 0.75},
             {6.65e6, {0.2, 0.3}, {0.09, 106}, 8.0 / 3, 1e-3, {1e3}}};
  law.set_time_step(1e-3);
  Contact<Pack> all = contact_at_rest<Pack>();
  Law::Memory<Pack> memory = {};
  std::array<Contact<double>, lanes> one;
  one.fill(contact_at_rest<double>());
  std::array<Law::Memory<double>, lanes> memories = {};
  std::mt19937 engine(1);
  const auto between = [&](double least, double most) {
    return least + (most - least) * engine() / 4294967295.0;
  };
  int held = 0, parted = 0;
  for (int n = 0; n < 300; ++n) {
    for (int k = 0; k < lanes; ++k) {
      const Draw draw = {between(-1.5e-3, 1.01e-3),
                         between(-1, 1),
                         {between(-1e-2, 1e-2), between(-1e-2, 1e-2), between(-1e-2, 1e-2)},
                         {between(-1e-5, 1e-5), between(-1e-5, 1e-5)}};
      set(all, k, draw);
      set(one[k], 0, draw);
    }
    const Response<Pack> together = law(all, memory);
    for (int k = 0; k < lanes; ++k) {
      const Response<double> alone = law(one[k], memories[k]);
      const double scale = 1e-12 * (1 + std::abs(alone.push) + norm(alone.shear));
      ASSERT_NEAR(together.push[k], alone.push, scale);
      ASSERT_NEAR(together.stone[k], alone.stone, scale);
      ASSERT_NEAR(together.shear.x[k], alone.shear.x, scale);
      ASSERT_NEAR(together.shear.y[k], alone.shear.y, scale);
      ASSERT_NEAR(together.stiffness[k], alone.stiffness, 1e-12 * alone.stiffness);
      ASSERT_EQ(lane(Law::holds<Pack>(memory), k), bool(Law::holds<double>(memories[k])));
      (Law::holds<double>(memories[k]) ? held : parted) += 1;
    }
  }
  EXPECT_GT(held, 500);
  EXPECT_GT(parted, 200);
}

TEST(pack, reciprocal_roots_are_right_to_the_last_bits) {
  // Reference: 1 / sqrt; and the same bits one at a time as eight at a time.
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> exponent(-290, 290);
  for (int n = 0; n < 10000; ++n) {
    Pack x;
    for (int k = 0; k < lanes; ++k) x.value[k] = std::pow(10, exponent(engine));
    const Pack root = reciprocal_root(x);
    for (int k = 0; k < lanes; ++k) {
      ASSERT_NEAR(root[k] * std::sqrt(x[k]), 1, 1e-15) << x[k];
      ASSERT_EQ(root[k], reciprocal_root(double{x[k]}));
    }
  }
  EXPECT_EQ(fast_root(0.0), 0);
}

TEST(records, vectors_and_loads_keep_their_numbers) {
  // By definition: lane k is record k.
  Vectors vectors;
  for (int k = 0; k < 20; ++k) vectors.push_back({1.0 * k, 100.0 + k, 200.0 + k});
  const std::array<std::int32_t, lanes> index = {19, 0, 7, 7, 3, 11, 18, 1};
  const Vec3<Pack> found = gather<Pack>(vectors, index.data());
  for (int k = 0; k < lanes; ++k) {
    EXPECT_EQ(found.x[k], index[k]);
    EXPECT_EQ(found.y[k], 100 + index[k]);
    EXPECT_EQ(found.z[k], 200 + index[k]);
  }
  const std::array<std::int32_t, lanes> other = {0, 19, 7, 8, 4, 1, 18, 2};
  const Vec3<Pack> apart = gather_difference<Pack>(vectors, index.data(), other.data());
  for (int k = 0; k < lanes; ++k) {
    EXPECT_EQ(apart.x[k], index[k] - other[k]);
    EXPECT_EQ(apart.y[k], index[k] - other[k]);
    EXPECT_EQ(apart.z[k], index[k] - other[k]);
  }
  Pack fourth;
  for (int k = 0; k < lanes; ++k) set_lane(fourth, k, 300 + index[k]);
  alignas(64) Quad quad[lanes];
  quads(found, fourth, quad);
  for (int k = 0; k < lanes; ++k)
    for (int n = 0; n < 4; ++n) EXPECT_EQ(quad[quad_place(k)][n], 100 * n + index[k]);
  EXPECT_EQ(joined<false>(quad[0], quad[1])[3], quad[0][3] + quad[1][3]);
  EXPECT_EQ(joined<true>(quad[0], quad[1])[3], std::max(quad[0][3], quad[1][3]));
  EXPECT_EQ(joined<true>(quad[0], quad[1])[2], quad[0][2] + quad[1][2]);
}

}  // namespace
}  // namespace dem

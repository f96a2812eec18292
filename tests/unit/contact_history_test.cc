#include "dem/contact_history.h"

#include <gtest/gtest.h>

#include <vector>

#include "dem/laws/binder.h"
#include "dem/laws/mindlin.h"
#include "dem/laws/sum.h"

namespace dem {
namespace {

using Law = Sum<Mindlin<>, Binder<2>>;
using History = ContactHistory<Law>;

// A memory whose every number tells its slot.
History::Slot marked(int slot) {
  History::Slot memory;
  double* number = reinterpret_cast<double*>(&memory);
  for (int m = 0; m < History::numbers; ++m) number[m] = 100.0 * slot + m + 1;
  return memory;
}

bool same(const History::Slot& a, const History::Slot& b) {
  return __builtin_memcmp(&a, &b, sizeof a) == 0;
}

History filled(int slots) {
  History history;
  history.resize(slots);
  for (int s = 0; s < slots; ++s) history.set(s, marked(s));
  return history;
}

TEST(contact_history, a_slot_gives_back_what_was_put_into_it) {
  // By definition, over full blocks and a started one.
  const History history = filled(21);
  for (int s = 0; s < 21; ++s) EXPECT_TRUE(same(history.slot(s), marked(s)));
}

TEST(contact_history, a_block_holds_member_by_member_what_its_slots_hold) {
  // From the layout: member m of slot 8 b + k is lane k of number m of block b.
  History history = filled(16);
  EXPECT_EQ(history.block(1).b.bonded[3], history.slot(11).b.bonded);
  EXPECT_EQ(history.block(0).a.compliance[7], history.slot(7).a.compliance);
  EXPECT_EQ(history.block(1).b.ring[0].shear[1].z[0], history.slot(8).b.ring[0].shear[1].z);
  set_lane(history.block(1).b.push[1], 2, -5);
  EXPECT_EQ(history.slot(10).b.push[1], -5);
}

TEST(contact_history, a_rebuilt_list_takes_over_the_memories_of_its_contacts) {
  // By definition: previous[s] is the old slot of the same contact, -1 for a new one.
  History history = filled(10);
  const std::vector<std::int32_t> previous = {9, -1, 0, 4, -1, -1, 2, 8, 7, 1, -1, 3};
  history.carry(previous);
  for (std::size_t s = 0; s < previous.size(); ++s)
    EXPECT_TRUE(same(history.slot(s), previous[s] < 0 ? History::Slot{} : marked(previous[s])));
}

TEST(contact_history, the_raw_numbers_are_all_there_is) {
  // A checkpoint is the raw numbers and nothing else.
  const History history = filled(13);
  History restored;
  restored.resize(13);
  ASSERT_EQ(restored.raw().size(), history.raw().size());
  std::copy(history.raw().begin(), history.raw().end(), restored.raw().begin());
  for (int s = 0; s < 13; ++s) EXPECT_TRUE(same(restored.slot(s), history.slot(s)));
}

TEST(contact_history, it_knows_which_contacts_live_on_without_touching) {
  // From the law: bonded shells hold.
  History history;
  history.resize(9);
  History::Slot bonded = {};
  bonded.b.bonded = 1;
  history.set(8, bonded);
  EXPECT_TRUE(history.holds(8));
  EXPECT_FALSE(history.holds(7));
}

}  // namespace
}  // namespace dem

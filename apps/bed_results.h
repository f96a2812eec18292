// The bed of stones as it is, for those who look at it later: groups of results.h5, written anew
// with every picture. A group is a table, one dataset a column.
//
//   /filling        while the bed comes to rest, and until the history begins: for those who watch
//   /stones         by id: places, share of its stiffness that a stone has left, touching stones
//   /contacts       between stones that push or pull: ids, force on the first [N]
//   /wall_contacts  number of the wall in the order of its program (gyratory: floor, mould, head;
//                   flow_test: floor, left, right, front, back, strip), id, force on the wall [N]
//   /fractures      the stones that broke and when, from the beginning of the history
#pragma once

#include <string>
#include <vector>

#include "apps/recorder.h"
#include "dem/observe.h"
#include "dem/simulation.h"

namespace apps {

struct TableColumn {
  std::string name, unit;
  std::vector<double> values = {};
};
using Table = std::vector<TableColumn>;

void write_table(Recorder& recorder, const std::string& group, const Table& table);

Table table_of_stones(const dem::ParticleStore& stones, const std::vector<int>& coordination);
Table table_of_fractures(const std::vector<dem::Crack>& cracks, double history_began);

// A row of three numbers in the columns from `column` on.
void put_vector(Table& table, std::size_t column, const dem::Vec3d& vector);

template <class Law>
Table table_of_contacts(const dem::Simulation<Law>& bed) {
  Table table = {{"first", "1"},   {"second", "1"},  {"force_x", "N"},
                 {"force_y", "N"}, {"force_z", "N"}, {"normal_force", "N"}};
  const dem::ParticleStore& stones = bed.stones();
  const std::vector<dem::SlotForce> forces = bed.pairs().forces(stones);
  for (std::size_t s = 0; s < forces.size(); ++s) {
    const dem::Vec3d& force = forces[s].force;
    if (dot(force, force) == 0) continue;
    const std::int32_t i = bed.pairs().first(s), j = bed.pairs().second(s);
    const dem::Vec3d apart = stones.position[i] - stones.position[j];
    table[0].values.push_back(stones.id[i]);
    table[1].values.push_back(stones.id[j]);
    put_vector(table, 2, force);
    table[5].values.push_back(dot(force, apart) / norm(apart));
  }
  return table;
}

template <class Law>
Table table_of_wall_contacts(const dem::Simulation<Law>& bed) {
  Table table = {{"wall", "1"},    {"stone", "1"},   {"x", "m"},
                 {"y", "m"},       {"z", "m"},       {"force_x", "N"},
                 {"force_y", "N"}, {"force_z", "N"}, {"normal_force", "N"}};
  for (std::size_t w = 0; w < bed.walls().size(); ++w) {
    const dem::WallContacts<Law>& contacts = bed.wall_contacts(w);
    for (std::int64_t s = 0; s < contacts.slots(); ++s) {
      const auto& touch = contacts.touch(s);
      if (dot(touch.action.force, touch.action.force) == 0) continue;
      table[0].values.push_back(static_cast<double>(w));
      table[1].values.push_back(bed.stones().id[contacts.stones[s]]);
      put_vector(table, 2, touch.point);
      put_vector(table, 5, -touch.action.force);
      table[8].values.push_back(touch.push);
    }
  }
  return table;
}

template <class Law>
void write_bed(Recorder& recorder, const dem::Simulation<Law>& bed, double history_began) {
  write_table(recorder, "/stones",
              table_of_stones(bed.stones(), dem::coordination(bed.pairs(), bed.stones())));
  write_table(recorder, "/contacts", table_of_contacts(bed));
  write_table(recorder, "/wall_contacts", table_of_wall_contacts(bed));
  write_table(recorder, "/fractures", table_of_fractures(bed.cracks(), history_began));
}

// What a bed does before its history begins.
class FillingHistory {
 public:
  // A row: time [s], height [m], kinetic energy [J] of the bed under a pressure [Pa].
  void record(Recorder& recorder, double time, const dem::ParticleStore& stones, double pressure);

  // See dem/state.h.
  template <class Visit>
  void visit_state(Visit& visit) {
    visit("filling.time", time_);
    visit("filling.height", height_);
    visit("filling.energy", energy_);
    visit("filling.pressure", pressure_);
  }

 private:
  std::vector<double> time_, height_, energy_, pressure_;
};

}  // namespace apps

#include "apps/bed_results.h"

#include "apps/bed.h"

namespace apps {

void write_table(Recorder& recorder, const std::string& group, const Table& table) {
  for (const TableColumn& column : table)
    recorder.write(group + '/' + column.name, column.values, column.unit);
}

void put_vector(Table& table, std::size_t column, const dem::Vec3d& vector) {
  table[column].values.push_back(vector.x);
  table[column + 1].values.push_back(vector.y);
  table[column + 2].values.push_back(vector.z);
}

Table table_of_stones(const dem::ParticleStore& stones, const std::vector<int>& coordination) {
  Table table = {
      {"x", "m"}, {"y", "m"}, {"z", "m"}, {"stiffness_share", "1"}, {"coordination", "1"}};
  for (TableColumn& column : table) column.values.resize(stones.size());
  for (std::size_t k = 0; k < stones.size(); ++k) {
    const std::uint32_t id = stones.id[k];
    const dem::Vec3d& place = stones.position[k];
    table[0].values[id] = place.x;
    table[1].values[id] = place.y;
    table[2].values[id] = place.z;
    table[3].values[id] = stones.softness.empty() ? 1 : 1 / stones.softness[k];
    table[4].values[id] = coordination[k];
  }
  return table;
}

Table table_of_fractures(const std::vector<dem::Crack>& cracks, double history_began) {
  Table table = {{"stone", "1"}, {"time", "s"}, {"force", "N"}};
  for (const dem::Crack& crack : cracks) {
    table[0].values.push_back(crack.stone);
    table[1].values.push_back(crack.time - history_began);
    table[2].values.push_back(crack.force);
  }
  return table;
}

void FillingHistory::record(Recorder& recorder, double time, const dem::ParticleStore& stones,
                            double pressure) {
  time_.push_back(time);
  height_.push_back(dem::mean_of_highest(stones, highest_points));
  energy_.push_back(dem::kinetic_energy(stones));
  pressure_.push_back(pressure);
  recorder.write("/filling/time", time_, "s");
  recorder.write("/filling/height", height_, "m");
  recorder.write("/filling/kinetic_energy", energy_, "J");
  recorder.write("/filling/pressure", pressure_, "Pa");
}

}  // namespace apps

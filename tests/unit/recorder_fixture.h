// A folder for results and what a reader that knows nothing of the recorder finds in them.
#pragma once

#include <gtest/gtest.h>
#include <hdf5.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "apps/recorder.h"

namespace tests {

class RecorderTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("recorder_test_" + std::to_string(::getpid())) / test->name();
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }

  void TearDown() override { std::filesystem::remove_all(folder_.parent_path()); }

  std::string file(const std::string& name = "results.h5") const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

inline const std::vector<apps::Column> columns = {
    {"time", "s"}, {"air_voids", "1"}, {"force", "N"}};

inline apps::Provenance provenance() {
  apps::Provenance from;
  from.program = "gyratory";
  from.command_line = "gyratory scene.toml --set run.seed=7";
  from.scene_text = "[run]\nseed = 3  # Körnung äöü\n";
  from.seed = 7;
  from.threads = 2;
  return from;
}

inline void append_rows(apps::Recorder& recorder, int first, int last) {
  for (int i = first; i < last; ++i)
    recorder.append(std::vector<double>{0.01 * i, 0.3 - 1e-5 * i, std::sqrt(2.0 * i)});
}

inline std::vector<double> read(const std::string& path, const char* dataset) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t data = H5Dopen2(file, dataset, H5P_DEFAULT);
  const hid_t space = H5Dget_space(data);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  EXPECT_GE(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Sclose(space);
  H5Dclose(data);
  H5Fclose(file);
  return values;
}

inline std::string read_text(const std::string& path, const char* object, const char* attribute) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t found = H5Aopen_by_name(file, object, attribute, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t type = H5Aget_type(found);
  char* text = nullptr;
  EXPECT_GE(H5Aread(found, type, &text), 0);
  const std::string copy = text;
  H5free_memory(text);
  H5Tclose(type);
  H5Aclose(found);
  H5Fclose(file);
  return copy;
}

}  // namespace tests

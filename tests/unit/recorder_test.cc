#include "apps/recorder.h"

#include <signal.h>
#include <sys/resource.h>

#include <ctime>
#include <limits>

#include "apps/errors.h"
#include "tests/unit/recorder_fixture.h"

namespace {

using apps::Provenance;
using apps::Recorder;
using tests::append_rows, tests::columns, tests::provenance, tests::read, tests::read_text;
using tests::RecorderTest;

std::time_t time_stamp(const std::string& path, const char* dataset) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  H5O_info_t about{};
  EXPECT_GE(H5Oget_info_by_name(file, dataset, &about, H5P_DEFAULT), 0);
  H5Fclose(file);
  return about.ctime;
}

std::string bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(RecorderTest, every_row_comes_back_bit_by_bit_under_its_name_and_unit) {
  // Closed form of the rows in append_rows; float64 in, float64 out: no rounding is allowed.
  {
    Recorder recorder(file(), provenance(), columns);
    append_rows(recorder, 0, 1300);
    EXPECT_EQ(recorder.rows(), 1300u);
  }
  const auto time = read(file(), "/history/time"), force = read(file(), "/history/force");
  ASSERT_EQ(time.size(), 1300u);
  ASSERT_EQ(force.size(), 1300u);
  for (int i = 0; i < 1300; ++i) {
    EXPECT_EQ(time[i], 0.01 * i);
    EXPECT_EQ(force[i], std::sqrt(2.0 * i));
  }
  EXPECT_EQ(read_text(file(), "/history/time", "unit"), "s");
  EXPECT_EQ(read_text(file(), "/history/force", "unit"), "N");
}

TEST_F(RecorderTest, the_provenance_keeps_scene_and_command_line_letter_by_letter) {
  // The scene is UTF-8 with line ends; it must come back as it was read.
  { Recorder recorder(file(), provenance(), columns); }
  EXPECT_EQ(read_text(file(), "/provenance", "scene"), provenance().scene_text);
  EXPECT_EQ(read_text(file(), "/provenance", "command_line"), provenance().command_line);
  EXPECT_EQ(read_text(file(), "/provenance", "overrides"), "");
}

TEST_F(RecorderTest, a_scene_longer_than_a_plain_attribute_is_kept_whole) {
  // Attributes of HDF5 held in an object header end at 64 KiB (HDF5 User's Guide, 8.5).
  Provenance large = provenance();
  large.scene_text.assign(200'000, 'x');
  { Recorder recorder(file(), large, columns); }
  EXPECT_EQ(read_text(file(), "/provenance", "scene"), large.scene_text);
}

TEST_F(RecorderTest, flushed_rows_are_readable_while_the_run_goes_on) {
  // The file on the disk is complete after each flush, and does not move in between.
  Recorder recorder(file(), provenance(), columns);
  append_rows(recorder, 0, 7);
  EXPECT_EQ(read(file(), "/history/time").size(), 0u);
  recorder.flush();
  append_rows(recorder, 7, 2000);
  EXPECT_EQ(read(file(), "/history/time").size(), 7u);
  recorder.flush();
  EXPECT_EQ(read(file(), "/history/time").size(), 2000u);
}

TEST_F(RecorderTest, the_same_run_flushed_at_the_same_rows_gives_the_same_bytes) {
  // Nothing in the file may come from the clock or from memory that was never written.
  for (const char* name : {"one.h5", "two.h5"}) {
    Recorder recorder(file(name), provenance(), columns);
    append_rows(recorder, 0, 700);
    recorder.flush();
    append_rows(recorder, 700, 900);
    recorder.write("/stones/radius", std::vector<double>{1e-3, 2e-3}, "m");
  }
  EXPECT_TRUE(bytes(file("one.h5")) == bytes(file("two.h5")));
  EXPECT_FALSE(bytes(file("one.h5")).empty());
}

TEST_F(RecorderTest, no_result_is_stamped_with_the_time_of_its_creation) {
  // HDF5 stamps datasets, in seconds, unless told not to; without a stamp it reports zero.
  {
    Recorder recorder(file(), provenance(), columns);
    recorder.write("/stones/radius", std::vector<double>{1e-3}, "m");
  }
  EXPECT_EQ(time_stamp(file(), "/history/time"), 0);
  EXPECT_EQ(time_stamp(file(), "/stones/radius"), 0);
}

TEST_F(RecorderTest, a_row_with_a_nan_is_refused_whole_and_its_column_is_named) {
  // Promise of the recorder: what is in a history is a number.
  Recorder recorder(file(), provenance(), columns);
  append_rows(recorder, 0, 3);
  try {
    recorder.append(std::vector<double>{0.03, std::nan(""), 1});
    FAIL() << "a NaN was recorded";
  } catch (const apps::NotANumber& trouble) {
    EXPECT_STREQ(trouble.what(), "/history/air_voids is nan in row 3");
  }
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_THROW(recorder.append(std::vector<double>{0.03, 0.3, infinite}), apps::NotANumber);
  EXPECT_THROW(recorder.write("/stones/radius", std::vector<double>{std::nan("")}, "m"),
               apps::NotANumber);
  recorder.flush();
  for (const char* dataset : {"/history/time", "/history/air_voids", "/history/force"})
    EXPECT_EQ(read(file(), dataset).size(), 3u);
}

TEST_F(RecorderTest, results_that_exist_are_never_overwritten) {
  // Whatever the older file holds, a second run refuses and leaves its bytes alone.
  { Recorder recorder(file(), provenance(), columns); }
  const std::string before = bytes(file());
  EXPECT_THROW(Recorder(file(), provenance(), columns), apps::OutputError);
  EXPECT_TRUE(bytes(file()) == before);
}

TEST_F(RecorderTest, a_folder_that_is_not_there_is_an_output_error) {
  // ENOENT of open(2).
  EXPECT_THROW(Recorder(file("missing/results.h5"), provenance(), columns), apps::OutputError);
}

// Lets no file of this process grow beyond `bytes`, as a full disk would.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_F(RecorderTest, a_full_disk_is_an_output_error_and_the_last_good_file_stays) {
  // write(2) fails beyond the file size limit (setrlimit(2)) as it does without space.
  Recorder recorder(file(), provenance(), columns);
  append_rows(recorder, 0, 10);
  recorder.flush();
  append_rows(recorder, 10, 5000);
  {
    const FullDisk full(32 * 1024);
    EXPECT_THROW(recorder.flush(), apps::OutputError);
  }
  EXPECT_EQ(read(file(), "/history/time").size(), 10u);
  EXPECT_FALSE(std::filesystem::exists(file("results.h5.part")));
  recorder.flush();
  EXPECT_EQ(read(file(), "/history/time").size(), 5000u);
}

TEST_F(RecorderTest, a_run_that_cannot_begin_for_a_full_disk_leaves_no_file) {
  // Otherwise the empty file would be taken for results when space is there again.
  const FullDisk full(0);
  EXPECT_THROW(Recorder(file(), provenance(), columns), apps::OutputError);
  EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(RecorderTest, a_result_written_twice_is_the_second_one) {
  // Stones at the end of a continued run replace those of the first attempt.
  {
    Recorder recorder(file(), provenance(), columns);
    recorder.write("/stones/radius", std::vector<double>{1, 2, 3}, "m");
    recorder.write("/stones/radius", std::vector<double>{4, 5}, "mm");
    recorder.write("/stones/none", {}, "m");
  }
  EXPECT_EQ(read(file(), "/stones/radius"), (std::vector<double>{4, 5}));
  EXPECT_EQ(read_text(file(), "/stones/radius", "unit"), "mm");
  EXPECT_TRUE(read(file(), "/stones/none").empty());
}

}  // namespace

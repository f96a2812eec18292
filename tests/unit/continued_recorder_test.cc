#include <fstream>

#include "apps/errors.h"
#include "tests/unit/recorder_fixture.h"

namespace {

using apps::Recorder;
using tests::append_rows, tests::columns, tests::provenance, tests::read, tests::read_text;

using ContinuedRecorder = tests::RecorderTest;

TEST_F(ContinuedRecorder, a_continued_run_ends_with_the_rows_of_an_unbroken_one) {
  // Whether the file held rows beyond the checkpoint or not.
  for (const int reached : {600, 700, 1400}) {
    const std::string broken = file(std::to_string(reached) + ".h5");
    {
      Recorder recorder(broken, provenance(), columns);
      append_rows(recorder, 0, reached);
    }
    {
      Recorder continued(broken, columns, 600);
      EXPECT_EQ(continued.rows(), 600u);
      append_rows(continued, 600, 1500);
      continued.flush();
      EXPECT_EQ(continued.replaced(), 0u);
    }
    const std::string unbroken = file("unbroken" + std::to_string(reached) + ".h5");
    {
      Recorder recorder(unbroken, provenance(), columns);
      append_rows(recorder, 0, 1500);
    }
    for (const char* dataset : {"/history/time", "/history/air_voids", "/history/force"})
      EXPECT_EQ(read(broken, dataset), read(unbroken, dataset)) << dataset;
    EXPECT_EQ(read_text(broken, "/provenance", "scene"), provenance().scene_text);
  }
}

TEST_F(ContinuedRecorder, a_history_never_loses_rows_while_a_run_catches_up) {
  // A reader sees the rows of the interrupted run until they are found again.
  {
    Recorder broken(file(), provenance(), columns);
    append_rows(broken, 0, 1500);
  }
  Recorder continued(file(), columns, 600);
  append_rows(continued, 600, 1100);
  continued.flush();
  EXPECT_EQ(read(file(), "/history/time").size(), 1500u);
}

TEST_F(ContinuedRecorder, a_row_that_is_found_otherwise_is_replaced_and_counted) {
  {
    Recorder broken(file(), provenance(), columns);
    append_rows(broken, 0, 20);
  }
  Recorder continued(file(), columns, 10);
  append_rows(continued, 10, 12);
  continued.append(std::vector<double>{0.12, 0.5, 3});
  append_rows(continued, 13, 20);
  continued.flush();
  EXPECT_EQ(continued.replaced(), 1u);
  EXPECT_EQ(read(file(), "/history/air_voids")[12], 0.5);
}

TEST_F(ContinuedRecorder, a_run_that_does_not_fit_its_earlier_file_is_not_continued) {
  // Too few rows, another unit, a column unknown to the file, no HDF5 at all.
  {
    Recorder recorder(file(), provenance(), columns);
    append_rows(recorder, 0, 5);
  }
  std::ofstream(file("text.h5")) << "no results\n";
  EXPECT_THROW(Recorder(file(), columns, 6), apps::OutputError);
  EXPECT_THROW(Recorder(file(), {{"time", "min"}}, 5), apps::OutputError);
  EXPECT_THROW(Recorder(file(), {{"height", "m"}}, 5), apps::OutputError);
  EXPECT_THROW(Recorder(file("text.h5"), columns, 5), apps::OutputError);
  EXPECT_EQ(read(file(), "/history/time").size(), 5u);
}

}  // namespace

#include "apps/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace {

using apps::Progress;

constexpr bool terminal = true, quiet = true;

// A run whose clock the test turns.
struct Watched {
  double now = 0;  // [s]
  std::ostringstream out;
  Progress progress;

  Watched(bool on_terminal, bool is_quiet)
      : progress(out, on_terminal, is_quiet, [this] { return now; }) {}

  long lines() const {
    const std::string text = out.str();
    return std::count(text.begin(), text.end(), '\n');
  }
};

TEST(progress, time_to_go_follows_from_the_time_taken) {
  // Rule of three: a quarter took 30 s, three quarters take 90 s.
  Watched run(!terminal, !quiet);
  run.progress.report(0, "gyration 0");
  run.now = 30;
  run.progress.report(0.25, "gyration 25");
  EXPECT_EQ(run.out.str(), "  0 %  gyration 0\n 25 %  gyration 25  1 min 30 s to go\n");
}

TEST(progress, a_continued_run_counts_only_its_own_part) {
  // From one half to three quarters in 1800 s: the last quarter takes 1800 s, not 600 s.
  Watched run(!terminal, !quiet);
  run.progress.report(0.5, "");
  run.now = 1800;
  run.progress.report(0.75, "height 0.1150 m");
  EXPECT_NE(run.out.str().find(" 75 %  height 0.1150 m  30 min 00 s to go\n"), std::string::npos);
}

TEST(progress, hours_are_told_in_hours) {
  // 1 % in 100 s leaves 99 * 100 s = 2 h 45 min.
  Watched run(!terminal, !quiet);
  run.progress.report(0, "");
  run.now = 100;
  run.progress.report(0.01, "");
  EXPECT_NE(run.out.str().find("2 h 45 min to go"), std::string::npos);
}

TEST(progress, plain_lines_come_at_most_every_ten_seconds) {
  // 100 s of reports every 0.5 s: one line at 0, 10, ..., 100 s.
  Watched run(!terminal, !quiet);
  for (int i = 0; i <= 200; ++i) {
    run.now = 0.5 * i;
    run.progress.report(i / 200.0, "x");
  }
  run.progress.finish();
  EXPECT_EQ(run.lines(), 11);
  EXPECT_EQ(run.out.str().find('\r'), std::string::npos);
}

TEST(progress, a_terminal_line_is_rewritten_in_place_and_ended_once) {
  // One line end in all, and the line was begun anew for every report 0.1 s or more after the last.
  Watched run(terminal, !quiet);
  for (int i = 0; i < 4; ++i) {
    run.now = 0.25 * i;
    run.progress.report(0.25 * i, "x");
  }
  run.progress.finish();
  run.progress.finish();
  const std::string text = run.out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 4);
  EXPECT_EQ(run.lines(), 1);
  EXPECT_EQ(text.back(), '\n');
}

TEST(progress, the_last_report_is_always_seen) {
  // It came 1 s after the one before, and was held back until the end.
  Watched run(!terminal, !quiet);
  run.progress.report(0, "first");
  run.now = 1;
  run.progress.report(1, "last");
  EXPECT_EQ(run.out.str().find("last"), std::string::npos);
  run.progress.finish();
  EXPECT_NE(run.out.str().find("100 %  last\n"), std::string::npos);
}

TEST(progress, a_quiet_run_says_nothing) {
  // The option's promise.
  Watched run(terminal, quiet);
  run.progress.report(0, "x");
  run.now = 100;
  run.progress.report(1, "x");
  run.progress.finish();
  EXPECT_TRUE(run.out.str().empty());
}

}  // namespace

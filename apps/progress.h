// The progress of a run in one line: how far, the text of the program, time to go.
// A terminal shows it in place; elsewhere it is a plain line now and then.
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "apps/clocks.h"

namespace apps {

class Progress {
 public:
  Progress(std::ostream& out, bool terminal, bool quiet,
           std::function<double()> clock = wall_clock);

  // `fraction` of the whole run that is done, 0 to 1. May be called as often as one likes.
  void report(double fraction, std::string_view text);
  // Shows the last report, should it have been held back, and ends the line.
  void finish();

 private:
  void show();

  std::ostream& out_;
  bool terminal_, quiet_;
  std::function<double()> clock_;           // [s]
  std::optional<double> start_, shown_at_;  // [s]
  double first_fraction_ = 0;  // of the first report: a continued run starts above zero
  std::string line_;           // last report, as it would be shown
  bool held_back_ = false;
};

}  // namespace apps

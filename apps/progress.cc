#include "apps/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <utility>

namespace apps {
namespace {

constexpr double terminal_interval = 0.1;  // between two looks of the line on a terminal [s]
constexpr double plain_interval = 10;      // between two plain lines [s]

// Without these a line wider than the terminal would break into several that are never rewritten.
constexpr const char* line_start = "\r\x1b[?7l";    // to the left edge, no wrapping
constexpr const char* line_end = "\x1b[K\x1b[?7h";  // erase the rest, wrap again

std::string duration(double seconds) {
  const auto total = static_cast<long long>(std::llround(seconds));
  const long long hours = total / 3600, minutes = total / 60 % 60;
  if (hours > 0) return fmt::format("{} h {:02} min", hours, minutes);
  if (minutes > 0) return fmt::format("{} min {:02} s", minutes, total % 60);
  return fmt::format("{} s", total);
}

}  // namespace

Progress::Progress(std::ostream& out, bool terminal, bool quiet, std::function<double()> clock)
    : out_(out), terminal_(terminal), quiet_(quiet), clock_(std::move(clock)) {}

void Progress::report(double fraction, std::string_view text) {
  if (quiet_) return;
  const double now = clock_();
  if (!start_) {
    start_ = now;
    first_fraction_ = fraction;
  }
  const double done = fraction - first_fraction_;
  const double left = done > 0 ? (now - *start_) * std::max(0.0, 1 - fraction) / done : 0;
  const int percent = static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0));
  line_ = fmt::format("{:3} %  {}", percent, text);
  if (done > 0 && fraction < 1) line_ += fmt::format("  {} to go", duration(left));
  held_back_ = true;
  const double interval = terminal_ ? terminal_interval : plain_interval;
  if (!shown_at_ || now - *shown_at_ >= interval) show();
}

void Progress::show() {
  if (terminal_)
    out_ << line_start << line_ << line_end << std::flush;
  else
    out_ << line_ << std::endl;
  shown_at_ = clock_();
  held_back_ = false;
}

void Progress::finish() {
  if (held_back_) show();
  if (terminal_ && shown_at_) out_ << std::endl;
  shown_at_.reset();
}

}  // namespace apps

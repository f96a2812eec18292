// The mistakes found in the user's files, gathered so that all are reported at once.
#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "apps/errors.h"

namespace apps {

// Where something was written: a file with line and column, or a --set option (line 0).
struct Place {
  std::string source;
  int line = 0, column = 0;  // from 1

  std::string text() const {
    if (line == 0) return source;
    return source + ':' + std::to_string(line) + ':' + std::to_string(column);
  }
  friend bool operator==(const Place&, const Place&) = default;
};

class Mistakes {
 public:
  // `advice` says what to do, as an order: "write it like ...".
  void add(const Place& place, const std::string& expected, const std::string& found,
           const std::string& advice) {
    found_.push_back(
        {place, place.text() + ": expected " + expected + ", found " + found + "; " + advice});
  }

  void add(const Mistakes& others) {
    found_.insert(found_.end(), others.found_.begin(), others.found_.end());
  }

  bool any() const { return !found_.empty(); }

  bool any_at(const Place& place) const {
    return std::ranges::any_of(found_, [&](const Mistake& m) { return m.place == place; });
  }

  // One line each, file by file from top to bottom.
  std::vector<std::string> lines() const {
    std::vector<std::string> sources;
    for (const Mistake& m : found_) {
      if (std::ranges::find(sources, m.place.source) == sources.end())
        sources.push_back(m.place.source);
    }
    std::vector<std::string> lines;
    for (const std::string& source : sources) {
      std::vector<Mistake> here;
      std::ranges::copy_if(found_, std::back_inserter(here),
                           [&](const Mistake& m) { return m.place.source == source; });
      std::ranges::stable_sort(here, {}, [](const Mistake& m) {
        return std::pair{m.place.line, m.place.column};
      });
      for (const Mistake& m : here) lines.push_back(m.line);
    }
    return lines;
  }

 private:
  struct Mistake {
    Place place;
    std::string line;
  };
  std::vector<Mistake> found_;
};

}  // namespace apps

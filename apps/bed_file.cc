#include "apps/bed_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <string_view>

#include "apps/text.h"
#include "dem/neighbor_list.h"

namespace apps {
namespace {

constexpr std::string_view header = "x,y,z,radius";

// The number that all of `text` is; nothing if it is something else.
std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

// A comment's cylinder radius, if it names one; the mistake is added if it is no radius.
void read_comment(const std::string& line, const Place& place, BedFile& bed, Mistakes& mistakes) {
  constexpr std::string_view key = "cylinder_radius=";
  const std::size_t at = line.find(key);
  if (at == std::string::npos) return;
  const std::size_t from = at + key.size();
  const std::string word = line.substr(from, line.find_first_of(" \t,;\r", from) - from);
  bed.cylinder_radius = number(word);
  if (bed.cylinder_radius && *bed.cylinder_radius > 0) return;
  mistakes.add({place.source, place.line, static_cast<int>(from) + 1}, "a radius in metres",
               '"' + word + '"', "write it like cylinder_radius=0.05");
}

void read_stone(const std::string& line, const Place& row, BedFile& bed, Mistakes& mistakes) {
  std::vector<double> values;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t to = std::min(line.find(',', from), line.size());
    const std::string field = trimmed(line.substr(from, to - from));
    const std::optional<double> value = number(field);
    if (!value) {
      mistakes.add({row.source, row.line, static_cast<int>(from) + 1}, "a number",
                   '"' + field + '"', "write x,y,z,radius in metres");
      return;
    }
    values.push_back(*value);
    from = to + 1;
  }
  if (values.size() != 4) {
    mistakes.add(row, "four columns, x,y,z,radius", std::to_string(values.size()),
                 "write one stone a row");
  } else if (values[3] <= 0) {
    mistakes.add(row, "a radius above zero", fmt::format("{}", values[3]), "mend the radius");
  } else {
    bed.position.push_back({values[0], values[1], values[2]});
    bed.radius.push_back(values[3]);
    bed.line.push_back(row.line);
  }
}

// The deepest overlap of a stone found so far [/ radius].
struct Deepest {
  double share = 0;
  std::size_t stone = 0;
  std::string other;
};

void report(const BedFile& bed, const Deepest& deepest, double most, Mistakes& mistakes) {
  if (deepest.share <= most) return;
  mistakes.add({bed.path, bed.line[deepest.stone], 1},
               fmt::format("overlaps of at most {} of the smaller radius", most),
               fmt::format("{:.3g} with {}", deepest.share, deepest.other),
               "give a settled bed, and its cylinder's radius");
}

}  // namespace

BedFile read_bed_file(const std::string& path, Mistakes& mistakes) {
  BedFile bed;
  bed.path = path;
  const std::optional<std::string> text = read_text(path);
  if (!text) {
    mistakes.add({path}, "a table of stones", "no file to read", "mend the path");
    return bed;
  }
  const std::string table = without_mark(*text);
  int number_of_line = 0;
  bool first = true;  // of the rows, which may be the header
  for (std::size_t begin = 0; begin < table.size();) {
    const std::size_t end = std::min(table.find('\n', begin), table.size());
    const std::string line = table.substr(begin, end - begin);
    begin = end + 1;
    const Place place = {path, ++number_of_line, 1};
    const std::string content = trimmed(line);
    if (content.empty()) continue;
    if (content.front() == '#') {
      read_comment(line, place, bed, mistakes);
      continue;
    }
    if (!first || content != header) read_stone(line, place, bed, mistakes);
    first = false;
  }
  if (bed.radius.empty() && !mistakes.any())
    mistakes.add({path, 1, 1}, "one stone or more", "none", "write x,y,z,radius in metres");
  return bed;
}

void check_overlaps(const BedFile& bed, double cylinder_radius, double most, Mistakes& mistakes) {
  if (bed.radius.empty()) return;
  std::vector<std::uint32_t> id(bed.radius.size());
  std::iota(id.begin(), id.end(), 0u);
  dem::NeighborList pairs;
  pairs.build({bed.position, bed.radius, id}, 0);
  Deepest stone, wall;
  for (std::size_t s = 0; s < pairs.first.size(); ++s) {
    const std::uint32_t i = pairs.first[s], j = pairs.second[s];
    const double overlap = bed.radius[i] + bed.radius[j] - norm(bed.position[i] - bed.position[j]);
    const double share = overlap / std::min(bed.radius[i], bed.radius[j]);
    if (share > stone.share)
      stone = {share, std::max(i, j),
               fmt::format("the stone of line {}", bed.line[std::min(i, j)])};
  }
  for (std::size_t k = 0; k < bed.radius.size(); ++k) {
    const dem::Vec3d& x = bed.position[k];
    const double floor = (bed.radius[k] - x.z) / bed.radius[k];
    const double mantle = (std::hypot(x.x, x.y) + bed.radius[k] - cylinder_radius) / bed.radius[k];
    if (floor > wall.share) wall = {floor, k, "the floor"};
    if (mantle > wall.share) wall = {mantle, k, "the cylinder"};
  }
  report(bed, stone, most, mistakes);
  report(bed, wall, most, mistakes);
}

}  // namespace apps

#include "apps/sieve_table.h"

#include <charconv>
#include <optional>
#include <vector>

#include "apps/text.h"

namespace apps {
namespace {

constexpr const char* header = "sieve_mm,passing_percent";
constexpr double metre_per_millimetre = 1e-3;
constexpr double whole_percent = 100;

struct Field {
  std::string text;
  Place place;
};

struct Row {
  Place place;
  std::vector<Field> fields;
};

// Without comment lines and empty lines.
std::vector<Row> rows_of(const std::string& text, const std::string& path) {
  std::vector<Row> rows;
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
    Row row{{path, number, 1}, {}};
    for (std::size_t from = 0; from <= line.size();) {
      const std::size_t to = std::min(line.find(',', from), line.size());
      const std::size_t word = std::min(line.find_first_not_of(" \t", from), to);
      row.fields.push_back(
          {trimmed(line.substr(from, to - from)), {path, number, static_cast<int>(word) + 1}});
      from = to + 1;
    }
    rows.push_back(row);
  }
  return rows;
}

std::string joined(const Row& row) {
  std::string text;
  for (const Field& field : row.fields) text += (text.empty() ? "" : ",") + field.text;
  return text;
}

// The number in a field, from 0 to `most`; the mistake is added otherwise.
std::optional<double> number(const Field& field, double most, const std::string& expected,
                             Mistakes& mistakes) {
  double value = 0;
  const char* end = field.text.data() + field.text.size();
  const auto [rest, error] = std::from_chars(field.text.data(), end, value);
  if (error != std::errc() || rest != end || !(value >= 0 && value <= most)) {
    mistakes.add(field.place, expected, '"' + field.text + '"',
                 "write the number alone, the header says its unit");
    return std::nullopt;
  }
  return value;
}

bool starts_as_number(const std::string& text) {
  double value = 0;
  return std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc();
}

}  // namespace

dem::SieveTable read_sieve_table(const std::string& path, const Place& asked, Mistakes& mistakes) {
  dem::SieveTable table;
  const std::optional<std::string> text = read_text(path);
  if (!text) {
    mistakes.add(asked, "a sieve table", "no file to read at " + path,
                 "give the path from the folder of the scene");
    return table;
  }
  std::vector<Row> rows = rows_of(without_mark(*text), path);
  const std::string first = rows.empty() ? "" : joined(rows.front());
  const bool is_row = starts_as_number(first);
  if (first != header) {
    const bool semicolons = first.find(';') != std::string::npos;
    const std::string found = rows.empty() ? "an empty file" : '"' + first + '"';
    mistakes.add(rows.empty() ? Place{path, 1, 1} : rows.front().place,
                 std::string("the header ") + header,
                 found + (semicolons ? " with semicolons" : ""),
                 semicolons ? "write commas between the columns, points in the numbers: 11.2,95"
                 : is_row   ? "put the header before the first row"
                            : "write it as the first row");
    if (semicolons) return table;  // no row has two columns then
  }
  if (!rows.empty() && !is_row) rows.erase(rows.begin());
  constexpr double coarsest = 1000;  // a wider opening [mm] was meant in another unit
  for (const Row& row : rows) {
    if (row.fields.size() != 2) {
      mistakes.add(row.place, "two columns, " + std::string(header),
                   std::to_string(row.fields.size()), "write one sieve a row, like 11.2,95");
      continue;
    }
    const auto sieve = number(row.fields[0], coarsest, "an opening up to 1000 mm", mistakes);
    const auto passing = number(row.fields[1], whole_percent, "a percentage up to 100", mistakes);
    if (!sieve || !passing) continue;
    const double before = table.sieve.empty() ? 0 : table.sieve.back();
    if (*sieve * metre_per_millimetre <= before) {
      mistakes.add(row.fields[0].place, "a sieve wider than the one before", row.fields[0].text,
                   "order the rows from the finest sieve to the coarsest");
    }
    if (!table.passing.empty() && *passing / whole_percent < table.passing.back()) {
      mistakes.add(row.fields[1].place, "no less passing than through the finer sieve before",
                   row.fields[1].text, "mend the percentage");
    }
    table.sieve.push_back(*sieve * metre_per_millimetre);
    table.passing.push_back(*passing / whole_percent);
  }
  const Place end = rows.empty() ? Place{path, 1, 1} : rows.back().place;
  if (table.sieve.size() < 2) {
    mistakes.add(end, "two sieves or more", std::to_string(table.sieve.size()), "add rows");
  } else if (table.passing.back() < 1) {
    mistakes.add(end, "a last row with 100 percent passing", joined(rows.back()),
                 "add the sieve that the largest stone passes");
  }
  return table;
}

}  // namespace apps

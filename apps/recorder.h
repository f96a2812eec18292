// results.h5 of a run: its histories row by row, its scene and where it came from.
// HDF5 through its C API, in the flavour the program was linked with.
//
// The file grows in memory and is written whole at each flush, so that what lies on the disk is
// always a complete HDF5 file. Histories are /history/<column>, float64, with an attribute `unit`;
// the provenance is the attributes of the group /provenance. Equal runs give equal data, and equal
// bytes where they are flushed at the same rows.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace apps {

struct Column {
  std::string name;  // dataset /history/<name>
  std::string unit;  // attribute "unit"
};

// What a result must carry to be trusted and repeated.
struct Provenance {
  std::string program, version, compiler, flags, host, command_line;
  std::string scene_text;  // the scene file as read
  std::string overrides;   // the --set options, one a line
  int seed = 0;
  int threads = 0;
};

// A result that is NaN or infinite: the run went wrong before, nothing of the row is kept.
struct NotANumber : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Recorder {
 public:
  // A new file; what cannot be written, or exists already, throws OutputError (exit status 4).
  Recorder(const std::string& path, const Provenance& provenance, std::vector<Column> columns);
  // The file of an earlier run, continued after its first `rows` rows. What it holds beyond them
  // stays, and is expected to be found again bit by bit (see `replaced`).
  Recorder(const std::string& path, std::vector<Column> columns, std::size_t rows);
  // Flushes; a failure is heard only from an explicit flush before.
  ~Recorder();
  Recorder(Recorder&&) noexcept;

  // One value per column, every one finite: otherwise NotANumber names the column.
  void append(std::span<const double> row);
  std::size_t rows() const;
  // Rows that a continued run has found otherwise than the file had them; they were replaced.
  std::size_t replaced() const;
  // Puts everything recorded so far on the disk, at the cost of writing the whole file: every few
  // seconds, and before a checkpoint. Throws OutputError and keeps the last good file.
  void flush();
  // A one-dimensional result outside the history, e.g. "/stones/radius"; written again it is
  // replaced.
  void write(const std::string& dataset, std::span<const double> values, const std::string& unit);

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace apps

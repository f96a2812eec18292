#include "apps/recorder.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "apps/hdf5_handle.h"
#include "apps/whole_file.h"

namespace apps {
namespace {

constexpr hsize_t chunk_rows = 512;                // rows of one column written at once
constexpr std::size_t memory_increment = 1 << 20;  // growth of the file in memory [byte]

Handle memory_driver() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "choose its driver");
  require(H5Pset_fapl_core(access, memory_increment, false), "keep a file in memory");
  return access;
}

Handle create_in_memory(const std::string& path) {
  silence_hdf5();
  const Handle access = memory_driver();
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "create a file"};
}

Handle read_into_memory(const std::string& path) {
  silence_hdf5();
  const Handle access = memory_driver();
  return {H5Fopen(path.c_str(), H5F_ACC_RDWR, access), H5Fclose, "read '" + path + "'"};
}

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make a text type");
  require(H5Tset_size(type, H5T_VARIABLE), "make a text type");
  require(H5Tset_cset(type, H5T_CSET_UTF8), "make a text type");
  return type;
}

void set_attribute(hid_t object, const char* name, hid_t type, const void* value) {
  const Handle scalar(H5Screate(H5S_SCALAR), H5Sclose, "make a scalar");
  const Handle attribute(H5Acreate2(object, name, type, scalar, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         std::string("create attribute ") + name);
  require(H5Awrite(attribute, type, value), std::string("write attribute ") + name);
}

void set_attribute(hid_t object, const char* name, const std::string& text) {
  const char* begin = text.c_str();
  set_attribute(object, name, text_type(), &begin);
}

void set_attribute(hid_t object, const char* name, int value) {
  set_attribute(object, name, H5T_NATIVE_INT, &value);
}

std::string unit_of(hid_t dataset) {
  const Handle attribute(H5Aopen(dataset, "unit", H5P_DEFAULT), H5Aclose, "find a unit");
  char* text = nullptr;
  require(H5Aread(attribute, text_type(), &text), "read a unit");
  const std::string unit = text;
  H5free_memory(text);
  return unit;
}

Handle create_dataset(hid_t file, const std::string& path, hid_t space, hid_t layout) {
  const Handle link(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "create a group");
  require(H5Pset_create_intermediate_group(link, 1), "create a group");
  require(H5Pset_obj_track_times(layout, false), "leave out the time of creation");
  return {H5Dcreate2(file, path.c_str(), H5T_IEEE_F64LE, space, link, layout, H5P_DEFAULT),
          H5Dclose, "create " + path};
}

std::string history_path(const Column& column) {
  return "/history/" + column.name;
}

Handle create_history(hid_t file, const Column& column) {
  const hsize_t none = 0, unlimited = H5S_UNLIMITED;
  const Handle space(H5Screate_simple(1, &none, &unlimited), H5Sclose, "make an extent");
  const Handle layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make a layout");
  require(H5Pset_chunk(layout, 1, &chunk_rows), "cut a history into chunks");
  require(H5Pset_fill_time(layout, H5D_FILL_TIME_ALLOC), "fill a history");
  Handle history = create_dataset(file, history_path(column), space, layout);
  set_attribute(history, "unit", column.unit);
  return history;
}

Handle open_history(hid_t file, const Column& column, const std::string& path) {
  const std::string name = history_path(column);
  Handle history(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose,
                 "find " + name + " in '" + path + "'");
  if (unit_of(history) != column.unit)
    throw OutputError("'" + path + "': " + name + " is in " + unit_of(history) + ", the run in " +
                      column.unit);
  return history;
}

hsize_t length(hid_t dataset) {
  const Handle space(H5Dget_space(dataset), H5Sclose, "measure a dataset");
  return static_cast<hsize_t>(H5Sget_simple_extent_npoints(space));
}

// The rows `start` to `start + count` of a dataset, in memory and in the file.
struct Rows {
  Handle memory, file;

  Rows(hid_t dataset, hsize_t start, hsize_t count)
      : memory(H5Screate_simple(1, &count, nullptr), H5Sclose, "make an extent"),
        file(H5Dget_space(dataset), H5Sclose, "measure a dataset") {
    require(H5Sselect_hyperslab(file, H5S_SELECT_SET, &start, nullptr, &count, nullptr),
            "choose rows");
  }
};

// Writes the values from row `start` on; marks in `changed` those that were there otherwise.
void put(hid_t dataset, hsize_t start, std::span<const double> values, std::vector<bool>& changed) {
  const hsize_t there = length(dataset), end = start + values.size();
  if (const hsize_t known = std::min(there, end); known > start) {
    std::vector<double> before(known - start);
    const Rows rows(dataset, start, before.size());
    require(H5Dread(dataset, H5T_NATIVE_DOUBLE, rows.memory, rows.file, H5P_DEFAULT, before.data()),
            "read a history");
    for (std::size_t k = 0; k < before.size(); ++k)
      if (std::memcmp(&before[k], &values[k], sizeof(double)) != 0) changed[k] = true;
  }
  if (end > there) require(H5Dset_extent(dataset, &end), "extend a history");
  const Rows rows(dataset, start, values.size());
  require(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, rows.memory, rows.file, H5P_DEFAULT, values.data()),
          "write a history");
}

void require_finite(double value, const std::string& dataset, std::size_t index) {
  if (std::isfinite(value)) return;
  throw NotANumber(dataset + " is " + std::to_string(value) + " in row " + std::to_string(index));
}

void record(hid_t file, const Provenance& provenance) {
  const Handle group(H5Gcreate2(file, "/provenance", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                     H5Gclose, "create /provenance");
  set_attribute(group, "program", provenance.program);
  set_attribute(group, "version", provenance.version);
  set_attribute(group, "compiler", provenance.compiler);
  set_attribute(group, "flags", provenance.flags);
  set_attribute(group, "host", provenance.host);
  set_attribute(group, "command_line", provenance.command_line);
  set_attribute(group, "scene", provenance.scene_text);
  set_attribute(group, "overrides", provenance.overrides);
  set_attribute(group, "seed", provenance.seed);
  set_attribute(group, "threads", provenance.threads);
}

}  // namespace

struct Recorder::File {
  std::string path;
  std::vector<Column> columns;
  Handle file;
  std::vector<Handle> histories;             // one per column
  std::vector<std::vector<double>> pending;  // per column, rows not yet in `histories`
  std::size_t rows = 0;
  std::size_t replaced = 0;
  bool on_disk = false;  // does the disk hold all that was recorded

  void settle() {
    const std::size_t count = pending.empty() ? 0 : pending.front().size();
    if (count == 0) return;
    std::vector<bool> changed(count);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      put(histories[c], rows - count, pending[c], changed);
      pending[c].clear();
    }
    replaced += static_cast<std::size_t>(std::ranges::count(changed, true));
  }
};

Recorder::Recorder(const std::string& path, const Provenance& provenance,
                   std::vector<Column> columns) {
  claim_new_file(path);
  file_ = std::make_unique<File>(File{path, std::move(columns), create_in_memory(path), {}, {}});
  record(file_->file, provenance);
  for (const Column& column : file_->columns)
    file_->histories.push_back(create_history(file_->file, column));
  file_->pending.resize(file_->columns.size());
  try {
    flush();
  } catch (const OutputError&) {
    std::remove(path.c_str());
    throw;
  }
}

Recorder::Recorder(const std::string& path, std::vector<Column> columns, std::size_t rows)
    : file_(new File{path, std::move(columns), read_into_memory(path), {}, {}, rows}) {
  const hsize_t wanted = rows;
  for (const Column& column : file_->columns) {
    const Handle& history = file_->histories.emplace_back(open_history(file_->file, column, path));
    if (length(history) < wanted)
      throw OutputError("'" + path + "' holds " + std::to_string(length(history)) + " rows of " +
                        column.name + ", the run to be continued had " + std::to_string(rows));
  }
  file_->pending.resize(file_->columns.size());
}

Recorder::Recorder(Recorder&&) noexcept = default;

Recorder::~Recorder() {
  if (!file_) return;
  try {
    flush();
  } catch (const OutputError&) {
    return;
  }
}

void Recorder::append(std::span<const double> row) {
  File& file = *file_;
  assert(row.size() == file.columns.size());
  for (std::size_t c = 0; c < row.size(); ++c)
    require_finite(row[c], history_path(file.columns[c]), file.rows);
  for (std::size_t c = 0; c < row.size(); ++c) file.pending[c].push_back(row[c]);
  ++file.rows;
  file.on_disk = false;
  if (file.rows % chunk_rows == 0) file.settle();
}

std::size_t Recorder::rows() const {
  return file_->rows;
}

std::size_t Recorder::replaced() const {
  return file_->replaced;
}

void Recorder::flush() {
  File& file = *file_;
  if (file.on_disk) return;
  file.settle();
  require(H5Fflush(file.file, H5F_SCOPE_GLOBAL), "gather '" + file.path + "'");
  const ssize_t size = H5Fget_file_image(file.file, nullptr, 0);
  if (size < 0) throw OutputError("HDF5 cannot gather '" + file.path + "'");
  std::string image(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file.file, image.data(), image.size()) != size)
    throw OutputError("HDF5 cannot gather '" + file.path + "'");
  write_whole_file(file.path, image);
  file.on_disk = true;
}

void Recorder::write(const std::string& dataset, std::span<const double> values,
                     const std::string& unit) {
  for (std::size_t i = 0; i < values.size(); ++i) require_finite(values[i], dataset, i);
  File& file = *file_;
  const hsize_t count = values.size();
  if (H5Oexists_by_name(file.file, dataset.c_str(), H5P_DEFAULT) > 0)
    require(H5Ldelete(file.file, dataset.c_str(), H5P_DEFAULT), "replace " + dataset);
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, "make an extent");
  const Handle layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make a layout");
  const Handle target = create_dataset(file.file, dataset, space, layout);
  set_attribute(target, "unit", unit);
  require(H5Dwrite(target, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
          "write " + dataset);
  file.on_disk = false;
}

}  // namespace apps

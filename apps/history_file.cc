#include "apps/history_file.h"

#include "apps/hdf5_handle.h"

namespace apps {

struct HistoryFile::File {
  std::string path;
  Handle handle;
};

HistoryFile::HistoryFile(const std::string& path) {
  silence_hdf5();
  file_ =
      std::make_unique<File>(File{path, Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT),
                                               H5Fclose, "read '" + path + "'")});
}

HistoryFile::~HistoryFile() = default;

bool HistoryFile::has(const std::string& column) const {
  return H5Lexists(file_->handle, ("/history/" + column).c_str(), H5P_DEFAULT) > 0;
}

std::vector<double> HistoryFile::column(const std::string& name) const {
  const std::string what = "/history/" + name + " of '" + file_->path + "'";
  const Handle dataset(H5Dopen2(file_->handle, ("/history/" + name).c_str(), H5P_DEFAULT), H5Dclose,
                       "find " + what);
  const Handle space(H5Dget_space(dataset), H5Sclose, "measure " + what);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  require(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
          "read " + what);
  return values;
}

}  // namespace apps

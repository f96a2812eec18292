// An HDF5 identifier that is given back at the end of its scope.
#pragma once

#include <hdf5.h>

#include <string>
#include <utility>

#include "apps/errors.h"

namespace apps {

class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close) {
    if (id < 0) throw OutputError("HDF5 cannot " + what);
  }
  Handle(Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

inline void require(herr_t status, const std::string& what) {
  if (status < 0) throw OutputError("HDF5 cannot " + what);
}

// HDF5 prints every failed call by itself; ours are exceptions.
inline void silence_hdf5() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace apps

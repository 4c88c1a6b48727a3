// What every call of the HDF5 library needs: one at a time, closed identifiers, no words on stderr.
#pragma once

#include <hdf5.h>

#include <mutex>

namespace slipproof {

// Named, as members of a class with a name have these types.
namespace hdf5 {

inline std::mutex& mutex() {
  static std::mutex one;
  return one;
}

/// An identifier of the library, closed as its kind is.
class Id {
 public:
  Id(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Id(const Id&) = delete;
  Id& operator=(const Id&) = delete;
  ~Id() {
    if (id_ >= 0) close_(id_);
  }
  bool open() const { return id_ >= 0; }
  hid_t get() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Keeps the library from printing its errors to stderr; restores the former setting at the end.
class Silence {
 public:
  Silence() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  ~Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

}  // namespace hdf5

}  // namespace slipproof

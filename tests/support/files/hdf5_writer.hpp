// Writes small HDF5 files, sound and strange.
#pragma once

#ifdef SLIPPROOF_HDF5
#include <hdf5.h>

#include <string>
#include <vector>

#include "support/files/small_files.hpp"

namespace slipproof::test {

class Hdf5Writer {
 public:
  explicit Hdf5Writer(const std::string& path)
      : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {
    REQUIRE(file_ >= 0);
  }
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;
  ~Hdf5Writer() { H5Fclose(file_); }

  hid_t file() const { return file_; }

  void group(const std::string& path) const {
    H5Gclose(H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  }
  /// In the place of what may stand there.
  void remove(const std::string& path) const {
    if (H5Lexists(file_, path.c_str(), H5P_DEFAULT) > 0) H5Ldelete(file_, path.c_str(), H5P_DEFAULT);
  }
  /// Without data, if there are none.
  void set(const std::string& path, hid_t type, const std::vector<hsize_t>& sizes, hid_t memory, const void* data,
           hid_t properties = H5P_DEFAULT) const {
    remove(path);
    const hid_t space = H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr);
    const hid_t made = H5Dcreate2(file_, path.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    REQUIRE(made >= 0);
    if (data != nullptr) REQUIRE(H5Dwrite(made, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0);
    H5Dclose(made);
    H5Sclose(space);
  }
  void integers(const std::string& path, const std::vector<long long>& values, hid_t type = H5T_STD_I32LE) const {
    set(path, type, {values.size()}, H5T_NATIVE_LLONG, values.data());
  }
  void reals(const std::string& path, const Numbers& values, hid_t type = H5T_IEEE_F64LE,
             hid_t properties = H5P_DEFAULT) const {
    set(path, type, {values.size()}, H5T_NATIVE_DOUBLE, values.data(), properties);
  }
  void text(const std::string& path, const std::string& value) const {
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
    H5Tset_size(type, value.size() + 1);
    const hid_t made = H5Dcreate2(file_, path.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.c_str());
    H5Dclose(made);
    H5Sclose(space);
    H5Tclose(type);
  }
  /// nz is a number of triplets, -1 for columns, -2 for rows.
  void matrix(const std::string& path, long long rows, long long columns, long long nz, const std::vector<long long>& i,
              const std::vector<long long>& p, const Numbers& x) const {
    group(path);
    integers(path + "/m", {rows});
    integers(path + "/n", {columns});
    integers(path + "/nz", {nz});
    integers(path + "/nzmax", {static_cast<long long>(x.size())});
    integers(path + "/i", i);
    integers(path + "/p", p);
    reals(path + "/x", x);
  }

 private:
  hid_t file_;
};

}  // namespace slipproof::test
#endif

// What problem files need of HDF5: lists of numbers under paths. The only place that calls the library.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slipproof {

/// Whether this program was built with HDF5.
bool has_hdf5();
/// The message of the error if slipproof was built without HDF5.
inline constexpr const char* without_hdf5 =
    "found an HDF5 file, which cannot be read: this slipproof was built without HDF5, as all wheels are; build it from "
    "its sources where HDF5 is installed (Debian: apt-get install libhdf5-dev)";

/// An HDF5 file in memory. Only one may be open at a time, since the library is not thread-safe; others wait. Refuses
/// links that lead elsewhere (soft, external), virtual and external storage, chunks, types of variable length or
/// user-defined ones, and sizes for which the file has no data: nothing outside of `bytes` is read, and no more is
/// allocated than they can describe. All functions throw InputError, with the path in the message.
class Hdf5File {
 public:
  /// `file` is its name in messages. Also throws if the program was built without HDF5.
  Hdf5File(const std::string& bytes, std::string file);
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;
  ~Hdf5File();

  /// Whether there is an object at the path, which starts with a slash.
  bool has(const std::string& path) const;
  /// The number of objects in a group.
  std::size_t size_of_group(const std::string& path) const;
  std::int64_t integer(const std::string& path) const;
  /// Integers in at most one dimension; unsigned ones that do not fit become the largest.
  std::vector<std::int64_t> integers(const std::string& path) const;
  /// Numbers that are binary32, binary64, or integers that binary64 represents exactly.
  std::vector<double> reals(const std::string& path) const;
  /// The same for a data set that may have been created but never written, which the library reads as zeros; sets
  /// `written` accordingly. All other functions refuse such a data set. Refuses more than `most` numbers before it
  /// allocates memory for them.
  std::vector<double> reals(const std::string& path, bool& written, std::optional<std::size_t> most) const;
  /// A text of fixed length, up to its first zero byte; nothing if it is not a text or longer than 64 KiB.
  std::optional<std::string> text(const std::string& path) const;

  [[noreturn]] void refuse(const std::string& path, const std::string& message) const;

 private:
  class Library;
  std::string file_;
  std::unique_ptr<Library> library_;
};

}  // namespace slipproof

// What is being written, until it takes its place.
#pragma once

#include <filesystem>

#include "base/os/descriptor.hpp"

namespace slipproof {

/// A new file in a folder, without a name where the file system can do that. It is gone with its owner, unless it has
/// become the file it was made for. System errors are thrown as std::system_error.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& folder);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  int descriptor() const { return file_.number(); }
  /// Replaces `target`, a path in the same folder, atomically.
  void become(const std::filesystem::path& target);

 private:
  /// Tries names, from name_ on, until `make` succeeds with one.
  template <class Make>
  void find_name(const std::filesystem::path& folder, const Make& make);

  std::filesystem::path folder_, name_;  ///< no name yet: empty
  Descriptor file_;
};

}  // namespace slipproof

// Input files, which must not be overwritten.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <initializer_list>
#include <map>
#include <utility>
#include <vector>

namespace slipproof {

/// The input files of a result, identified by device and inode, so that other names, links and hard links are
/// recognised. Ignores paths that are not regular files.
class Inputs {
 public:
  Inputs() = default;
  Inputs(const std::vector<std::filesystem::path>& files);
  Inputs(std::initializer_list<std::filesystem::path> files) : Inputs(std::vector(files)) {}

  void add(const std::filesystem::path& file);
  /// Throws InputError if `path` is one of them.
  void refuse(const std::filesystem::path& path) const;

 private:
  std::map<std::pair<dev_t, ino_t>, std::filesystem::path> files_;
};

}  // namespace slipproof

// Files that must not be written over.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <initializer_list>
#include <map>
#include <utility>
#include <vector>

namespace slipproof {

/// The files that a result is made from, known by device and inode: by another name, a link or a hard link, they are
/// the same. Paths that lead to no regular file are passed over.
class Inputs {
 public:
  Inputs() = default;
  Inputs(const std::vector<std::filesystem::path>& files);
  Inputs(std::initializer_list<std::filesystem::path> files) : Inputs(std::vector(files)) {}

  void add(const std::filesystem::path& file);
  /// Throws InputError where `path` is one of them.
  void refuse(const std::filesystem::path& path) const;

 private:
  std::map<std::pair<dev_t, ino_t>, std::filesystem::path> files_;
};

}  // namespace slipproof

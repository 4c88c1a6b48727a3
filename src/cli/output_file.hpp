// Files that the program writes.
#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

namespace slipproof::cli {

/// A file for the result of long work: opened before it, so that no result is lost for want of a place. What stood
/// there stays until the result is written; without one, nothing is left behind.
class OutputFile {
 public:
  /// Makes the folders above it, too. Throws InputError.
  explicit OutputFile(std::filesystem::path path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Replaces what stood there. Throws InputError.
  void write(std::string_view contents);

 private:
  std::filesystem::path path_;
  bool keep_ = false;
  std::ofstream stream_;
};

/// Writes a file whole. Throws InputError.
inline void write_file(const std::filesystem::path& path, std::string_view contents) {
  OutputFile(path).write(contents);
}

}  // namespace slipproof::cli

// Files that hold results: the old content or the new, never a part.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

#include "base/output/inputs.hpp"

namespace slipproof {

/// Where a result may go. What a user names may be a pipe or a device; a file that the program names itself may not:
/// writing to a pipe that happens to have its name would wait for a reader.
enum class Targets : std::uint8_t { all, files };

/// A file for the result of long work. Constructing it before the work shows whether it can be written, so that no
/// result is lost for want of a place.
///
/// The contents go to a nameless file in the same folder, are flushed to the disk, and then take the name at once:
/// whatever happens in between, the older content stays. The permissions of an older file are kept. A symbolic link is
/// followed, and its target replaced; other names of that file (hard links) keep the older content. Pipes, devices and
/// open descriptors (/dev/stdout) are written directly. On a file system without nameless files, a file called
/// .slipproof-PROCESS-NUMBER is used; it remains only if a signal ends the program while it writes.
class OutputFile {
 public:
  /// Changes nothing yet. Throws OutputError if no file can be written there: the folder is missing or cannot be
  /// changed, the path is a folder, or the file is write-protected. Throws InputError if `path` is one of the `inputs`
  /// under any name: it would be lost.
  /// Throws OutputError for a pipe or device if only files are allowed.
  explicit OutputFile(std::filesystem::path path, const Inputs& inputs = {}, Targets allowed = Targets::all);

  /// Puts the contents there, as often as it is called. Throws OutputError.
  void write(std::string_view contents) const;

 private:
  enum class Kind { file, descriptor, special };

  void write_to(int descriptor, std::string_view contents) const;
  void write_beside(std::string_view contents) const;

  std::filesystem::path path_;    ///< as the caller says it
  std::filesystem::path target_;  ///< behind symbolic links
  Kind kind_ = Kind::file;
};

/// Writes a file whole. Throws as the constructor of OutputFile does.
void write_file(const std::filesystem::path& path, std::string_view contents, const Inputs& inputs = {},
                Targets allowed = Targets::all);

/// A folder for results, made before the long work if the folder around it is there.
class OutputFolder {
 public:
  /// Throws OutputError where it can neither be found nor made, or cannot be written to.
  explicit OutputFolder(std::filesystem::path path, Inputs inputs = {});

  /// Writes a file, and makes the folders that its name needs. Throws as write_file does for files only.
  void write(const std::filesystem::path& name, std::string_view contents) const;

 private:
  std::filesystem::path path_;
  Inputs inputs_;
};

}  // namespace slipproof

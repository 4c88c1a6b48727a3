// Files that hold results: the old content or the new, never a part.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

#include "base/output/inputs.hpp"

namespace slipproof {

/// Allowed targets. A path from the user may be a pipe or a device. A path that the program chose must be a file, since
/// writing to a pipe of that name would wait for a reader.
enum class Targets : std::uint8_t { all, files };

/// A file for the result of long work. Construct it before the work, so that an unwritable file is reported before the
/// work is done.
///
/// The contents are written to a nameless file in the same folder and flushed to the disk; the file then takes the name
/// atomically. Until then the older content stays, also after a crash. The permissions of an older file are kept. A
/// symbolic link is followed, and its target replaced; other names of that file (hard links) keep the older content.
/// Pipes, devices and open descriptors (/dev/stdout) are written directly. On a file system without nameless files, a
/// file called .slipproof-PROCESS-NUMBER is used; it remains only if a signal ends the program while it writes.
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

  std::filesystem::path path_;    ///< as given by the caller
  std::filesystem::path target_;  ///< with symbolic links resolved
  Kind kind_ = Kind::file;
};

/// Writes a complete file. Throws as the constructor of OutputFile does.
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

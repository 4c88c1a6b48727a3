// Files that hold results: the old content or the new, never a part.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "base/output/inputs.hpp"

namespace slipproof {

/// A file for the result of long work, looked at before it, so that no result is lost for want of a place.
///
/// What is written goes to a nameless file in the same folder, is flushed to the disk, and takes the name at once:
/// whatever happens in between, the older content stands. The permissions of an older file are kept, and a symbolic
/// link leads to the file that is replaced; other names of that file (hard links) keep the older content. Pipes,
/// devices and open descriptors (/dev/stdout) are written as they are. Where a file system has no nameless files, one
/// called .slipproof-PROCESS-NUMBER stands for it, and stays only where a signal ends the program while it writes.
class OutputFile {
 public:
  /// Changes nothing yet. Throws OutputError where no file can be written: in a folder that is not there or cannot be
  /// changed, on a folder, on a file that is write-protected. Throws InputError where `path` is one of the `inputs`,
  /// under whatever name: it would be lost.
  explicit OutputFile(std::filesystem::path path, const Inputs& inputs = {});

  using Sink = std::function<void(std::string_view)>;

  /// Puts the contents there, as often as it is called. Throws OutputError.
  void write(std::string_view contents) const;
  /// The same of whatever contents(sink) gives to the sink. What it throws is thrown on: of a file the older content
  /// stands then.
  void write_by(const std::function<void(const Sink&)>& contents) const;

 private:
  enum class Kind { file, descriptor, special };

  void write_to(int descriptor, const std::function<void(const Sink&)>& contents) const;
  void write_beside(const std::function<void(const Sink&)>& contents) const;

  std::filesystem::path path_;    ///< as the caller says it
  std::filesystem::path target_;  ///< behind symbolic links
  Kind kind_ = Kind::file;
};

/// Writes a file whole. Throws OutputError, and InputError if it is one of the inputs.
void write_file(const std::filesystem::path& path, std::string_view contents, const Inputs& inputs = {});

/// A folder for results, made before the long work if the folder around it is there.
class OutputFolder {
 public:
  /// Throws OutputError where it can neither be found nor made, or cannot be written to.
  explicit OutputFolder(std::filesystem::path path, Inputs inputs = {});

  /// Writes a file, and makes the folders that its name needs. Throws as write_file does.
  void write(const std::filesystem::path& name, std::string_view contents) const;

 private:
  std::filesystem::path path_;
  Inputs inputs_;
};

}  // namespace slipproof

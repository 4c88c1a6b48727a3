// Keeps the results of long work as they come, so that a later run, or another process, can use them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/os/descriptor.hpp"

namespace slipproof {

/// A file with the results of requests. Each result is found again by its request, so neither the number of ranks nor
/// the order of the work matters. One process writes it, and locks it while it lives; others may read what it has
/// written so far. If a killed program or a full disk leaves part of a result, its length or its digest shows this, and
/// the part is cut off.
///
/// Format: `slipproof-journal 2`, a newline, the text that describes the work; then for each result the digest
/// (SHA-256, hexadecimal) of request and result, the request's digest, and the result. Each text follows its length.
class Journal {
 public:
  enum class Access : std::uint8_t { write, read };

  /// Opens the file; creates it to write. For reading, the file need not exist yet. `work` describes everything else
  /// that the results depend on: version, arguments, input. Throws InputError if the file is not a journal, or one of
  /// other work; OutputError if it cannot be written, or another run is writing it.
  Journal(std::filesystem::path path, std::string_view work, Access access = Access::write);

  /// Whether the process that writes this file is alive.
  static bool is_written(const std::filesystem::path& path);
  /// Reads the results that another process has added since the last call; for a journal opened read-only. Throws
  /// InputError.
  void refresh();

  bool has(std::string_view request) const;
  /// The result of a request, if there is one. Throws InputError if the file was changed meanwhile.
  std::optional<std::string> find(std::string_view request) const;
  /// Adds a result. Throws OutputError.
  void keep(std::string_view request, std::string_view result);
  /// Flushes the results to the disk. Throws OutputError.
  void flush() const;

  std::size_t size() const { return places_.size(); }

 private:
  struct ResultPlace {
    std::uint64_t offset = 0, size = 0;
    std::string digest;
  };

  bool check_head() const;
  void read_results();

  std::filesystem::path path_;
  std::string head_;  ///< the first bytes of the file
  Descriptor file_{-1};
  std::uint64_t end_ = 0;  ///< end of the results read so far, in bytes; 0 before the head is read
  std::map<std::string, ResultPlace, std::less<>> places_;  ///< by digest of the request
};

}  // namespace slipproof

// Keeps the results of long work as they come, so that a later run can continue.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/os/descriptor.hpp"

namespace slipproof {

/// Up to `size` bytes of an open file from an offset on, fewer at its end. Throws InputError.
std::string read_at(int file, std::uint64_t offset, std::uint64_t size, const std::filesystem::path& path);

/// A file with the results of requests. Each result is found again by its request, so neither the number of ranks nor
/// the order of the work matters. A result is written at once. If a killed program or a full disk leaves part of one,
/// its length or its digest shows this, and the part is cut off.
///
/// Format: `slipproof-journal 1`, a newline, the text that describes the work; then for each result the digest
/// (SHA-256, hexadecimal) of request and result, the request's digest, and the result. Each text follows its length.
class Journal {
 public:
  /// Opens or creates the file. `work` describes what the results depend on, apart from the requests: version,
  /// arguments, input. Throws InputError if the file is not a journal, or one of other work; OutputError if it cannot
  /// be written, or another run is writing it.
  Journal(std::filesystem::path path, std::string_view work);

  /// Opens an existing journal read-only, whatever run wrote it. Throws InputError if the file is not a journal, is
  /// damaged, or is being written.
  explicit Journal(std::filesystem::path path);

  /// The result of a request, if there is one. Throws InputError if the file was changed meanwhile.
  std::optional<std::string> find(std::string_view request) const;
  /// Adds a result. Throws OutputError.
  void keep(std::string_view request, std::string_view result);
  /// Makes the kept results survive a failure of the machine. Throws OutputError.
  void flush() const;

  std::size_t size() const { return places_.size(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  struct ResultPlace {
    std::uint64_t offset = 0, size = 0;
    std::string digest;
  };

  void read_results(std::uint64_t at);

  std::filesystem::path path_;
  Descriptor file_;
  std::uint64_t end_ = 0;
  std::map<std::string, ResultPlace, std::less<>> places_;  ///< by the request's digest
};

}  // namespace slipproof

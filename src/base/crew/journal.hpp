// Results of long work, kept as they come, from which a later run goes on.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/os/descriptor.hpp"

namespace slipproof {

/// Up to `size` bytes of an open file from a place on, fewer at its end. Throws InputError.
std::string read_at(int file, std::uint64_t offset, std::uint64_t size, const std::filesystem::path& path);

/// A file with the results of requests, each found again by the request, so that neither the number of ranks nor the
/// order of the work matters. A result is written at once; what a killed program, or a full disk, leaves of one is no
/// result: it is noticed by its length or its digest and cut off.
///
/// Its form: `slipproof-journal 1`, a newline, the text of what the work is; then for each result the digest (SHA-256,
/// hexadecimal) of request and result, the request's digest, and the result. Texts have their length before them.
class Journal {
 public:
  /// Opens or makes it. `work` says what the results depend on beside the requests: version, arguments, input.
  /// Throws InputError for a file that is no journal, or one of other work; OutputError where it cannot be written, or
  /// another run is writing it.
  Journal(std::filesystem::path path, std::string_view work);

  /// One that is there, to be read and not kept in, of whatever work. Throws InputError for what is no journal, is
  /// damaged, or is being written.
  explicit Journal(std::filesystem::path path);

  /// The result of a request, if it is there. Throws InputError where the file has changed under it.
  std::optional<std::string> find(std::string_view request) const;
  /// Adds a result. Throws OutputError.
  void keep(std::string_view request, std::string_view result);
  /// What was kept survives a failure of the machine, too. Throws OutputError.
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

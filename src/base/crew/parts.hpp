// Output in parts, a file for each rank, with an index that says which of their bytes follow each other.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "base/crew/journal.hpp"
#include "base/os/descriptor.hpp"

namespace slipproof {

/// A range of the output, and where its bytes are.
struct PartRange {
  std::string part;  ///< the end of the file's name, which begins as the index does
  std::uint64_t offset = 0, size = 0;
  std::string digest;  ///< SHA-256

  std::string to_bytes() const;
  static PartRange from_bytes(std::string_view bytes);
};

/// PREFIX.index: the journal of the run; its results say where their bytes are.
std::filesystem::path parts_index(const std::string& prefix);

/// The parts that exist when it is constructed: before a run continues, as its new parts may take the names of lost
/// ones.
class PartSizes {
 public:
  explicit PartSizes(const std::string& prefix);
  /// The part was there, and long enough.
  bool hold(const PartRange& range) const;

 private:
  std::map<std::string, std::uintmax_t, std::less<>> sizes_;
};

/// Writes the part of one rank, PREFIX.RANK.1, or PREFIX.RANK.2 and so on if earlier runs left parts. Overwrites
/// nothing. Creates the file when the first bytes come.
class PartWriter {
 public:
  PartWriter(std::string prefix, int rank) : prefix_(std::move(prefix)), rank_(rank) {}

  /// Adds bytes, from many threads at once. Throws OutputError.
  PartRange add(std::string_view bytes);

 private:
  void make_file();

  std::string prefix_, part_;
  int rank_;
  std::mutex mutex_;
  Descriptor file_{-1};
};

/// What a run with parts leaves when it comes to its end.
struct PartsEnd {
  std::vector<PartRange> ranges = {};  ///< in their order
  std::string out = {}, err = {};      ///< what follows them on standard output, and what is said on standard error
  int exit_code = 0;
};

/// Into the index. Throws OutputError.
void keep_end(Journal& index, const PartsEnd& end);
/// From the index. Throws InputError where that is damaged, or its run has not come to its end.
PartsEnd read_end(const std::string& prefix);

/// The bytes of all parts in their order. Throws InputError that names each part that is missing, too short or
/// changed, after all of them were read; sink() has been given the bytes of the others then.
void read_parts(const std::string& prefix, const PartsEnd& end, const std::function<void(std::string_view)>& sink);

}  // namespace slipproof

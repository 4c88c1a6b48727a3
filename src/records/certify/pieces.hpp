// Certifying one file by many ranks: each reads its own ranges of it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "base/crew/crew.hpp"
#include "base/crew/parts.hpp"
#include "records/certify/certify.hpp"

namespace slipproof {

/// A file of lines in pieces of a fixed number of bytes: a line is of the piece that it begins in. The same on each
/// rank, which must see the same file.
class RecordPieces {
 public:
  static constexpr std::uint64_t usual_size = 1U << 18U;

  /// Reads the header of options.file, CSV or JSON Lines. options.judged is passed over. Throws InputError.
  explicit RecordPieces(const CertifyOptions& options, std::uint64_t piece_size = usual_size);
  ~RecordPieces();

  std::uint64_t pieces() const;
  /// What the results depend on beside the options: the file's name, size and time of change.
  std::string input() const;

  /// The service of a crew: counts the lines of a piece, or judges them. From many threads at once. With a part the
  /// lines of the output go there, and a PartRange stands for them. Throws InputError, and OutputError.
  std::string answer(std::string_view request, PartWriter* part = nullptr) const;
  /// Whether such an answer still has its lines.
  static bool stands(std::string_view request, std::string_view result, const PartSizes& parts);

  /// What certify() does, by a crew whose service is answer(): all lines are counted before the first is judged, so
  /// that each is called by its number. Of answers that are in parts `output` is given the PartRange of each. Throws as
  /// certify() and Crew::each() do.
  CertifySummary certify(Crew& crew, const LineSink& output, const Progress& progress = {}) const;

 private:
  class File;
  class Places;
  std::unique_ptr<const File> file_;
};

}  // namespace slipproof

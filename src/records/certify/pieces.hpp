// Certifies one file by many ranks: each reads its own ranges of the file.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "base/crew/crew.hpp"
#include "base/crew/parts.hpp"
#include "records/certify/certify.hpp"

namespace slipproof {

/// A file of lines, divided into pieces of a fixed number of bytes. A line belongs to the piece in which it begins. All
/// ranks must see the same file; then they have the same pieces.
class RecordPieces {
 public:
  static constexpr std::uint64_t usual_size = 1U << 18U;

  /// Reads the header of options.file, which is CSV or JSON Lines. Ignores options.judged. Throws InputError.
  explicit RecordPieces(const CertifyOptions& options, std::uint64_t piece_size = usual_size);
  ~RecordPieces();

  std::uint64_t pieces() const;
  /// What the results depend on apart from the options: the file's name, size and time of change.
  std::string input() const;

  /// The service of a crew: counts the lines of a piece, or judges them. May be called by many threads at once. If a
  /// part is given, the output lines go there, and the answer has a PartRange in their place. Throws InputError and
  /// OutputError.
  std::string answer(std::string_view request, PartWriter* part = nullptr) const;
  /// Whether the lines of such an answer are still in the parts.
  static bool stands(std::string_view request, std::string_view result, const PartSizes& parts);

  /// Does the work of certify() by a crew whose service is answer(). Counts all lines before it judges the first, so
  /// that each line has its number in messages. If answers are in parts, `output` receives the PartRange of each.
  /// Throws what certify() and Crew::each() throw.
  CertifySummary certify(Crew& crew, const LineSink& output, const Progress& progress = {}) const;

 private:
  class File;
  class Places;
  std::unique_ptr<const File> file_;
};

}  // namespace slipproof

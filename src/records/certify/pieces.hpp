// Certifies one file by many ranks, or goes on where a run ended: each piece of its lines is a request.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/crew/crew.hpp"
#include "base/files/byte_file.hpp"
#include "base/input/diagnostic.hpp"
#include "records/certify/chunk_judge.hpp"

namespace slipproof {

/// A file of lines, read once to cut it into the pieces in which certify() reads it. All ranks must see the same file;
/// then they have the same pieces.
class RecordPieces {
 public:
  /// Reads options.file, which is CSV or JSON Lines. Ignores options.judged. Throws InputError.
  explicit RecordPieces(CertifyOptions options);

  /// Identifies the input: the file's name, size and time of change. Results depend on it and on the options only.
  std::string input() const;

  /// The service of a crew: judges the lines of a piece. May be called by several threads. Throws InputError.
  std::string answer(std::string_view request) const;

  /// Does the work of certify() by a crew whose service is answer(). Throws what certify() and Crew::each() throw.
  CertifySummary certify(Crew& crew, const LineSink& output, const Progress& progress = {}) const;

 private:
  struct Piece {
    std::uint64_t offset = 0;
    std::size_t size = 0;
    std::uint64_t first_line = 0, first_record = 0;
  };

  CertifyOptions options_;
  ByteFile bytes_;
  std::vector<Piece> pieces_;          ///< a request is the number of one
  std::optional<InputError> mistake_;  ///< the mistake after the last piece, if any
  std::optional<ChunkJudge> judge_;
};

}  // namespace slipproof

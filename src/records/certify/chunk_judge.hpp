// Judges the lines of a chunk, for all kinds of records.
#pragma once

#include <memory>

#include "records/certify/judged.hpp"
#include "records/reading/chunk_reader.hpp"

namespace slipproof {

/// Begins an input: determines its format, reads its header, and makes the objects shared by all chunks.
class ChunkJudge {
 public:
  /// Throws InputError for a header that cannot be used.
  ChunkJudge(const CertifyOptions& options, ChunkReader& chunks);
  ~ChunkJudge();

  /// May be called by several threads.
  Judged judge(const Chunk& chunk) const;

 private:
  struct Judges;

  CertifyOptions options_;
  std::unique_ptr<const Judges> judges_;
};

}  // namespace slipproof

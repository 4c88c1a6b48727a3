// Judging the lines of a chunk, whatever they are records of.
#pragma once

#include <memory>

#include "records/certify/chunk_reader.hpp"
#include "records/certify/judged.hpp"

namespace slipproof {

/// Begins an input: takes its format and its header, and makes what is the same for all its chunks.
class ChunkJudge {
 public:
  /// Throws InputError for a header that cannot be used.
  ChunkJudge(const CertifyOptions& options, ChunkReader& chunks);
  ~ChunkJudge();

  /// From many threads at once.
  Judged judge(const Chunk& chunk) const;

 private:
  class Judges;

  CertifyOptions options_;
  std::unique_ptr<const Judges> judges_;
};

}  // namespace slipproof

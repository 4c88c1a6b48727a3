#include "records/certify/certify.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number/format.hpp"
#include "base/output/json.hpp"
#include "records/certify/chunk_judge.hpp"
#include "records/certify/judged.hpp"
#include "records/problems/contact_file.hpp"
#include "records/reading/chunk_reader.hpp"

namespace slipproof {

void CertifySummary::add(const CertifySummary& other) {
  records += other.records;
  for (std::size_t i = 0; i < record_verdict_count; ++i) verdicts[i] += other.verdicts[i];
  for (std::size_t i = 0; i < tier_count; ++i) tiers[i] += other.tiers[i];
  broken += other.broken;
  worst_certified_error = std::max(worst_certified_error, other.worst_certified_error);
  worst_error = std::max(worst_error, other.worst_error);
  with_rho += other.with_rho;
  worst_rho = std::max(worst_rho, other.worst_rho);
  eps_solutions += other.eps_solutions;
  others_possible += other.others_possible;
}

void CertifySummary::add(const RecordJudgement& judgement) {
  ++records;
  ++verdicts[static_cast<std::size_t>(judgement.verdict)];
  if (judgement.verdict != RecordVerdict::invalid) ++tiers[static_cast<std::size_t>(judgement.tier)];
  if (judgement.verdict == RecordVerdict::certified)
    worst_certified_error = std::max(worst_certified_error, judgement.max_error);
  worst_error = std::max(worst_error, judgement.max_error);
  if (judgement.eps_solution) ++eps_solutions;
  if (judgement.verdict == RecordVerdict::certified && !judgement.others_excluded) ++others_possible;
  if (judgement.verdict == RecordVerdict::certified && !judgement.members.empty()) {
    ++with_rho;
    worst_rho = std::max(worst_rho, judgement.rho);
  }
}

CertifySummary certify(const ByteSource& input, const LineSink& output, const CertifyOptions& given,
                       const Progress& progress) {
  ChunkReader chunks(input, given.file);
  const ChunkJudge judge(given, chunks);
  return judge_in_order<Chunk>(
      given, output, progress, [&](Chunk& chunk) { return chunks.next(chunk); },
      [&](const Chunk& chunk) { return judge.judge(chunk); });
}

CertifySummary certify(std::istream& input, const LineSink& output, const CertifyOptions& options,
                       const Progress& progress) {
  return certify(bytes_of(input, options.file), output, options, progress);
}

std::string to_json(const CertifySummary& s) {
  Json json{{"records", s.records}};
  for (std::size_t i = 0; i < record_verdict_count; ++i)
    json["verdicts"][std::string(name(static_cast<RecordVerdict>(i)))] = s.verdicts[i];
  for (std::size_t i = 0; i < tier_count; ++i) json["tiers"][std::string(name(static_cast<Tier>(i)))] = s.tiers[i];
  json["broken"] = s.broken;
  json["worst_certified_error"] = fmt::format("{:.3g}", s.worst_certified_error);
  json["worst_error"] = fmt::format("{:.3g}", s.worst_error);
  if (s.with_rho > 0) json["worst_rho"] = at_most(s.worst_rho);
  if (s.eps_solutions > 0) json["eps_solutions"] = s.eps_solutions;
  if (s.others_possible > 0) json["others_not_excluded"] = s.others_possible;
  return json_text(json);
}

}  // namespace slipproof

#include "records/judging/record_judge.hpp"

#include <stdexcept>

#include "base/input/diagnostic.hpp"
#include "records/judging/block_judge.hpp"

namespace slipproof {

RecordJudge::RecordJudge(CertifiedMechanism certified, const JudgeOptions& options)
    : certified_(std::move(certified)),
      fields_(certified_),
      options_(options),
      maker_(certified_.mechanism),
      kinds_(certified_.mechanism) {}

const MechanismBatch& RecordJudge::batch(const std::vector<bool>& given) const {
  const std::lock_guard lock(mutex_);
  auto& batch = batches_[given];
  if (!batch) batch = std::make_unique<const MechanismBatch>(certified_.mechanism, certified_.values.starts, given);
  return *batch;
}

Record RecordJudge::record(const NamedNumbers& numbers) const {
  Record record;
  record.clear(fields_.size());
  for (const auto& [name, value] : numbers) {
    const auto field = fields_.find(name);
    if (!field) throw std::invalid_argument("found the number " + in_quotes(name) + ", expected a field");
    record.set(*field, value);
    if (!record.not_finite) record.not_finite = not_finite(name, value, 0);
  }
  return record;
}

RecordJudgement RecordJudge::operator()(const Record& record) const {
  if (const std::string reason = incomplete(record.present, fields_, certified_); !reason.empty()) {
    throw std::invalid_argument(reason);
  }
  if (record.not_finite) return exact()(record);
  RecordBlock block(fields_);
  block.begin(record.present);
  block.add(record);
  BlockJudge judge(*this);
  judge.look_at(block);
  RecordJudgement result;
  return judge.certified(0, result) ? result : exact()(record);
}

}  // namespace slipproof

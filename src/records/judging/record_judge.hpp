// Judges records of a mechanism. What binary64 cannot certify goes to the kernel.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "records/judging/exact_judge.hpp"
#include "records/judging/space_judge.hpp"

namespace slipproof {

/// Compiled once for all records of a run; may be shared by threads.
class RecordJudge {
 public:
  RecordJudge(CertifiedMechanism certified, const JudgeOptions& options);

  const RecordFields& fields() const { return fields_; }
  const CertifiedMechanism& certified() const { return certified_; }
  const JudgeOptions& options() const { return options_; }
  RecordSetting setting() const { return {certified_, fields_, maker_, kinds_}; }
  /// The mechanism, compiled for these given parameters at the first call.
  const MechanismBatch& batch(const std::vector<bool>& given) const;

  /// A record from numbers and the names of their fields. Throws std::invalid_argument for a name that is not a field.
  using NamedNumbers = std::vector<std::pair<std::string, double>>;
  Record record(const NamedNumbers& numbers) const;
  /// Throws std::invalid_argument if the record is incomplete.
  RecordJudgement operator()(const Record& record) const;
  /// Judges records by the kernel.
  ExactJudge exact() const { return {setting(), options_, in_space_}; }

 private:
  CertifiedMechanism certified_;
  RecordFields fields_;
  JudgeOptions options_;
  ProblemMaker maker_;
  MechanismKinds kinds_;
  SpaceMemory in_space_;
  mutable std::mutex mutex_;
  mutable std::map<std::vector<bool>, std::unique_ptr<const MechanismBatch>> batches_;
};

}  // namespace slipproof

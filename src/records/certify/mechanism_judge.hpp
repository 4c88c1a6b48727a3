// Judging records of a mechanism, several at once: what binary64 cannot certify goes to the kernel.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "floating/tape/mechanism_batch.hpp"
#include "floating/tape/mode_run.hpp"
#include "records/certify/mechanism_exact.hpp"

namespace slipproof {

/// Made ready for all records of a run; shared by threads. What it is made of must outlive it.
class MechanismJudge {
 public:
  MechanismJudge(const CertifiedMechanism& certified, const MechanismFields& fields);

  MechanismSetting setting() const { return {certified_, fields_, maker_, kinds_}; }
  /// The mechanism with these parameters given, compiled when it is asked for first.
  const MechanismBatch& batch(const std::vector<bool>& given) const;

 private:
  const CertifiedMechanism& certified_;
  const MechanismFields& fields_;
  ProblemMaker maker_;
  MechanismKinds kinds_;
  mutable std::mutex mutex_;
  mutable std::map<std::vector<bool>, std::unique_ptr<const MechanismBatch>> batches_;
};

/// Records that are judged together, as many as fit. Of one thread.
class MechanismBlock {
 public:
  MechanismBlock(const MechanismJudge& judge, const JudgeOptions& options);

  /// Takes a record, and gives another one for its memory; `judgement` says what was found once finish() returns, or
  /// before. The record is complete, and its numbers are finite.
  void add(MechanismRecord& record, RecordJudgement& judgement);
  /// Judges what is left.
  void finish();

 private:
  struct Number {
    double nearest = 0;
    bool exact = true;
  };
  static Number number_of(const Rational& x);

  void use(const MechanismBatch& batch);
  bool put(const MechanismRecord& record, std::size_t lane);
  std::optional<Number> angle(const MechanismRecord& record, std::size_t index) const;
  void decide();
  Lanes answer_error(std::size_t mode, const ModeRun::Values& values) const;
  std::optional<std::size_t> claimed_motion(std::size_t lane) const;
  void certify(std::size_t lane, std::size_t mode, double error);

  const MechanismJudge& judge_;
  MechanismSetting setting_;
  const JudgeOptions& options_;
  std::vector<Number> base_, base_angles_;  ///< what is the same for all records: parameters and the load; angles
  const MechanismBatch* batch_ = nullptr;
  std::unique_ptr<ModeRun> run_;
  std::vector<std::string> names_;  ///< of the batch's modes, as JSON texts
  std::vector<MechanismRecord> records_;
  std::vector<RecordJudgement*> judgements_;
};

}  // namespace slipproof

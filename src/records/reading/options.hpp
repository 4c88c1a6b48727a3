// Options for reading and judging records.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "contact/judge/judge.hpp"
#include "records/judging/judge.hpp"
#include "records/record/record.hpp"

namespace slipproof {

enum class RecordFormat {
  by_first_byte,  ///< JSON Lines begin with a brace, CSV does not
  csv,
  json_lines
};

struct CertifyOptions {
  JudgeOptions judge;
  ContactJudgeOptions contact = {};  ///< for lines with a contact problem in the form of `read_problem_line`
  /// Replaces the law that a contact problem in a line names. If this or contact.within is set, all lines must be
  /// contact problems, and are judged like files.
  std::optional<FrictionLaw> law = std::nullopt;
  bool as_files() const { return law || contact.within; }
  RecordFormat format = RecordFormat::by_first_byte;
  std::string file = "-";  ///< the name of the input in messages
  /// The mechanism of the records; without it, records are bicycles (bicycle_records.hpp) or contact problems.
  std::optional<CertifiedMechanism> mechanism = std::nullopt;
  bool decimal_exact = false;      ///< decimals are exact, not the nearest binary64
  bool stop_at_broken = false;     ///< throw at the first record that cannot be read, instead of reporting it
  bool ignore_unknown = false;     ///< ignore columns and keys that are not fields
  std::uint64_t first_record = 1;  ///< records before it are skipped, because an earlier run judged them
  unsigned threads = 0;            ///< 0: all cores
  /// Also called for each judged record, in order, with its number and its judgement.
  std::function<void(std::uint64_t record, const RecordJudgement& judgement)> judged = {};
};

inline constexpr std::size_t max_record_line = 1U << 23U;

}  // namespace slipproof

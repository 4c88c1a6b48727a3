#include "records/judging/judge.hpp"

#include <array>

#include "base/output/json.hpp"

namespace slipproof {

std::string_view name(RecordVerdict verdict) {
  constexpr std::array<std::string_view, record_verdict_count> names{"certified", "ambiguous", "inaccurate",
                                                                     "wrong",     "invalid",   "undecided"};
  return names[static_cast<std::size_t>(verdict)];
}

void RecordJudgement::add_mode(std::uint16_t mode, std::string_view name) {
  modes.push_back(mode);
  if (!mode_names.empty()) mode_names += ',';
  mode_names += '"';
  mode_names += name;
  mode_names += '"';
}

namespace {

RecordJudgement judgement_for(RecordVerdict verdict, const std::string& reason) {
  RecordJudgement result;
  result.verdict = verdict;
  result.details = "," + inner_json_text({{"reason", reason}});
  return result;
}

}  // namespace

RecordJudgement invalid_judgement(const std::string& reason) {
  return judgement_for(RecordVerdict::invalid, reason);
}

RecordJudgement undecided_judgement(const std::string& reason) {
  return judgement_for(RecordVerdict::undecided, reason);
}

std::string too_much_work(Work needed, Work effort) {
  const std::string allowed = "more than the effort of " + std::to_string(effort) + " allows; ";
  if (needed == unlimited) return "too much work: " + allowed + "a larger --effort may do";
  const std::string work = std::to_string(needed);
  return "too much work: about " + work + " operations on words, " + allowed + "--effort " + work + " would do";
}

}  // namespace slipproof

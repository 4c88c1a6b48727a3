#include "records/certify/exact_judge.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "mechanics/bicycle_modes/bicycle_motions.hpp"
#include "mechanics/bicycle_modes/motions.hpp"
#include "records/certify/mechanism_exact.hpp"

namespace slipproof {

namespace {

using Json = nlohmann::ordered_json;

/// Bicycles as records of the mechanism of their file.
struct BicycleAsMechanism {
  CertifiedMechanism certified{bicycle_mechanism()};
  MechanismFields fields{certified.mechanism};
  ProblemMaker maker{certified.mechanism};
  MechanismKinds kinds{certified.mechanism};
  std::array<std::size_t, answer_count> answers{};  ///< fields

  BicycleAsMechanism() {
    for (std::size_t i = 0; i < answer_count; ++i) answers[i] = *fields.find(name(answer_quantities[i]));
  }
  MechanismSetting setting() const { return {certified, fields, maker, kinds}; }
};

const BicycleAsMechanism& as_mechanism() {
  static const BicycleAsMechanism all;
  return all;
}

MechanismRecord answer_of(const Record& record) {
  const BicycleAsMechanism& bicycle = as_mechanism();
  MechanismRecord result;
  result.clear(bicycle.fields.size());
  for (std::size_t i = 0; i < answer_count; ++i) {
    const auto field = static_cast<Field>(parameter_count + i);
    if (record.has(field)) result.set(bicycle.answers[i], record.exactly(field));
  }
  if (record.mode) result.mode = bicycle.fields.find_mode(name(*record.mode));
  return result;
}

MechanismVerdict judge_as_mechanism(const Record& record, const ForcedScene<Rational>& s, const JudgeOptions& options) {
  const FrictionProblem problem = as_mechanism().maker.problem(bicycle_values(s.bicycle, s.road, s.force_kind));
  return judge_at(as_mechanism().setting(), answer_of(record), problem, s.F, options);
}

/// The mode that the answer looks like, where the solver does not name one.
ContactMode looks_like(const Record& record, const Rational& f) {
  const auto state = [&](Field normal, Field tangential) {
    const Rational N = record.exactly(normal), S = record.exactly(tangential), limit = f * N;
    if (N.is_zero() && S.is_zero()) return ContactState::lift;
    if (abs(S) < limit * Rational(999999, 1000000)) return ContactState::stick;
    return sign(S) < 0 ? ContactState::slip_forward : ContactState::slip_backward;
  };
  return {state(Field::N2, Field::S2), state(Field::N3, Field::S3)};
}

Json modes_json(const std::vector<ContactMode>& modes) {
  Json names = Json::array();
  for (const ContactMode mode : modes) names.push_back(name(mode));
  return names;
}

Json motions_json(const MotionsAtForce& found) {
  Json motions = Json::array();
  for (const auto& motion : found.motions) {
    Json entry{{"modes", modes_json(motion.modes)}, {"status", motion.strict ? "strict" : "boundary"}};
    for (const Quantity q : all_quantities()) entry[std::string(name(q))] = exact_text(motion.values[q]);
    motions.push_back(std::move(entry));
  }
  return motions;
}

std::uint16_t mode_bits(const std::vector<MechanismMode>& modes) {
  unsigned bits = 0;
  for (const MechanismMode& mode : modes) bits |= 1U << contact_mode(mode)->index();
  return static_cast<std::uint16_t>(bits);
}

/// Without the braces: members to append to an object.
std::string members(const Json& object) {
  const std::string text = object.dump(-1, ' ', false, Json::error_handler_t::replace);
  return object.empty() ? "" : "," + text.substr(1, text.size() - 2);
}

/// Why an answer in a mode that has not been rejected is wrong.
const char* reason(const MotionsAtForce& found, const ModeTable& table, ContactMode mode) {
  if (table.find(mode) == nullptr) return "the mode is not modelled: without J no wheel leaves the road";
  const bool one = std::any_of(found.motions.begin(), found.motions.end(), [&](const auto& m) {
    return std::find(m.modes.begin(), m.modes.end(), mode) != m.modes.end();
  });
  return one ? "the mode is right, its numbers are not"
             : "the mode has a continuum of motions, and none of them is near";
}

/// What speaks against the mode that the answer claims, or looks like.
void explain(Json& details, const MotionsAtForce& found, const ModeTable& table, ContactMode mode, bool claimed) {
  details[claimed ? "claimed" : "looks_like"] = name(mode);
  details["violated"] = nullptr;
  const auto rejected =
      std::find_if(found.rejected.begin(), found.rejected.end(), [&](const Rejection& r) { return r.mode == mode; });
  if (rejected == found.rejected.end()) {
    details["reason"] = reason(found, table, mode);
  } else if (rejected->violated) {
    details["violated"] = name(*rejected->violated);
    details["margin"] = exact_text(rejected->margin);
  } else {
    details["reason"] = reason(*rejected);
  }
}

/// Of all modes at once. The numbers of a motion are quotients of polynomials in those of the scene, and have as many
/// digits as all these together, times their degree.
Work work_of(const Record& record) {
  constexpr Work products = 400;
  constexpr std::size_t degree = 4;
  std::size_t bits = 0;
  for (std::size_t i = 0; i < field_count; ++i) {
    const auto field = static_cast<Field>(i);
    if (record.has(field)) bits += bit_count(record.exactly(field));
  }
  return times(products, product_work(degree * bits));
}

}  // namespace

RecordJudgement undecided_judgement(const std::string& reason) {
  RecordJudgement result;
  result.verdict = RecordVerdict::undecided;
  result.details = members({{"reason", reason}});
  return result;
}

RecordJudgement invalid_judgement(const std::string& reason) {
  RecordJudgement result;
  result.details = members({{"reason", reason}});
  return result;
}

std::string too_much_work(Work needed, Work effort) {
  const std::string allowed = "more than the effort of " + std::to_string(effort) + " allows; ";
  if (needed == endless) return "too much work: " + allowed + "a larger --effort may do";
  const std::string work = std::to_string(needed);
  return "too much work: about " + work + " operations on words, " + allowed + "--effort " + work + " would do";
}

RecordJudgement judge_exactly(const Record& record, const JudgeOptions& options) {
  if (const Work needed = work_of(record); needed > options.effort)
    return undecided_judgement(too_much_work(needed, options.effort));
  const ForcedScene<Rational> s = exact_scene(record);
  MechanismVerdict judged;
  try {
    judged = judge_as_mechanism(record, s, options);
  } catch (const TooMuchWork&) {
    return undecided_judgement(too_much_work(endless, options.effort));
  }
  RecordJudgement result;
  result.verdict = judged.verdict;
  result.motions = judged.found.motions.size();
  result.continuum = !judged.found.continua.empty();
  if (result.verdict != RecordVerdict::wrong) {
    const MotionAtLoad* motion = motion_with(judged.found, judged.nearest);
    result.modes = mode_bits(motion == nullptr ? std::vector<MechanismMode>{judged.nearest} : motion->all_modes());
    result.max_error = enclose(judged.distance.relative).upper;
  }
  Json details = Json::object();
  if (result.verdict != RecordVerdict::certified) {
    const ModeTable table(s.bicycle, s.road, s.force_kind);
    const MotionsAtForce found = motions_at(table, s.F);
    if (result.verdict == RecordVerdict::wrong) {
      explain(details, found, table, record.mode ? *record.mode : looks_like(record, s.road.f),
              record.mode.has_value());
    }
    details["found"] = motions_json(found);
    if (!found.continua.empty()) {
      Json continua = Json::array();
      for (const auto& c : found.continua) continua.push_back(name(c.continuum->mode));
      details["continua"] = std::move(continua);
    }
  }
  result.details = members(details);
  return result;
}

}  // namespace slipproof

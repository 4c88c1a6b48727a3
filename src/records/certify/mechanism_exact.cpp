#include "records/certify/mechanism_exact.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/mechanism/words.hpp"
#include "mechanics/scene/degrees.hpp"
#include "mechanics/scene/sampling.hpp"
#include "records/certify/exact_judge.hpp"

namespace slipproof {

namespace {

using Json = nlohmann::ordered_json;

/// The point of a record, or why it is none.
struct RecordPoint {
  MechanismValues values;
  std::optional<Rational> load;
  std::string mistake;
};

RecordPoint point_of(const MechanismSetting& setting, const MechanismRecord& record) {
  const auto& [certified, fields, maker, kinds] = setting;
  RecordPoint point{certified.values, certified.load, {}};
  for (std::size_t i = 0; i < fields.parameters(); ++i) {
    if (!record.present[i]) continue;
    point.values.parameters[i] = record.exactly(i);
    point.values.given[i] = true;
  }
  for (std::size_t i = 0; i < fields.angles(); ++i) {
    bool own = false;
    for (std::size_t form = 0; form < MechanismFields::angle_forms; ++form) {
      own = own || record.present[fields.angle(i, MechanismFields::AngleForm{form})];
    }
    if (!own) continue;
    std::string mistake;
    const RecordAngle angle = angle_of(record, fields, i, mistake);
    if (!mistake.empty() && point.mistake.empty()) {
      point.mistake = certified.mechanism.angles[i].name + ": " + mistake;
    }
    point.values.angles[i] = angle.half_turn
                                 ? MechanismValues::Circle{-1, 0}
                                 : point_of_tan_half(angle.exact ? *angle.exact : to_rational(angle.nearest));
  }
  if (fields.load() && record.present[*fields.load()]) point.load = record.exactly(*fields.load());
  return point;
}

/// What of the domain a point breaks, with what was found and expected; empty if nothing.
std::string outside_domain(const MechanismSetting& setting, const RecordPoint& point) {
  const Mechanism& mechanism = setting.certified.mechanism;
  const auto broken = setting.maker.broken(point.values);
  using What = ProblemMaker::Broken::What;
  if (!broken.empty()) {
    const ProblemMaker::Broken& one = broken.front();
    const std::string expected = ", expected " + to_string(one.condition->expression);
    if (one.what == What::parameter) {
      return mechanism.parameters[one.index].symbol + ": found " + exact_text(point.values.parameters[one.index]) +
             expected;
    }
    if (one.what == What::angle) {
      const MechanismValues::Circle& at = point.values.angles[one.index];
      return mechanism.angles[one.index].name + ": found the cosine " + decimal_text(at.cosine, 6) + " and the sine " +
             decimal_text(at.sine, 6) + expected;
    }
    return "found values that break " + mechanism.assume[one.index].name + expected;
  }
  if (!point.load) return {};
  const ForceInterval loads = setting.maker.load_domain(point.values);
  if (loads.contains(*point.load)) return {};
  return mechanism.load->symbol + ": found " + exact_text(*point.load) + ", expected a value in " + to_string(loads);
}

/// Numbers are quotients of polynomials in those of the record, and have as many digits as all these together, times
/// their degree.
Work work_of(const MechanismSetting& setting, const RecordPoint& point) {
  const Mechanism& mechanism = setting.certified.mechanism;
  constexpr std::size_t degree = 4;
  std::size_t bits = point.load ? bit_count(*point.load) : 0;
  for (const Rational& value : point.values.parameters) bits += bit_count(value);
  for (const auto& angle : point.values.angles) bits += bit_count(angle.cosine) + bit_count(angle.sine);
  const auto kinds = element_kinds(mechanism, point.values.starts, point.values.given);
  const auto modes = static_cast<Work>(mode_count(kinds));
  const Work unknowns = mechanism.unknowns.size();
  return times(times(modes, unknowns * unknowns), product_work(degree * bits));
}

Json names_of(const std::vector<MechanismMode>& modes) {
  Json names = Json::array();
  for (const MechanismMode& mode : modes) names.push_back(name(mode));
  return names;
}

Json end_of(const std::optional<Rational>& end) {
  return end ? Json(exact_text(*end)) : Json(nullptr);
}

/// What is right, and what speaks against the answer.
class Explanation {
 public:
  Explanation(const MechanismSetting& setting, const FrictionProblem& problem, const MotionsAtLoad& found,
              const std::optional<Rational>& load)
      : setting_(setting), problem_(problem), found_(found), load_(load) {}

  void add_motions(Json& details) const {
    Json motions = Json::array();
    for (const MotionAtLoad& motion : found_.motions) motions.push_back(motion_of(motion));
    details["found"] = std::move(motions);
    Json continua = Json::array();
    for (const ContinuumAtLoad& continuum : found_.continua) continua.push_back(name(continuum.mode));
    if (!continua.empty()) details["continua"] = std::move(continua);
    if (!found_.hysteresis.empty()) details["hysteresis"] = names_of(found_.hysteresis);
  }

  void add_claimed(Json& details, const MechanismMode& mode, const MechanismValues& values) const {
    details["claimed"] = name(mode);
    details["violated"] = nullptr;
    if (std::string missing = not_modelled(mode, values); !missing.empty()) {
      details["reason"] = missing;
      return;
    }
    const ModesOf own = mode_of(problem_, mode, load_);
    if (own.rejected.empty()) {
      details["reason"] = own.consistent.front().determined
                              ? "the mode is right, its numbers are not"
                              : "the mode has a continuum of motions, and none of them is near";
      return;
    }
    const RejectedMode& rejected = own.rejected.front();
    std::vector<std::string> because;
    for (const ViolatedCondition& c : rejected.because) {
      std::string text = condition_name(setting_.certified.mechanism, c.element, c.state, c.condition);
      if (because.empty() || because.back() != text) because.push_back(std::move(text));
    }
    if (rejected.margin) {
      details["violated"] = because.front();
      details["margin"] = exact_text(*rejected.margin);
    } else if (because.empty()) {
      details["reason"] = "its equations have no solution";
    } else {
      details["because"] = because;
    }
  }

 private:
  Json motion_of(const MotionAtLoad& motion) const {
    const auto& fields = setting_.fields;
    Json accelerations = Json::object(), forces = Json::object(), undetermined = Json::object();
    for (std::size_t i = 0; i < motion.accelerations.size(); ++i) {
      accelerations[fields.name(fields.first_answer() + i)] = exact_text(motion.accelerations[i]);
    }
    for (std::size_t i = 0; i < motion.forces.size(); ++i) {
      const std::string& name = fields.name(fields.first_answer() + fields.accelerations() + i);
      const Range& range = motion.forces[i];
      if (range.is_point()) {
        forces[name] = exact_text(*range.lower);
      } else {
        undetermined[name] = Json::array({end_of(range.lower), end_of(range.upper)});
      }
    }
    Json result{{"modes", names_of(motion.modes)}, {"boundary_modes", names_of(motion.boundary_modes)}};
    result["status"] = motion.strict() ? "strict" : "boundary";
    result["accelerations"] = std::move(accelerations);
    result["forces"] = std::move(forces);
    result["force_ranges"] = std::move(undetermined);
    return result;
  }

  /// Why a mode is none at this point; empty if it is one.
  std::string not_modelled(const MechanismMode& mode, const MechanismValues& values) const {
    const Mechanism& mechanism = setting_.certified.mechanism;
    for (std::size_t i = 0; i < mode.size(); ++i) {
      if (has_state(problem_.elements[i].kind, mode[i])) continue;
      std::string text =
          "the mode is not modelled: " + element_name(mechanism, i) + " has no " + std::string(name(mode[i])) + " here";
      if (mode[i] != ElementState::lift || i >= mechanism.contacts.size()) return text;
      for (const std::size_t need : missing_for_lift(mechanism.contacts[i], values.given)) {
        text += " without " + mechanism.parameters[need].symbol;
      }
      return text;
    }
    return {};
  }

  const MechanismSetting& setting_;
  const FrictionProblem& problem_;
  const MotionsAtLoad& found_;
  const std::optional<Rational>& load_;
};

/// Without the braces and brackets.
std::string inner_text(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.substr(1, text.size() - 2);
}

RecordJudgement judge_point(const MechanismSetting& setting, const MechanismRecord& record, const RecordPoint& point,
                            const FrictionProblem& problem, const JudgeOptions& options) {
  const MechanismVerdict judged = judge_at(setting, record, problem, point.load, options);
  const MotionsAtLoad& found = judged.found;
  RecordJudgement result;
  result.verdict = judged.verdict;
  result.motions = found.motions.size();
  result.continuum = !found.continua.empty();
  Json details = Json::object();
  const FrictionProblem solved = without_equations(problem);
  const Explanation explanation(setting, solved, found, point.load);
  if (result.verdict == RecordVerdict::wrong) {
    if (record.mode != nullptr) {
      explanation.add_claimed(details, *record.mode, point.values);
    } else {
      details["reason"] = judged.nearest.empty() ? "there is no motion" : "no motion is near";
    }
  } else {
    const MotionAtLoad* motion = motion_with(found, judged.nearest);
    result.mode_names = inner_text(motion == nullptr  ? names_of({judged.nearest})
                                   : motion->strict() ? names_of(motion->modes)
                                                      : names_of(motion->boundary_modes));
    result.max_error = enclose(judged.distance.relative).upper;
    if (result.verdict == RecordVerdict::inaccurate) {
      details["worst"] = setting.fields.name(setting.fields.first_answer() + judged.worst);
    }
  }
  if (result.verdict != RecordVerdict::certified) explanation.add_motions(details);
  if (!details.empty()) result.details = "," + inner_text(details);
  return result;
}

RecordJudgement undecided_record(Work needed, const JudgeOptions& options) {
  return undecided_judgement(too_much_work(needed, options.effort));
}

}  // namespace

const MotionAtLoad* motion_with(const MotionsAtLoad& found, const MechanismMode& mode) {
  for (const MotionAtLoad& motion : found.motions) {
    for (const auto* modes : {&motion.modes, &motion.boundary_modes}) {
      if (std::find(modes->begin(), modes->end(), mode) != modes->end()) return &motion;
    }
  }
  return nullptr;
}

MechanismVerdict judge_at(const MechanismSetting& setting, const MechanismRecord& record,
                          const FrictionProblem& problem, const std::optional<Rational>& load,
                          const JudgeOptions& options) {
  MechanismVerdict result;
  result.found = motions_of(without_equations(problem), load);
  const MechanismAnswer answer(setting, record, problem, load);
  const Rational tolerance = to_rational(options.tolerance);
  Effort effort(options.effort);
  for (const ConsistentMode& mode : ModeSolver(problem, load).consistent()) {
    if (record.mode != nullptr && mode.mode != *record.mode) continue;
    std::size_t worst = 0;
    Distance distance = answer.distance(mode, effort, worst);
    if (!result.nearest.empty() && !is_nearer(distance, result.distance, tolerance)) continue;
    result.nearest = mode.mode;
    result.distance = std::move(distance);
    result.worst = worst;
  }
  if (result.nearest.empty() || result.distance.scaled > to_rational(options.near)) return result;
  const bool several = result.found.motions.size() > 1 || !result.found.continua.empty();
  result.verdict = result.distance.relative > tolerance ? RecordVerdict::inaccurate
                   : several                            ? RecordVerdict::ambiguous
                                                        : RecordVerdict::certified;
  return result;
}

bool is_given(const MechanismSetting& setting, const MechanismRecord& record, std::size_t parameter) {
  return record.present[parameter] || setting.certified.values.given[parameter];
}

RecordJudgement judge_exactly(const MechanismSetting& setting, const MechanismRecord& record,
                              const JudgeOptions& options) {
  const RecordPoint point = point_of(setting, record);
  if (!point.mistake.empty()) return invalid_judgement(point.mistake);
  if (const std::string reason = outside_domain(setting, point); !reason.empty()) return invalid_judgement(reason);
  if (const Work needed = work_of(setting, point); needed > options.effort) return undecided_record(needed, options);
  return judged_or_undecided([&] {
    try {
      return judge_point(setting, record, point, setting.maker.problem(point.values), options);
    } catch (const NoValue& error) {
      return invalid_judgement(error.what());
    } catch (const TooMuchWork&) {
      return undecided_record(endless, options);
    }
  });
}

}  // namespace slipproof

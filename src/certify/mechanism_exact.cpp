#include "certify/mechanism_exact.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "certify/exact_judge.hpp"
#include "mechanism/degrees.hpp"
#include "mechanism/sampling.hpp"
#include "mechanism/words.hpp"
#include "motions/motions_of.hpp"
#include "number/binary64.hpp"
#include "number/format.hpp"

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
  const auto& [certified, fields, maker] = setting;
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

/// What an answer is held against: a solution of one mode, as near to the answer as what it leaves free allows.
struct NearestSolution {
  std::vector<std::optional<Rational>> values;  ///< of each answer field that the record has
  std::vector<bool> open;                       ///< whether the mode leaves it open
};

class RecordAnswer {
 public:
  RecordAnswer(const MechanismSetting& setting, const MechanismRecord& record, const FrictionProblem& problem,
               const std::optional<Rational>& load)
      : setting_(setting), record_(record), problem_(problem) {
    find_scales(load);
  }

  /// The answers that vary are taken over one by one, as far as their ranges allow.
  NearestSolution nearest(const ConsistentMode& mode) const {
    Polyhedron solutions = mode.solutions;
    const std::size_t answers = setting_.fields.answers();
    NearestSolution result{std::vector<std::optional<Rational>>(answers), std::vector<bool>(answers, false)};
    for (std::size_t i = 0; i < answers; ++i) {
      if (!has(i)) continue;
      result.open[i] = !is_free_of_unknowns(mode.solutions.space.on(form(i)));
      const Range range = ranges(solutions, {form(i)}).front();
      Rational value = answer(i);
      if (range.lower && value < *range.lower) value = *range.lower;
      if (range.upper && value > *range.upper) value = *range.upper;
      if (!range.is_point()) {
        AffineForm taken = form(i);
        taken.constant -= value;
        solutions = *with(solutions, {taken});
      }
      result.values[i] = std::move(value);
    }
    return result;
  }

  /// `worst` is the field with the largest relative error.
  Distance to(const NearestSolution& solution, std::size_t& worst) const {
    std::array<Rational, 2> largest;
    for (std::size_t i = 0; i < solution.values.size(); ++i) {
      if (solution.values[i]) largest[kind(i)] = std::max(largest[kind(i)], Rational(abs(*solution.values[i])));
    }
    Distance d{0, 0};
    for (std::size_t i = 0; i < solution.values.size(); ++i) {
      if (!solution.values[i]) continue;
      const Rational& value = *solution.values[i];
      const Rational& scale = scales_[kind(i)];
      const Rational unit = !scale.is_zero() ? scale : !largest[kind(i)].is_zero() ? largest[kind(i)] : Rational(1);
      const Rational distance = abs(answer(i) - value);
      Rational size = value.is_zero() ? unit : Rational(abs(value));
      if (solution.open[i]) size = std::max(size, unit);  // the answer's errors are in it, of all sizes
      const Rational relative = distance / size;
      if (relative > d.relative) worst = i;
      d.relative = std::max(d.relative, relative);
      d.scaled = std::max(d.scaled, Rational(distance / std::max(unit, largest[kind(i)])));
    }
    return d;
  }

 private:
  bool has(std::size_t i) const { return record_.present[setting_.fields.first_answer() + i]; }
  Rational answer(std::size_t i) const { return record_.exactly(setting_.fields.first_answer() + i); }
  std::size_t kind(std::size_t i) const { return i < setting_.fields.accelerations() ? 0 : 1; }
  const AffineForm& form(std::size_t i) const {
    const std::size_t accelerations = setting_.fields.accelerations();
    return i < accelerations ? problem_.accelerations[i] : problem_.forces[i - accelerations];
  }

  void find_scales(const std::optional<Rational>& load) {
    AffineSpace space(problem_.unknowns, problem_.has_load);
    bool solvable = !load || space.require(load_minus(*load, problem_.unknowns));
    const std::size_t own = setting_.certified.mechanism.equations.size();
    for (std::size_t i = 0; i < problem_.equations.size(); ++i) {
      const AffineForm& equation = problem_.equations[i];
      Rational applied = equation.constant;
      if (load) applied += equation.coefficients.back() * *load;
      if (i < own) scales_[1] = std::max(scales_[1], Rational(abs(applied)));
      solvable = solvable && space.require(equation);
    }
    for (const ProblemElement& element : problem_.elements) {
      for (const AffineForm* force : {&element.normal, &element.tangent}) {
        if (!force->coefficients.empty()) solvable = solvable && space.require(*force);
      }
    }
    if (!solvable) return;
    Rational largest = 0;
    for (std::size_t i = 0; i < setting_.certified.mechanism.accelerations; ++i) {
      const AffineForm value = space.on(problem_.accelerations[i]);
      if (!is_constant(value)) return;
      largest = std::max(largest, Rational(abs(value.constant)));
    }
    scales_[0] = largest;
  }

  const MechanismSetting& setting_;
  const MechanismRecord& record_;
  const FrictionProblem& problem_;
  std::array<Rational, 2> scales_;  ///< of accelerations, of forces; 0: there is none
};

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

/// The motion to which a mode belongs; null for one of a continuum.
const MotionAtLoad* motion_with(const MotionsAtLoad& found, const MechanismMode& mode) {
  for (const MotionAtLoad& motion : found.motions) {
    for (const auto* modes : {&motion.modes, &motion.boundary_modes}) {
      if (std::find(modes->begin(), modes->end(), mode) != modes->end()) return &motion;
    }
  }
  return nullptr;
}

RecordJudgement judge_point(const MechanismSetting& setting, const MechanismRecord& record, const RecordPoint& point,
                            const FrictionProblem& problem, const JudgeOptions& options) {
  const FrictionProblem solved = without_equations(problem);
  const MotionsAtLoad found = motions_of(solved, point.load);
  const RecordAnswer answer(setting, record, problem, point.load);
  const MechanismMode* nearest = nullptr;
  Distance distance;
  std::size_t worst = 0;
  const std::vector<ConsistentMode> modes = ModeSolver(problem, point.load).consistent();
  for (const ConsistentMode& mode : modes) {
    if (record.mode != nullptr && mode.mode != *record.mode) continue;
    std::size_t off = 0;
    const Distance d = answer.to(answer.nearest(mode), off);
    if (nearest != nullptr && d.scaled >= distance.scaled) continue;
    nearest = &mode.mode;
    distance = d;
    worst = off;
  }

  RecordJudgement result;
  result.motions = found.motions.size();
  result.continuum = !found.continua.empty();
  Json details = Json::object();
  const Explanation explanation(setting, solved, found, point.load);
  if (nearest == nullptr || distance.scaled > to_rational(options.near)) {
    result.verdict = RecordVerdict::wrong;
    if (record.mode != nullptr) {
      explanation.add_claimed(details, *record.mode, point.values);
    } else {
      details["reason"] = nearest == nullptr ? "there is no motion" : "no motion is near";
    }
  } else {
    const MotionAtLoad* motion = motion_with(found, *nearest);
    result.mode_names = inner_text(motion == nullptr  ? names_of({*nearest})
                                   : motion->strict() ? names_of(motion->modes)
                                                      : names_of(motion->boundary_modes));
    result.max_error = enclose(distance.relative).upper;
    const bool several = result.motions > 1 || result.continuum;
    result.verdict = distance.relative > to_rational(options.tolerance) ? RecordVerdict::inaccurate
                     : several                                          ? RecordVerdict::ambiguous
                                                                        : RecordVerdict::certified;
    if (result.verdict == RecordVerdict::inaccurate) {
      details["worst"] = setting.fields.name(setting.fields.first_answer() + worst);
    }
  }
  if (result.verdict != RecordVerdict::certified) explanation.add_motions(details);
  if (!details.empty()) result.details = "," + inner_text(details);
  return result;
}

}  // namespace

bool is_given(const MechanismSetting& setting, const MechanismRecord& record, std::size_t parameter) {
  return record.present[parameter] || setting.certified.values.given[parameter];
}

RecordJudgement judge_exactly(const MechanismSetting& setting, const MechanismRecord& record,
                              const JudgeOptions& options) {
  const RecordPoint point = point_of(setting, record);
  if (!point.mistake.empty()) return invalid_judgement(point.mistake);
  if (const std::string reason = outside_domain(setting, point); !reason.empty()) return invalid_judgement(reason);
  if (const Work needed = work_of(setting, point); needed > options.effort) {
    RecordJudgement result;
    result.verdict = RecordVerdict::undecided;
    result.details = "," + inner_text(Json{{"reason", too_much_work(needed, options.effort)}});
    return result;
  }
  try {
    return judge_point(setting, record, point, setting.maker.problem(point.values), options);
  } catch (const NoValue& error) {
    return invalid_judgement(error.what());
  }
}

}  // namespace slipproof

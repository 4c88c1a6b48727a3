#include "certify/exact_judge.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "modes/motions.hpp"
#include "number/binary64.hpp"
#include "number/format.hpp"

namespace slipproof {

namespace {

using Json = nlohmann::ordered_json;

/// A motion to hold the answer against: a motion of the scene, or the nearest one of a continuum.
struct Candidate {
  std::vector<ContactMode> modes;
  Motion<Rational> values;
};

class Answer {
 public:
  Answer(const Record& r, const ForcedScene<Rational>& s) : record_(r), g_(s.road.g), R_(s.bicycle.R) {
    weight_ = s.bicycle.M * g_;
  }

  bool has(Quantity q) const { return field(q) && record_.has(*field(q)); }
  Rational operator[](Quantity q) const { return record_.exactly(*field(q)); }

  Distance to(const Motion<Rational>& m) const {
    Rational force = weight_, acceleration = g_;
    for (std::size_t i = 0; i < answer_count; ++i) {
      const Rational size = abs(m[answer_quantities[i]]);
      if (i >= 5) {
        force = std::max(force, size);
      } else {
        acceleration = std::max(acceleration, i < 2 ? size : Rational(size * R_));
      }
    }
    Distance d{0, 0};
    for (std::size_t i = 0; i < answer_count; ++i) {
      const Quantity q = answer_quantities[i];
      if (!has(q)) continue;
      const Rational distance = abs((*this)[q] - m[q]);
      const Rational unit = i >= 5 ? weight_ : i < 2 ? g_ : Rational(g_ / R_);
      const Rational scale = i >= 5 ? force : i < 2 ? acceleration : Rational(acceleration / R_);
      d.relative = std::max(d.relative, Rational(distance / (m[q].is_zero() ? unit : Rational(abs(m[q])))));
      d.scaled = std::max(d.scaled, Rational(distance / scale));
    }
    return d;
  }

  /// The mode that the answer looks like, where the solver does not name one.
  ContactMode mode(const Rational& f) const {
    const auto state = [&](Quantity normal, Quantity tangential) {
      const Rational N = (*this)[normal], S = (*this)[tangential], limit = f * N;
      if (N.is_zero() && S.is_zero()) return ContactState::lift;
      if (abs(S) < limit * Rational(999999, 1000000)) return ContactState::stick;
      return sign(S) < 0 ? ContactState::slip_forward : ContactState::slip_backward;
    };
    return {state(Quantity::N2, Quantity::S2), state(Quantity::N3, Quantity::S3)};
  }

 private:
  static std::optional<Field> field(Quantity q) {
    const auto it = std::find(answer_quantities.begin(), answer_quantities.end(), q);
    if (it == answer_quantities.end()) return std::nullopt;
    return static_cast<Field>(parameter_count + static_cast<std::size_t>(it - answer_quantities.begin()));
  }

  const Record& record_;
  Rational g_, R_, weight_;
};

/// The member of a continuum whose free parameters are the answer's, as far as their ranges allow.
Motion<Rational> nearest_member(const FoundContinuum& c, const Answer& answer, const Rational& F) {
  Motion<Rational> m;
  for (const Quantity q : all_quantities()) m[q] = c.continuum->base[q].at(F);
  for (std::size_t k = 0; k < c.parameters.size(); ++k) {
    const ForceInterval& range = c.parameters[k];
    const Quantity parameter = c.continuum->parameters[k];
    Rational t = answer.has(parameter) ? answer[parameter] : range.sample();
    if (range.lower() && t < *range.lower()) t = *range.lower();
    if (range.upper() && t > *range.upper()) t = *range.upper();
    for (const Quantity q : all_quantities()) m[q] += t * c.continuum->directions[k][q];
  }
  return m;
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

std::uint16_t mode_bits(const std::vector<ContactMode>& modes) {
  unsigned bits = 0;
  for (const ContactMode mode : modes) bits |= 1U << mode.index();
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

RecordJudgement undecided_judgement(Work needed, Work effort) {
  RecordJudgement result;
  result.verdict = RecordVerdict::undecided;
  result.details = members({{"reason", too_much_work(needed, effort)}});
  return result;
}

}  // namespace

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
  if (const Work needed = work_of(record); needed > options.effort) return undecided_judgement(needed, options.effort);
  const ForcedScene<Rational> s = exact_scene(record);
  const ModeTable table(s.bicycle, s.road, s.force_kind);
  const MotionsAtForce found = motions_at(table, s.F);
  const Answer answer(record, s);

  std::vector<Candidate> candidates;
  for (const auto& motion : found.motions) candidates.push_back({motion.modes, motion.values});
  for (const auto& c : found.continua) {
    candidates.push_back({{c.continuum->mode}, nearest_member(c, answer, s.F)});
  }
  const Candidate* best = nullptr;
  Distance distance;
  for (const Candidate& c : candidates) {
    if (record.mode && std::find(c.modes.begin(), c.modes.end(), *record.mode) == c.modes.end()) continue;
    const Distance d = answer.to(c.values);
    if (best != nullptr && d.scaled >= distance.scaled) continue;
    best = &c;
    distance = d;
  }

  RecordJudgement result;
  result.motions = found.motions.size();
  result.continuum = !found.continua.empty();
  const bool several = result.motions > 1 || result.continuum;
  Json details = Json::object();
  if (best == nullptr || distance.scaled > to_rational(options.near)) {
    result.verdict = RecordVerdict::wrong;
    explain(details, found, table, record.mode ? *record.mode : answer.mode(s.road.f), record.mode.has_value());
  } else {
    result.modes = mode_bits(best->modes);
    result.max_error = enclose(distance.relative).upper;
    const bool accurate = distance.relative <= to_rational(options.tolerance);
    result.verdict = !accurate ? RecordVerdict::inaccurate
                     : several ? RecordVerdict::ambiguous
                               : RecordVerdict::certified;
  }
  if (result.verdict != RecordVerdict::certified) {
    details["found"] = motions_json(found);
    if (result.continuum) {
      Json continua = Json::array();
      for (const auto& c : found.continua) continua.push_back(name(c.continuum->mode));
      details["continua"] = std::move(continua);
    }
  }
  result.details = members(details);
  return result;
}

}  // namespace slipproof

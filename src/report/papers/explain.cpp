#include "report/papers/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/number/format.hpp"
#include "claims/paper/setting_names.hpp"
#include "claims/sampling/force_domain.hpp"
#include "mechanics/points/degrees.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

namespace {

/// ` for F = 0`; a mechanism without a load has nothing to say here, or that there is no motion.
std::string for_forces(const std::string& F, const ForceInterval& forces) {
  if (F.empty()) return forces.empty() ? " nowhere" : "";
  if (forces.empty()) return " for no " + F;
  if (forces.is_point()) return fmt::format(" for {} = {}", F, exact_text(*forces.lower()));
  return fmt::format(" for {} in {}", F, to_string(forces));
}

/// Whether anything in the claim, or in the mode of its counterexample, depends on the force.
bool depends_on_force(const Setting& setting, const Claim& claim, Reading reading, const Counterexample& example) {
  if (setting.force.symbol.empty()) return false;
  const SettingNames names(setting);
  const std::vector<Expression> all = expressions(claim.body(reading));
  return example.judgement.mode || is_about_motions(claim) ||
         std::any_of(all.begin(), all.end(),
                     [&](const Expression& e) { return names.depends(e, reading, setting.force.symbol); });
}

class Explanation {
 public:
  Explanation(const ClaimsFile& file, const ClaimResult& result, const Counterexample& example)
      : claim_(file.claims[result.claim]),
        body_(claim_.body(result.reading)),
        setting_(file.settings[claim_.setting]),
        reading_(result.reading),
        example_(example),
        j_(example.judgement),
        F_(setting_.force.symbol) {}

  std::string text() const {
    if (j_.reason == Reason::ends) return interval() + "; only the ends differ";
    if (j_.reason == Reason::forces) return interval();
    if (j_.reason == Reason::exists) {
      return fmt::format("there is a motion in {}{}, and the claim says that there is none", mode(), forces());
    }
    if (j_.reason == Reason::formula) return formula();
    if (j_.reason == Reason::continuum) {
      return fmt::format("in {} there is a continuum of motions{}, and the claim knows of one", mode(), forces());
    }
    if (j_.reason == Reason::extra) {
      return fmt::format("there is also a motion in {}{}, which the claim rules out", mode(), forces());
    }
    if (j_.reason == Reason::missing) return missing();
    if (j_.reason == Reason::uncovered) return uncovered();
    if (j_.outcome == Outcome::refuted) return failing() + forces();
    return "the claim has no value";
  }

 private:
  std::string mode() const { return j_.mode ? name(*j_.mode) : std::string("no mode"); }
  /// ` for F in (0, 1)`.
  std::string forces() const {
    return j_.witnesses && !j_.witnesses->empty() ? for_forces(F_, *j_.witnesses) : std::string();
  }

  std::string interval() const {
    const std::string claimed = j_.claimed ? for_forces(F_, *j_.claimed) : " for " + F_ + " in several intervals";
    return fmt::format("the claim has motions in {}{}; in fact there are such motions{}", mode(), claimed,
                       for_forces(F_, *j_.real));
  }

  std::string missing() const {
    const std::string text =
        fmt::format("the claim has a motion{}{}, and there is none", j_.mode ? " in " + mode() : "", forces());
    if (!setting_.strict || !example_.motions) return text;
    for (const MotionAtLoad& motion : example_.motions->motions) {
      const auto& boundary = motion.boundary_modes;
      const bool here = j_.mode && std::find(boundary.begin(), boundary.end(), *j_.mode) != boundary.end();
      if (here) return text + " that meets all conditions strictly, as the setting asks";
    }
    return text;
  }

  /// The comparison that fails, with the values of both sides, and the force if it matters.
  std::string formula() const {
    std::string text;
    for (const BrokenComparison& broken : example_.broken) {
      const std::string left = to_string(broken.left), right = to_string(broken.right);
      text += fmt::format("{}{} {} {} is false: ", text.empty() ? "" : "; ", left, spelling(broken.relation), right);
      const std::string values[] = {side(broken.left, left, broken.left_value, "the left side"),
                                    side(broken.right, right, broken.right_value, "the right side")};
      text += values[0] + (values[0].empty() || values[1].empty() ? "" : " and ") + values[1];
    }
    if (text.empty()) text = failing();
    if (j_.mode) text += ", in " + mode();
    const bool of_two_conditions = !body_.kind->forces_say_where();
    if (of_two_conditions && !example_.broken.empty()) text = failing() + ", for " + text;
    if (!depends_on_force(setting_, claim_, reading_, example_)) return text;
    if (!example_.broken.empty() && example_.force)
      text += fmt::format(", at {} = {}", F_, exact_text(*example_.force));
    const bool more = j_.witnesses && !j_.witnesses->is_point();
    return text + (more ? "; it fails" + for_forces(F_, *j_.witnesses) : "");
  }
  /// `b1 = 2`; `the left side is 2` if the expression is long; nothing for a number.
  static std::string side(const Expression& e, const std::string& text, const Rational& value, const char* which) {
    const Expression& bare = e->operation == Operation::negate ? e->operands[0] : e;
    if (bare->operation == Operation::number) return "";
    if (e->operation == Operation::symbol) return text + " = " + exact_text(value);
    return fmt::format("{} is {}", which, exact_text(value));
  }
  std::string uncovered() const {
    if (!j_.mode) return failing() + (j_.witnesses ? for_forces(F_, *j_.witnesses) : "");
    if (j_.real && !j_.real->empty()) {
      return fmt::format("{}, and in {} there are motions{}", failing(), mode(), for_forces(F_, *j_.real));
    }
    return fmt::format("{} (in {} there is no motion)", failing(), mode());
  }

  /// How the claim fails, in the words of its kind.
  std::string failing() const { return body_.kind->failing(body_, j_, noun(setting_)); }

  const Claim& claim_;
  const ClaimBody& body_;
  const Setting& setting_;
  const Reading reading_;
  const Counterexample& example_;
  const Judgement& j_;
  const std::string& F_;
};

}  // namespace

std::string explain(const ClaimsFile& file, const ClaimResult& result, const Counterexample& example) {
  return Explanation(file, result, example).text();
}

namespace {

std::string why_undecided(const ClaimsFile& file, const ClaimResult& result, bool unsure) {
  if (unsure) return ": a comparison has irrational zeros over the forces";
  const Setting& setting = file.settings[file.claims[result.claim].setting];
  if (setting.force.symbol.empty() || !domain_is_no_interval(setting)) return "";
  return fmt::format(": the domain of {}, {}, is no interval there; expected one, and a setting for each part",
                     setting.force.symbol, in_quotes(to_string(setting.force.domain)));
}

}  // namespace

std::string explain(const ClaimsFile& file, const ClaimResult& result) {
  const std::string_view noun = slipproof::noun(file.settings[file.claims[result.claim].setting]);
  if (result.counterexample) return explain(file, result, *result.counterexample);
  if (!result.failure.empty()) {
    return result.refuted == 0 ? "judging it failed: " + result.failure
                               : fmt::format("it is wrong at {} of {}, but showing one failed: {}", result.refuted,
                                             counted(result.samples(), noun), result.failure);
  }
  switch (result.verdict) {
    case Verdict::holds:
      break;
    case Verdict::vacuous:
      return fmt::format("it says something of no {} at all, and that is proved", noun);
    case Verdict::refuted:
      return file.claims[result.claim].kind().traits().seeks ? "proved: there is no such motion"
                                                             : "proved to be false; no sample is a counterexample";
    case Verdict::undecided: {
      if (result.undecided == 0) {
        return fmt::format("none of the {} that were tried is one of which it says anything",
                           counted(result.tried, noun));
      }
      const bool unsure = result.unsure == result.undecided;
      return fmt::format("{} at {} of {} in its region{}", unsure ? "it was not decided" : "it has no value",
                         result.undecided == result.samples() ? "any" : std::to_string(result.undecided),
                         counted(result.samples(), noun), why_undecided(file, result, unsure));
    }
  }
  return "";
}

std::string missing_text(std::size_t missing) {
  return fmt::format("{} that the claims file asks for {} missing: slipproof prove searches for them",
                     counted(missing, "certificate"), missing == 1 ? "is" : "are");
}

bool is_about_motions(const Claim& claim) {
  const bool by_others = claim.kind().has("claims") && !claim.kind().is_linear();
  return !claim.printed.modes.empty() || by_others;
}

std::vector<std::pair<std::string, Rational>> place_of(const ClaimsFile& file, const ClaimResult& result,
                                                       const Counterexample& example) {
  const Claim& claim = file.claims[result.claim];
  const Setting& setting = file.settings[claim.setting];
  auto place = parameters_of(setting, example);
  if (example.force && depends_on_force(setting, claim, result.reading, example)) {
    place.emplace_back(setting.force.symbol, *example.force);
  }
  return place;
}

std::vector<std::pair<std::string, Rational>> parameters_of(const Setting& setting, const Counterexample& example) {
  std::vector<std::pair<std::string, Rational>> place;
  for (std::size_t k = 0; k < example.values.size(); ++k) {
    if (!setting.parameters[k].angle) {
      place.emplace_back(setting.parameters[k].symbol, example.values[k]);
      continue;
    }
    const FreeAngle& angle = setting.angles[*setting.parameters[k].angle];
    const MechanismValues::Circle point = point_of_tan_half(example.values[k]);
    place.emplace_back(angle.cosine, point.cosine);
    place.emplace_back(angle.sine, point.sine);
  }
  return place;
}

std::string scene_text(const Setting& setting, const Counterexample& example) {
  return to_toml(example.scene, setting.mechanism_name, setting.along);
}

std::string broken_conditions(const Setting& setting, const Counterexample& example) {
  std::string text;
  for (const Realisable& condition : setting.realisable) {
    const auto& broken = example.unrealisable;
    if (std::find(broken.begin(), broken.end(), condition.name) == broken.end()) continue;
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", condition.name, to_string(condition.condition));
  }
  return text;
}

std::string realisability(const ClaimsFile& file, const ClaimResult& result) {
  const Setting& setting = file.settings[file.claims[result.claim].setting];
  if (!result.counterexample || setting.realisable.empty()) return "";
  const Counterexample& example = *result.counterexample;
  const std::string_view what = noun(setting, "mechanism");
  if (example.unrealisable.empty()) return fmt::format("this {} can be built", what);
  return fmt::format(
      "this {} cannot be built: it breaks {}; none that can was found, neither among the {} at which "
      "the claim was found to fail nor among those of small numbers",
      what, broken_conditions(setting, example), counted(result.refuted, noun(setting)));
}

std::string no_motions(const Counterexample& example) {
  const Mechanism& mechanism = example.scene.mechanism;
  std::string needs;
  for (const MechanismContact& contact : mechanism.contacts) {
    for (const std::size_t parameter : missing_for_lift(contact, example.scene.values.given)) {
      const std::string& symbol = mechanism.parameters[parameter].symbol;
      if (needs.find(symbol) == needs.npos) needs += (needs.empty() ? "" : ", ") + symbol;
    }
  }
  if (needs.empty()) return "there is no motion at all";
  return fmt::format(
      "there is no motion with those contacts closed that are not modelled open; without {} no other is modelled",
      needs);
}

std::string_view noun(const Setting& setting, std::string_view otherwise) {
  const std::string& name = setting.mechanism->name;
  const auto is_letter = [](char c) { return 'a' <= c && c <= 'z'; };
  return std::all_of(name.begin(), name.end(), is_letter) ? std::string_view(name) : otherwise;
}

std::string_view noun(const ClaimsFile& file) {
  const auto& all = file.settings;
  const std::string_view first = all.empty() ? "point" : noun(all.front());
  return std::all_of(all.begin(), all.end(), [&](const Setting& s) { return noun(s) == first; }) ? first : "point";
}

std::string sentence(std::string text) {
  if (text.empty()) return text;
  const std::size_t end = text.find_first_of(" :,");
  const std::string_view first = std::string_view(text).substr(0, end);
  const auto is_lower = [](unsigned char c) { return std::islower(c) != 0; };
  // Two letters and no digit are a word; in a formula an operator follows.
  const bool word = first.size() > 1 && std::all_of(first.begin(), first.end(), is_lower);
  const bool goes_on = end == text.npos || end + 1 >= text.size() ||
                       std::isalpha(static_cast<unsigned char>(text[end + 1])) != 0 || text[end] != ' ';
  if (word && goes_on) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  if (text.back() != '.') text += '.';
  return text;
}

}  // namespace slipproof

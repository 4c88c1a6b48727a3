#include "records/problems/problem_judge.hpp"

#include <algorithm>

#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "base/output/json.hpp"
#include "contact/problem/every_load_json.hpp"
#include "contact/problem/tolerance.hpp"
#include "records/judging/judge.hpp"

namespace slipproof {

namespace {

class Judge {
 public:
  Judge(const ContactProblem& problem, const ProblemAnswer& answer, const JudgeOptions& options)
      : problem_(problem), answer_(answer), options_(options), solver_(problem), effort_(options.effort) {
    for (std::size_t i = 0; i < problem.size(); ++i) {
      if (!problem.W[i][i].is_zero()) force_ = std::max(force_, Rational(abs(problem.q[i] / problem.W[i][i])));
    }
  }

  RecordJudgement judge() {
    looks_like_ = answer_.mode ? *answer_.mode : mode_of_answer();
    try {
      if (const auto all = solutions()) {
        judge_among(*all);
      } else {
        judge_alone();
      }
      if (options_.every_q) tell_every_q();
    } catch (const TooMuchWork&) {
      result_ = RecordJudgement();
      result_.verdict = RecordVerdict::undecided;
      details_ = Json{{"reason", too_much_work(endless, options_.effort)}};
    }
    if (!details_.empty()) result_.details = "," + inner_json_text(details_);
    return std::move(result_);
  }

 private:
  /// A solution to compare the answer with, and which of its components a continuum leaves open.
  struct Compared {
    std::vector<Rational> z, w;
    std::vector<bool> open_z, open_w;
  };
  /// The yardsticks of z and of w.
  struct Sizes {
    Rational z, w;
  };

  Compared determined(std::vector<Rational> z) const {
    auto w = accelerations(problem_, z);
    const std::vector<bool> none(problem_.size(), false);
    return {std::move(z), std::move(w), none, none};
  }

  Compared at_base(const ContactContinuum& c) const {
    Compared result = determined(c.base);
    for (const auto& direction : c.directions) {
      const auto slope = slope_of_w(direction);
      for (std::size_t i = 0; i < problem_.size(); ++i) {
        if (!direction[i].is_zero()) result.open_z[i] = true;
        if (!slope[i].is_zero()) result.open_w[i] = true;
      }
    }
    return result;
  }

  /// How w varies with z.
  std::vector<Rational> slope_of_w(const std::vector<Rational>& direction) const {
    std::vector<Rational> slope = accelerations(problem_, direction);
    for (std::size_t i = 0; i < problem_.size(); ++i) slope[i] -= problem_.q[i];
    return slope;
  }

  Sizes sizes(const Compared& to) const {
    Yardsticks largest(2);
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      largest.take(0, to.open_z[i] ? answer_.z[i] : to.z[i]);
      largest.take(1, problem_.q[i]);
      if (!to.open_w[i]) largest.take(1, to.w[i]);
      if (to.open_w[i] && answer_.w) largest.take(1, (*answer_.w)[i]);
    }
    return {largest[0].is_zero() ? force_ : largest[0], largest[1]};
  }

  Distance distance_to(const Compared& to) const {
    Distance d{0, 0};
    const Sizes size = sizes(to);
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      compare({answer_.z[i], to.z[i], size.z, to.open_z[i]}, d);
      if (answer_.w) compare({(*answer_.w)[i], to.w[i], size.w, to.open_w[i]}, d);
    }
    return d;
  }

  /// All solutions, unless finding them is too much work. Trying a few modes is faster than deciding whether the matrix
  /// is definite.
  std::optional<ContactSolutions> solutions() {
    constexpr Work few_modes = 4096;
    std::optional<ContactSolutions> all;
    if (solver_.modes() <= few_modes) all = solver_.all(effort_);
    if (all) return all;
    if (auto only = solver_.only(looks_like_, effort_)) {
      details_["unique_by"] = name(EveryLoad::Reason::definite);
      all.emplace();
      all->solutions.push_back(std::move(*only));
      return all;
    }
    return solver_.modes() > few_modes ? solver_.all(effort_) : std::nullopt;
  }

  /// The solution of a continuum that is nearest to the answer, measured by the largest error of a component.
  Compared nearest_member(const ContactContinuum& c) {
    Compared member = at_base(c);
    const Sizes size = sizes(member);
    std::vector<OpenComponent> open;
    const auto add = [&](std::size_t i, const Rational& base, const RationalMatrix& slopes, const Rational& answer,
                         const Rational& yardstick) {
      AffineForm form{base, {}};
      for (const auto& slope : slopes) form.coefficients.push_back(slope[i]);
      open.push_back({std::move(form), answer, yardstick});
    };
    RationalMatrix slopes;
    for (const auto& direction : c.directions) slopes.push_back(slope_of_w(direction));
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      if (member.open_z[i]) add(i, member.z[i], c.directions, answer_.z[i], size.z);
      if (member.open_w[i] && answer_.w) add(i, member.w[i], slopes, (*answer_.w)[i], size.w);
    }
    member.z = c.at(nearest_solution(open, c.conditions, c.directions.size(), effort_));
    member.w = accelerations(problem_, member.z);
    return member;
  }

  /// The mode that the answer suggests, if the solver names none.
  ProblemMode mode_of_answer() const {
    const auto w = accelerations(problem_, answer_.z);
    ProblemMode mode;
    for (std::size_t i = 0; i < problem_.contacts(); ++i) {
      const std::size_t normal = problem_.frictional() ? 2 * i : i;
      const Rational& N = answer_.z[normal];
      const Rational size = abs(problem_.W[normal][normal]);
      const bool nothing = N.is_zero() && (!problem_.frictional() || answer_.z[normal + 1].is_zero());
      if (nothing || N * (size.is_zero() ? Rational(1) : size) <= w[normal]) {
        mode.push_back(ElementState::lift);
      } else if (!problem_.frictional()) {
        mode.push_back(ElementState::touch);
      } else if (abs(answer_.z[normal + 1]) < problem_.mu[i] * N * Rational(999999, 1000000)) {
        mode.push_back(ElementState::stick);
      } else {
        mode.push_back(answer_.z[normal + 1].sign() < 0 ? ElementState::slip_forward : ElementState::slip_backward);
      }
    }
    return mode;
  }

  Json modes_json(const std::vector<ProblemMode>& modes) const {
    Json names = Json::array();
    for (const ProblemMode& mode : modes) names.push_back(name(problem_, mode));
    return names;
  }

  static Json exact_json(const std::vector<Rational>& values) {
    Json list = Json::array();
    for (const Rational& x : values) list.push_back(exact_text(x));
    return list;
  }

  Json to_json(const ContactSolution& s) const {
    return {{"modes", modes_json(s.modes)},
            {"status", s.strict ? "strict" : "boundary"},
            {"z", exact_json(s.z)},
            {"w", exact_json(s.w)}};
  }

  Json to_json(const ContactContinuum& c) {
    return {{"mode", name(problem_, c.mode)},
            {"parameters", c.directions.size()},
            {"nearest_z", exact_json(nearest_member(c).z)}};
  }

  /// Explains what is wrong with the mode that the answer claims or suggests.
  void explain() {
    Effort again(options_.effort);
    const ModeOutcome outcome = solver_.solve(looks_like_, again);
    details_[answer_.mode ? "claimed" : "looks_like"] = name(problem_, looks_like_);
    details_["violated"] = nullptr;
    switch (outcome.kind) {
      case ModeOutcome::Kind::violated:
        details_["violated"] = name(problem_, *outcome.condition);
        details_["margin"] = exact_text(outcome.margin);
        break;
      case ModeOutcome::Kind::inconsistent:
        details_["reason"] = "the mode has no solution";
        break;
      case ModeOutcome::Kind::solution:
      case ModeOutcome::Kind::continuum:
        details_["reason"] = "the mode is right, its numbers are not";
        break;
    }
  }

  void accept(const std::vector<ProblemMode>& modes, const Distance& distance, RecordVerdict if_accurate) {
    result_.mode_names = inner_json_text(modes_json(modes));
    result_.max_error = enclose(distance.relative).upper;
    const bool accurate = distance.scaled <= to_rational(options_.tolerance);
    result_.verdict = accurate ? if_accurate : RecordVerdict::inaccurate;
  }

  bool near(const Distance& distance) const { return distance.scaled <= to_rational(contact_near); }

  void tell_every_q() {
    Effort again(options_.effort);
    const EveryLoad found = for_every_load(problem_, again);
    details_["every_q"] = slipproof::to_json(found, found.mode ? name(problem_, *found.mode) : "");
  }

  /// Judges the answer if all solutions are known.
  void judge_among(const ContactSolutions& all) {
    result_.motions = all.solutions.size();
    result_.continuum = !all.continua.empty();
    const std::vector<ProblemMode>* best = nullptr;
    std::vector<std::vector<ProblemMode>> continua;
    for (const auto& c : all.continua) continua.push_back({c.mode});
    Distance least;
    const auto consider = [&](const std::vector<ProblemMode>& modes, const Compared& to) {
      if (answer_.mode && std::find(modes.begin(), modes.end(), *answer_.mode) == modes.end()) return;
      Distance d = distance_to(to);
      if (best != nullptr && !is_nearer(d, least, to_rational(options_.tolerance))) return;
      best = &modes;
      least = std::move(d);
    };
    for (const auto& s : all.solutions) consider(s.modes, determined(s.z));
    for (std::size_t i = 0; i < continua.size(); ++i) consider(continua[i], nearest_member(all.continua[i]));
    if (best == nullptr || !near(least)) {
      result_.verdict = RecordVerdict::wrong;
      explain();
    } else {
      accept(*best, least, all.one() ? RecordVerdict::certified : RecordVerdict::ambiguous);
    }
    if (result_.verdict == RecordVerdict::certified) return;
    details_["found"] = Json::array();
    for (const auto& s : all.solutions) details_["found"].push_back(to_json(s));
    for (const auto& c : all.continua) details_["continua"].push_back(to_json(c));
  }

  /// Judges the answer by its own mode alone.
  void judge_alone() {
    ModeOutcome outcome = solver_.solve(looks_like_, effort_);
    result_.verdict = answer_.mode ? RecordVerdict::wrong : RecordVerdict::undecided;
    result_.counted = false;
    if (outcome.kind == ModeOutcome::Kind::solution || outcome.kind == ModeOutcome::Kind::continuum) {
      const Distance distance =
          distance_to(outcome.continuum ? nearest_member(*outcome.continuum) : determined(outcome.z));
      if (near(distance)) {
        // A continuum always has many solutions.
        const bool only = !outcome.continuum && is_unique_by_bound(problem_);
        accept({looks_like_}, distance,
               outcome.continuum ? RecordVerdict::ambiguous
               : only            ? RecordVerdict::certified
                                 : RecordVerdict::undecided);
        result_.motions = outcome.continuum ? 0 : 1;
        result_.counted = true;
        result_.continuum = outcome.continuum.has_value();
        if (only) {
          details_["unique_by"] = name(EveryLoad::Reason::bound);
          return;
        }
        details_["reason"] =
            outcome.continuum ? "in a mode with a continuum of solutions" : "near the solution of its mode";
        details_["unexamined"] = others_unexamined();
        return;
      }
    }
    explain();
    if (result_.verdict == RecordVerdict::undecided) details_["unexamined"] = others_unexamined();
  }

  std::string others_unexamined() const {
    const Work needed = solver_.work_of_all();  // continua take more
    return "the other modes: " + too_much_work(needed > options_.effort ? needed : endless, options_.effort);
  }

  const ContactProblem& problem_;
  const ProblemAnswer& answer_;
  const JudgeOptions& options_;
  const ContactSolver solver_;
  Effort effort_;
  Rational force_ = 0;
  ProblemMode looks_like_;
  RecordJudgement result_;
  Json details_ = Json::object();
};

}  // namespace

RecordJudgement judge_problem(const ContactProblem& problem, const ProblemAnswer& answer, const JudgeOptions& options) {
  RecordJudgement result = judged_or_undecided([&] { return Judge(problem, answer, options).judge(); });
  result.contact_problem = true;
  return result;
}

}  // namespace slipproof

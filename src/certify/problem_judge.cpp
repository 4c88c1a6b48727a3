#include "certify/problem_judge.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "certify/exact_judge.hpp"
#include "contact/every_load_json.hpp"
#include "number/binary64.hpp"
#include "number/format.hpp"

namespace slipproof {

namespace {

using Json = nlohmann::ordered_json;

Rational largest(const std::vector<Rational>& values) {
  Rational result = 0;
  for (const Rational& x : values) result = std::max(result, Rational(abs(x)));
  return result;
}

class Judge {
 public:
  Judge(const ContactProblem& problem, const ProblemAnswer& answer, const JudgeOptions& options)
      : problem_(problem), answer_(answer), options_(options), solver_(problem), effort_(options.effort) {
    for (std::size_t i = 0; i < problem.size(); ++i) {
      if (!problem.W[i][i].is_zero()) force_ = std::max(force_, Rational(abs(problem.q[i] / problem.W[i][i])));
    }
    if (force_.is_zero()) force_ = 1;
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
    result_.contact_problem = true;
    const std::string text = details_.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (!details_.empty()) result_.details = "," + text.substr(1, text.size() - 2);
    return std::move(result_);
  }

 private:
  Distance distance_to(const std::vector<Rational>& z) const {
    Distance d{0, 0};
    const auto compare = [&d](const std::vector<Rational>& found, const std::vector<Rational>& exact,
                              const Rational& scale) {
      for (std::size_t i = 0; i < exact.size(); ++i) {
        const Rational distance = abs(found[i] - exact[i]);
        if (distance.is_zero()) continue;
        d.relative = std::max(d.relative, Rational(distance / (exact[i].is_zero() ? scale : Rational(abs(exact[i])))));
        d.scaled = std::max(d.scaled, Rational(distance / scale));
      }
    };
    const Rational size = largest(z);
    compare(answer_.z, z, size.is_zero() ? force_ : size);
    if (answer_.w) {
      const auto w = accelerations(problem_, z);
      const Rational scale = std::max(largest(w), largest(problem_.q));
      compare(*answer_.w, w, scale.is_zero() ? Rational(1) : scale);
    }
    return d;
  }

  /// Every solution, if that is not too much work. Trying a few modes is faster than finding out that the matrix is
  /// definite.
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

  /// The solution of a continuum that is nearest to the answer's z, its largest distance of a component counting.
  std::vector<Rational> nearest_member(const ContactContinuum& c) {
    // Least s with |base + sum of t_k directions[k] - z| <= s in each component: variables t, then s.
    std::vector<AffineForm> constraints = c.conditions;
    for (AffineForm& form : constraints) form.coefficients.emplace_back(0);
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      for (const int sign : {1, -1}) {
        AffineForm form{sign * (c.base[i] - answer_.z[i]), {}};
        for (const auto& direction : c.directions) form.coefficients.push_back(sign * direction[i]);
        form.coefficients.emplace_back(1);
        constraints.push_back(std::move(form));
      }
    }
    AffineForm objective{0, std::vector<Rational>(c.directions.size() + 1)};
    objective.coefficients.back() = 1;
    return c.at(minimize(objective, constraints, effort_).x);
  }

  /// What the answer looks like, where the solver names no mode.
  ProblemMode mode_of_answer() const {
    const auto w = accelerations(problem_, answer_.z);
    ProblemMode mode;
    for (std::size_t i = 0; i < problem_.contacts(); ++i) {
      const std::size_t normal = problem_.frictional() ? 2 * i : i;
      const Rational& N = answer_.z[normal];
      const Rational size = abs(problem_.W[normal][normal]);
      const bool nothing = N.is_zero() && (!problem_.frictional() || answer_.z[normal + 1].is_zero());
      if (nothing || N * (size.is_zero() ? Rational(1) : size) <= w[normal]) {
        mode.push_back(ContactState::lift);
      } else if (!problem_.frictional()) {
        mode.push_back(ContactState::touch);
      } else if (abs(answer_.z[normal + 1]) < problem_.mu[i] * N * Rational(999999, 1000000)) {
        mode.push_back(ContactState::stick);
      } else {
        mode.push_back(answer_.z[normal + 1].sign() < 0 ? ContactState::slip_forward : ContactState::slip_backward);
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
            {"nearest_z", exact_json(nearest_member(c))}};
  }

  /// What speaks against the mode that the answer claims, or looks like.
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
    const std::string names = modes_json(modes).dump();
    result_.mode_names = names.substr(1, names.size() - 2);
    result_.max_error = enclose(distance.relative).upper;
    const bool accurate = distance.relative <= to_rational(options_.tolerance);
    result_.verdict = accurate ? if_accurate : RecordVerdict::inaccurate;
  }

  bool near(const Distance& distance) const { return distance.scaled <= to_rational(options_.near); }

  void tell_every_q() {
    Effort again(options_.effort);
    const EveryLoad found = for_every_load(problem_, again);
    details_["every_q"] = slipproof::to_json(found, found.mode ? name(problem_, *found.mode) : "");
  }

  /// All solutions are known.
  void judge_among(const ContactSolutions& all) {
    result_.motions = all.solutions.size();
    result_.continuum = !all.continua.empty();
    const std::vector<ProblemMode>* best = nullptr;
    std::vector<std::vector<ProblemMode>> continua;
    for (const auto& c : all.continua) continua.push_back({c.mode});
    Distance least;
    const auto consider = [&](const std::vector<ProblemMode>& modes, const std::vector<Rational>& z) {
      if (answer_.mode && std::find(modes.begin(), modes.end(), *answer_.mode) == modes.end()) return;
      Distance d = distance_to(z);
      if (best != nullptr && d.scaled >= least.scaled) return;
      best = &modes;
      least = std::move(d);
    };
    for (const auto& s : all.solutions) consider(s.modes, s.z);
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

  /// One mode alone is solved: the answer's.
  void judge_alone() {
    ModeOutcome outcome = solver_.solve(looks_like_, effort_);
    result_.verdict = answer_.mode ? RecordVerdict::wrong : RecordVerdict::undecided;
    if (outcome.kind == ModeOutcome::Kind::continuum) outcome.z = nearest_member(*outcome.continuum);
    if (outcome.kind == ModeOutcome::Kind::solution || outcome.kind == ModeOutcome::Kind::continuum) {
      const Distance distance = distance_to(outcome.z);
      if (near(distance)) {
        // A continuum is many solutions for certain.
        const bool only = !outcome.continuum && is_unique_by_bound(problem_);
        accept({looks_like_}, distance,
               outcome.continuum ? RecordVerdict::ambiguous
               : only            ? RecordVerdict::certified
                                 : RecordVerdict::undecided);
        result_.motions = outcome.continuum ? 0 : 1;
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
  return Judge(problem, answer, options).judge();
}

}  // namespace slipproof

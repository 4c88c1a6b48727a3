#include "records/problems/contact_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "base/output/json.hpp"
#include "base/parallel/failure.hpp"
#include "contact/enclosure/answer.hpp"
#include "contact/exact/exact_lcp.hpp"
#include "contact/formats/problem_check.hpp"
#include "contact/judge/all_solutions_json.hpp"
#include "contact/judge/find/find.hpp"
#include "contact/judge/others.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

namespace {

JudgedAnswer judge_one(const JudgedProblem& problem, const SolverAnswer& answer, const ContactFileOptions& options) {
  std::string reason;
  std::vector<double> x = answer_vector(problem.problem, problem.mixed, answer, reason);
  if (!reason.empty()) {
    JudgedAnswer result{answer.origin};
    result.judgement.reason = std::move(reason);
    return result;
  }
  // Velocities are those of bodies: what a compliance, a bias or a law of impact adds is none.
  const ProblemFile& file = problem.problem;
  const bool moved = !file.compliance.empty() || !file.bias.empty() || file.impact;
  const std::span<const double> u = moved ? std::span<const double>() : answer.u;
  auto tree = problem.answers.empty() ? nullptr : problem.answers.front().judgement.tree;
  JudgedAnswer result{answer.origin, judge_contacts(problem.mixed, x, u, options.judge, std::move(tree))};
  const bool finite = std::ranges::all_of(x, [](double component) { return std::isfinite(component); });
  if (file.impact && finite) result.energy = step_energy(file, x);
  if (problem.rigid) {
    ContactJudgeOptions rigid = options.judge;  // of an answer that its own law refuses, the verdict is enough
    if (result.judgement.verdict == ContactVerdict::wrong && !rigid.refine)
      rigid.effort = work_beyond_verdict(*problem.rigid, rigid.effort);
    result.coulomb = judge_contacts(*problem.rigid, std::move(x), answer.u, rigid);
  }
  return result;
}

/// If judging an answer fails, reports that with this answer; the others are still judged.
template <class Judge>
JudgedAnswer judged_or_undecided(const std::string& origin, const Judge& judge) {
  JudgedAnswer result{origin};
  if (const std::string failure = failure_of([&] { result = judge(); }); !failure.empty()) {
    result = {origin};
    result.judgement.verdict = ContactVerdict::undecided;
    result.judgement.reason = failure;
  }
  return result;
}

/// Starting points for the search if no answer is given: the result of an iteration over contacts, of Lemke's method if
/// there is no friction, and zero forces.
std::vector<std::vector<double>> starts(const MixedProblem& problem, const ContactJudgeOptions& options) {
  std::vector<std::vector<double>> result;
  result.push_back(approximate_solution(problem));
  if (is_complementarity(problem) && problem.size() <= 1000) {
    Effort effort(options.effort);
    if (const auto found = solve_lcp(problem, std::vector<bool>(problem.size(), false), effort)) {
      result.emplace_back();
      for (std::size_t i = 0; i < found->x.size(); ++i) result.back().push_back(nearest_binary64(found->x.at(i)));
    }
  }
  result.emplace_back(problem.size(), 0);
  std::erase_if(result, [&](auto& x) { return x.size() != problem.size() || !complete_free_unknowns(problem, x); });
  return result;
}

/// The known exact solution, rounded. It need not be near the answer that was judged.
std::vector<double> known_solution(const ContactJudgement& j) {
  if (j.enclosure) return center_of(*j.enclosure);
  std::vector<double> x;
  for (const Rational& value : j.exact.empty() ? j.every->point : j.exact) x.push_back(nearest_binary64(value));
  return x;
}

/// The first of all solutions as an answer, held against all of them; undecided if not all are found.
JudgedAnswer judge_first_of_all(const MixedProblem& problem, const ContactJudgeOptions& options) {
  ContactJudgement none = judge_contacts(problem, std::vector<double>(problem.size()), {}, options);
  if (!none.all) {
    ContactJudgement open;
    open.verdict = ContactVerdict::undecided;
    open.reason = "no answer is given, and not all solutions were found";
    open.left_out = std::move(none.left_out);
    return {"none", std::move(open)};
  }
  if (none.all->none()) return JudgedAnswer{"none", std::move(none)};
  std::vector<Rational> r;
  for (const Range& range : none.all->solutions.front().r) r.push_back((*range.lower + *range.upper) / 2);
  std::vector<double> x;
  for (const Rational& value : eliminated(problem)->with_free(std::move(r))) x.push_back(nearest_binary64(value));
  return JudgedAnswer{"found here", judge_contacts(problem, std::move(x), {}, options, none.tree)};
}

JudgedAnswer judge_what_is_found(const JudgedProblem& problem, const ContactFileOptions& options) {
  if (options.judge.all && problem.mixed.is_coulomb()) {
    JudgedAnswer found = judge_first_of_all(problem.mixed, options.judge);
    if (found.judgement.all || !options.judge.refine) return found;
  }
  JudgedAnswer result{"none"};
  result.judgement.verdict = ContactVerdict::undecided;
  result.judgement.reason = "no answer is given: --answer FILE, or --refine to look for one";
  if (!options.judge.refine) return result;
  for (std::vector<double>& start : starts(problem.mixed, options.judge)) {
    result.judgement = judge_contacts(problem.mixed, std::move(start), {}, options.judge, result.judgement.tree);
    const ContactVerdict verdict = result.judgement.verdict;
    using enum ContactVerdict;
    const bool far = verdict == wrong || verdict == inaccurate || verdict == not_converged;
    if (far && result.judgement.has_solution()) {
      result.judgement =
          judge_contacts(problem.mixed, known_solution(result.judgement), {}, options.judge, result.judgement.tree);
    }
    result.origin = "found here";
    if (result.judgement.verdict != ContactVerdict::wrong) return result;
  }
  result = {"none"};
  result.judgement.verdict = ContactVerdict::undecided;
  result.judgement.reason = "no answer is given, and none was found";
  return result;
}

/// Whether a file has guesses only, and none of them is near a solution: then they are no answers.
bool are_bad_guesses(const std::vector<JudgedAnswer>& answers) {
  return !answers.empty() && std::ranges::all_of(answers, [](const JudgedAnswer& a) {
    return a.origin.starts_with("/guesses/") && a.judgement.verdict == ContactVerdict::wrong;
  });
}

Json counted_from_one(const std::vector<std::size_t>& contacts) {
  Json list = Json::array();
  for (const std::size_t k : contacts) list.push_back(k + 1);
  return list;
}

Json worst_json(const Residual& residual, std::size_t most = 10) {
  Json list = Json::array();
  for (const Violation& v : std::span(residual.worst).first(std::min(most, residual.worst.size()))) {
    Json item;
    if (v.contact) {
      item["contact"] = *v.contact + 1;
    } else {
      item["row"] = v.row + 1;
    }
    item["violates"] = v.condition;
    item["by"] = at_most(v.amount);
    list.push_back(std::move(item));
  }
  return list;
}

/// What Coulomb's law says of the same forces.
Json coulomb_json(const ContactJudgement& j) {
  Json line{{"verdict", name(j.verdict)}};
  if (j.has_solution()) line["rho"] = at_most(j.rho);
  if (j.residual) {
    line["backward_error"] = at_most(j.residual->backward_error());
    line["worst"] = worst_json(*j.residual, 1);
  }
  if (j.velocity_error > 0) line["velocity_error"] = at_most(j.velocity_error);
  if (!j.reason.empty()) line["reason"] = j.reason;
  return line;
}

/// `tolerance`: what counts as no change.
Json energy_json(const StepEnergy& energy, double tolerance) {
  const auto gains = energy.gains(tolerance);
  return {{"before", energy.before ? Json(nearest_binary64(*energy.before)) : Json()},
          {"work", nearest_binary64(energy.work)},
          {"gains", gains ? Json(*gains) : Json()}};
}

/// What is known of other solutions than a certified answer's.
void add_others(const ContactJudgement& j, Json& line) {
  if (is_certified(j.verdict) && !j.others_excluded()) line["others"] = "not excluded";
  if (!j.linear_modes) return;
  line["linear_modes"] = Json{{"number", j.linear_modes->modes == unlimited ? Json() : Json(j.linear_modes->modes)},
                              {"tried", j.linear_modes->tried}};
}

/// Whether a solution that was found is the only one, and in what sense.
Json uniqueness(const ContactJudgement& j) {
  if (j.verdict == ContactVerdict::unique) return "globally";
  if (j.others_excluded()) return "velocities";
  return j.enclosure && j.enclosure->locally_unique ? Json("locally") : Json();
}

Json open_forces_json(const OpenForces& open) {
  Json normal = Json::array();
  for (const NormalRange& range : open.ranges) {
    normal.push_back({{"contact", range.contact + 1},
                      {"least", at_least(range.least)},
                      {"most", range.most ? Json(at_most(*range.most)) : Json()}});
  }
  return {{"velocities_within", at_most(open.change)},
          {"directions", open.directions},
          {"normal", std::move(normal)},
          {"all", open.all}};
}

/// What was found of all solutions, and where others may be.
Json some_json(const AllSolutions& some) {
  Json result{{"open_patterns", some.unexamined.size()}};
  if (some.open_speed) result["velocities_below"] = at_most(*some.open_speed);
  add_solutions(some, result);
  return result;
}

/// All solutions of a small problem, and the exact margin by which a wrong answer's mode fails.
Json all_json(const ContactJudgement& j) {
  Json all{{"solutions", j.all->singles()}, {"continuum", j.all->families() > 0}};
  if (j.own) add_own_mode(*j.own, all);
  add_solutions(*j.all, all);
  return all;
}

}  // namespace

JudgedProblem::JudgedProblem(std::string name, ReadProblem read, const ContactFileOptions& options)
    : file(std::move(name)), tolerance(options.judge.tolerance), problem(std::move(read.problem)) {
  if (options.law) problem.law.kind = *options.law;
  Mistakes mistakes(file);
  if (options.law) check_problem(problem, mistakes);
  mistakes.refuse_if_any();
  mixed = mixed_problem(problem);
  if (!mixed.is_coulomb() || !problem.compliance.empty() || !problem.bias.empty()) rigid = coulomb_problem(problem);
  const auto judge = [&](const SolverAnswer& answer) {
    answers.push_back(judged_or_undecided(answer.origin, [&] { return judge_one(*this, answer, options); }));
  };
  if (options.answer) {
    judge(*options.answer);
  } else {
    for (const SolverAnswer& answer : read.answers) judge(answer);
    if (options.judge.refine && are_bad_guesses(answers)) {
      JudgedAnswer found = judge_what_is_found(*this, options);
      if (found.origin != "none") answers.insert(answers.begin(), std::move(found));
    }
  }
  if (answers.empty())
    answers.push_back(judged_or_undecided("none", [&] { return judge_what_is_found(*this, options); }));
}

JudgedProblem judge_problem_file(std::string file, ReadProblem read, const ContactFileOptions& options) {
  return JudgedProblem(std::move(file), std::move(read), options);
}

std::string contact_line(const JudgedProblem& problem, std::size_t answer) {
  return fmt::format("{{\"record\":{}{}}}", answer + 1, contact_members(problem, answer));
}

std::string contact_members(const JudgedProblem& problem, std::size_t answer) {
  const ContactJudgement& j = problem.answers[answer].judgement;
  Json line{{"problem", problem.problem.title.empty() ? problem.file : problem.problem.title},
            {"answer", problem.answers[answer].origin},
            {"contacts", problem.mixed.contacts()},
            {"dimension", problem.mixed.dimension},
            {"verdict", name(j.verdict)}};
  if (j.has_solution()) {
    line["rho"] = at_most(j.rho);
    if (j.verdict == ContactVerdict::inaccurate || j.verdict == ContactVerdict::not_converged) {
      line["error"] = at_most(j.error);
    }
    if (is_certified(j.verdict) || j.verdict == ContactVerdict::ambiguous) line["unique"] = uniqueness(j);
  }
  add_others(j, line);
  if (j.every && std::isfinite(j.every->eta)) line["velocities_within"] = at_most(j.every->eta);
  const bool by_velocities = j.verdict == ContactVerdict::velocities_of_a_solution;
  if (by_velocities || (j.enclosure && j.enclosure->proof)) line["velocities_within"] = at_most(j.eta);
  if (j.excluded() > 0) line["no_solution_within"] = at_least(j.excluded());
  if (j.residual) {
    line["residual"] = at_most(j.residual->change);
    line["moved"] = at_most(j.residual->moved);
    line["backward_error"] = at_most(j.residual->backward_error());
    line["worst"] = worst_json(*j.residual);
  }
  if (j.velocity_error > 0) line["velocity_error"] = at_most(j.velocity_error);
  if (!problem.problem.force_unit.empty()) {
    line["units"] = Json{{"force", problem.problem.force_unit}, {"velocity", problem.problem.velocity_unit}};
  }
  if (j.law != FrictionLaw::cone) line["law"] = name(j.law);
  if (problem.problem.impact) line["impact"] = name(problem.problem.impact->law);
  if (const auto& energy = problem.answers[answer].energy) line["energy"] = energy_json(*energy, problem.tolerance);
  if (problem.answers[answer].coulomb) line["coulomb"] = coulomb_json(*problem.answers[answer].coulomb);
  if (j.right_for) line["right_for"] = name(*j.right_for);
  if (j.has_solution() || j.every) line["undetermined_forces"] = j.undetermined;
  if (j.open) line["open_forces"] = open_forces_json(*j.open);
  if (!j.reason.empty()) line["reason"] = j.reason;
  if (j.verdict == ContactVerdict::eps_solution && is_judged_by_residual(problem.mixed)) {
    line["nothing_stronger"] = true;
  }
  if (!j.contacts.empty()) line["about"] = counted_from_one(j.contacts);
  if (j.other) {
    Json other = Json::array();
    for (const double x : center_of(*j.other)) other.push_back(x);
    line["other"] = std::move(other);
  }
  if (!j.exact.empty() && j.exact.size() <= 64) line["exact"] = exact_texts(j.exact);
  if (!j.other_exact.empty()) line["other"] = exact_texts(j.other_exact);
  if (j.unique_by) line["unique_by"] = name(j.unique_by->kind);
  if (j.all) line["all"] = all_json(j);
  if (j.some) line["some"] = some_json(*j.some);
  if (!j.left_out.empty()) line["left_out"] = j.left_out;
  if (!problem.problem.remarks.empty()) line["remarks"] = problem.problem.remarks;
  return ',' + inner_json_text(line);
}

std::string refined_answer(const JudgedProblem& problem, std::size_t answer) {
  const ContactJudgement& j = problem.answers[answer].judgement;
  if (!j.has_solution()) return {};
  const std::vector<double> x = known_solution(j);
  const std::size_t bodies = problem.problem.form == ProblemForm::global ? problem.problem.M.rows : 0;
  Json result, radius = Json::array();
  for (std::size_t i = 0; i < x.size(); ++i) {
    result[i < bodies ? "v" : i < problem.mixed.free ? "lambda" : "r"].push_back(x[i]);
    if (!j.enclosure) {
      const double own = j.exact.empty() ? j.every->radius[i] : 0;
      const Rational& point = j.exact.empty() ? j.every->point[i] : j.exact[i];
      radius.push_back(enclose(abs(to_rational(x[i]) - point) + to_rational(own)).upper);
    } else {
      const std::size_t unknown = j.enclosure->system.unknown(i);
      radius.push_back(unknown == ModeSystem::none ? 0.0 : j.enclosure->radius[unknown]);
    }
  }
  for (std::size_t i = problem.mixed.free; i < x.size(); ++i) {
    result["u"].push_back(row_sum(problem.mixed, i, x).nearest());
  }
  result["radius"] = std::move(radius);
  return json_text(result) + '\n';
}

}  // namespace slipproof

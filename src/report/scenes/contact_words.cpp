#include "report/scenes/contact_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "mechanics/mechanism/mechanism.hpp"
#include "report/scenes/records/record_words.hpp"

namespace slipproof {

namespace {

std::string size_of(const MixedProblem& problem) {
  if (problem.dimension == 1) return counted(problem.contacts(), "component");
  return fmt::format("{} in dimension {}", counted(problem.contacts(), "contact"), problem.dimension);
}

std::string contact_list(const std::vector<std::size_t>& contacts) {
  return (contacts.size() == 1 ? "contact " : "contacts ") + numbers_words(contacts, 6);
}

std::string range_words(const NormalRange& range) {
  if (!range.most) return fmt::format("contact {} presses with {} or more", range.contact + 1, at_least(range.least));
  return fmt::format("contact {} presses with {} to {}", range.contact + 1, at_least(range.least),
                     at_most(*range.most));
}

/// What nothing determines, with the widest ranges.
std::string open_words(const OpenForces& open, const ContactUnits& units) {
  std::string text =
      fmt::format("Forces with these velocities, up to {}{}, are open along {}", at_most(open.change),
                  units.velocity.empty() ? "" : " " + units.velocity, counted(open.directions, "direction"));
  const std::size_t shown = std::min<std::size_t>(open.ranges.size(), 3);
  for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? ": " : ", ") + range_words(open.ranges[i]);
  if (shown > 0 && !units.force.empty()) text += " " + units.force;
  if (open.ranges.size() > shown) text += fmt::format("; and {} more", open.ranges.size() - shown);
  return text + (open.all ? "." : "; others were not looked at.");
}

std::string violation_words(const Violation& v) {
  return fmt::format("{}, {}, by {}", place_words(v.contact, v.row), v.condition, at_most(v.amount));
}

/// `zw = zz` for a solution in two modes.
std::string modes_words(const FoundSolution& solution) {
  std::string text;
  for (const std::string& mode : solution.modes) text += (text.empty() ? "" : " = ") + mode;
  return text;
}

/// How far solutions are apart in one of their quantities, and where most: `differ by up to 1.00e+00 at contact 2`.
std::string apart_words(const AllSolutions& all, std::vector<Range> FoundSolution::*quantity, const std::string& unit) {
  double most = 0;
  std::size_t where = 0;
  for (std::size_t i = 0; i < (all.solutions.front().*quantity).size(); ++i) {
    std::optional<Rational> least, largest;
    for (const FoundSolution& solution : all.solutions) {
      const Range& range = (solution.*quantity)[i];
      if (!range.lower || !range.upper) continue;
      if (!least || *range.lower < *least) least = range.lower;
      if (!largest || *range.upper > *largest) largest = range.upper;
    }
    const double apart = least ? enclose(Rational(*largest - *least)).upper : 0;
    if (apart > most) most = apart, where = i;
  }
  if (most == 0) return "are the same";
  return fmt::format("differ by up to {}{} at {}", at_most(most), unit.empty() ? "" : " " + unit,
                     place_words(where / all.dimension, 0));
}

/// What is known of the velocities of all that count as a solution: of a continuum that moves differently, or of
/// solutions so near that they were not told apart.
std::string around_words(const FoundSolution& solution, const ContactUnits& units) {
  Rational most;
  for (const Range& range : solution.around) most = std::max(most, Rational(*range.upper - *range.lower));
  const std::string width = at_most(enclose(most).upper) + (units.velocity.empty() ? "" : " " + units.velocity);
  if (solution.others.empty()) {
    return fmt::format(" Solutions that were not told apart from {} have velocities within {} of each other.",
                       modes_words(solution), width);
  }
  return fmt::format(" Along the continuum at {} velocities change: {} of its motions are proved, all are within {}.",
                     modes_words(solution), solution.others.size() + 1, width);
}

/// How many solutions there are, in which modes, and how they differ.
std::string solutions_words(const AllSolutions& all, const ContactUnits& units) {
  if (all.none()) return "It is proved that there is no solution.";
  constexpr std::size_t shown = 8;
  const std::size_t singles = all.singles(), families = all.families();
  std::string text = singles > 0 ? counted(singles, "solution") : "";
  if (families > 0) {
    text += fmt::format("{}{} of solutions", singles > 0 ? " and " : "",
                        families == 1 ? "1 continuum" : std::to_string(families) + " continua");
  }
  for (std::size_t i = 0; i < std::min(shown, all.solutions.size()); ++i) {
    const FoundSolution& solution = all.solutions[i];
    text += (i == 0 ? ": " : ", ") + modes_words(solution);
    if (!solution.is_family()) continue;
    text += fmt::format(" along {}", counted(solution.open_directions, "direction"));
    if (all.dimension == 3 && solution.others.empty() && solution.around.empty()) text += ", all with one motion";
  }
  if (all.solutions.size() > shown) text += fmt::format(" and {} more", all.solutions.size() - shown);
  text = "The problem has " + text + '.';
  for (const FoundSolution& solution : all.solutions) {
    if (!solution.around.empty()) text += around_words(solution, units);
  }
  if (all.solutions.size() < 2) return text;
  const std::string members = families > 0 ? " (of a continuum the one nearest to the answer)" : "";
  return text + fmt::format(" Their forces {}, their velocities {}{}.",
                            apart_words(all, &FoundSolution::r, units.force),
                            apart_words(all, &FoundSolution::u, units.velocity), members);
}

std::string own_mode_words(const OwnMode& own) {
  return fmt::format(
      "The answer {} the mode {}: {}.", own.claimed ? "claims" : "suggests", own.mode,
      own.violated ? *own.violated + " is violated by " + at_most(enclose(Rational(-own.margin)).upper) : own.reason);
}

}  // namespace

std::string place_words(const std::optional<std::size_t>& contact, std::size_t row) {
  return contact ? fmt::format("contact {}", *contact + 1) : fmt::format("row {}", row + 1);
}

std::string numbers_words(const std::vector<std::size_t>& contacts, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(contacts.size(), most); ++i) {
    text += (i == 0 ? "" : ", ") + std::to_string(contacts[i] + 1);
  }
  return contacts.size() > most ? text + fmt::format(" and {} more", contacts.size() - most) : text;
}

std::string verdict_words(const ContactJudgement& j, const ContactUnits& units) {
  const auto in = [](double bound, const std::string& unit) {
    return at_most(bound) + (unit.empty() ? "" : " " + unit);
  };
  switch (j.verdict) {
    case ContactVerdict::invalid:
      return "The answer is invalid: " + j.reason + ".";
    case ContactVerdict::undecided:
      return "Undecided: " + j.reason + ".";
    case ContactVerdict::no_solution:
      return "The problem has no solution: no forces keep all contacts from overlapping.";
    case ContactVerdict::unique:
      return fmt::format("The one solution of the problem is within {} of the answer.", in(j.rho, units.force));
    case ContactVerdict::ambiguous:
      return fmt::format("A solution is within {} of the answer, and there is another one elsewhere.",
                         in(j.rho, units.force));
    case ContactVerdict::solution_within_rho:
      return fmt::format("An exact solution is within {} of the answer in each component{}; {}.",
                         in(j.rho, units.force),
                         j.enclosure && j.enclosure->locally_unique ? ", and near it there is no other" : "",
                         j.others_excluded() ? "all solutions have its velocities" : "others are not excluded");
    case ContactVerdict::inaccurate:
      return fmt::format(
          "The answer is inaccurate: an exact solution is within {} of it in each component, an error of {}.",
          in(j.rho, units.force), at_most(j.error));
    case ContactVerdict::not_converged:
      return fmt::format(
          "The answer has not converged: an exact solution is within {} of it in each component, an error of {}.",
          in(j.rho, units.force), at_most(j.error));
    case ContactVerdict::velocities_within_rho:
      return fmt::format("Every solution has velocities within {} of those of the answer.",
                         in(j.every->eta, units.velocity));
    case ContactVerdict::velocities_of_a_solution:
      return fmt::format(
          "An exact solution has velocities within {} of those of the answer. Forces differ by up to {}. Others are "
          "not "
          "excluded.",
          in(j.eta, units.velocity), in(j.rho, units.force));
    case ContactVerdict::none_within_rho:
    case ContactVerdict::wrong:
      if (!j.reason.empty()) return "The answer is wrong: " + j.reason + ".";
      if (j.excluded() == 0) return "The answer is wrong: its backward error is too large.";
      return fmt::format("The answer is wrong: no solution is within {} of it.", at_least(j.excluded()));
    default:
      return "The answer solves a problem that is as near as its backward error; whether the problem itself has a "
             "solution near it is undecided.";
  }
}

std::vector<std::string> further_words(const ContactJudgement& j, const ContactUnits& units) {
  std::vector<std::string> sentences;
  if (j.verdict == ContactVerdict::eps_solution && !j.reason.empty()) {
    sentences.push_back(fmt::format("Nothing stronger: {}{}.", j.reason,
                                    j.contacts.empty() ? "" : " (" + contact_list(j.contacts) + ")"));
  }
  if (j.verdict == ContactVerdict::velocities_of_a_solution) {
    sentences.push_back(fmt::format("Forces are open: {} ({}).", j.reason, contact_list(j.contacts)));
  }
  if (j.right_for) {
    sentences.push_back(
        fmt::format("It is right for the {}: not the answer, but the law is another.", name(*j.right_for)));
  }
  if (j.verdict == ContactVerdict::wrong && j.velocity_error > j.residual->change) {
    sentences.push_back(
        fmt::format("Its velocities differ from those of its forces by up to {}.", at_most(j.velocity_error)));
  }
  if (j.unique_by) {
    sentences.push_back(fmt::format("There is one solution for every constant, too ({}).", name(j.unique_by->kind)));
  }
  if (j.linear_modes && !j.linear_modes->tried && is_certified(j.verdict) && !j.all) {
    sentences.emplace_back(
        "No other solution was looked for among modes without sliding: there are too many for the effort.");
  }
  if (j.own) sentences.push_back(own_mode_words(*j.own));
  if (j.all) sentences.push_back(solutions_words(*j.all, units));
  for (const std::string& failure : j.left_out) sentences.push_back("Not found, " + failure + ".");
  if (j.undetermined == 1) {
    sentences.emplace_back("1 component of the forces is determined by nothing; it is held as it is.");
  } else if (j.undetermined > 1) {
    sentences.push_back(counted(j.undetermined, "component") +
                        " of the forces are determined by nothing; they are held as they are.");
  }
  if (j.open) sentences.push_back(open_words(*j.open, units));
  return sentences;
}

ContactUnits units_of(const JudgedProblem& problem) {
  const ProblemFile& file = problem.problem;
  return {problem.mixed.free == 0 ? file.force_unit : "", file.velocity_unit};  // rho is of velocities, too
}

std::string coulomb_words(const JudgedProblem& problem, std::size_t answer) {
  const auto& coulomb = problem.answers[answer].coulomb;
  if (!coulomb) return {};
  const bool cone = problem.mixed.law.kind == FrictionLaw::cone;
  std::string text = cone ? "Without compliance and bias: " : "By Coulomb's law instead: ";
  text += verdict_words(*coulomb, units_of(problem));
  if (!coulomb->residual || coulomb->residual->worst.empty() || is_certified(coulomb->verdict)) return text;
  const Violation& v = coulomb->residual->worst.front();
  return text + fmt::format(" Worst: {}, {:.2g} % of the largest velocity.", violation_words(v),
                            100 * v.effect / coulomb->residual->scale);
}

std::string advice(const ContactJudgement& j) {
  switch (j.verdict) {
    case ContactVerdict::inaccurate:
      return tolerance_advice(at_most(j.error)) + " For a better answer: --refine FILE.";
    case ContactVerdict::not_converged:
    case ContactVerdict::eps_solution:
    case ContactVerdict::none_within_rho:
    case ContactVerdict::wrong:
      return "To look for a solution: --refine FILE.";
    case ContactVerdict::ambiguous:
    case ContactVerdict::solution_within_rho:
      return j.all || j.others_excluded() ? "" : "To find all solutions: --all.";
    default:
      return {};
  }
}

namespace {

/// `Impact by Newton's law: the answer GAINS 3 % of the energy.` A problem without bodies tells the work alone.
std::string energy_words(const JudgedProblem& problem, const StepEnergy& energy) {
  const std::string law = problem.problem.impact->law == ImpactLaw::newton ? "Newton's" : "Moreau's";
  const std::string text = "Impact by " + law + " law: the answer ";
  const auto gains = energy.gains(problem.tolerance);
  if (!gains) return text + "keeps the energy.";
  const std::string change = *gains ? "GAINS " : "loses ";
  if (energy.before && !energy.before->is_zero()) {
    return text + change + decimal_text(Rational(abs(energy.work) * 100 / *energy.before), 4) + " % of the energy.";
  }
  return text + change + "energy: the work of contacts is " + decimal_text(energy.work, 4) + ".";
}

}  // namespace

std::string contact_words(const JudgedProblem& problem, std::size_t answer) {
  const ContactJudgement& j = problem.answers[answer].judgement;
  std::string text =
      fmt::format("{}: {}, answer: {}\n", problem.file, size_of(problem.mixed), problem.answers[answer].origin);
  if (problem.mixed.law.kind != FrictionLaw::cone) text += fmt::format("  Judged by the {}.\n", name(j.law));
  text += "  " + verdict_words(j, units_of(problem)) + '\n';
  if (j.residual) {
    text += fmt::format("  Backward error {} of the largest {}", at_most(j.residual->backward_error()),
                        problem.mixed.free == 0 ? "constant" : "of its kind");
    const std::size_t listed = is_certified(j.verdict) ? 1 : 3;
    for (std::size_t i = 0; i < std::min(listed, j.residual->worst.size()); ++i) {
      text += (i == 0 ? "; worst: " : "; ") + violation_words(j.residual->worst[i]);
    }
    text += ".\n";
  }
  for (const std::string& sentence : further_words(j, units_of(problem))) text += "  " + sentence + '\n';
  if (const std::string words = coulomb_words(problem, answer); !words.empty()) text += "  " + words + '\n';
  if (const auto& energy = problem.answers[answer].energy) text += "  " + energy_words(problem, *energy) + '\n';
  for (const std::string& remark : problem.problem.remarks) text += "  Note: " + remark + ".\n";
  return text;
}

}  // namespace slipproof

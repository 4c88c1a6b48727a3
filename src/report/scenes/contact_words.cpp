#include "report/scenes/contact_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number/format.hpp"

namespace slipproof {

namespace {

std::string size_of(const MixedProblem& problem) {
  if (problem.dimension == 1) return counted(problem.contacts(), "component");
  return fmt::format("{} in dimension {}", counted(problem.contacts(), "contact"), problem.dimension);
}

std::string contact_list(const std::vector<std::size_t>& contacts) {
  std::string text = contacts.size() == 1 ? "contact" : "contacts";
  for (std::size_t i = 0; i < std::min<std::size_t>(contacts.size(), 6); ++i) {
    text += fmt::format("{} {}", i == 0 ? "" : ",", contacts[i] + 1);
  }
  return contacts.size() > 6 ? text + fmt::format(" and {} more", contacts.size() - 6) : text;
}

std::string place_of(const Violation& v) {
  return v.contact ? fmt::format("contact {}", *v.contact + 1) : fmt::format("row {}", v.row + 1);
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
  return fmt::format("{}, {}, by {}", place_of(v), v.condition, at_most(v.amount));
}

}  // namespace

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
      return fmt::format("An exact solution is within {} of the answer in each component{}; others are not excluded.",
                         in(j.rho, units.force),
                         j.enclosure && j.enclosure->locally_unique ? ", and near it there is no other" : "");
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
  if (j.linear_modes && !j.linear_modes->tried && is_certified(j.verdict)) {
    sentences.emplace_back(
        "No other solution was looked for among modes without sliding: there are too many for the effort.");
  }
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
  for (const std::string& remark : problem.problem.remarks) text += "  Note: " + remark + ".\n";
  return text;
}

}  // namespace slipproof

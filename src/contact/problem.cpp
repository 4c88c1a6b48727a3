#include "contact/problem.hpp"

#include <algorithm>

#include "modes/delassus.hpp"

namespace slipproof {

std::string name(const ContactProblem& problem, const ProblemMode& mode) {
  if (problem.frictional()) return name(mode);
  std::string text;
  for (const ContactState state : mode) text += state == ContactState::lift ? 'w' : 'z';
  return text;
}

std::optional<ProblemMode> parse_mode(const ContactProblem& problem, std::string_view text) {
  ProblemMode mode;
  if (!problem.frictional()) {
    if (text.find_first_not_of("zw") != std::string_view::npos) return std::nullopt;
    for (const char c : text) mode.push_back(c == 'w' ? ContactState::lift : ContactState::touch);
  } else {
    const auto known = states(problem.kind());
    while (true) {
      const std::string_view word = text.substr(0, text.find('/'));
      const auto state = parse_element_state(word);
      if (!state || std::find(known.begin(), known.end(), *state) == known.end()) return std::nullopt;
      mode.push_back(*state);
      if (word.size() == text.size()) break;
      text.remove_prefix(word.size() + 1);
    }
  }
  if (mode.size() != problem.contacts()) return std::nullopt;
  return mode;
}

std::vector<ProblemCondition> conditions(const ContactProblem& problem, const ProblemMode& mode) {
  std::vector<ProblemCondition> list;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    for (const StateCondition c : conditions(problem.kind(), mode[i])) list.push_back({i, c});
  }
  return list;
}

std::string name(const ContactProblem& problem, const ProblemCondition& condition) {
  const std::string j = std::to_string(condition.contact + 1);
  switch (condition.kind) {
    case StateCondition::pushes:
      return (problem.frictional() ? "N" : "z") + j + " >= 0";
    case StateCondition::slips_forward:
      return "slip" + j + " >= 0";
    case StateCondition::slips_backward:
      return "slip" + j + " <= 0";
    case StateCondition::opens:
      return (problem.frictional() ? "gap" : "w") + j + " >= 0";
    default:
      return "|T" + j + "| <= mu N" + j;
  }
}

Rational condition_value(const ContactProblem& problem, const ProblemCondition& condition,
                         const std::vector<Rational>& z, const std::vector<Rational>& w) {
  const std::size_t i = condition.contact, normal = problem.frictional() ? 2 * i : i;
  switch (condition.kind) {
    case StateCondition::pushes:
      return z[normal];
    case StateCondition::holds_forward:
      return problem.mu[i] * z[normal] - z[normal + 1];
    case StateCondition::holds_backward:
      return problem.mu[i] * z[normal] + z[normal + 1];
    case StateCondition::slips_forward:
      return w[normal + 1];
    case StateCondition::slips_backward:
      return -w[normal + 1];
    default:
      return w[normal];
  }
}

bool solves(const ContactProblem& problem, const ProblemMode& mode, const std::vector<Rational>& z) {
  const auto w = accelerations(problem, z);
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const std::size_t normal = problem.frictional() ? 2 * i : i, tangential = normal + 1;
    const std::vector<Rational>& nothing = mode[i] == ContactState::lift ? z : w;
    if (!nothing[normal].is_zero()) return false;
    if (!problem.frictional()) continue;
    const int direction = slip_direction(mode[i]);
    if (direction == 0 ? !nothing[tangential].is_zero() : z[tangential] != -direction * problem.mu[i] * z[normal]) {
      return false;
    }
  }
  const auto list = conditions(problem, mode);
  return std::all_of(list.begin(), list.end(), [&](const ProblemCondition& condition) {
    return condition_value(problem, condition, z, w).sign() >= 0;
  });
}

std::vector<Rational> accelerations(const ContactProblem& problem, const std::vector<Rational>& z) {
  std::vector<Rational> w = problem.q;
  for (std::size_t i = 0; i < w.size(); ++i) {
    for (std::size_t j = 0; j < z.size(); ++j) {
      if (!z[j].is_zero()) w[i] += problem.W[i][j] * z[j];
    }
  }
  return w;
}

std::optional<ContactProblem> contact_problem(const Bicycle<Rational>& bicycle, const Road<Rational>& road,
                                              ForceKind kind, const Rational& F) {
  const auto form = delassus(bicycle, road, kind);
  if (!form) return std::nullopt;
  ContactProblem problem;
  for (std::size_t i = 0; i < form->W.size(); ++i) {
    problem.W.emplace_back(form->W[i].begin(), form->W[i].end());
    problem.q.push_back(form->free[i] + form->per_force[i] * F);
  }
  problem.mu = {road.f, road.f};
  return problem;
}

std::string mistake_in(const ContactProblem& p) {
  const std::size_t n = p.size();
  const auto found = [](std::size_t rows, const std::string& what) { return std::to_string(rows) + " " + what; };
  if (n == 0 || n > max_problem_size) {
    return "found " + found(n, "components of q") + ", expected 1 to " + std::to_string(max_problem_size);
  }
  if (p.W.size() != n)
    return "found " + found(p.W.size(), "rows of W") + ", expected " + std::to_string(n) + " as in q";
  for (std::size_t i = 0; i < n; ++i) {
    if (p.W[i].size() == n) continue;
    return "found " + found(p.W[i].size(), "entries in row ") + std::to_string(i + 1) + " of W, expected " +
           std::to_string(n) + " as in q";
  }
  if (p.frictional() && 2 * p.mu.size() != n) {
    return "found " + found(p.mu.size(), "coefficients mu") + " for " + std::to_string(n) +
           " components of q, expected one for each pair of them";
  }
  for (std::size_t i = 0; i < p.mu.size(); ++i) {
    if (p.mu[i].sign() < 0) return "found mu" + std::to_string(i + 1) + " = " + p.mu[i].str() + ", expected >= 0";
  }
  return {};
}

}  // namespace slipproof

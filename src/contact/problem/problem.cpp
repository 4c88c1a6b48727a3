#include "contact/problem/problem.hpp"

#include <algorithm>

namespace slipproof {

std::string name(const ContactProblem& problem, const ProblemMode& mode) {
  if (problem.frictional()) return name(mode);
  std::string text;
  for (const ElementState state : mode) text += state == ElementState::lift ? 'w' : 'z';
  return text;
}

std::optional<ProblemMode> parse_mode(const ContactProblem& problem, std::string_view text) {
  ProblemMode mode;
  if (!problem.frictional()) {
    if (text.find_first_not_of("zw") != std::string_view::npos) return std::nullopt;
    for (const char c : text) mode.push_back(c == 'w' ? ElementState::lift : ElementState::touch);
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

std::string name(const ContactProblem& problem, const ViolatedCondition& condition) {
  const std::string j = std::to_string(condition.element + 1);
  switch (condition.condition) {
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

std::vector<Rational> accelerations(const ContactProblem& problem, const std::vector<Rational>& z) {
  std::vector<Rational> w = problem.q;
  for (std::size_t i = 0; i < w.size(); ++i) {
    for (std::size_t j = 0; j < z.size(); ++j) {
      if (!z[j].is_zero()) w[i] += problem.W[i][j] * z[j];
    }
  }
  return w;
}

FrictionProblem friction_problem(const ContactProblem& p) {
  FrictionProblem problem;
  problem.unknowns = p.size();
  for (std::size_t i = 0; i < p.size(); ++i) {
    problem.accelerations.push_back({0, std::vector<Rational>(p.size() + 1)});
    problem.accelerations.back().coefficients[i] = 1;
  }
  const auto w = [&](std::size_t i) {
    AffineForm form{p.q[i], p.W[i]};
    form.coefficients.emplace_back(0);
    return form;
  };
  for (std::size_t i = 0; i < p.contacts(); ++i) {
    const std::size_t normal = p.frictional() ? 2 * i : i;
    ProblemElement& e = problem.elements.emplace_back();
    e.kind = p.kind();
    e.gap = w(normal);
    e.normal = problem.accelerations[normal];
    if (!p.frictional()) continue;
    e.slip = w(normal + 1);
    e.tangent = problem.accelerations[normal + 1];
    e.static_limit = e.normal;
    e.static_limit.coefficients[normal] = p.mu[i];
    e.kinetic_limit = e.static_limit;
  }
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

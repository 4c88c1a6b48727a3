#include "mechanics/kernel/fourier_motzkin.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace slipproof::test {

namespace {

using Inequalities = std::vector<RawSystem::Inequality>;

AffineForm combined(const Rational& p, const AffineForm& x, const Rational& q, const AffineForm& y) {
  AffineForm result{p * x.constant + q * y.constant, {}};
  for (std::size_t i = 0; i < x.coefficients.size(); ++i) {
    result.coefficients.push_back(p * x.coefficients[i] + q * y.coefficients[i]);
  }
  return result;
}

bool has_no_variable(const AffineForm& form) {
  return std::all_of(form.coefficients.begin(), form.coefficients.end(), [](const auto& c) { return c.is_zero(); });
}

/// Of inequalities with the same direction the tightest; nothing if one cannot hold.
std::optional<Inequalities> tidied(const Inequalities& inequalities) {
  std::map<std::vector<Rational>, std::pair<Rational, bool>> tightest;
  for (const auto& [form, strict] : inequalities) {
    if (has_no_variable(form)) {
      if (form.constant < 0 || (strict && form.constant == 0)) return std::nullopt;
      continue;
    }
    const auto first = std::find_if(form.coefficients.begin(), form.coefficients.end(),
                                    [](const Rational& c) { return !c.is_zero(); });
    const AffineForm scaled = combined(1 / abs(*first), form, 0, form);
    const auto [place, is_new] = tightest.try_emplace(scaled.coefficients, scaled.constant, strict);
    auto& [constant, is_strict] = place->second;
    if (is_new || scaled.constant > constant) continue;
    is_strict = strict || (is_strict && scaled.constant == constant);
    constant = scaled.constant;
  }
  Inequalities result;
  for (const auto& [coefficients, side] : tightest) result.push_back({{side.first, coefficients}, side.second});
  return result;
}

/// Solves the equations for variables other than `kept`; an equation with `kept` alone becomes two inequalities. False
/// if they contradict each other.
bool solve_equations(RawSystem& system, std::size_t kept) {
  while (!system.equations.empty()) {
    const AffineForm equation = system.equations.back();
    system.equations.pop_back();
    if (has_no_variable(equation)) {
      if (equation.constant != 0) return false;
      continue;
    }
    std::size_t pivot = 0;
    while (pivot < equation.coefficients.size() && (pivot == kept || equation.coefficients[pivot].is_zero())) ++pivot;
    if (pivot == equation.coefficients.size()) {
      system.inequalities.push_back({equation, false});
      system.inequalities.push_back({combined(-1, equation, 0, equation), false});
      continue;
    }
    const auto solve = [&](AffineForm& form) {
      form = combined(1, form, -form.coefficients[pivot] / equation.coefficients[pivot], equation);
    };
    for (AffineForm& form : system.equations) solve(form);
    for (auto& inequality : system.inequalities) solve(inequality.form);
  }
  return true;
}

/// Every sum of an inequality that bounds the variable from below and one that bounds it from above.
Inequalities without(const Inequalities& inequalities, std::size_t variable) {
  Inequalities result;
  for (const auto& lower : inequalities) {
    const Rational& up = lower.form.coefficients[variable];
    if (up == 0) result.push_back(lower);
    if (up <= 0) continue;
    for (const auto& upper : inequalities) {
      const Rational& down = upper.form.coefficients[variable];
      if (down < 0) result.push_back({combined(-down, lower.form, up, upper.form), lower.strict || upper.strict});
    }
  }
  return result;
}

/// The variable, other than `kept`, that makes the fewest new inequalities; none if only `kept` is left.
std::optional<std::size_t> next_variable(const Inequalities& inequalities, std::size_t kept) {
  std::optional<std::size_t> best;
  std::size_t fewest = 0;
  for (std::size_t v = 0; !inequalities.empty() && v < inequalities[0].form.coefficients.size(); ++v) {
    std::size_t above = 0, below = 0;
    for (const auto& inequality : inequalities) {
      above += inequality.form.coefficients[v] > 0 ? 1 : 0;
      below += inequality.form.coefficients[v] < 0 ? 1 : 0;
    }
    if (v == kept || above + below == 0 || (best && above * below >= fewest)) continue;
    best = v;
    fewest = above * below;
  }
  return best;
}

}  // namespace

ForceInterval shadow(const RawSystem& system, std::size_t variable) {
  RawSystem solved = system;
  if (!solve_equations(solved, variable)) return ForceInterval::nothing();
  auto left = tidied(solved.inequalities);
  while (left) {
    const auto next = next_variable(*left, variable);
    if (!next) break;
    left = tidied(without(*left, *next));
  }
  if (!left) return ForceInterval::nothing();
  ForceInterval result;
  for (const auto& [form, strict] : *left) {
    const Rational root = -form.constant / form.coefficients[variable];
    result.intersect(form.coefficients[variable] > 0 ? ForceInterval::between(root, !strict, std::nullopt, false)
                                                     : ForceInterval::between(std::nullopt, false, root, !strict));
  }
  return result;
}

ForceInterval shadow(const RawSystem& system, const AffineForm& form) {
  RawSystem longer = system;
  for (AffineForm& equation : longer.equations) equation.coefficients.emplace_back(0);
  for (auto& inequality : longer.inequalities) inequality.form.coefficients.emplace_back(0);
  longer.equations.push_back(form);
  longer.equations.back().coefficients.emplace_back(-1);
  return shadow(longer, form.coefficients.size());
}

bool is_solvable(const RawSystem& system) {
  return !shadow(system, static_cast<std::size_t>(-1)).empty();
}

}  // namespace slipproof::test

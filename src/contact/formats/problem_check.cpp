#include "contact/formats/problem_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace slipproof {

namespace {

std::string short_number(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g", x);
  return text.data();
}

std::string not_finite(double x) {
  return std::string("found ") + (std::isnan(x) ? "NaN" : "an infinity") + ", expected a finite number";
}

class ProblemCheck {
 public:
  explicit ProblemCheck(Mistakes& mistakes) : mistakes_(mistakes) {}

  void matrix(const char* name, const SparseMatrix& m, std::size_t rows, std::size_t columns) {
    const auto shape = [](std::size_t r, std::size_t c) {
      return std::to_string(r) + " rows and " + std::to_string(c) + " columns";
    };
    if (m.rows != rows || m.columns != columns) {
      add(std::string(name) + ": found " + shape(m.rows, m.columns) + ", expected " + shape(rows, columns));
    }
    for (std::size_t i = 0; i < m.rows; ++i) {
      const auto values = m.values_of(i);
      const auto wrong = std::ranges::find_if(values, [](double x) { return !std::isfinite(x); });
      if (wrong == values.end()) continue;
      const std::size_t column = m.columns_of(i)[static_cast<std::size_t>(wrong - values.begin())];
      return add(name + place(i) + place(column) + ": " + not_finite(*wrong));
    }
  }

  void size(const std::string& name, const std::vector<double>& v, std::size_t expected) {
    if (v.size() == expected) return;
    add(name + ": found " + std::to_string(v.size()) + " numbers, expected " + std::to_string(expected));
  }

  void finite(const std::string& name, const std::vector<double>& v) {
    const auto wrong = std::ranges::find_if(v, [](double x) { return !std::isfinite(x); });
    if (wrong != v.end()) add(name + place(static_cast<std::size_t>(wrong - v.begin())) + ": " + not_finite(*wrong));
  }

  /// Numbers that are not negative, being `what`.
  void magnitudes(const std::string& name, const std::vector<double>& v, std::size_t expected, const char* what) {
    size(name, v, expected);
    finite(name, v);
    refuse_first(name, v, std::string(what) + ", which is not negative", [](double x) { return x < 0; });
  }

  /// From 0 to 1.
  void shares(const std::string& name, const std::vector<double>& v, std::size_t expected) {
    size(name, v, expected);
    finite(name, v);
    refuse_first(name, v, "a restitution, from 0 to 1", [](double x) { return x < 0 || x > 1; });
  }

  void add(const std::string& message) { mistakes_.add({}, message); }

 private:
  template <class Wrong>
  void refuse_first(const std::string& name, const std::vector<double>& v, const std::string& expected,
                    const Wrong& wrong) {
    const auto found = std::ranges::find_if(v, wrong);
    if (found == v.end()) return;
    add(name + place(static_cast<std::size_t>(found - v.begin())) + fmt::format(": found {}, expected ", *found) +
        expected);
  }
  static std::string place(std::size_t i) { return "[" + std::to_string(i + 1) + "]"; }

  Mistakes& mistakes_;
};

bool given(const SparseMatrix& m) {
  return m.rows != 0 || m.columns != 0;
}

void check_velocities(const ProblemFile& p, ProblemCheck& check) {
  check.matrix("W", p.W, p.q.size(), p.q.size());
  check.finite("q", p.q);
  if (!given(p.V) && !given(p.R) && p.s.empty()) return;
  check.matrix("V", p.V, p.q.size(), p.s.size());
  check.matrix("R", p.R, p.s.size(), p.s.size());
  check.finite("s", p.s);
}

void check_global(const ProblemFile& p, ProblemCheck& check) {
  check.matrix("M", p.M, p.f.size(), p.f.size());
  check.matrix("H", p.H, p.f.size(), p.w.size());
  check.finite("f", p.f);
  check.finite("w", p.w);
  if (!given(p.G) && p.b.empty()) return;
  check.matrix("G", p.G, p.f.size(), p.b.size());
  check.finite("b", p.b);
}

void check_contacts(const ProblemFile& p, ProblemCheck& check) {
  if (p.form == ProblemForm::complementarity) {
    if (p.dimension != 1) check.add("found the dimension " + std::to_string(p.dimension) + ", expected 1 without mu");
    check.size("mu", p.mu, 0);
    return;
  }
  if (p.dimension != 2 && p.dimension != 3) {
    return check.add("found the dimension " + std::to_string(p.dimension) + ", expected 2 or 3");
  }
  const std::size_t components = p.form == ProblemForm::global ? p.w.size() : p.q.size();
  if (components % p.dimension != 0) {
    check.add("found " + std::to_string(components) + " components, expected a multiple of the dimension " +
              std::to_string(p.dimension));
  }
  check.magnitudes("mu", p.mu, components / p.dimension, "a coefficient of friction");
}

/// That the law has what it needs, and nothing that only others need.
void check_law(const ProblemFile& p, ProblemCheck& check) {
  const std::size_t components = p.components();
  if (!p.compliance.empty()) check.magnitudes("compliance", p.compliance, components, "a compliance");
  if (!p.bias.empty()) {
    check.size("bias", p.bias, components);
    check.finite("bias", p.bias);
  }
  const bool regularised = p.law.kind == FrictionLaw::regularised;
  if (is_bounded(p.law.kind) || !p.law.bounds.empty()) {
    const std::size_t bounds = p.contacts() * bounds_of_contact(p.law.kind, p.dimension);
    check.magnitudes("bounds", p.law.bounds, bounds, "a bound of a tangential component");
  }
  if ((regularised || p.law.slip_speed != 0) && !(p.law.slip_speed > 0 && std::isfinite(p.law.slip_speed))) {
    const std::string found = p.law.slip_speed == 0 ? "nothing or 0" : short_number(p.law.slip_speed);
    check.add("slip_speed: found " + found + ", expected a speed above 0");
  }
}

void check_impact(const ProblemFile& p, ProblemCheck& check) {
  if (!p.impact) return;
  const StepImpact& impact = *p.impact;
  check.shares("restitution", impact.restitution, p.contacts());
  if (!impact.tangential_restitution.empty()) {
    check.shares("tangential_restitution", impact.tangential_restitution, p.contacts());
  }
  const bool global = p.form == ProblemForm::global;
  check.size(velocities_before_key(global), impact.before, global ? p.f.size() : p.components());
  check.finite(velocities_before_key(global), impact.before);
}

/// Rows of A x added to `sum`, their absolute values to `scale`.
void add_product(const SparseMatrix& A, const std::vector<double>& x, std::vector<double>& sum,
                 std::vector<double>& scale) {
  for (std::size_t i = 0; i < A.rows && i < sum.size(); ++i) {
    for (std::size_t k = A.starts[i]; k < A.starts[i + 1]; ++k) {
      const double term = A.value[k] * x[A.column[k]];
      sum[i] += term;
      scale[i] += std::abs(term);
    }
  }
}

/// How far `left` is from A x + B y + constant, if by more than rounding.
std::optional<double> distance(const std::vector<double>& left, const SparseMatrix& A, const std::vector<double>& x,
                               const SparseMatrix& B, const std::vector<double>& y, const std::vector<double>& constant,
                               std::vector<double> scale) {
  std::vector<double> sum = constant;
  for (std::size_t i = 0; i < sum.size(); ++i) scale[i] += std::abs(sum[i]) + std::abs(left[i]);
  if (x.size() == A.columns) add_product(A, x, sum, scale);
  if (y.size() == B.columns) add_product(B, y, sum, scale);
  double largest = 0, largest_scale = 0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    largest = std::max(largest, std::abs(sum[i] - left[i]));
    largest_scale = std::max(largest_scale, scale[i]);
  }
  if (largest > 1e-9 * largest_scale) return largest;
  return std::nullopt;
}

void remark_asymmetry(const char* name, const SparseMatrix& matrix, ProblemFile& problem) {
  const Asymmetry found = asymmetry(matrix);
  if (found.difference == 0) return;
  problem.remarks.push_back(std::string(name) + " is asymmetric: the entry in row " + std::to_string(found.row + 1) +
                            " and column " + std::to_string(found.column + 1) + " differs from its opposite by " +
                            short_number(found.difference) + ", which is " +
                            short_number(found.difference / found.largest) + " of the largest entry");
}

/// Where a compliance or a bias is added to a number of the problem, the sum is rounded: that is the problem of the
/// law.
void remark_rounded(const char* name, const std::vector<double>& added, ProblemFile& problem) {
  double largest = 0;
  for (std::size_t i = 0; i < added.size(); ++i) {
    double to = name[0] == 'b' ? (problem.form == ProblemForm::global ? problem.w[i] : problem.q[i]) : 0;
    if (name[0] == 'c' && problem.form != ProblemForm::global) {
      const auto columns = problem.W.columns_of(i);
      const auto found = std::ranges::find(columns, i);
      if (found != columns.end()) to = problem.W.values_of(i)[static_cast<std::size_t>(found - columns.begin())];
    }
    const double sum = to + added[i], rest = sum - to;
    const double lost = (to - (sum - rest)) + (added[i] - rest);  // exact: what the sum leaves out
    largest = std::max(largest, std::abs(lost));
  }
  if (largest == 0) return;
  problem.remarks.push_back(std::string("the ") + name + " is added in binary64, which changes it by up to " +
                            short_number(largest));
}

}  // namespace

DimensionBySizes dimension_by_sizes(std::size_t components, std::optional<std::size_t> coefficients) {
  const auto fits = [&](std::size_t d) {
    return components > 0 && (coefficients ? *coefficients * d == components : components % d == 0);
  };
  const std::string size = std::to_string(components) + " components";
  if (fits(2) && fits(3)) {
    return {0, "dimension",
            "found nothing, and one mu for " + size + ", expected 2 or 3: they are of " +
                std::to_string(components / 2) + " contacts in the plane or of " + std::to_string(components / 3) +
                " in space"};
  }
  if (fits(2) || fits(3)) return {fits(2) ? std::size_t{2} : std::size_t{3}, {}, {}};
  return {0, "mu",
          "found " + (coefficients ? std::to_string(*coefficients) + " coefficients" : std::string("one number")) +
              " for " + size + ", expected 2 or 3 components for each contact"};
}

void check_problem(const ProblemFile& problem, Mistakes& mistakes) {
  ProblemCheck check(mistakes);
  if (problem.form == ProblemForm::global) {
    check_global(problem, check);
  } else {
    check_velocities(problem, check);
  }
  check_contacts(problem, check);
  check_law(problem, check);
  check_impact(problem, check);
}

AnswerSizes answer_sizes(const ProblemFile& problem) {
  const bool global = problem.form == ProblemForm::global;
  return {.r = problem.components(),
          .u = problem.components(),
          .v = global ? problem.f.size() : 0,
          .lambda = global ? problem.b.size() : problem.s.size()};
}

void check_answer(const ProblemFile& problem, const SolverAnswer& answer, const std::string& where,
                  Mistakes& mistakes) {
  ProblemCheck check(mistakes);
  const AnswerSizes sizes = answer_sizes(problem);
  const auto size = [&](const char* part, const std::vector<double>& v, std::optional<std::size_t> expected) {
    if (!v.empty()) check.size(where + part, v, *expected);
  };
  size("r", answer.r, sizes.r);
  size("u", answer.u, sizes.u);
  size("v", answer.v, sizes.v);
  size("lambda", answer.lambda, sizes.lambda);
}

Asymmetry asymmetry(const SparseMatrix& matrix) {
  Asymmetry result;
  const SparseMatrix other = transposed(matrix);
  const auto differ = [&result](std::size_t row, std::size_t column, double difference) {
    if (std::abs(difference) > result.difference) result = {std::abs(difference), result.largest, row, column};
  };
  for (const double x : matrix.value) result.largest = std::max(result.largest, std::abs(x));
  for (std::size_t i = 0; i < std::min(matrix.rows, other.rows); ++i) {
    std::size_t k = matrix.starts[i], l = other.starts[i];
    while (k < matrix.starts[i + 1] || l < other.starts[i + 1]) {
      const bool here = k < matrix.starts[i + 1], there = l < other.starts[i + 1];
      const bool both = here && there && matrix.column[k] == other.column[l];
      if (both) {
        differ(i, matrix.column[k], matrix.value[k] - other.value[l]);
        ++k, ++l;
      } else if (here && (!there || matrix.column[k] < other.column[l])) {
        differ(i, matrix.column[k], matrix.value[k]);
        ++k;
      } else {
        differ(i, other.column[l], other.value[l]);
        ++l;
      }
    }
  }
  return result;
}

std::optional<std::string> contradiction(const ProblemFile& problem, const SolverAnswer& answer) {
  const bool zero = std::ranges::all_of(answer.r, [](double x) { return x == 0; });
  if (answer.r.empty() || !zero) return std::nullopt;
  const bool global = problem.form == ProblemForm::global;
  const std::size_t bilateral = global ? problem.b.size() : problem.s.size();
  if (answer.lambda.size() != bilateral) return std::nullopt;
  std::optional<double> off;
  if (global && answer.v.size() == problem.f.size()) {
    // M v may be made of large terms that cancel; they are the measure.
    std::vector<double> left(problem.f.size()), scale(problem.f.size());
    add_product(problem.M, answer.v, left, scale);
    off = distance(left, problem.H, answer.r, problem.G, answer.lambda, problem.f, scale);
    if (off)
      return std::string("r is 0, and M v differs from H r ") + (bilateral == 0 ? "" : "+ G lambda ") +
             "+ f by up to " + short_number(*off);
  }
  if (answer.u.size() != problem.components()) return std::nullopt;
  const std::vector<double> scale(answer.u.size());
  if (!global) {
    off = distance(answer.u, problem.W, answer.r, problem.V, answer.lambda, problem.q, scale);
    if (off)
      return std::string("r is 0, and u differs from W r ") + (bilateral == 0 ? "" : "+ V lambda ") + "+ q by up to " +
             short_number(*off);
  } else if (answer.v.size() == problem.f.size()) {
    off = distance(answer.u, transposed(problem.H), answer.v, {}, {}, problem.w, scale);
    if (off) return "r is 0, and u differs from H^T v + w by up to " + short_number(*off);
  }
  return std::nullopt;
}

void add_remarks(ReadProblem& read) {
  ProblemFile& problem = read.problem;
  if (problem.form == ProblemForm::local) remark_asymmetry("W", problem.W, problem);
  if (problem.form == ProblemForm::global) remark_asymmetry("M", problem.M, problem);
  remark_rounded("compliance", problem.compliance, problem);
  remark_rounded("bias", problem.bias, problem);
  if (const double lost = rounding_of_restored(problem); lost > 0) {
    problem.remarks.push_back("what the law of impact restores is added in binary64, which changes it by up to " +
                              short_number(lost));
  }
  if (problem.components() == 0) problem.remarks.emplace_back("there is no contact in it");
  for (const SolverAnswer& answer : read.answers) {
    if (answer.origin != "/solution") continue;
    if (const auto why = contradiction(problem, answer)) {
      problem.remarks.push_back("the stored /solution is no solution: " + *why);
    }
  }
}

}  // namespace slipproof

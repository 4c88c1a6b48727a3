#include "contact/judge/problem_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/number/binary64.hpp"
#include "base/os/sha256.hpp"

namespace slipproof {

std::string canonical_form(const MixedProblem& problem) {
  std::string text = fmt::format("slipproof-contact-problem 1\ndimension {} free {} contacts {}\n", problem.dimension,
                                 problem.free, problem.contacts());
  const auto vector = [&](const char* word, const std::vector<double>& numbers) {
    text += word;
    for (const double x : numbers) (text += ' ') += to_rational(x).str();
    text += '\n';
  };
  vector("mu", problem.mu);
  text += "matrix\n";
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const auto columns = problem.A.columns_of(i);
    const auto values = problem.A.values_of(i);
    for (std::size_t e = 0; e < columns.size(); ++e) {
      if (values[e] == 0) continue;
      fmt::format_to(std::back_inserter(text), "{} {} {}\n", i, columns[e], to_rational(values[e]).str());
    }
  }
  vector("constant", problem.c);
  if (problem.is_coulomb()) return text;
  const ContactLaw& law = problem.law;
  text += fmt::format("law {}", word(law.kind));
  if (law.kind == FrictionLaw::regularised) {
    text += fmt::format(" {} {}", word(law.function), to_rational(law.slip_speed).str());
  }
  vector("", is_bounded(law.kind) ? law.bounds : std::vector<double>());
  return text;
}

std::string problem_name(const MixedProblem& problem) {
  return sha256(canonical_form(problem));
}

std::optional<std::size_t> turned_rows(const SparseMatrix& A) {
  const SparseMatrix B = transposed(A);
  if (A.starts != B.starts || A.column != B.column) return std::nullopt;
  std::size_t turned = 0;
  const auto all = [&](const auto& holds) {
    for (std::size_t i = 0; i < A.rows; ++i) {
      for (std::size_t e = A.starts[i]; e < A.starts[i + 1]; ++e) {
        if (!holds(i, A.column[e], A.value[e], B.value[e])) return false;
      }
    }
    return true;
  };
  all([&](std::size_t i, std::size_t j, double a, double b) {
    if (a != b) turned = std::max(turned, std::min(i, j) + 1);
    return true;
  });
  const bool mirrored = all(
      [&](std::size_t i, std::size_t j, double a, double b) { return a == ((i < turned) == (j < turned) ? b : -b); });
  return mirrored ? std::optional(turned) : std::nullopt;
}

}  // namespace slipproof

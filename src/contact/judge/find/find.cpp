#include "contact/judge/find/find.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/number/dice.hpp"
#include "base/parallel/stop.hpp"
#include "contact/enclosure/answer.hpp"
#include "contact/enclosure/residual.hpp"
#include "contact/enclosure/sizes.hpp"
#include "contact/judge/find/contact_newton.hpp"
#include "contact/judge/find/sweeps.hpp"
#include "contact/problem/parts.hpp"

namespace slipproof {

namespace {

using Dense = Eigen::MatrixXd;
using DenseVector = Eigen::VectorXd;

/// x_free = -X r - y in binary64, by the parts of the free unknowns: a row of (column, value) for each.
struct FreeByForces {
  std::vector<std::vector<std::pair<std::size_t, double>>> X;
  std::vector<double> y;
};

/// Nothing where a part is singular, or larger than `largest`.
std::optional<FreeByForces> free_by_forces(const MixedProblem& problem, std::size_t largest) {
  FreeByForces result{std::vector<std::vector<std::pair<std::size_t, double>>>(problem.free),
                      std::vector<double>(problem.free, 0)};
  std::vector<Eigen::Index> place(problem.size(), -1);
  for (const std::vector<std::size_t>& part : free_parts(problem)) {
    stop_if_asked();
    if (part.size() > largest) return std::nullopt;
    const auto n = static_cast<Eigen::Index>(part.size());
    for (Eigen::Index i = 0; i < n; ++i) place[part[static_cast<std::size_t>(i)]] = i;
    Dense own = Dense::Zero(n, n);
    std::map<std::size_t, DenseVector> columns;  // of what depends on forces; the last is the constant
    const auto column = [&](std::size_t j) -> DenseVector& {
      return columns.try_emplace(j, DenseVector::Zero(n)).first->second;
    };
    for (Eigen::Index i = 0; i < n; ++i) {
      const std::size_t row = part[static_cast<std::size_t>(i)];
      column(problem.size())[i] = problem.c[row];
      for (std::size_t e = problem.A.starts[row]; e < problem.A.starts[row + 1]; ++e) {
        const std::size_t j = problem.A.column[e];
        (j < problem.free ? own(i, place[j]) : column(j)[i]) = problem.A.value[e];
      }
    }
    const Eigen::PartialPivLU<Dense> lu(own);
    for (const auto& [j, b] : columns) {
      const DenseVector x = lu.solve(b);
      if (!x.allFinite()) return std::nullopt;
      for (Eigen::Index i = 0; i < n; ++i) {
        const std::size_t row = part[static_cast<std::size_t>(i)];
        if (j == problem.size()) {
          result.y[row] = x[i];
        } else if (x[i] != 0) {
          result.X[row].emplace_back(j - problem.free, x[i]);
        }
      }
    }
  }
  return result;
}

/// u = W r + q with the free unknowns eliminated, in binary64. Nothing where that is impossible, or W would have more
/// than `most` entries.
std::optional<MixedProblem> delassus(const MixedProblem& problem, const FindOptions& options) {
  const auto free = free_by_forces(problem, options.largest);
  if (!free) return std::nullopt;
  MixedProblem result;
  result.dimension = problem.dimension;
  result.mu = problem.mu;
  result.law = problem.law;
  const std::size_t n = problem.size() - problem.free;
  result.A.rows = result.A.columns = n;
  std::map<std::size_t, double> row;
  for (std::size_t i = problem.free; i < problem.size(); ++i) {
    row.clear();
    result.c.push_back(problem.c[i]);
    for (std::size_t e = problem.A.starts[i]; e < problem.A.starts[i + 1]; ++e) {
      const std::size_t j = problem.A.column[e];
      const double a = problem.A.value[e];
      if (j >= problem.free) {
        row[j - problem.free] += a;
        continue;
      }
      result.c.back() -= a * free->y[j];
      for (const auto& [k, x] : free->X[j]) row[k] -= a * x;
    }
    for (const auto& [j, w] : row) {
      result.A.column.push_back(static_cast<std::uint32_t>(j));
      result.A.value.push_back(w);
    }
    result.A.starts.push_back(result.A.value.size());
    if (result.A.value.size() > options.most_entries) return std::nullopt;
  }
  return result;
}

/// Other forces to begin from: contacts press without friction, with this part of the problem's force.
constexpr std::array pressed{0.1, 1.0, 100.0};

std::vector<double> pressed_by(const MixedProblem& problem, double part) {
  const double size = contact_sizes(problem).force;
  std::vector<double> x(problem.size(), 0);
  for (std::size_t k = 0; k < problem.contacts(); ++k) x[problem.normal(k)] = part * size;
  return x;
}

/// Where sweeps and Newton's method go round in circles, as where an indefinite matrix has one solution among many
/// modes: Newton's method from many modes of few contacts.
std::optional<std::vector<double>> from_random_forces(const MixedProblem& part) {
  constexpr std::size_t few = 12;  // contacts
  constexpr int starts = 1'000;
  if (!part.is_coulomb() || part.dimension == 1 || part.contacts() > few) return std::nullopt;
  const double size = contact_sizes(part).force;
  const ContactNewton newton(part);
  Twister random(1);
  const auto number = [&](double most) { return most * static_cast<double>(random() % 1024) / 1024; };
  for (int start = 0; start < starts; ++start) {
    stop_if_asked();
    DenseVector r = DenseVector::Zero(static_cast<Eigen::Index>(part.size()));
    for (std::size_t k = 0; k < part.contacts(); ++k) {
      const auto normal = static_cast<Eigen::Index>(part.normal(k));
      r[normal] = std::max(0.0, number(4 * size) - size);
      for (Eigen::Index i = 1; i < static_cast<Eigen::Index>(part.dimension); ++i) {
        r[normal + i] = (number(4) - 2) * part.mu[k] * r[normal];
      }
    }
    if (newton.solve(r, start)) return std::vector<double>(r.begin(), r.end());
  }
  return std::nullopt;
}

/// One part, from other forces where it does not converge: where these are redundant, sweeps may creep along them.
std::vector<double> swept_from_anywhere(const MixedProblem& part, std::vector<double> r, const FindOptions& options) {
  constexpr std::size_t few = 100;  // contacts
  SweptForces first = swept(part, r, options.rounds, options.newton);
  if (first.agreed || !options.elsewhere || part.contacts() > few) return std::move(first.r);
  for (const double force : pressed) {
    SweptForces next = swept(part, pressed_by(part, force), options.rounds, options.newton);
    if (next.agreed) return std::move(next.r);
  }
  if (auto found = from_random_forces(part)) return *std::move(found);
  return std::move(first.r);
}

/// Each part for itself: parts converge at their own pace, and Newton's method is cubic in their sizes.
std::vector<double> swept_by_parts(const MixedProblem& contacts, std::vector<double> r, const FindOptions& options) {
  const std::vector<ContactPart> parts = parts_of(contacts);
  if (contacts.law.kind == FrictionLaw::fixed) return swept(contacts, r, options.rounds, options.newton).r;
  if (parts.size() == 1) return swept_from_anywhere(contacts, std::move(r), options);
  for (const ContactPart& part : parts) {
    const std::vector<std::size_t> rows = rows_of(contacts, part);
    std::vector<double> own;
    for (const std::size_t i : rows) own.push_back(r[i]);
    own = swept_from_anywhere(part_of(contacts, part, rows), std::move(own), options);
    for (std::size_t i = 0; i < rows.size(); ++i) r[rows[i]] = own[i];
  }
  return r;
}

std::vector<double> with_free(const MixedProblem& problem, const std::vector<double>& r) {
  std::vector<double> x(problem.free, 0);
  x.insert(x.end(), r.begin(), r.end());
  if (!complete_free_unknowns(problem, x)) return {};
  return x;
}

bool apart(const Enclosure& a, const Enclosure& b) {
  const std::vector<double> x = center_of(a), y = center_of(b);
  const auto radius = [](const Enclosure& box, std::size_t i) {
    const std::size_t j = box.system.unknown(i);
    return j == ModeSystem::none ? 0 : box.radius[j];
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::abs(x[i] - y[i]) * (1 - 1e-12) > (radius(a, i) + radius(b, i)) * (1 + 1e-12)) return true;
  }
  return false;
}

}  // namespace

std::vector<double> approximate_solution(const MixedProblem& problem, const FindOptions& options) {
  std::optional<MixedProblem> eliminated;
  if (problem.free > 0 && !(eliminated = delassus(problem, options))) return {};
  const MixedProblem& contacts = eliminated ? *eliminated : problem;
  std::vector<double> r(contacts.size(), 0);
  if (!options.start.empty())
    std::copy(options.start.begin() + static_cast<std::ptrdiff_t>(problem.free), options.start.end(), r.begin());
  r = swept_by_parts(contacts, std::move(r), options);
  if (!std::ranges::all_of(r, [](double x) { return std::isfinite(x); })) return {};
  return with_free(problem, r);
}

std::vector<double> answer_from_elsewhere(const MixedProblem& problem, int number) {
  if (number < 0 || number >= static_cast<int>(pressed.size())) return {};
  return approximate_solution(problem, {.start = pressed_by(problem, pressed[static_cast<std::size_t>(number)])});
}

std::optional<std::vector<double>> converged_answer(const MixedProblem& problem, const FindOptions& options,
                                                    double tolerance) {
  std::vector<double> x = approximate_solution(problem, options);
  const bool finite = std::ranges::all_of(x, [](double value) { return std::isfinite(value); });
  if (x.size() != problem.size() || !finite) return std::nullopt;
  if (residual(problem, x, exact_rows(problem, x)).backward_error() > tolerance) return std::nullopt;
  return x;
}

std::optional<Enclosure> another_solution(const MixedProblem& problem, const Enclosure& first,
                                          const FindOptions& options) {
  const std::vector<double> scales = contact_scales(problem), x = center_of(first);
  const Work n = first.system.size(), of_one = 4 * times(n * n, n);
  const Work affordable = options.effort / std::max<Work>(of_one, 1);
  EnclosureOptions enclosing;
  enclosing.modes = static_cast<int>(std::min<Work>(static_cast<Work>(enclosing.modes), affordable));
  const auto from = [&](std::vector<double> start) -> std::optional<Enclosure> {
    if (!complete_free_unknowns(problem, start)) return std::nullopt;
    auto found = enclose_solution(problem, start, enclosing);
    auto* box = std::get_if<Enclosure>(&found);
    if (box == nullptr || !apart(first, *box)) return std::nullopt;
    return std::move(*box);
  };
  std::vector<double> none = x;
  std::fill(none.begin() + static_cast<std::ptrdiff_t>(problem.free), none.end(), 0);
  if (auto found = from(none)) return found;
  if (affordable < problem.contacts()) return std::nullopt;  // some neighbours would say nothing of the others
  const Work most = std::min<Work>(problem.contacts(), options.neighbours);
  for (std::size_t k = 0; k < most; ++k) {
    std::vector<double> start = x;
    const std::size_t normal = problem.normal(k);
    if (x[normal] > 0) {
      for (std::size_t i = 0; i < problem.dimension; ++i) start[normal + i] = 0;
    } else {  // pressed as hard as would stop what is leaving
      start[normal] = 2 * std::abs(exact_row(problem, normal, x).to_double()) / scales[k] + 1e-6;
    }
    if (auto found = from(std::move(start))) return found;
  }
  return std::nullopt;
}

}  // namespace slipproof

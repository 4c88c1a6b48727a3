#include "contact/solutions.hpp"

#include <algorithm>

#include "number/bareiss.hpp"

namespace slipproof {

namespace {

/// Steps of principal pivoting; on problems that occur a few times the size suffices.
constexpr int max_pivots = 2000;
/// Bits of integers by rows, beyond which exact elimination takes more than a moment.
constexpr std::size_t max_enumerated_bits = 1U << 13U;
constexpr std::size_t max_pivoted_bits = 1U << 14U;
constexpr std::size_t max_bits = 1U << 17U;

std::size_t bit_count(const Integer& x) {
  return x.is_zero() ? 0 : static_cast<std::size_t>(msb(abs(x))) + 1;
}

ProblemMode next_mode(ProblemMode mode, bool frictional, bool& done) {
  for (ContactState& state : mode) {
    if (state == ContactState::lift) {
      state = ContactState::stick;
      continue;
    }
    state = frictional ? static_cast<ContactState>(static_cast<int>(state) + 1) : ContactState::lift;
    return mode;
  }
  done = true;
  return mode;
}

}  // namespace

/// The problem in integers. Rows of W and q are multiplied by something positive: neither solutions nor signs change.
struct ContactSolver::Scaled {
  std::vector<std::vector<Integer>> rows;  ///< W, then q
  std::vector<Integer> friction, unit;     ///< mu = friction / unit of each contact
  std::size_t bits = 0;                    ///< of the longest number, times the size: of determinants, about
  std::size_t modes = 1;                   ///< their number, or more than max_enumerated_modes
};

ContactSolver::ContactSolver(const ContactProblem& problem) : problem_(problem) {
  Scaled s;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    std::vector<Rational> row = problem.W[i];
    row.push_back(problem.q[i]);
    s.rows.push_back(clear_denominators(row));
    for (const Integer& x : s.rows.back()) s.bits = std::max(s.bits, bit_count(x));
  }
  for (const Rational& mu : problem.mu) {
    s.friction.push_back(numerator(mu));
    s.unit.push_back(denominator(mu));
    s.bits = std::max(s.bits, bit_count(s.friction.back()) + bit_count(s.unit.back()));
  }
  s.bits *= problem.size();
  for (std::size_t i = 0; i < problem.contacts() && s.modes <= max_enumerated_modes; ++i) {
    s.modes *= problem.frictional() ? 4 : 2;
  }
  scaled_ = std::make_unique<const Scaled>(std::move(s));
}

ContactSolver::~ContactSolver() = default;

bool ContactSolver::too_long() const {
  return scaled_->bits > max_bits;
}

ModeOutcome ContactSolver::solve(const ProblemMode& mode) const {
  // z = sum of y_k columns[k]: the forces that the mode leaves open, each with the components it drives.
  using Column = std::vector<std::pair<std::size_t, Integer>>;
  std::vector<Column> columns;
  std::vector<std::size_t> equations;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const std::size_t normal = problem_.frictional() ? 2 * i : i;
    if (mode[i] == ContactState::lift) continue;
    equations.push_back(normal);
    if (!problem_.frictional() || mode[i] == ContactState::stick) {
      columns.push_back({{normal, 1}});
    } else {
      const Integer& friction = scaled_->friction[i];
      columns.push_back(
          {{normal, scaled_->unit[i]}, {normal + 1, slip_direction(mode[i]) > 0 ? Integer(-friction) : friction}});
    }
    if (problem_.frictional() && mode[i] == ContactState::stick) {
      equations.push_back(normal + 1);
      columns.push_back({{normal + 1, 1}});
    }
  }
  const std::size_t size = problem_.size(), unknowns = columns.size();
  IntegerMatrix matrix;
  for (const std::size_t row : equations) {
    std::vector<Integer> entries;
    for (const Column& column : columns) {
      Integer sum = 0;
      for (const auto& [j, factor] : column) sum += scaled_->rows[row][j] * factor;
      entries.push_back(std::move(sum));
    }
    entries.push_back(-scaled_->rows[row][size]);
    matrix.push_back(std::move(entries));
  }
  const Echelon echelon = eliminate(std::move(matrix), unknowns);
  ModeOutcome outcome;
  for (std::size_t i = echelon.rank(); i < echelon.rows.size(); ++i) {
    if (!echelon.rows[i][unknowns].is_zero()) return outcome;
  }
  // A column of the echelon form, as z: the right-hand side, or what one of the free unknowns adds.
  const auto to_z = [&](std::size_t right, bool homogeneous) {
    std::vector<Rational> z(size);
    const auto add = [&](std::size_t k, const Rational& y) {
      for (const auto& [j, factor] : columns[k]) z[j] += y * Rational(factor);
    };
    for (std::size_t i = 0; i < echelon.rank(); ++i) {
      const Integer& value = echelon.rows[i][right];
      if (!value.is_zero()) {
        add(echelon.pivot_columns[i], Rational(homogeneous ? Integer(-value) : value, echelon.pivot));
      }
    }
    if (homogeneous) add(right, 1);
    return z;
  };
  outcome.z = to_z(unknowns, false);
  if (echelon.rank() == unknowns) {
    const auto w = accelerations(problem_, outcome.z);
    outcome.kind = ModeOutcome::Kind::solution;
    outcome.strict = true;
    for (const ProblemCondition& condition : conditions(problem_, mode)) {
      Rational value = condition_value(problem_, condition, outcome.z, w);
      if (value.sign() < 0) {
        outcome.kind = ModeOutcome::Kind::violated;
        outcome.condition = condition;
        outcome.margin = std::move(value);
        return outcome;
      }
      outcome.strict = outcome.strict && value.sign() > 0;
    }
    return outcome;
  }

  ContactContinuum continuum{mode, outcome.z, {}, {}};
  std::vector<std::vector<Rational>> changes;  // of w, by each direction
  for (std::size_t k = 0; k < unknowns; ++k) {
    if (std::find(echelon.pivot_columns.begin(), echelon.pivot_columns.end(), k) != echelon.pivot_columns.end()) {
      continue;
    }
    continuum.directions.push_back(to_z(k, true));
    auto change = accelerations(problem_, continuum.directions.back());
    for (std::size_t i = 0; i < size; ++i) change[i] -= problem_.q[i];
    changes.push_back(std::move(change));
  }
  const auto w = accelerations(problem_, continuum.base);
  for (const ProblemCondition& condition : conditions(problem_, mode)) {
    AffineForm form{condition_value(problem_, condition, continuum.base, w), {}};
    for (std::size_t k = 0; k < changes.size(); ++k) {
      form.coefficients.push_back(condition_value(problem_, condition, continuum.directions[k], changes[k]));
    }
    continuum.conditions.push_back(std::move(form));
  }
  // One point, or more?
  AffineForm parameter{0, std::vector<Rational>(changes.size())};
  bool point = true;
  LinearOptimum lowest;
  for (std::size_t k = 0; k < changes.size() && point; ++k) {
    parameter.coefficients[k] = 1;
    lowest = minimize(parameter, continuum.conditions);
    if (lowest.kind == LinearOptimum::Kind::infeasible) return outcome;
    parameter.coefficients[k] = -1;
    const LinearOptimum highest = minimize(parameter, continuum.conditions);
    parameter.coefficients[k] = 0;
    point = lowest.kind == LinearOptimum::Kind::attained && highest.kind == LinearOptimum::Kind::attained &&
            lowest.value == -highest.value;
  }
  if (point) {
    outcome.kind = ModeOutcome::Kind::solution;
    outcome.z = continuum.at(lowest.x);
  } else {
    outcome.kind = ModeOutcome::Kind::continuum;
    outcome.continuum = std::move(continuum);
  }
  return outcome;
}

std::optional<ContactSolutions> ContactSolver::all() const {
  if (scaled_->modes > max_enumerated_modes || scaled_->bits > max_enumerated_bits) return std::nullopt;
  ContactSolutions found;
  ProblemMode mode(problem_.contacts(), ContactState::stick);
  for (bool done = false; !done; mode = next_mode(std::move(mode), problem_.frictional(), done)) {
    ModeOutcome outcome = solve(mode);
    if (outcome.kind == ModeOutcome::Kind::continuum) found.continua.push_back(std::move(*outcome.continuum));
    if (outcome.kind != ModeOutcome::Kind::solution) continue;
    const auto same = std::find_if(found.solutions.begin(), found.solutions.end(),
                                   [&](const ContactSolution& s) { return s.z == outcome.z; });
    if (same == found.solutions.end()) {
      auto w = accelerations(problem_, outcome.z);
      found.solutions.push_back({{mode}, outcome.strict, std::move(outcome.z), std::move(w)});
    } else {
      same->modes.push_back(mode);
      same->strict = same->strict || outcome.strict;
    }
  }
  std::erase_if(found.solutions, [&](const ContactSolution& s) {
    return std::any_of(found.continua.begin(), found.continua.end(),
                       [&](const ContactContinuum& c) { return solves(problem_, c.mode, s.z); });
  });
  return found;
}

std::optional<ContactSolution> ContactSolver::only(ProblemMode mode) const {
  if (problem_.frictional() || scaled_->bits > max_pivoted_bits || !positive_definite(problem_.W)) return std::nullopt;
  for (int step = 0; step < max_pivots; ++step) {
    ModeOutcome outcome = solve(mode);
    if (outcome.kind == ModeOutcome::Kind::solution) {
      auto w = accelerations(problem_, outcome.z);
      return ContactSolution{{mode}, outcome.strict, std::move(outcome.z), std::move(w)};
    }
    ContactState& state = mode[outcome.condition->contact];
    state = state == ContactState::lift ? ContactState::stick : ContactState::lift;
  }
  return std::nullopt;
}

bool positive_definite(const RationalMatrix& W) {
  std::vector<Rational> flat;
  for (const auto& row : W) flat.insert(flat.end(), row.begin(), row.end());
  const Integer common = common_denominator(flat);
  const std::size_t n = W.size();
  IntegerMatrix m(n, std::vector<Integer>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = integer_times(W[i][j] + W[j][i], common);
  }
  // Bareiss without a choice of pivots: they are the leading principal minors.
  Integer previous = 1;
  for (std::size_t k = 0; k < n; ++k) {
    if (m[k][k].sign() <= 0) return false;
    for (std::size_t i = k + 1; i < n; ++i) {
      for (std::size_t j = k + 1; j < n; ++j) m[i][j] = (m[k][k] * m[i][j] - m[i][k] * m[k][j]) / previous;
    }
    previous = m[k][k];
  }
  return true;
}

std::vector<Rational> ContactContinuum::at(const std::vector<Rational>& t) const {
  std::vector<Rational> z = base;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    for (std::size_t i = 0; i < z.size(); ++i) z[i] += t[k] * directions[k][i];
  }
  return z;
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
  if (ContactSolver(p).too_long())
    return "found numbers of too many digits, expected fewer: exact elimination would not end soon";
  return {};
}

}  // namespace slipproof

#include "contact/problem/every_push.hpp"

#include <algorithm>

#include "contact/problem/solutions.hpp"
#include "mechanics/kernel/affine_space.hpp"
#include "mechanics/kernel/kinematic_modes.hpp"

namespace slipproof {

namespace {

/// The kernel of a symmetric matrix, and the columns that span its range.
struct SymmetricRange {
  std::vector<std::size_t> columns;
  RationalMatrix kernel;

  explicit SymmetricRange(const RationalMatrix& matrix) {
    const Echelon echelon = eliminate(matrix);
    columns = echelon.pivot_columns;
    for (std::size_t j = 0; j < matrix.size(); ++j) {
      if (std::ranges::binary_search(columns, j)) continue;
      std::vector<Rational> direction(matrix.size());
      direction[j] = Rational(echelon.pivot);
      for (std::size_t i = 0; i < columns.size(); ++i) direction[columns[i]] = -Rational(echelon.rows[i][j]);
      kernel.push_back(std::move(direction));
    }
  }
};

bool is_symmetric(const RationalMatrix& matrix) {
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (matrix[i][j] != matrix[j][i]) return false;
    }
  }
  return true;
}

/// Of a symmetric matrix: it is where its part on independent columns is positive definite.
bool is_semidefinite(const RationalMatrix& matrix, const std::vector<std::size_t>& columns) {
  RationalMatrix part;
  for (const std::size_t i : columns) {
    part.emplace_back();
    for (const std::size_t j : columns) part.back().push_back(matrix[i][j]);
  }
  return positive_definite(part);
}

/// Two solutions side by side: the unknowns are w and z of the first, then those of the second.
class SolutionPairs {
 public:
  SolutionPairs(const ContactProblem& problem, const SymmetricRange& range, Work effort)
      : problem_(problem), size_(problem.size()), space_(4 * size_, false), effort_(effort) {
    for (const bool second : {false, true}) {
      for (std::size_t i = 0; i < problem.contacts(); ++i) elements_[second].push_back(element(i, second));
    }
    for (std::size_t i = 0; i < size_; ++i) differences_.push_back(w(i, false) - w(i, true));
    for (std::size_t i = 0; i < size_; ++i) {
      AffineForm form = differences_[i];
      for (std::size_t j = 0; j < size_; ++j) {
        form.coefficients[z_index(j, false)] -= problem.W[i][j];
        form.coefficients[z_index(j, true)] += problem.W[i][j];
      }
      space_.require(form);
    }
    for (const auto& direction : range.kernel) {
      AffineForm form = zero();
      for (std::size_t i = 0; i < size_; ++i) form.coefficients[w_index(i, false)] = direction[i];
      space_.require(form);
    }
  }

  /// Whether two solutions with different w were found; the modes are theirs then.
  bool differ() { return differ(space_, {}, true); }
  const ProblemMode& mode(bool second) const { return mode_[second]; }
  /// Under which both are solutions.
  const std::vector<Rational>& q() const { return q_; }

 private:
  std::size_t w_index(std::size_t i, bool second) const { return (second ? 2 * size_ : 0) + i; }
  std::size_t z_index(std::size_t i, bool second) const { return w_index(i, second) + size_; }
  AffineForm zero() const { return {0, std::vector<Rational>(4 * size_ + 1)}; }
  AffineForm unit(std::size_t index) const {
    AffineForm form = zero();
    form.coefficients[index] = 1;
    return form;
  }
  AffineForm w(std::size_t i, bool second) const { return unit(w_index(i, second)); }

  ProblemElement element(std::size_t contact, bool second) const {
    const std::size_t normal = problem_.frictional() ? 2 * contact : contact;
    ProblemElement e;
    e.kind = problem_.kind();
    e.gap = w(normal, second);
    e.normal = unit(z_index(normal, second));
    if (!problem_.frictional()) return e;
    e.slip = w(normal + 1, second);
    e.tangent = unit(z_index(normal + 1, second));
    e.static_limit = e.normal;
    for (Rational& x : e.static_limit.coefficients) x *= problem_.mu[contact];
    e.kinetic_limit = e.static_limit;
    return e;
  }

  /// `alike`: both modes are the same so far. Then the second is not before the first, as pairs have no order.
  bool differ(const AffineSpace& space, const std::vector<AffineForm>& conditions, bool alike) {
    const auto vanishes = [&](const AffineForm& form) { return is_free_of_unknowns(space.on(form)); };
    if (std::ranges::all_of(differences_, vanishes)) return false;
    const std::size_t level = mode_[0].size();
    if (level == problem_.contacts()) return differ_within(space, conditions);
    const std::vector<ElementState> all = states(problem_.kind());
    for (auto first = all.begin(); first != all.end(); ++first) {
      for (auto second = alike ? first : all.begin(); second != all.end(); ++second) {
        AffineSpace inner = space;
        std::vector<AffineForm> more = conditions;
        enter(inner, more, *first, false);
        enter(inner, more, *second, true);
        if (differ(inner, more, alike && first == second)) return true;
        mode_[0].pop_back(), mode_[1].pop_back();
      }
    }
    return false;
  }

  void enter(AffineSpace& space, std::vector<AffineForm>& more, ElementState state, bool second) {
    const ProblemElement& e = elements_[second][mode_[second].size()];
    for (const StateEquation equation : equations(e.kind, state)) space.require(form_of(e, state, equation));
    for (const StateCondition condition : conditions(e.kind, state)) more.push_back(form_of(e, state, condition));
    mode_[second].push_back(state);
  }

  bool differ_within(const AffineSpace& space, const std::vector<AffineForm>& conditions) {
    const std::vector<std::size_t> free = space.free_unknowns();
    const auto in_free = [&](const AffineForm& form) {
      AffineForm result = compressed(space, free, form);
      result.coefficients.resize(free.size());  // without that of the load, which there is none of
      return result;
    };
    effort_.spend(static_cast<Work>(8 * size_ * size_ * (free.size() + 2) * (free.size() + 2)));
    std::vector<AffineForm> cone;
    for (const AffineForm& condition : conditions) cone.push_back(in_free(condition));
    LinearProgram program(free.size(), cone);
    for (const AffineForm& difference : differences_) {
      for (AffineForm form = in_free(difference); const bool grows : {false, true}) {
        if (grows) form = -form;
        if (program.least(form)) continue;
        form = -form;
        form.constant -= 1;  // at least 1 apart
        cone.push_back(form);
        AffineForm any;
        any.coefficients.resize(free.size());
        tell_q(minimize(any, cone).x, in_free);
        return true;
      }
    }
    return false;
  }

  template <class InFree>
  void tell_q(const std::vector<Rational>& x, const InFree& in_free) {
    for (std::size_t i = 0; i < size_; ++i) {
      AffineForm form = w(i, false);
      for (std::size_t j = 0; j < size_; ++j) form.coefficients[z_index(j, false)] -= problem_.W[i][j];
      q_.push_back(in_free(form).at(x));
    }
  }

  const ContactProblem& problem_;
  std::size_t size_;
  AffineSpace space_;
  Effort effort_;
  std::vector<ProblemElement> elements_[2];
  std::vector<AffineForm> differences_;  ///< of the accelerations w
  ProblemMode mode_[2];
  std::vector<Rational> q_;
};

}  // namespace

EveryLoad for_every_push(const ContactProblem& problem, Work effort) {
  if (!is_symmetric(problem.W)) return for_every_load(problem);
  const SymmetricRange range(problem.W);
  const auto in_range = [&](const std::vector<Rational>& direction) {
    Rational sum = 0;
    for (std::size_t i = 0; i < problem.size(); ++i) sum += direction[i] * problem.q[i];
    return sum.is_zero();
  };
  if (range.kernel.empty() || !is_semidefinite(problem.W, range.columns) ||
      !std::ranges::all_of(range.kernel, in_range)) {
    return for_every_load(problem);
  }
  EveryLoad result;
  result.undetermined = range.kernel.size();
  try {
    SolutionPairs pairs(problem, range, effort);
    result.reason = EveryLoad::Reason::pairs;
    result.verdict = EveryLoad::Verdict::at_most_one;
    if (!pairs.differ()) return result;
    result.verdict = EveryLoad::Verdict::not_unique;
    result.mode = pairs.mode(false);
    result.other = pairs.mode(true);
    result.q = pairs.q();
  } catch (const TooMuchWork&) {
    result.verdict = EveryLoad::Verdict::undecided;
    result.reason = EveryLoad::Reason::too_many;
  }
  return result;
}

std::optional<EveryLoad> for_every_push(const FrictionProblem& problem) {
  if (has_too_many_to_try(problem)) return std::nullopt;
  const auto contacts = contact_problem(problem);
  return contacts ? std::optional(for_every_push(*contacts)) : std::nullopt;
}

}  // namespace slipproof

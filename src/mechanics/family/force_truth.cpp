#include "mechanics/family/force_truth.hpp"

#include <algorithm>
#include <utility>

#include "base/algebra/real_roots.hpp"

namespace slipproof {

namespace {

/// The signs of a polynomial, for one cell after another. For a linear polynomial, as most are, a sign takes only a
/// comparison with its root.
class Signs {
 public:
  explicit Signs(const Polynomial& p) : p_(p), last_(sign(p.coefficient(p.degree()))) {
    if (p.degree() == 1) root_ = -p.coefficient(0) / p.coefficient(1);
  }

  int at(const Rational& force) const {
    if (p_.degree() == 0) return last_;
    if (p_.degree() > 1) return sign(p_.at(force));
    const auto order = force <=> root_;
    return order == 0 ? 0 : order > 0 ? last_ : -last_;
  }

  /// Adds the real roots; returns whether all are rational.
  bool add_roots(std::vector<Rational>& roots) const {
    if (p_.degree() == 1) roots.push_back(root_);
    if (p_.degree() <= 1) return true;
    for (const RealRoot& root : real_roots({IntegerPolynomial::proportional_to(p_.coefficients())})) {
      if (!root.is_rational()) return false;
      roots.push_back(root.lower);
    }
    return true;
  }

 private:
  Polynomial p_;
  int last_;       ///< the sign for large forces
  Rational root_;  ///< the root of a linear polynomial
};

/// A comparison as the sign of numerator(F) / denominator(F) where no divisor is 0, or a mark that it cannot be written
/// so.
struct Link {
  bool decided = false;
  Failure failure = Failure::undecided;
  std::optional<Signs> numerator, denominator;
  std::vector<Signs> divisors;
  std::vector<Rational> roots;  ///< the roots of all these polynomials, if all are rational
};

Link difference(const Program& statement, const Program::Instruction& comparison, Evaluator<ForceFunction>& evaluator) {
  const Value<ForceFunction> x = evaluator.number(statement, comparison.first);
  const Value<ForceFunction> y = x.number ? evaluator.number(statement, comparison.second) : x;
  Link link;
  if (!y.number) {
    link.failure = y.failure;
    return link;
  }
  const ForceFunction d = *x.number - *y.number;
  const bool same = d.value().is_zero();  // the two sides are equal wherever both have a value
  link.numerator.emplace(same ? Polynomial() : d.value().numerator());
  link.denominator.emplace(same ? Polynomial({Rational(1)}) : d.value().denominator());
  for (const Polynomial& divisor : d.divisors()) link.divisors.emplace_back(divisor);
  link.decided =
      link.numerator->add_roots(link.roots) && link.denominator->add_roots(link.roots) &&
      std::all_of(link.divisors.begin(), link.divisors.end(), [&](const Signs& s) { return s.add_roots(link.roots); });
  return link;
}

class OverForces {
 public:
  OverForces(const Program& statement, Evaluator<ForceFunction>& evaluator)
      : statement_(statement), links_(statement.code().size()) {
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const Program::Instruction& instruction = statement.code()[i];
      if (instruction.operation != Operation::compare) continue;
      links_[i] = difference(statement, instruction, evaluator);
      if (links_[i].decided) roots_.insert(roots_.end(), links_[i].roots.begin(), links_[i].roots.end());
    }
    std::sort(roots_.begin(), roots_.end());
    roots_.erase(std::unique(roots_.begin(), roots_.end()), roots_.end());
  }

  std::vector<TruthCell> cells() const {
    std::vector<TruthCell> cells;
    std::optional<Rational> lower;
    for (const Rational& root : roots_) {
      append(cells, ForceInterval::open_between(lower, root));
      append(cells, ForceInterval::point(root));
      lower = root;
    }
    append(cells, ForceInterval::open_between(lower, std::nullopt));
    return cells;
  }

 private:
  void append(std::vector<TruthCell>& cells, ForceInterval forces) const {
    const Truth here = truth(statement_.root(), forces.sample());
    if (cells.empty() || cells.back().truth != here) {
      cells.push_back({std::move(forces), here});
    } else {
      ForceInterval& last = cells.back().forces;
      last = ForceInterval::between(last.lower(), last.lower_closed(), forces.upper(), forces.upper_closed());
    }
  }

  Truth truth(std::uint32_t index, const Rational& force) const {
    const Program::Instruction& instruction = statement_.code()[index];
    const auto operands = [&](Truth decisive, Truth neutral) {
      return combine(truth(instruction.first, force), truth(instruction.second, force), decisive, neutral);
    };
    switch (instruction.operation) {
      case Operation::truth:
        return instruction.truth ? Truth::yes : Truth::no;
      case Operation::logical_not:
        return negation(truth(instruction.first, force));
      case Operation::logical_and:
        return operands(Truth::no, Truth::yes);
      case Operation::logical_or:
        return operands(Truth::yes, Truth::no);
      default:
        return compare(links_[index], instruction.relation, force);
    }
  }

  static Truth compare(const Link& link, Relation relation, const Rational& force) {
    if (!link.decided) return link.failure == Failure::undefined ? Truth::undefined : Truth::undecided;
    const auto vanishes = [&](const Signs& divisor) { return divisor.at(force) == 0; };
    if (std::any_of(link.divisors.begin(), link.divisors.end(), vanishes)) return Truth::undefined;
    const int denominator = link.denominator->at(force);
    if (denominator == 0) return Truth::undefined;
    return holds(relation, link.numerator->at(force) * denominator) ? Truth::yes : Truth::no;
  }

  const Program& statement_;
  std::vector<Link> links_;
  std::vector<Rational> roots_;
};

}  // namespace

std::vector<TruthCell> truth_over_forces(const Program& statement, Evaluator<ForceFunction>& evaluator) {
  return OverForces(statement, evaluator).cells();
}

std::optional<ForceInterval> true_interval(const Program& statement, Evaluator<ForceFunction>& evaluator,
                                           const ForceInterval& within) {
  std::optional<ForceInterval> found;
  for (const TruthCell& cell : truth_over_forces(statement, evaluator)) {
    ForceInterval forces = cell.forces;
    forces.intersect(within);
    if (forces.empty() || cell.truth == Truth::no) continue;
    if (cell.truth != Truth::yes || found) return std::nullopt;
    found = std::move(forces);
  }
  return found ? found : ForceInterval::nothing();
}

}  // namespace slipproof

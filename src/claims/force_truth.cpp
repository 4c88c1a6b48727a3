#include "claims/force_truth.hpp"

#include <algorithm>
#include <utility>

namespace slipproof {

namespace {

// A comparison as the sign of numerator(F) / denominator(F), both of degree at most 1; or no such thing.
struct Link {
  bool decided = false;
  Failure failure = Failure::undecided;
  Affine<Rational> numerator, denominator;
};

Affine<Rational> as_affine(const Polynomial& p) {
  return {p.coefficient(0), p.coefficient(1)};
}

Link difference(const Program& statement, const Program::Instruction& comparison,
                Evaluator<RationalFunction>& evaluator) {
  const Value<RationalFunction> x = evaluator.number(statement, comparison.first);
  if (!x.number) return {false, x.failure, {}, {}};
  const Value<RationalFunction> y = evaluator.number(statement, comparison.second);
  if (!y.number) return {false, y.failure, {}, {}};
  const RationalFunction d = *x.number - *y.number;
  if (d.numerator().degree() > 1 || d.denominator().degree() > 1) return {};
  return {true, {}, as_affine(d.numerator()), as_affine(d.denominator())};
}

class OverForces {
 public:
  OverForces(const Program& statement, Evaluator<RationalFunction>& evaluator)
      : statement_(statement), links_(statement.code().size()) {
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const Program::Instruction& instruction = statement.code()[i];
      if (instruction.operation != Operation::compare) continue;
      links_[i] = difference(statement, instruction, evaluator);
      add_root(links_[i].numerator);
      add_root(links_[i].denominator);
    }
    std::sort(roots_.begin(), roots_.end());
    roots_.erase(std::unique(roots_.begin(), roots_.end()), roots_.end());
  }

  std::vector<TruthCell> cells() const {
    std::vector<TruthCell> cells;
    std::optional<Rational> lower;
    for (const Rational& root : roots_) {
      append(cells, ForceInterval::between(lower, false, root, false));
      append(cells, ForceInterval::point(root));
      lower = root;
    }
    append(cells, ForceInterval::between(lower, false, std::nullopt, false));
    return cells;
  }

 private:
  void add_root(const Affine<Rational>& x) {
    if (!x.beta.is_zero()) roots_.push_back(-x.alpha / x.beta);
  }

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
    const int denominator = sign(link.denominator.at(force));
    if (denominator == 0) return Truth::undefined;
    return holds(relation, sign(link.numerator.at(force)) * denominator) ? Truth::yes : Truth::no;
  }

  const Program& statement_;
  std::vector<Link> links_;
  std::vector<Rational> roots_;
};

}  // namespace

std::vector<TruthCell> truth_over_forces(const Program& statement, Evaluator<RationalFunction>& evaluator) {
  return OverForces(statement, evaluator).cells();
}

std::optional<ForceInterval> true_interval(const Program& statement, Evaluator<RationalFunction>& evaluator,
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

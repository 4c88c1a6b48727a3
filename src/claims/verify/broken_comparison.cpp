#include "claims/verify/broken_comparison.hpp"

#include "mechanics/kernel/affine_space.hpp"

namespace slipproof {

namespace {

class Comparisons {
 public:
  Comparisons(const CompiledSetting& setting, Reading reading)
      : setting_(setting), reading_(reading), values_(setting.scope()) {}

  void set(std::size_t slot, const Rational& value) { values_.set(slot, value); }
  bool is_false(const Expression& condition) {
    return values_.truth(setting_.compile(condition, reading_)) == Truth::no;
  }
  /// Collects the comparisons in a condition that is false.
  void collect(const Expression& condition, std::vector<BrokenComparison>& found) {
    if (condition->operation == Operation::compare) return links(*condition, found);
    if (condition->operation != Operation::logical_and && condition->operation != Operation::logical_or) return;
    for (const Expression& operand : condition->operands) {
      if (is_false(operand)) collect(operand, found);
    }
  }

 private:
  void links(const Node& chain, std::vector<BrokenComparison>& found) {
    for (std::size_t i = 0; i < chain.relations.size(); ++i) {
      const auto left = number(chain.operands[i]), right = number(chain.operands[i + 1]);
      if (!left || !right || holds(chain.relations[i], sign(Rational(*left - *right)))) continue;
      found.push_back({chain.operands[i], chain.operands[i + 1], chain.relations[i], *left, *right});
    }
  }
  std::optional<Rational> number(const Expression& expression) {
    return values_.number(setting_.compile(expression, reading_)).number;
  }

  const CompiledSetting& setting_;
  Reading reading_;
  Evaluator<Rational> values_;
};

}  // namespace

std::vector<BrokenComparison> broken_comparisons(const Claim& claim, Reading reading, const CompiledSetting& setting,
                                                 const Counterexample& example, SolvedSample& sample) {
  if (example.judgement.reason != Reason::formula || !example.force) return {};
  Comparisons at(setting, reading);
  for (std::size_t k = 0; k < sample.values().size(); ++k) {
    at.set(CompiledSetting::parameter_slot(k), sample.values()[k]);
  }
  at.set(CompiledSetting::force_slot(), *example.force);
  if (example.judgement.mode) {
    const ModeForms* forms = sample.motions().forms(*example.judgement.mode);
    if (forms == nullptr) return {};
    const Rational load = sample.load(*example.force);
    for (std::size_t q = 0; q < setting.quantities(); ++q) {
      const AffineForm& form = quantity_form(*forms, q);
      if (!is_free_of_unknowns(form)) continue;
      at.set(setting.quantity_slot(q), form.constant + form.coefficients.back() * load);
    }
  }
  std::vector<BrokenComparison> found;
  // A condition that must hold and does not; for two conditions that should be equivalent, the one that is false.
  const ClaimBody& body = claim.body(reading);
  const bool of_two = !body.kind->forces_say_where();
  const Expression& condition = of_two && at.is_false(body.forces) ? body.forces : body.holds;
  if (at.is_false(condition)) at.collect(condition, found);
  return found;
}

}  // namespace slipproof

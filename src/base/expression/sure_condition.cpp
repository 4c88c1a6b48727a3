#include "base/expression/sure_condition.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace slipproof {

namespace {

/// -1, 0 or +1 if sure, otherwise a number about which nothing is sure.
Approximate sign_number(const Approximate& x) {
  const auto sign = sure_sign(x);
  return sign ? Approximate(*sign) : Approximate(0, std::numeric_limits<double>::infinity());
}

Approximate power(Approximate base, int exponent) {
  if (!(base.error < std::numeric_limits<double>::infinity())) return base;  // may have no value: nor has its 0th power
  Approximate result(1);
  if (exponent < 0) base = result / base;
  for (unsigned n = static_cast<unsigned>(exponent < 0 ? -exponent : exponent); n != 0; n /= 2) {
    if (n % 2 == 1) result = result * base;
    if (n > 1) base = base * base;
  }
  return result;
}

}  // namespace

/// Writes programs one after the other, each definition once.
class SureCondition::Writer {
 public:
  Writer(SureCondition& condition, const Scope& scope, std::size_t first)
      : condition_(condition), scope_(scope), first_(first) {}

  /// The number of the step that has a program's value.
  std::uint32_t write(const Program& program) {
    std::vector<std::uint32_t> places;
    for (const Program::Instruction& instruction : program.code())
      places.push_back(write(program, instruction, places));
    return places.back();
  }

 private:
  std::uint32_t write(const Program& program, const Program::Instruction& instruction,
                      const std::vector<std::uint32_t>& places) {
    if (instruction.operation == Operation::symbol) return symbol(instruction.first);
    Result known;
    if (instruction.operation == Operation::number) {
      known.number = Approximate(program.constants()[instruction.first]);
      return push({instruction.operation, {}, 0, 0, 0}, known, {});
    }
    if (instruction.operation == Operation::truth) {
      known.truth = instruction.truth ? Truth::yes : Truth::no;
      return push({instruction.operation, {}, 0, 0, 0}, known, {});
    }
    const std::uint32_t x = places[instruction.first], y = places[instruction.second];
    std::vector<bool> depends = depends_[x];
    for (std::size_t k = 0; k < depends.size(); ++k) depends[k] = depends[k] || depends_[y][k];
    return push({instruction.operation, instruction.relation, instruction.exponent, x, y}, known, std::move(depends));
  }

  std::uint32_t symbol(std::size_t slot) {
    const auto known = places_.find(slot);
    if (known != places_.end()) return known->second;
    std::uint32_t place = 0;
    if (slot - first_ < condition_.coordinates_) {
      std::vector<bool> depends(condition_.coordinates_);
      depends[slot - first_] = true;
      place = push({Operation::symbol, {}, 0, static_cast<std::uint32_t>(slot - first_), 0}, {}, std::move(depends));
    } else if (const auto& definition = scope_.slots[slot].definition) {
      place = write(*definition);
    } else {
      place = push({Operation::number, {}, 0, 0, 0}, {}, {});
    }
    return places_[slot] = place;
  }

  std::uint32_t push(const Step& step, const Result& result, std::vector<bool> depends) {
    const auto place = static_cast<std::uint32_t>(condition_.steps_.size());
    condition_.steps_.push_back(step);
    condition_.results_.push_back(result);
    depends.resize(condition_.coordinates_);
    for (std::size_t k = 0; k < depends.size(); ++k) {
      if (depends[k]) condition_.behind_[k].push_back(place);
    }
    if (step.operation != Operation::number && step.operation != Operation::truth) {
      condition_.behind_[condition_.coordinates_].push_back(place);
    }
    depends_.push_back(std::move(depends));
    return place;
  }

  SureCondition& condition_;
  const Scope& scope_;
  std::size_t first_;
  std::map<std::size_t, std::uint32_t> places_;  ///< of symbols
  std::vector<std::vector<bool>> depends_;       ///< by step, on which coordinates
};

SureCondition::SureCondition(const Scope& scope, const Program& condition, std::size_t first, std::size_t coordinates)
    : coordinates_(coordinates), behind_(coordinates + 1), stale_(coordinates), demands_(coordinates) {
  note_demands(Writer(*this, scope, first).write(condition));
}

/// Notes what a step that must hold demands.
void SureCondition::note_demands(std::uint32_t i) {
  const Step& step = steps_[i];
  if (step.operation == Operation::logical_and) {
    note_demands(step.first);
    note_demands(step.second);
  }
  if (step.operation != Operation::compare || step.relation != Relation::equal) return;
  for (const auto& [side, other] : {std::pair(step.first, step.second), std::pair(step.second, step.first)}) {
    if (steps_[side].operation != Operation::symbol) continue;
    const std::size_t coordinate = steps_[side].first;
    if (!std::ranges::binary_search(behind_[coordinate], other)) demands_[coordinate] = other;
  }
}

void SureCondition::run(const std::vector<Approximate>& point) {
  for (const std::uint32_t i : behind_[stale_]) {
    const Step& step = steps_[i];
    if (step.operation == Operation::symbol) {
      results_[i].number = point[step.first];
    } else if (step.operation < Operation::truth) {
      results_[i].number = number(step);
    } else {
      results_[i].truth = truth(step);
    }
  }
  stale_ = nothing();
}

Approximate SureCondition::number(const Step& step) const {
  const Approximate &x = results_[step.first].number, &y = results_[step.second].number;
  switch (step.operation) {
    case Operation::negate:
      return -x;
    case Operation::add:
      return x + y;
    case Operation::subtract:
      return x - y;
    case Operation::multiply:
      return x * y;
    case Operation::divide:
      return x / y;
    case Operation::power:
      return power(x, step.exponent);
    case Operation::signum:
      return sign_number(x);
    case Operation::absolute:
      return sign_number(x) * x;
    default: {
      const auto order = sure_sign(x - y);
      if (!order) return {0, std::numeric_limits<double>::infinity()};
      return (*order <= 0) == (step.operation == Operation::minimum) ? x : y;
    }
  }
}

Truth SureCondition::truth(const Step& step) const {
  const Truth x = results_[step.first].truth, y = results_[step.second].truth;
  switch (step.operation) {
    case Operation::logical_not:
      return negation(x);
    case Operation::logical_and:
      return combine(x, y, Truth::no, Truth::yes);
    case Operation::logical_or:
      return combine(x, y, Truth::yes, Truth::no);
    default: {
      const Approximate &left = results_[step.first].number, &right = results_[step.second].number;
      const auto order = sure_sign(right.is_zero() ? left : left - right);
      if (!order) return Truth::undecided;
      return holds(step.relation, *order) ? Truth::yes : Truth::no;
    }
  }
}

}  // namespace slipproof

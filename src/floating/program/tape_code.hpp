// Selects from a tape what is to be computed, as steps that run over any number type: lanes of binary64, numbers with
// error bounds, ranges.
//
// A step is a quotient, or a sum of products and plain numbers, each with a sign. A sum includes its parts unless
// another result needs them, so that one step does many operations. An interpreter of such steps is nearly as fast as
// compiled code.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "floating/program/tape.hpp"

namespace slipproof {

/// The places of two factors; for a plain number twice the same place.
struct TapeTerm {
  std::uint32_t first, second;
};

/// numbers[target] = products + plain - products - plain, or its negative; or a quotient of two plain numbers.
struct TapeStep {
  std::uint32_t target = 0, terms = 0;  ///< where its terms begin
  std::uint16_t added_products = 0, added = 0, subtracted_products = 0, subtracted = 0;
  bool negative = false, quotient = false;
};

struct TapeCode {
  std::vector<TapeStep> steps;
  std::vector<TapeTerm> terms;
};

/// Makes code for a tape, and assigns places to its results. The first places are those of the inputs, in their order.
class TapeCompiler {
 public:
  /// The tape must outlive it.
  TapeCompiler(const std::vector<TapeNode>& nodes, std::size_t inputs);

  /// The code for results that are wanted and not computed yet. Results keep their places.
  TapeCode code_for(const std::vector<TapeRef>& wanted);
  /// Code in parts that reuse places; call it instead of code_for(). What a part wants keeps its place until the next
  /// part runs; `places` receives the places of what each part wants.
  std::vector<TapeCode> code_for_parts(const std::vector<std::vector<TapeRef>>& wanted,
                                       std::vector<std::vector<std::uint32_t>>& places);
  /// The place of a result that was wanted.
  std::uint32_t place(TapeRef ref) const { return places_[ref]; }
  std::size_t places() const { return count_; }
  /// The literals that code needs, and their places.
  const std::vector<std::pair<std::uint32_t, TapeRef>>& literals() const { return literals_; }

  /// Later code cannot use what was computed up to here.
  void forget();

 private:
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

  struct Signed {
    TapeRef ref;
    bool negative;
  };
  Signed resolved(TapeRef ref) const;
  bool is_sum(TapeRef ref) const;
  bool is_literal(TapeRef ref) const { return nodes_[ref].operation == TapeOperation::constant; }
  void count_uses(const std::vector<TapeRef>& wanted);
  std::vector<bool> stepwise(const std::vector<TapeRef>& wanted) const;
  TapeCode steps_for(const std::vector<TapeRef>& wanted);
  void add_step(TapeRef ref, TapeCode& code) const;
  template <class See>
  void each_term(TapeRef ref, bool negative, const See& see) const;
  void find_places(TapeCode& code);
  std::uint32_t place_for(TapeRef ref);

  const std::vector<TapeNode>& nodes_;
  std::vector<std::uint32_t> places_, uses_;
  std::vector<bool> done_;
  std::vector<std::uint32_t> unused_;
  std::vector<std::pair<std::uint32_t, TapeRef>> literals_;
  std::uint32_t count_;
};

/// Runs the steps in order; calls see(result) after each.
template <class N, class See>
void run_code(const TapeCode& code, N* numbers, const See& see) {
  for (const TapeStep& step : code.steps) {
    const TapeTerm* term = &code.terms[step.terms];
    const auto product = [&] { return numbers[term->first] * numbers[term->second]; };
    if (step.quotient) {
      const N value = numbers[term->first] / numbers[term->second];
      numbers[step.target] = step.negative ? -value : value;
    } else {
      N sum = step.added_products > 0 ? product() : numbers[term->first];
      const TapeTerm* const first = term++;
      for (const TapeTerm* end = first + step.added_products; term < end; ++term) sum = sum + product();
      for (const TapeTerm* end = first + step.added_products + step.added; term < end; ++term) {
        sum = sum + numbers[term->first];
      }
      for (const TapeTerm* end = term + step.subtracted_products; term < end; ++term) sum = sum - product();
      for (const TapeTerm* end = term + step.subtracted; term < end; ++term) sum = sum - numbers[term->first];
      numbers[step.target] = step.negative ? -sum : sum;
    }
    see(numbers[step.target]);
  }
}

template <class N>
void run_code(const TapeCode& code, N* numbers) {
  run_code(code, numbers, [](const N&) {});
}

/// Cosine and sine from tan(angle/2).
template <class N>
std::pair<N, N> circle_of(const N& tan_half, const N& one) {
  const N square = tan_half * tan_half;
  return {(one - square) / (one + square), (tan_half + tan_half) / (one + square)};
}

}  // namespace slipproof

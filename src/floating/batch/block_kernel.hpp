// The loops over blocks of points in vector registers: running the code, and checking its results.
#pragma once

#include <cstring>
#include <limits>

#include "floating/batch/block_modes.hpp"
#include "floating/lanes/lane_vectors.hpp"
#include "floating/lanes/vector_kernel.hpp"

namespace slipproof {

template <class V>
inline constexpr std::size_t vectors_of = block_points / static_cast<std::size_t>(width_of<V>);

/// So many vectors are computed side by side, so that their sums stay in registers.
inline constexpr std::size_t side_by_side = 8;

template <class V>
[[gnu::always_inline]] inline V number(const double* numbers, std::uint32_t place, std::size_t vector) {
  return load<V>(numbers + place * block_points + vector * static_cast<std::size_t>(width_of<V>));
}
template <class V>
[[gnu::always_inline]] inline void store(double* numbers, std::uint32_t place, std::size_t vector, const V& x) {
  std::memcpy(numbers + place * block_points + vector * static_cast<std::size_t>(width_of<V>), &x, sizeof x);
}

/// run_code() for a whole block; calls see(place) for each result.
template <class V, class See>
[[gnu::always_inline]] inline void run_block(const TapeCode& code, double* numbers, const See& see) {
  constexpr std::size_t n = side_by_side;
  for (const TapeStep& step : code.steps) {
    const TapeTerm* const terms = &code.terms[step.terms];
    for (std::size_t base = 0; base < vectors_of<V>; base += n) {
      const TapeTerm* term = terms;
      V sum[n];
      const auto each = [&](const auto& see) {
#pragma GCC unroll 8
        for (std::size_t k = 0; k < n; ++k) see(sum[k], base + k);
        ++term;
      };
      const auto x = [&](std::size_t k) { return number<V>(numbers, term->first, k); };
      const auto y = [&](std::size_t k) { return number<V>(numbers, term->second, k); };
      if (step.quotient) {
        each([&](V& s, std::size_t k) { s = x(k) / y(k); });
      } else {
        if (step.added_products > 0) {
          each([&](V& s, std::size_t k) { s = x(k) * y(k); });
        } else {
          each([&](V& s, std::size_t k) { s = x(k); });
        }
        const TapeTerm* end = terms + step.added_products;
        while (term < end) each([&](V& s, std::size_t k) { s += x(k) * y(k); });
        end = terms + step.added_products + step.added;
        while (term < end) each([&](V& s, std::size_t k) { s += x(k); });
        end += step.subtracted_products;
        while (term < end) each([&](V& s, std::size_t k) { s -= x(k) * y(k); });
        end += step.subtracted;
        while (term < end) each([&](V& s, std::size_t k) { s -= x(k); });
      }
#pragma GCC unroll 8
      for (std::size_t k = 0; k < n; ++k) store<V>(numbers, step.target, base + k, step.negative ? V(-sum[k]) : sum[k]);
    }
    see(step.target);
  }
}

template <class V>
inline V smaller_of(const V& x, const V& y) {
  return x < y ? x : y;
}

struct DecideModes {
  template <int width>
  static void run(BlockModes& block, BlockAnswers& answers) {
    using V = typename LaneTypes<width>::Numbers;
    const BlockCode& code = *block.code_;
    const ResultRange* range = block.results_.data();
    const auto check = [&](std::uint32_t place) {
      if (range->asked) check_result<V>(block.numbers_, place, *range, answers);
      ++range;
    };
    check_inputs<V>(block, answers);
    run_block<V>(code.domain, block.numbers_, check);
    check_domain<V>(block, answers);
    for (std::size_t mode = 0; mode < code.modes.size(); ++mode) {
      run_block<V>(code.modes[mode].code, block.numbers_, check);
      switch (code.modes[mode].equations.size()) {
        case 0:
          judge<V, 0>(block, mode, answers);
          break;
        case 1:
          judge<V, 1>(block, mode, answers);
          break;
        default:
          judge<V, 2>(block, mode, answers);
      }
    }
  }

 private:
  using Check = BlockModes::Check;
  using ResultRange = BlockModes::ResultRange;

  /// Negative if a number is outside the range; for NaN the result has no meaning. Uses no comparison, because GCC
  /// splits comparisons into single numbers before it inlines this function into one for wide registers.
  template <class V>
  [[gnu::always_inline]] static BitsOf<V> outside(const V& x, double lower, double upper) {
    return bits(V(x - in_all_lanes<V>(lower))) | bits(V(in_all_lanes<V>(upper) - x));
  }

  /// Marks points outside the ranges as left. Later steps ask only for signs of differences of numbers, none of which
  /// is NaN.
  template <class V>
  [[gnu::always_inline]] static void check_inputs(const BlockModes& block, BlockAnswers& answers) {
    constexpr double largest = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < vectors_of<V>; ++k) {
      BitsOf<V> left{};
      for (std::size_t i = 0; i < block.inputs_.size(); ++i) {
        if (block.code_->constant[i]) continue;
        const V x = number<V>(block.numbers_, static_cast<std::uint32_t>(i), k);
        left |= outside(x, block.inputs_[i].lower, block.inputs_[i].upper) | beyond(x, largest);
      }
      put(answers.left.data(), k, left);
    }
  }

  template <class V>
  [[gnu::always_inline]] static void check_result(const double* numbers, std::uint32_t place, const ResultRange& range,
                                                  BlockAnswers& answers) {
    for (std::size_t k = 0; k < vectors_of<V>; ++k) {
      leave(answers, k, outside(number<V>(numbers, place, k), range.lower, range.upper));
    }
  }

  template <class V>
  [[gnu::always_inline]] static void check_domain(const BlockModes& block, BlockAnswers& answers) {
    if (block.domain_.empty()) return;
    for (std::size_t k = 0; k < vectors_of<V>; ++k) leave(answers, k, unsure<V>(block.numbers_, block.domain_, k));
  }

  template <class B>
  [[gnu::always_inline]] static void leave(BlockAnswers& answers, std::size_t k, const B& left) {
    put(answers.left.data(), k, B(got<B>(answers.left.data(), k) | left));
  }

  /// Negative where a check is not sure to hold.
  template <class V>
  [[gnu::always_inline]] static BitsOf<V> unsure(const double* numbers, const std::vector<Check>& checks,
                                                 std::size_t k) {
    BitsOf<V> result{};
    for (const Check& check : checks) {
      V x = number<V>(numbers, check.number, k);
      if (check.sign == Check::Sign::any) x = absolute(x);
      if (check.sign == Check::Sign::negative) x = -x;
      result |= ~bits(V(in_all_lanes<V>(check.error) - x));
    }
    return result;
  }

  /// Handles two vectors side by side, so that each place is read half as often. The numbers are separate variables
  /// because GCC copies a struct of vectors in halves, which stalls processors.
  template <class V, std::size_t unknowns>
  [[gnu::always_inline]] static void judge(const BlockModes& block, std::size_t mode, BlockAnswers& answers) {
    constexpr std::size_t n = 2;
    const BlockMode& program = block.code_->modes[mode];
    const BlockForm* const end = program.conditions.data() + program.conditions.size();
    for (std::size_t base = 0; base < vectors_of<V>; base += n) {
      const auto at = [&](std::uint32_t place, std::size_t k) { return number<V>(block.numbers_, place, base + k); };
      V divisor[n]{}, u[n]{}, v[n]{}, least[n];
#pragma GCC unroll 2
      for (std::size_t k = 0; k < n; ++k) {
        solve<V, unknowns>(
            program.equations.data(), [&](std::uint32_t place) { return at(place, k); }, divisor[k], u[k], v[k]);
        least[k] = in_all_lanes<V>(std::numeric_limits<double>::infinity());
      }
      for (const BlockForm* form = program.conditions.data(); form < end; ++form) {
#pragma GCC unroll 2
        for (std::size_t k = 0; k < n; ++k) {
          V side = at(form->constant, k);
          if constexpr (unknowns > 0) side = side * divisor[k] + at(form->core[0], k) * u[k];
          if constexpr (unknowns > 1) side = side + at(form->core[1], k) * v[k];
          const BitsOf<V> orientation = bits(divisor[k]) & sign_bit<V>();
          least[k] = smaller_of(from_bits(BitsOf<V>(bits(side) ^ orientation)), least[k]);
        }
      }
#pragma GCC unroll 2
      for (std::size_t k = 0; k < n; ++k) answer<V, unknowns>(block, mode, base + k, divisor[k], least[k], answers);
    }
  }

  template <class V, std::size_t unknowns, class At>
  [[gnu::always_inline]] static void solve(const BlockForm* equations, const At& at, V& divisor, V& u, V& v) {
    if constexpr (unknowns == 1) {
      divisor = at(equations[0].core[0]);
      u = -at(equations[0].constant);
    } else if constexpr (unknowns == 2) {
      const V x0 = at(equations[0].core[0]), x1 = at(equations[0].core[1]), r = at(equations[0].constant);
      const V y0 = at(equations[1].core[0]), y1 = at(equations[1].core[1]), s = at(equations[1].constant);
      divisor = x0 * y1 - x1 * y0;
      u = x1 * s - r * y1;
      v = r * y0 - x0 * s;
    }
  }

  /// Answers for a mode, from its divisor and its least condition.
  template <class V, std::size_t unknowns>
  [[gnu::always_inline]] static void answer(const BlockModes& block, std::size_t mode, std::size_t k, const V& divisor,
                                            const V& least, BlockAnswers& answers) {
    using Words = typename LaneTypes<width_of<V>>::Words;
    BitsOf<V> left = ~bits(V(in_all_lanes<V>(block.bounds_[mode].conditions) - absolute(least)));
    if constexpr (unknowns > 0) left |= ~bits(V(in_all_lanes<V>(block.bounds_[mode].divisor) - absolute(divisor)));
    if (!block.pivots_[mode].empty()) left |= unsure<V>(block.numbers_, block.pivots_[mode], k);
    if (block.code_->modes[mode].only_refuted) left |= ~bits(least);
    leave(answers, k, left);
    std::uint64_t* const words = answers.inconsistent[mode / 64].data();
    const auto fails = Words(reinterpret_cast<Words>(bits(least)) >> 63 << (mode % 64));
    put(words, k, Words(got<Words>(words, k) | fails));
  }

  template <class B, class T>
  [[gnu::always_inline]] static B got(const T* from, std::size_t k) {
    B x;
    std::memcpy(&x, from + k * (sizeof(B) / sizeof(T)), sizeof x);
    return x;
  }
  template <class B, class T>
  [[gnu::always_inline]] static void put(T* to, std::size_t k, const B& x) {
    std::memcpy(to + k * (sizeof(B) / sizeof(T)), &x, sizeof x);
  }
};

/// Extends the range of each result by the values in a block of points.
struct SeeResults {
  template <int width>
  static void run(BlockModes& block) {
    using V = typename LaneTypes<width>::Numbers;
    const BlockCode& code = *block.code_;
    std::size_t result = 0;
    const auto see = [&](std::uint32_t place) {
      const bool divisor = code.divisors[result];
      auto& range = block.results_[result++];
      for (std::size_t i = 0; i < block_points; ++i) {
        const double x = block.numbers_[place * block_points + i];
        if (divisor && x == 0) continue;
        range.lower = x < range.lower ? x : range.lower;
        range.upper = x > range.upper ? x : range.upper;
      }
    };
    run_block<V>(code.domain, block.numbers_, see);
    for (const BlockMode& mode : code.modes) run_block<V>(mode.code, block.numbers_, see);
  }
};

}  // namespace slipproof

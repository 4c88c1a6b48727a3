#include "floating/tape/block_modes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "floating/filter/lane_vectors.hpp"
#include "floating/filter/vector_kernel.hpp"
#include "floating/tape/linear_mode.hpp"

namespace slipproof {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class V>
inline constexpr std::size_t vectors_of = block_points / static_cast<std::size_t>(width_of<V>);

/// As many vectors are computed side by side: their sums stay in registers.
inline constexpr std::size_t side_by_side = 8;

template <class V>
[[gnu::always_inline]] inline V number(const double* numbers, std::uint32_t place, std::size_t vector) {
  return load<V>(numbers + place * block_points + vector * static_cast<std::size_t>(width_of<V>));
}
template <class V>
[[gnu::always_inline]] inline void store(double* numbers, std::uint32_t place, std::size_t vector, const V& x) {
  std::memcpy(numbers + place * block_points + vector * static_cast<std::size_t>(width_of<V>), &x, sizeof x);
}

/// run_code() of a whole block.
template <class V>
[[gnu::always_inline]] inline void run_block(const TapeCode& code, double* numbers) {
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
  }
}

template <class V>
inline V smaller_of(const V& x, const V& y) {
  return x < y ? x : y;
}

}  // namespace

struct DecideModes {
  template <int width>
  static void run(BlockModes& block, BlockAnswers& answers) {
    using V = typename LaneTypes<width>::Numbers;
    const BlockCode& code = *block.code_;
    run_block<V>(code.domain, block.numbers_);
    check_domain<V>(block, answers);
    for (std::size_t mode = 0; mode < code.modes.size(); ++mode) {
      run_block<V>(code.modes[mode].code, block.numbers_);
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

  /// Points outside of the ranges are left: what follows asks signs of differences of numbers, none of which is NaN.
  template <class V>
  [[gnu::always_inline]] static void check_domain(const BlockModes& block, BlockAnswers& answers) {
    for (std::size_t k = 0; k < vectors_of<V>; ++k) {
      BitsOf<V> left{};
      for (std::size_t i = 0; i < block.inputs_.size(); ++i) {
        if (block.code_->constant[i]) continue;
        const V x = number<V>(block.numbers_, static_cast<std::uint32_t>(i), k);
        const V lower = in_all_lanes<V>(block.inputs_[i].lower), upper = in_all_lanes<V>(block.inputs_[i].upper);
        left |= ~((x >= lower) & (x <= upper));
      }
      left |= unsure<V>(block.numbers_, block.domain_, k);
      put(answers.left.data(), k, left);
    }
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

  /// Numbers stay in variables of their own: GCC copies a struct of vectors in halves, which processors stall at.
  template <class V, std::size_t unknowns>
  [[gnu::always_inline]] static void judge(const BlockModes& block, std::size_t mode, BlockAnswers& answers) {
    using Bits = BitsOf<V>;
    using Words = typename LaneTypes<width_of<V>>::Words;
    const BlockMode& program = block.code_->modes[mode];
    const V bound = in_all_lanes<V>(block.bounds_[mode]);
    const BlockForm* const equations = program.equations.data();
    const BlockForm* const end = program.conditions.data() + program.conditions.size();
    std::uint64_t* const words = answers.inconsistent[mode / 64].data();
    for (std::size_t k = 0; k < vectors_of<V>; ++k) {
      const auto at = [&](std::uint32_t place) { return number<V>(block.numbers_, place, k); };
      V divisor{}, u{}, v{};
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
      const Bits orientation = bits(divisor) & sign_bit<V>();
      V least = in_all_lanes<V>(infinity);
      for (const BlockForm* form = program.conditions.data(); form < end; ++form) {
        V side = at(form->constant);
        if constexpr (unknowns > 0) side = side * divisor + at(form->core[0]) * u;
        if constexpr (unknowns > 1) side = side + at(form->core[1]) * v;
        least = smaller_of(from_bits(Bits(bits(side) ^ orientation)), least);
      }
      V size = absolute(least);
      if constexpr (unknowns > 0) size = smaller_of(absolute(divisor), size);
      Bits left = ~bits(V(bound - size));
      if (!block.pivots_[mode].empty()) left |= unsure<V>(block.numbers_, block.pivots_[mode], k);
      if (program.only_refuted) left |= ~bits(least);
      put(answers.left.data(), k, Bits(got<Bits>(answers.left.data(), k) | left));
      const auto fails = Words(reinterpret_cast<Words>(bits(least)) >> 63 << (mode % 64));
      put(words, k, Words(got<Words>(words, k) | fails));
    }
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

namespace {

struct YesNoOfBlock {
  bool yes = false, no = false;
};

YesNoOfBlock compared(Relation relation, const SharedRange& x) {
  const bool not_positive = (-x).not_negative();
  switch (relation) {
    case Relation::less:
      return {x.negative(), x.not_negative()};
    case Relation::less_equal:
      return {not_positive, x.positive()};
    case Relation::greater:
      return {x.positive(), not_positive};
    case Relation::greater_equal:
      return {x.not_negative(), x.negative()};
    case Relation::equal:
      return {x.zero(), x.not_zero()};
    default:
      return {x.not_zero(), x.zero()};
  }
}

/// Whether a condition holds wherever the inputs are in their ranges; at(difference) in the order of the steps.
template <class At>
bool surely(const TruthProgram& truth, const At& at) {
  std::vector<YesNoOfBlock> found;
  for (const auto& step : truth.steps) {
    switch (step.operation) {
      case Operation::truth:
        found.push_back({step.truth, !step.truth});
        break;
      case Operation::logical_not:
        found.push_back({found[step.first].no, found[step.first].yes});
        break;
      case Operation::logical_and:
        found.push_back(
            {found[step.first].yes && found[step.second].yes, found[step.first].no || found[step.second].no});
        break;
      case Operation::logical_or:
        found.push_back(
            {found[step.first].yes || found[step.second].yes, found[step.first].no && found[step.second].no});
        break;
      default:
        found.push_back(compared(step.relation, at(step.difference)));
    }
  }
  return found.back().yes;
}

bool is_single(const TruthProgram& program) {
  return program.steps.size() == 1 && program.steps[0].operation == Operation::compare;
}

}  // namespace

BlockModes::BlockModes(const BlockCode& code)
    : code_(&code),
      inputs_(code.constant.size()),
      shared_(code.places),
      bounds_(code.modes.size()),
      pivots_(code.modes.size()) {
  constexpr std::size_t line = 8;
  memory_ = std::make_unique<double[]>(code.places * block_points + line);
  numbers_ = memory_.get();
  while (reinterpret_cast<std::uintptr_t>(numbers_) % 64 != 0) ++numbers_;
  for (const auto& [place, value] : code.literals) shared_[place] = value;
}

void BlockModes::set_ranges(std::span<const SharedRange> inputs) {
  std::copy(inputs.begin(), inputs.end(), inputs_.begin());
  std::copy(inputs.begin(), inputs.end(), shared_.begin());
  run_code(code_->of_constants, shared_.data());
  for (const std::uint32_t place : code_->constant_places) {
    std::fill_n(numbers_ + place * block_points, block_points, shared_[place].lower);
  }
  able_ = find_bounds();
}

bool BlockModes::find_bounds() {
  run_code(code_->domain, shared_.data());
  if (!find_domain()) return false;
  for (std::size_t i = 0; i < code_->modes.size(); ++i) {
    if (!find_mode(i)) return false;
  }
  return true;
}

bool BlockModes::add_check(std::uint32_t number, Check::Sign sign, std::vector<Check>& checks) const {
  const SharedRange& range = shared_[number];
  const bool holds = sign == Check::Sign::any        ? range.not_zero()
                     : sign == Check::Sign::positive ? range.positive()
                                                     : range.negative();
  if (!holds) checks.push_back({number, sign, range.error});
  return holds || range.known();
}

/// False where nothing can be sure of the domain.
bool BlockModes::find_domain() {
  const ModePrograms& programs = *code_->programs;
  domain_.clear();
  auto place = code_->domain_numbers.begin();
  for (const TruthProgram& truth : programs.domain) {
    const auto first = place;
    if (surely(truth, [&](TapeRef) -> const SharedRange& { return shared_[*place++]; })) continue;
    if (!is_single(truth)) return false;
    const Relation relation = truth.steps[0].relation;
    if (relation == Relation::equal) return false;
    const bool negative = relation == Relation::less || relation == Relation::less_equal;
    const auto sign = relation == Relation::not_equal ? Check::Sign::any
                      : negative                      ? Check::Sign::negative
                                                      : Check::Sign::positive;
    if (!add_check(*first, sign, domain_)) return false;
  }
  for (; place != code_->domain_numbers.end(); ++place) {
    if (!add_check(*place, Check::Sign::any, domain_)) return false;
  }
  return true;
}

/// The largest error of a mode's divisor and conditions; false where one has no bound.
bool BlockModes::find_mode(std::size_t index) {
  const BlockMode& mode = code_->modes[index];
  run_code(mode.code, shared_.data());
  double bound = 0;
  const auto take = [&](const SharedRange& x) {
    bound = std::max(bound, x.error);
    return x.known();
  };
  const auto core = [&](const BlockForm& form) { return std::array{shared_[form.core[0]], shared_[form.core[1]]}; };
  const std::size_t unknowns = mode.equations.size();
  CoreSolution<SharedRange> solution;
  if (unknowns == 1) {
    solution = {core(mode.equations[0])[0], {-shared_[mode.equations[0].constant], {}}};
  } else if (unknowns == 2) {
    solution = solve_two(core(mode.equations[0]), shared_[mode.equations[0].constant], core(mode.equations[1]),
                         shared_[mode.equations[1].constant]);
  }
  bool known = unknowns == 0 || take(solution.divisor);
  for (const BlockForm& form : mode.conditions) {
    const SharedRange& constant = shared_[form.constant];
    known = known && take(unknowns == 0 ? constant : on_core(unknowns, constant, core(form), solution));
  }
  bounds_[index] = bound;
  pivots_[index].clear();
  for (const std::uint32_t pivot : mode.pivots) {
    known = known && add_check(pivot, Check::Sign::any, pivots_[index]);
  }
  return known;
}

void BlockModes::decide(BlockAnswers& answers) {
  answers.inconsistent.resize((code_->modes.size() + 63) / 64);
  for (auto& word : answers.inconsistent) word.fill(0);
  if (!able_) {
    answers.left.fill(-1);
    return;
  }
  VectorKernel<DecideModes>::run(widest_registers(), *this, answers);
}

}  // namespace slipproof

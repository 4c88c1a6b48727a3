#include "claims/sampling/simplify.hpp"

#include <algorithm>
#include <utility>

namespace slipproof {

namespace {

/// A parameter that is not free: a boundary gives its value from the others.
struct Tie {
  std::size_t parameter;
  const CompiledSetting::Boundary* boundary;
};

/// Computes the values of tied parameters; false if one is undefined or the sample is outside the domains.
bool complete(const CompiledSetting& setting, const std::vector<Tie>& ties, std::vector<Rational>& values) {
  for (const Tie& tie : ties) {
    auto value = boundary_value(setting, *tie.boundary, values);
    if (!value) return false;
    values[tie.parameter] = std::move(*value);
  }
  return in_domain(setting, values);
}

class Search {
 public:
  Search(const CompiledSetting& setting, const std::function<bool(const std::vector<Rational>&)>& fails, Among among,
         std::size_t budget, std::vector<Tie> ties)
      : setting_(setting), fails_(fails), among_(among), budget_(budget), ties_(std::move(ties)) {
    for (std::size_t k = 0; k < setting.domains().size(); ++k) {
      if (std::none_of(ties_.begin(), ties_.end(), [&](const Tie& tie) { return tie.parameter == k; }))
        free_.push_back(k);
    }
  }

  /// Tries all samples whose free values have at most this height, the simplest first. False if the budget is used up.
  bool exhaust(int height, std::optional<std::vector<Rational>>& found) {
    std::vector<Rational> values(setting_.domains().size(), Rational(1));
    choices_.clear();
    for (const std::size_t k : free_) choices_.push_back(allowed(k, height));
    for (std::size_t others = 0; others <= free_.size(); ++others) {
      if (!choose(0, others, values, found)) return false;
      if (found) return true;
    }
    return true;
  }

  /// Makes single free values simpler while the sample still fails.
  std::vector<Rational> descend(std::vector<Rational> values) {
    for (bool improved = true; improved;) {
      improved = false;
      for (const std::size_t k : free_) {
        const Complexity here = complexity(values);
        for (const Rational& candidate : simpler_numbers(values[k], 6)) {
          std::vector<Rational> tried = values;
          tried[k] = candidate;
          if (ties_.empty() && !(complexity(tried) < here)) continue;
          if (!completed(tried) || !(complexity(tried) < here) || !fails_(tried)) continue;
          values = std::move(tried);
          improved = true;
          break;
        }
      }
    }
    return values;
  }

  /// Computes the tied values; returns whether the sample is one of those wanted.
  bool completed(std::vector<Rational>& values) const {
    return complete(setting_, ties_, values) && (among_ == Among::all || unrealisable(setting_, values).empty());
  }

 private:
  /// The values that the parameter may have where all others are 1, or positive but not 1. Domains that couple
  /// parameters (h > -R) are checked again when all values are known.
  std::vector<Rational> allowed(std::size_t parameter, int height) const {
    std::vector<Rational> result;
    for (const Rational& value : numbers_up_to(height)) {
      if (value == 1) continue;
      for (const Rational& others : {Rational(1), Rational(height), Rational(Integer(1), Integer(height))}) {
        std::vector<Rational> values(setting_.domains().size(), others);
        values[parameter] = value;
        if (!allows(setting_, parameter, values)) continue;
        result.push_back(value);
        break;
      }
    }
    return result;
  }

  /// Chooses values other than 1 for `others` of the free parameters from `first` on.
  bool choose(std::size_t first, std::size_t others, std::vector<Rational>& values,
              std::optional<std::vector<Rational>>& found) {
    if (others == 0) {
      if (budget_ == 0) return false;
      --budget_;
      std::vector<Rational> tried = values;
      if (completed(tried) && (!found || complexity(tried) < complexity(*found)) && fails_(tried))
        found = std::move(tried);
      return true;
    }
    for (std::size_t i = first; i + others <= free_.size(); ++i) {
      for (const Rational& choice : choices_[i]) {
        values[free_[i]] = choice;
        if (!choose(i + 1, others - 1, values, found)) return false;
      }
      values[free_[i]] = 1;
    }
    return true;
  }

  const CompiledSetting& setting_;
  const std::function<bool(const std::vector<Rational>&)>& fails_;
  Among among_;
  std::size_t budget_;
  std::vector<Tie> ties_;
  std::vector<std::size_t> free_;
  std::vector<std::vector<Rational>> choices_;  ///< by position in free_
};

/// The boundaries that cause the failure: the sample is on them, and it does not fail slightly off them with the other
/// values kept.
std::vector<Tie> ties_of(const CompiledSetting& setting, const std::vector<Rational>& values,
                         const std::function<bool(const std::vector<Rational>&)>& fails) {
  std::vector<Tie> candidates;
  for (const auto& boundary : setting.boundaries()) {
    if (boundary_value(setting, boundary, values) == values[boundary.parameter]) {
      candidates.push_back({boundary.parameter, &boundary});
    }
  }
  std::vector<Tie> ties;
  for (const Tie& candidate : candidates) {
    const auto same = [&](const Tie& tie) { return tie.parameter == candidate.parameter; };
    if (std::any_of(ties.begin(), ties.end(), same)) continue;
    std::vector<Tie> others = candidates;
    std::erase_if(others, same);
    const Rational& here = values[candidate.parameter];
    const Rational step = Rational(Integer(1), Integer(1) << 60) * (here.is_zero() ? Rational(1) : here);
    bool thin = true;
    for (const Rational& moved : {Rational(here - step), Rational(here + step)}) {
      std::vector<Rational> beside = values;
      beside[candidate.parameter] = moved;
      thin = thin && !(complete(setting, others, beside) && fails(beside));
    }
    if (thin) ties.push_back(candidate);
  }
  return ties;
}

}  // namespace

std::optional<Simplified> simplify(const CompiledSetting& setting, const std::vector<Rational>& failing,
                                   const std::function<bool(const std::vector<Rational>&)>& fails, Among among,
                                   std::size_t budget) {
  Search search(setting, fails, among, budget, ties_of(setting, failing, fails));
  std::optional<std::vector<Rational>> found;
  bool exhausted = true;
  for (int height = 1; exhausted && !found && height <= 6; ++height) exhausted = search.exhaust(height, found);
  if (found && exhausted) return Simplified{.values = std::move(*found), .minimal = true};
  std::vector<Rational> start = found ? std::move(*found) : failing;
  if (!search.completed(start)) return std::nullopt;
  return Simplified{.values = search.descend(std::move(start))};
}

}  // namespace slipproof

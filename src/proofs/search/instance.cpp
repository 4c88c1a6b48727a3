#include "proofs/search/instance.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <utility>

#include "proofs/search/value_choice.hpp"

namespace slipproof::prove {
namespace {

Rational value_at(const Polynomial& p, const std::vector<Rational>& values) {
  p.ring().budget().spend(p.length() + 20);
  Polynomial value = p;
  for (const std::size_t v : p.variables()) {
    Polynomial sum(p.ring());
    for (std::size_t k = value.degree(v) + 1; k-- > 0;) sum = sum.scaled(values[v]) + value.coefficient(v, k);
    value = std::move(sum);
  }
  return value.constant();
}

class Attempt {
 public:
  /// `late_choices`: of disjunctions without equations no part is chosen; they are looked at when all values are there.
  Attempt(const Ring& ring, const Formula& formula, std::mt19937_64& random, const Polynomial* boundary,
          bool late_choices, bool roots)
      : ring_(ring),
        random_(random),
        late_choices_(late_choices),
        choice_(ring, random, roots),
        values_(ring.size()),
        chosen_(ring.size()),
        order_(ring.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    collect(formula);
    if (boundary != nullptr) conditions_.push_back({*boundary, Sign::zero});
  }

  std::optional<std::vector<Rational>> run() {
    choose_points_on_circles();
    put_off_late_conditions();
    bool solving = false;
    std::vector<std::size_t> open;  // variables that no equation determines once the others are known: chosen last
    for (const std::size_t v : order_) {
      if (!simplify()) return std::nullopt;
      if (chosen_[v]) continue;
      const auto equations = static_cast<std::size_t>(count_equations(conditions_) + count_equations(late_));
      const auto variables = static_cast<std::size_t>(std::count(chosen_.begin(), chosen_.end(), false));
      if (!solving && equations + 1 >= variables) {
        solving = true;
        catch_up();
      }
      if (solving) {
        if ((open.empty() && equations < variables) || !solve(v)) {
          open.push_back(v);
          chosen_[v] = true;
        }
      } else if (!solve_if_last(v) && !assign(v)) {
        return std::nullopt;
      }
    }
    for (const std::size_t v : open) {
      if (!simplify() || (!solve_if_last(v) && !assign(v))) return std::nullopt;
    }
    if (!simplify() || !conditions_.empty()) return std::nullopt;
    std::vector<Rational> found = numbers();
    const auto holds = [&](const Formula* formula) { return prove::holds_at(*formula, found); };
    if (!std::all_of(unchosen_.begin(), unchosen_.end(), holds)) return std::nullopt;
    return found;
  }

 private:
  void collect(const Formula& formula) {
    switch (formula.kind) {
      case Formula::Kind::atom:
        conditions_.push_back({formula.polynomial.front(), formula.sign});
        break;
      case Formula::Kind::conjunction:
        for (const Formula& part : formula.parts) collect(part);
        break;
      case Formula::Kind::disjunction:
        if (formula.parts.empty()) {
          conditions_.push_back({Polynomial(ring_, 1), Sign::zero});
        } else if (const Polynomial* p = non_zero_polynomial(formula)) {
          conditions_.push_back({.p = *p, .sign = Sign::positive, .either_sign = true});
        } else if (late_choices_ && !has_equation(formula)) {
          unchosen_.push_back(&formula);
        } else {
          collect(formula.parts[random_() % formula.parts.size()]);
        }
        break;
    }
  }

  static bool has_equation(const Formula& formula) {
    if (formula.kind == Formula::Kind::atom) return formula.sign == Sign::zero;
    return std::any_of(formula.parts.begin(), formula.parts.end(), has_equation);
  }

  /// Cosines and sines: of two variables whose squares must add up to 1 neither is found from the other, but rational
  /// points on the circle are, by the tangent of half of the angle.
  void choose_points_on_circles() {
    for (const Condition& c : std::vector<Condition>(conditions_)) {
      if (!c.is_equation() || !is_circle(c.p)) continue;
      const std::vector<std::size_t> pair = c.p.variables();
      if (chosen_[pair[0]] || chosen_[pair[1]]) continue;
      const std::uint64_t kind = random_() % 8;  // four of eight in the first quadrant
      const auto q = static_cast<long>(random_() % 6 + 1), p = static_cast<long>(random_() % 7);
      Rational t(p, q);
      if (kind < 4 && t > 1) t = 1 / t;
      if (kind >= 6) t = -t;
      const Rational square = t * t, cosine = (1 - square) / (1 + square), sine = 2 * t / (1 + square);
      const bool turned = kind % 2 == 1;
      substitute(pair[0], Polynomial(ring_, turned ? sine : cosine));
      substitute(pair[1], Polynomial(ring_, turned ? cosine : sine));
    }
  }

  static bool is_circle(const Polynomial& p) {
    const std::vector<std::size_t> variables = p.variables();
    if (variables.size() != 2) return false;
    const auto [x, y] = std::pair{variables[0], variables[1]};
    if (p.degree(x) != 2 || p.degree(y) != 2) return false;
    const Polynomial square = p.coefficient(x, 2), rest = p.coefficient(x, 0);
    if (!square.is_constant() || !p.coefficient(x, 1).is_zero() || !rest.coefficient(y, 1).is_zero()) return false;
    const Polynomial other = rest.coefficient(y, 2), constant = rest.coefficient(y, 0);
    return other == square && constant == -square;
  }

  /// Drops what is true; whether nothing is false.
  bool simplify() {
    for (const Condition& c : conditions_) {
      if (c.p.is_constant() && !c.holds_at(c.p.constant())) return false;
    }
    std::erase_if(conditions_, [](const Condition& c) { return c.p.is_constant(); });
    return true;
  }

  static std::ptrdiff_t count_equations(const std::vector<Condition>& conditions) {
    return std::count_if(conditions.begin(), conditions.end(), [](const Condition& c) { return c.is_equation(); });
  }

  /// Conditions with a variable that will be solved for have nothing to say before that.
  void put_off_late_conditions() {
    const auto equations = static_cast<std::size_t>(count_equations(conditions_));
    std::vector<bool> late(order_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) late[order_[i]] = i + equations + 1 >= order_.size();
    const auto begin = std::stable_partition(conditions_.begin(), conditions_.end(), [&](const Condition& c) {
      const std::vector<std::size_t> variables = c.p.variables();
      return std::none_of(variables.begin(), variables.end(), [&](std::size_t v) { return late[v]; });
    });
    late_.assign(begin, conditions_.end());
    conditions_.erase(begin, conditions_.end());
  }

  void catch_up() {
    for (const std::size_t v : order_) {
      if (values_[v]) replace(late_, v, *values_[v]);
    }
    conditions_.insert(conditions_.end(), late_.begin(), late_.end());
    late_.clear();
  }

  void substitute(std::size_t v, const Polynomial& value) {
    values_[v] = value;
    chosen_[v] = true;
    replace(conditions_, v, value);
  }

  bool assign(std::size_t v) {
    const auto value = choice_.choose(v, conditions_);
    if (value) substitute(v, Polynomial(ring_, *value));
    return value.has_value();
  }

  void replace(std::vector<Condition>& conditions, std::size_t v, const Polynomial& value) {
    for (Condition& c : conditions) {
      const std::size_t degree = c.p.degree(v);
      if (degree == 0) continue;
      Polynomial result = c.p.coefficient(v, degree);
      for (std::size_t k = degree; k-- > 0;) result = result * value + c.p.coefficient(v, k);
      c.p = std::move(result);
      ring_.budget().spend(c.p.length() + 20);
    }
  }

  /// With an equation that determines v from variables that come later.
  bool solve(std::size_t v) {
    for (const Condition& c : conditions_) {
      if (!c.is_equation() || c.p.degree(v) != 1) continue;
      const Polynomial pivot = c.p.coefficient(v, 1);
      if (!pivot.is_constant()) continue;
      substitute(v, c.p.coefficient(v, 0).scaled(-1 / pivot.constant()));
      return true;
    }
    return false;
  }

  bool solve_if_last(std::size_t v) {
    return std::any_of(conditions_.begin(), conditions_.end(),
                       [&](const Condition& c) {
                         return c.is_equation() && c.p.variables() == std::vector<std::size_t>{v} && c.p.degree(v) == 1;
                       }) &&
           solve(v);
  }

  /// The values of variables that were expressed by later ones.
  std::vector<Rational> numbers() {
    std::vector<Rational> result(ring_.size());
    for (std::size_t v = 0; v < ring_.size(); ++v) {
      if (values_[v]->is_constant()) result[v] = values_[v]->constant();
    }
    for (std::size_t i = ring_.size(); i-- > 0;) {
      const std::size_t v = order_[i];
      result[v] = value_at(*values_[v], result);
    }
    return result;
  }

  const Ring& ring_;
  std::mt19937_64& random_;
  bool late_choices_;
  ValueChoice choice_;
  std::vector<const Formula*> unchosen_;
  std::vector<Condition> conditions_;
  std::vector<Condition> late_;
  std::vector<std::optional<Polynomial>> values_;
  std::vector<bool> chosen_;
  std::vector<std::size_t> order_;
};

}  // namespace

bool holds_at(const Formula& formula, const std::vector<Rational>& values) {
  if (formula.kind == Formula::Kind::atom) {
    const Polynomial& p = formula.polynomial.front();
    return Condition{p, formula.sign}.holds_at(value_at(p, values));
  }
  const auto holds = [&](const Formula& part) { return holds_at(part, values); };
  return formula.kind == Formula::Kind::conjunction ? std::all_of(formula.parts.begin(), formula.parts.end(), holds)
                                                    : std::any_of(formula.parts.begin(), formula.parts.end(), holds);
}

std::optional<std::vector<Rational>> find_instance(const Ring& ring, const Formula& formula,
                                                   const InstanceSearch& search) {
  std::array<std::mt19937_64, 2> random{std::mt19937_64(1), std::mt19937_64(1)};
  const std::vector<Polynomial>& boundaries = search.boundaries;
  for (int i = 0; i < search.attempts; ++i) {
    const auto which = static_cast<std::size_t>(i) % (2 * boundaries.size() + 1);
    const Polynomial* boundary = which < boundaries.size() ? &boundaries[which] : nullptr;
    for (const bool late_choices : {false, true}) {
      ring.budget().spend(1);
      auto& engine = random[late_choices ? 1 : 0];
      auto found = Attempt(ring, formula, engine, boundary, late_choices, search.roots).run();
      if (found && (!search.accept || search.accept(*found))) return found;
    }
  }
  return std::nullopt;
}

}  // namespace slipproof::prove

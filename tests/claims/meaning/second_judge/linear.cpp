#include "claims/meaning/second_judge/linear.hpp"

#include <algorithm>
#include <numeric>

#include "claims/meaning/second_judge/world.hpp"

namespace slipproof::meaning {

namespace {

/// A number that may have unknowns in it.
struct Form {
  Polynomial value;
  bool varies = false;  ///< an unknown or the force occurs in it, with whatever coefficient
};

/// "As it stands": nothing if a number is undefined, or multiplies or divides what varies.
class AsItStands {
 public:
  explicit AsItStands(const World& world) : world_(world) {}

  std::optional<Form> of(const Tree& tree, bool in_definition = false) const {
    if (tree->op == Op::number) return Form{tree->number};
    if (tree->op == Op::symbol) return of_symbol(tree->symbol, in_definition);
    std::vector<Form> parts;
    for (const Tree& part : tree->parts) {
      const auto form = of(part, in_definition);
      if (!form) return std::nullopt;
      parts.push_back(*form);
    }
    return of_parts(tree, parts);
  }

 private:
  /// Unknowns hide symbols of the same name, but not in definitions, which know none.
  std::optional<Form> of_symbol(const std::string& symbol, bool in_definition) const {
    const bool unknown = !in_definition && world_.is_unknown(symbol);
    if (unknown || symbol == world_.setting().force) return Form{Polynomial::variable(symbol), true};
    const Names& names = world_.names();
    const auto value = names.values.find(symbol);
    return value != names.values.end() ? Form{value->second} : of(names.definitions.at(symbol), true);
  }

  std::optional<Form> of_parts(const Tree& tree, const std::vector<Form>& parts) const {
    const bool varies = std::any_of(parts.begin(), parts.end(), [](const Form& part) { return part.varies; });
    if (!varies) return of_numbers(tree, parts);
    const Polynomial& x = parts[0].value;
    switch (tree->op) {
      case Op::negate:
        return Form{Polynomial() - x, true};
      case Op::add:
        return Form{x + parts[1].value, true};
      case Op::subtract:
        return Form{x - parts[1].value, true};
      case Op::multiply:
        if (parts[0].varies && parts[1].varies) return std::nullopt;
        return Form{x * parts[1].value, true};
      case Op::divide:
        if (parts[1].varies || parts[1].value.is_zero()) return std::nullopt;
        return Form{x * Polynomial(1 / parts[1].value.constant()), true};
      case Op::power:
        if (tree->exponent == 0) return Form{Rational(1)};
        return tree->exponent == 1 ? std::optional(parts[0]) : std::nullopt;
      default:
        return std::nullopt;
    }
  }

  std::optional<Form> of_numbers(const Tree& tree, const std::vector<Form>& parts) const {
    std::vector<Tree> numbers;
    for (const Form& part : parts) numbers.push_back(number(part.value.constant()));
    const Number value =
        number_of(tree->op == Op::power ? power(numbers[0], tree->exponent) : make(tree->op, numbers), {});
    return value ? std::optional(Form{*value}) : std::nullopt;
  }

  const World& world_;
};

void subtract(Row& row, const Rational& times, const Row& other) {
  for (std::size_t i = 0; i < row.size(); ++i) row[i] -= times * other[i];
}

}  // namespace

Row added(Row row, const Rational& factor, const Row& other) {
  for (std::size_t i = 0; i < row.size(); ++i) row[i] += factor * other[i];
  return row;
}

std::optional<Row> linear(const Tree& equation, const World& world) {
  const AsItStands as_it_stands(world);
  const auto left = as_it_stands.of(equation->parts[0]), right = as_it_stands.of(equation->parts[1]);
  if (!left || !right) return std::nullopt;
  const Polynomial difference = left->value - right->value;
  Row row;
  for (const std::string& unknown : world.unknowns()) row.push_back(difference.slope(unknown));
  row.push_back(difference.slope(world.setting().force));
  row.push_back(difference.constant());
  return row;
}

std::vector<std::size_t> first_columns(std::size_t count) {
  std::vector<std::size_t> columns(count);
  std::iota(columns.begin(), columns.end(), std::size_t{0});
  return columns;
}

Echelon::Echelon(Rows rows, const std::vector<std::size_t>& order) {
  for (const std::size_t column : order) {
    const auto pivot = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row[column] != 0; });
    if (pivot == rows.end()) continue;
    Row row = *pivot;
    rows.erase(pivot);
    const Rational leading = row[column];
    for (Rational& coefficient : row) coefficient /= leading;
    for (Row& other : rows) subtract(other, Rational(other[column]), row);
    for (auto& [begin, other] : rows_) subtract(other, Rational(other[column]), row);
    rows_.emplace_back(column, std::move(row));
  }
  for (Row& row : rows) {
    if (std::any_of(row.begin(), row.end(), [](const Rational& c) { return c != 0; })) rest_.push_back(std::move(row));
  }
}

Row Echelon::reduced(Row row) const {
  for (const auto& [column, pivot] : rows_) subtract(row, Rational(row[column]), pivot);
  return row;
}

bool Echelon::implies(const Row& row) const {
  const Row rest = reduced(row);
  return !solvable() || std::all_of(rest.begin(), rest.end(), [](const Rational& c) { return c == 0; });
}

Row Echelon::solution(Row values, const std::vector<std::size_t>& free_to_change) const {
  values.back() = 1;
  for (const auto& [begin, row] : rows_) {
    if (std::find(free_to_change.begin(), free_to_change.end(), begin) == free_to_change.end()) continue;
    values[begin] = 0;
    Rational sum = 0;
    for (std::size_t i = 0; i < row.size(); ++i) sum += row[i] * values[i];
    values[begin] = -sum;
  }
  return values;
}

const Row* Echelon::begins_in(std::size_t column) const {
  for (const auto& [begin, row] : rows_) {
    if (begin == column) return &row;
  }
  return nullptr;
}

Rows Echelon::without(const std::set<std::size_t>& columns) const {
  Rows result;
  for (const auto& [begin, row] : rows_) {
    const auto absent = [&, &row = row](std::size_t column) { return row[column] == 0; };
    if (std::all_of(columns.begin(), columns.end(), absent)) result.push_back(row);
  }
  return result;
}

}  // namespace slipproof::meaning

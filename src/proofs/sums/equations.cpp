#include "proofs/sums/equations.hpp"

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"

namespace slipproof::prove::sums {

namespace {

using Exponents = std::vector<unsigned long>;

/// row += factor * other, without zeros.
void add_multiple(std::map<std::size_t, Rational>& row, const std::map<std::size_t, Rational>& other,
                  const Rational& factor) {
  for (const auto& [column, value] : other) {
    const auto [place, is_new] = row.try_emplace(column, 0);
    place->second += factor * value;
    if (place->second.is_zero()) row.erase(place);
  }
}

/// The multiple of 1/denominator that is nearest. Halves go up, those that are halves but for the solver's error, too:
/// such an error decides nothing.
Rational near(double x, const Integer& denominator) {
  constexpr double up = 0.501;
  return Rational(Integer(static_cast<std::int64_t>(std::floor(x * Rational(denominator).to_double() + up))),
                  denominator);
}

}  // namespace

Equations::Equations(Context& context, const Ansatz& ansatz) : ansatz_(ansatz) {
  number_columns();
  solve(context, equations(context));
}

void Equations::number_columns() {
  for (const Multiple& multiple : ansatz_.multiples) entries_from_ += multiple.monomials.size();
  for (std::size_t b = 0; b < ansatz_.blocks.size(); ++b) {
    for (std::size_t i = 0; i < ansatz_.blocks[b].basis.size(); ++i) {
      for (std::size_t j = i; j < ansatz_.blocks[b].basis.size(); ++j) places_.push_back({b, i, j});
    }
  }
  constant_ = entries_from_ + places_.size();
}

std::vector<Equations::Row> Equations::equations(Context& context) const {
  std::map<Exponents, Row> rows;
  Row strict = {{constant_, -1}};
  const auto add = [&](std::size_t column, const Polynomial& worth) {
    context.budget().spend(worth.length());
    for (const Term& term : worth.terms()) rows[term.exponents][column] = term.coefficient;
  };
  std::size_t column = 0;
  for (const Multiple& multiple : ansatz_.multiples) {
    for (const Polynomial& monomial : multiple.monomials) add(column++, multiple.p * monomial);
  }
  for (const auto& [b, i, j] : places_) {
    const Block& block = ansatz_.blocks[b];
    add(column, (block.basis[i] * block.basis[j] * block.multiplier).scaled(i == j ? 1 : 2));
    if (block.strict && i == j) strict[column] = 1;
    ++column;
  }
  std::vector<Row> result;
  for (auto& [monomial, row] : rows) result.push_back(std::move(row));
  result.push_back(std::move(strict));
  return result;
}

/// A coefficient of a multiple, or else the entry with the largest factor.
std::size_t Equations::pivot_of(const Row& row) const {
  if (row.begin()->first < entries_from_) return row.begin()->first;
  std::size_t best = row.begin()->first;
  for (const auto& [column, value] : row) {
    if (is_entry(column) && absolute(value) > absolute(row.at(best))) best = column;
  }
  return best;
}

void Equations::solve(Context& context, std::vector<Row> rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const Row& x, const Row& y) { return x.size() < y.size(); });
  for (const bool multiples : {true, false}) {
    for (Row& row : rows) {
      for (const Solved& solved : rows_) {
        const auto place = row.find(solved.column);
        if (place == row.end()) continue;
        context.budget().spend(solved.row.size());
        add_multiple(row, solved.row, -Rational(place->second));
      }
      if (row.empty() || (multiples && row.begin()->first >= entries_from_)) continue;
      const std::size_t pivot = pivot_of(row);
      contradictory_ = contradictory_ || pivot == constant_;
      if (contradictory_) return;
      const Rational factor = 1 / row.at(pivot);
      for (auto& [column, value] : row) value *= factor;
      for (Solved& solved : rows_) {
        const auto place = solved.row.find(pivot);
        if (place == solved.row.end()) continue;
        context.budget().spend(row.size());
        add_multiple(solved.row, row, -Rational(place->second));
      }
      rows_.push_back({pivot, std::move(row)});
      row.clear();
    }
    if (multiples) of_multiples_ = rows_.size();
  }
}

MatrixEquations Equations::in_binary64() const {
  MatrixEquations result;
  for (const Block& block : ansatz_.blocks) result.sizes.push_back(block.basis.size());
  for (std::size_t k = of_multiples_; k < rows_.size(); ++k) {
    MatrixEquation equation;
    for (const auto& [column, value] : rows_[k].row) {
      if (column == constant_) {
        equation.sum = -nearest_binary64(value);
        continue;
      }
      const MatrixPlace& place = places_[column - entries_from_];
      equation.terms.emplace_back(place, nearest_binary64(value) / (place.row == place.column ? 1 : 2));
    }
    result.equations.push_back(std::move(equation));
  }
  return result;
}

ExactBlocks Equations::rounded(const MatrixPoint& point, const Integer& denominator) const {
  std::vector<Rational> values(constant_ + 1);
  values[constant_] = 1;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const auto& [b, i, j] = places_[k];
    values[entries_from_ + k] = near(point.blocks[b][i * ansatz_.blocks[b].basis.size() + j], denominator);
  }
  for (std::size_t k = of_multiples_; k < rows_.size(); ++k) values[rows_[k].column] = 0;
  for (std::size_t k = of_multiples_; k < rows_.size(); ++k) {
    Rational rest = 0;
    for (const auto& [column, value] : rows_[k].row) {
      if (column != rows_[k].column) rest += value * values[column];
    }
    values[rows_[k].column] = -rest;
  }
  ExactBlocks blocks;
  for (const Block& block : ansatz_.blocks) blocks.emplace_back(block.basis.size() * block.basis.size());
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const auto& [b, i, j] = places_[k];
    const std::size_t size = ansatz_.blocks[b].basis.size();
    blocks[b][i * size + j] = blocks[b][j * size + i] = values[entries_from_ + k];
  }
  return blocks;
}

std::vector<Polynomial> Equations::multipliers(const ExactBlocks& entries) const {
  std::vector<Rational> coefficients(entries_from_);
  for (std::size_t k = 0; k < of_multiples_; ++k) {
    Rational rest = 0;
    for (const auto& [column, value] : rows_[k].row) {
      if (column == constant_) rest += value;
      if (!is_entry(column)) continue;
      const auto& [b, i, j] = places_[column - entries_from_];
      rest += value * entries[b][i * ansatz_.blocks[b].basis.size() + j];
    }
    coefficients[rows_[k].column] = -rest;
  }
  std::vector<Polynomial> result;
  std::size_t column = 0;
  for (const Multiple& multiple : ansatz_.multiples) {
    Polynomial sum(multiple.p.ring());
    for (const Polynomial& monomial : multiple.monomials) sum += monomial.scaled(coefficients[column++]);
    result.push_back(std::move(sum));
  }
  return result;
}

}  // namespace slipproof::prove::sums

#include "proofs/sums/squares_sum.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "proofs/sums/equations.hpp"
#include "proofs/sums/face.hpp"

namespace slipproof::prove::sums {

namespace {

constexpr std::size_t most_entries = 6000, most_equations = 1200;
constexpr int most_faces = 12;

std::size_t entries_of(const Ansatz& ansatz) {
  std::size_t entries = 0;
  for (const Block& block : ansatz.blocks) entries += block.basis.size() * (block.basis.size() + 1) / 2;
  return entries;
}

/// X = L^T D L with an upper triangular L with 1 on its diagonal: the squares of a block, or nothing where one of D
/// would be negative or X is not of full rank, 0 aside.
std::optional<std::vector<Square>> squares_of(const Block& block, std::vector<Rational> x) {
  const std::size_t size = block.basis.size();
  std::vector<Square> result;
  for (std::size_t k = 0; k < size; ++k) {
    const Rational pivot = x[k * size + k];
    if (pivot < 0) return std::nullopt;
    if (pivot.is_zero()) {
      for (std::size_t j = k + 1; j < size; ++j) {
        if (!x[k * size + j].is_zero()) return std::nullopt;
      }
      continue;
    }
    Polynomial root = block.basis[k];
    for (std::size_t j = k + 1; j < size; ++j) root += block.basis[j].scaled(x[k * size + j] / pivot);
    for (std::size_t i = k + 1; i < size; ++i) {
      const Rational factor = x[i * size + k] / pivot;
      for (std::size_t j = k + 1; j < size; ++j) x[i * size + j] -= factor * x[k * size + j];
    }
    // The root in integers without a common factor, and with it the coefficient.
    const Factorization content = root.as_irreducible();
    const Polynomial primitive = root.scaled(1 / content.constant);
    const Rational coefficient = pivot * content.constant * content.constant;
    result.push_back({coefficient * block.scale, block.product, block.strict, primitive,
                      (block.multiplier * primitive * primitive).scaled(coefficient)});
  }
  return result;
}

/// Times a common denominator of all squares: partial sums of them have integer coefficients.
void clear_denominators_of(SumOfSquares& sum) {
  Integer common = 1;
  for (const Square& square : sum.squares) {
    common = lcm(common, denominator(square.coefficient));
    for (const Term& term : square.worth.terms()) common = lcm(common, denominator(term.coefficient));
  }
  for (Square& square : sum.squares) {
    square.coefficient *= common;
    square.worth = square.worth.scaled(common);
  }
  for (auto& [name, multiplier] : sum.equations) multiplier = multiplier.scaled(common);
}

std::optional<SumOfSquares> exact_sum(const Ansatz& ansatz, const Equations& equations, const ExactBlocks& entries) {
  SumOfSquares result;
  for (std::size_t b = 0; b < ansatz.blocks.size(); ++b) {
    auto squares = squares_of(ansatz.blocks[b], entries[b]);
    if (!squares) return std::nullopt;
    std::move(squares->begin(), squares->end(), std::back_inserter(result.squares));
  }
  const std::vector<Polynomial> multipliers = equations.multipliers(entries);
  for (std::size_t k = 0; k < multipliers.size(); ++k) {
    if (!multipliers[k].is_zero()) result.equations.emplace_back(ansatz.multiples[k].name, multipliers[k]);
  }
  clear_denominators_of(result);
  return result;
}

/// With the smallest denominators that do.
std::optional<SumOfSquares> rounded_sum(Context& context, const Ansatz& ansatz, const Equations& equations,
                                        const MatrixPoint& point) {
  static constexpr std::array<int, 14> denominators = {1,  2,  3,   4,    6,     8,       12,
                                                       24, 60, 120, 1024, 32768, 1 << 20, 1 << 28};
  for (const int denominator : denominators) {
    context.budget().spend(equations.size() * ansatz.blocks.size());
    auto sum = exact_sum(ansatz, equations, equations.rounded(point, denominator));
    if (sum) return sum;
  }
  return std::nullopt;
}

/// In operations of binary64, of which a step of polynomial arithmetic is worth some hundred.
void spend(Context& context, const MatrixEquations& problem) {
  double work = 1e6;
  const auto equations = static_cast<double>(problem.equations.size());
  constexpr double iterations = 20, a_step = 200;
  double entries = 0;
  for (const std::size_t size : problem.sizes) {
    const auto n = static_cast<double>(size);
    work += iterations * n * n * (10 * n + equations);
    entries += n * n;
  }
  work += iterations * equations * equations * (equations / 3 + entries / 10);
  context.budget().spend(static_cast<std::size_t>(work / a_step));
}

/// Solves one ansatz after another, each restricted to a face that the one before showed: first to the one that fewest
/// of the small eigenvalues make.
class Faces {
 public:
  explicit Faces(Context& context) : context_(context) {}

  std::optional<SumOfSquares> search(const Ansatz& ansatz) {
    constexpr double hopeless = -1e-4;
    if (++solved_ > most_faces) return std::nullopt;
    const Equations equations(context_, ansatz);
    if (equations.contradictory()) return std::nullopt;
    const MatrixEquations problem = equations.in_binary64();
    if (problem.equations.size() > most_equations) return std::nullopt;
    spend(context_, problem);
    const auto point = widest_point(problem);
    if (!point || point->margin < hopeless) return std::nullopt;
    if (auto sum = rounded_sum(context_, ansatz, equations, *point)) return sum;
    std::size_t before = entries_of(ansatz);
    for (const double threshold : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
      const auto smaller = restricted_to_face(ansatz, *point, threshold);
      if (!smaller || entries_of(*smaller) == before) continue;
      before = entries_of(*smaller);
      if (auto sum = search(*smaller)) return sum;
    }
    return std::nullopt;
  }

 private:
  Context& context_;
  int solved_ = 0;
};

}  // namespace

std::optional<SumOfSquares> find_sum_of_squares(Context& context, const Ansatz& ansatz) {
  return entries_of(ansatz) > most_entries ? std::nullopt : Faces(context).search(ansatz);
}

}  // namespace slipproof::prove::sums

#include "contact/space/from_contacts.hpp"

#include "base/algebra/elimination.hpp"

namespace slipproof {

Range weighted(const std::vector<Rational>& weights, const std::vector<Range>& ranges, const Rational& constant) {
  Range sum{constant, constant};
  const auto add = [](std::optional<Rational>& to, const Rational& weight, const std::optional<Rational>& end) {
    if (to && end) *to += weight * *end;
    if (!end) to.reset();
  };
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i].is_zero()) continue;
    const bool up = weights[i].sign() > 0;
    add(sum.lower, weights[i], up ? ranges[i].lower : ranges[i].upper);
    add(sum.upper, weights[i], up ? ranges[i].upper : ranges[i].lower);
  }
  return sum;
}

/// Solves W^T c = A^T, restricted to these rows of W, for all rows of A at once.
std::vector<std::optional<Range>> from_contacts(const ExactContacts& contacts, const std::vector<std::size_t>& rows,
                                                const std::vector<Range>& u, const RationalMatrix& A,
                                                const std::vector<Rational>& a) {
  RationalMatrix equations(contacts.size());
  for (std::size_t i = 0; i < equations.size(); ++i) {
    for (const std::size_t row : rows) equations[i].push_back(contacts.W[row][i]);
    for (const auto& wanted : A) equations[i].push_back(wanted[i]);
  }
  const Echelon echelon = eliminate(equations);
  const std::size_t rank = echelon.rank(rows.size());
  std::vector<std::optional<Range>> result(A.size());
  for (std::size_t j = 0; j < A.size(); ++j) {
    const std::size_t column = rows.size() + j;
    bool follows = true;
    for (std::size_t i = rank; i < echelon.rank(); ++i) follows = follows && echelon.rows[i][column].is_zero();
    if (!follows) continue;
    std::vector<Rational> weights(u.size());
    Rational constant = a[j];
    for (std::size_t i = 0; i < rank; ++i) {
      const std::size_t row = rows[echelon.pivot_columns[i]];
      weights[row] = Rational(echelon.rows[i][column], echelon.pivot);
      constant -= weights[row] * contacts.q[row];
    }
    result[j] = weighted(weights, u, constant);
  }
  return result;
}

}  // namespace slipproof

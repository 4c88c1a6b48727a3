#include "claims/uniqueness/written_matrix.hpp"

#include <algorithm>

namespace slipproof {

namespace {

constexpr int most_products = 4'000;

WrittenNumber along_row(const WrittenMatrix& m, int& left) {
  if (m.empty()) return WrittenNumber(Rational(1));
  const auto entries = [](const auto& row) { return std::ranges::count_if(row, [](auto& x) { return !x.is_zero(); }); };
  const auto row = std::ranges::min_element(m, {}, entries);
  const auto index = static_cast<std::size_t>(row - m.begin());
  WrittenNumber sum(Rational(0));
  for (std::size_t j = 0; j < m.size() && left > 0; ++j) {
    if ((*row)[j].is_zero()) continue;
    --left;
    WrittenMatrix minor;
    for (std::size_t i = 0; i < m.size(); ++i) {
      if (i == index) continue;
      minor.push_back(m[i]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(j));
    }
    const WrittenNumber product = (*row)[j] * along_row(minor, left);
    sum = (index + j) % 2 == 0 ? sum + product : sum - product;
  }
  return sum;
}

}  // namespace

std::optional<WrittenNumber> determinant_of(const WrittenMatrix& matrix) {
  int left = most_products;
  WrittenNumber result = along_row(matrix, left);
  return left > 0 ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace slipproof

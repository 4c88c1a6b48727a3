// The real roots of several polynomials on one line, and a rational number between each two neighbours.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/algebra/integer_polynomial.hpp"

namespace slipproof {

/// A part of the line; no value: infinite.
struct LinePart {
  std::optional<Rational> lower, upper;
};

/// A real root: a rational number, or an irrational one strictly between two rational numbers.
struct RealRoot {
  Rational lower, upper;  ///< equal for a rational root
  /// The irreducible polynomial of an irrational root, which has no other root between `lower` and `upper`. Null for a
  /// rational root.
  std::shared_ptr<const IntegerPolynomial> polynomial = nullptr;

  bool is_rational() const { return lower == upper; }
};

/// Half of the interval of an irrational root; a rational one stays as it is.
void halve(RealRoot& root);
/// The binary64 nearest to a root, and for an irrational one an interval whose numbers all have it.
double nearest_binary64(RealRoot& root);
/// The polynomial as an expression: `3*mu^2 - 2*mu - 1`.
std::string text_of(const IntegerPolynomial& polynomial, const std::string& symbol);

/// The roots of all of `polynomials` inside of `part`, its ends left out, each once and ascending; what encloses two
/// neighbours is apart. Zero polynomials do not count. Every polynomial is factored over the integers once: roots are
/// rational where a factor is linear, and different factors have no root in common.
std::vector<RealRoot> real_roots(const std::set<IntegerPolynomial>& polynomials, const LinePart& part = {});

/// A number in every cell into which the roots cut the part of the line: between two neighbours, and beyond the first
/// and the last. Each is the simplest of its cell, or of a part of the cell if an end is irrational.
std::vector<Rational> cell_points(const std::vector<RealRoot>& roots, const LinePart& part = {});

/// A root or an end of the part of the line, or the open interval between two neighbours.
struct LineCell {
  std::optional<RealRoot> lower, upper;  ///< both the same for a single number; nothing: no end
  std::optional<Rational> sample;        ///< the number, or that of cell_points(); nothing for an irrational root

  bool is_point() const { return lower && upper && lower->lower == upper->lower && lower->upper == upper->upper; }
};

/// All of them in ascending order, from the lower end of the part to its upper end.
std::vector<LineCell> line_cells(const std::vector<RealRoot>& roots, const LinePart& part = {});

}  // namespace slipproof

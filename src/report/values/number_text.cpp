#include "report/values/number_text.hpp"

#include <fmt/format.h>

#include "base/number/format.hpp"
#include "report/values/quantity_units.hpp"

namespace slipproof {

namespace {

std::string end(const std::optional<Rational>& x, const char* infinite, int digits) {
  return x ? decimal_text(*x, digits) : infinite;
}

}  // namespace

std::string number_text(const Rational& x, int digits, const std::string& unit, std::size_t longest) {
  const std::string exact = exact_text(x);
  std::string decimal = decimal_text(x, digits);
  if (exact == decimal) return exact + unit_suffix(unit);
  decimal += unit_suffix(unit);
  if (exact.size() > longest) return fmt::format("{:<14} = a fraction of {} digits", decimal, exact.size());
  return fmt::format("{:<14} = {}", decimal, exact);
}

std::string interval_text(std::string_view symbol, const ForceInterval& i, int digits) {
  if (i.is_point()) return fmt::format("{} = {}", symbol, decimal_text(*i.lower(), digits));
  return fmt::format("{}{}, {}{}", i.lower_closed() ? '[' : '(', end(i.lower(), "-oo", digits),
                     end(i.upper(), "+oo", digits), i.upper_closed() ? ']' : ')');
}

std::string range_text(const Range& range, int digits, const std::string& unit) {
  if (!range.lower || !range.upper) return "unbounded";
  if (range.is_point()) return number_text(*range.lower, digits, unit);
  const std::string about = decimal_text(*range.lower, digits);
  if (about == decimal_text(*range.upper, digits)) return about + "..." + unit_suffix(unit);
  return "in [" + decimal_text(*range.lower, digits + 6) + ", " + decimal_text(*range.upper, digits + 6) + "]" +
         unit_suffix(unit);
}

std::string short_text(const Rational& x, int digits) {
  const std::string exact = exact_text(x);
  return exact.size() <= 8 ? exact : decimal_text(x, digits);
}

}  // namespace slipproof

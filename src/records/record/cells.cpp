#include "records/record/cells.hpp"

#include <fast_float/fast_float.h>

#include <cmath>
#include <system_error>
#include <utility>

#include "base/number/binary64.hpp"
#include "base/number/parse.hpp"

namespace slipproof {

std::string place_text(std::uint64_t line, std::size_t column) {
  if (line == 0) return {};
  return "line " + std::to_string(line) + (column == 0 ? "" : ", column " + std::to_string(column)) + ": ";
}

bool is_decimal(std::string_view text) {
  return text.find_first_of("/xXpP") == std::string_view::npos;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return text;
}

CellNumber read_number(std::string_view text, std::string_view name, std::size_t place, bool decimal_exact) {
  if (!decimal_exact || !is_decimal(text)) {
    double value = 0;
    const char* begin = text.data() + (text.size() > 1 && text.front() == '+' ? 1 : 0);
    const auto [end, error] = fast_float::from_chars(begin, text.data() + text.size(), value);
    if (error == std::errc() && end == text.data() + text.size() && (begin == text.data() || *begin != '-')) {
      return {value, std::nullopt};
    }
  }
  try {
    Rational exact = parse_rational(text);
    const double nearest = nearest_binary64(exact);
    if (is_decimal(text) && !decimal_exact) return {nearest, std::nullopt};
    return {nearest, std::move(exact)};
  } catch (const NumberError& error) {
    double value = 0;  // NaN and infinities are possible values of a solver, although they are not numbers
    const auto [end, code] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || std::isfinite(value)) {
      throw BrokenRecord{place == 0 ? 0 : place + error.position(), std::string(name) + ": " + error.what()};
    }
    return {value, std::nullopt};
  }
}

std::optional<NotFinite> not_finite(std::string_view name, double value, std::size_t place) {
  if (std::isfinite(value)) return std::nullopt;
  return NotFinite{place, std::string(name) + ": found " +
                              (std::isnan(value) ? "NaN" : "infinity or a number beyond the largest binary64") +
                              ", expected a finite number"};
}

}  // namespace slipproof

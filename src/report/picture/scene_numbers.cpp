#include "report/picture/scene_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/input/diagnostic.hpp"
#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "base/output/listed.hpp"

namespace slipproof {

std::string rounded_value(double x) {
  std::string text = fmt::format("{:.4g}", x);
  const bool exact = std::abs(std::stod(text) - x) <= 1e-12 * std::abs(x);
  if (text[0] == '-') text.replace(0, 1, "−");
  return (exact ? "= " : "≈ ") + text;
}

double drawn_size(const Rational& x) {
  constexpr double most = 1e300;
  return std::clamp(nearest_binary64(x), -most, most);
}

SceneNumbers::SceneNumbers(const MechanismScene& scene)
    : scene_(scene), maker_(scene.mechanism), at_(maker_.at(scene.values)) {
  const bool positive = maker_.load_domain(scene.values).contains(Rational(1));
  if (scene.mechanism.load)
    at_.set(maker_.compiled().load(), scene.load.value_or(positive ? Rational(1) : Rational(-1)));
}

Rational SceneNumbers::exact(const PlacedExpression& placed) {
  auto value = at_.number(maker_.compiled().compile(placed.expression));
  if (value.number) return std::move(*value.number);
  const Place place = placed.place();
  throw InputError({{scene_.mechanism.file, place.line, place.column,
                     "found " + in_quotes(placed.text.text()) + ", expected a coordinate that has a value there"}});
}

double SceneNumbers::number(const PlacedExpression& placed) {
  return drawn_size(exact(placed));
}
double SceneNumbers::number(const Expression& expression) {
  return drawn_size(exact(expression));
}

std::pair<std::string, std::string> SceneNumbers::text_of(const PlacedExpression& placed) {
  const Expression& e = placed.expression;
  const Expression named = e->operation == Operation::negate ? e->operands[0] : e;
  std::string text = to_string(named);
  const auto& load = scene_.mechanism.load;
  const bool compound = text.find_first_of("*+/( ") != text.npos;
  if (compound && load && scene_.load && abs(exact(e)) == abs(*scene_.load)) return text_of_load();
  return {text, value_of(named)};
}

std::pair<std::string, std::string> SceneNumbers::text_of_load() {
  const std::string& symbol = scene_.mechanism.load->symbol;
  return {symbol, value_of(make_symbol(symbol))};
}

std::string SceneNumbers::value_of(const Expression& named) {
  const bool known = scene_.load || !scene_.mechanism.load;
  if (!known || named->operation == Operation::number) return {};
  const Rational value = exact(named);
  const double size = nearest_binary64(value);
  return std::isfinite(size) ? rounded_value(size) : "≈ " + decimal_text(value, 4);
}

std::pair<std::string, std::string> SceneNumbers::name_of(const PlacedVector& force) {
  std::vector<const PlacedExpression*> written, pushing;
  for (const PlacedExpression* one : {&force.x, &force.y, &force.z}) {
    if (*one) written.push_back(one);
    if (*one && !is_literal_zero(one->expression)) pushing.push_back(one);
  }
  if (pushing.size() == 1) return text_of(*pushing.front());
  if (scene_.mechanism.load && scene_.load && written.size() == 3) {
    Rational square;
    for (const PlacedExpression* one : pushing) square += exact(*one) * exact(*one);
    if (square == *scene_.load * *scene_.load) return text_of_load();
  }
  const auto text = [](const PlacedExpression* one) { return to_string(one->expression); };
  return {"(" + listed(written, text) + ")", {}};
}

}  // namespace slipproof

#include "mechanics/scene/read_angle.hpp"

#include <array>
#include <utility>

#include "base/number/format.hpp"
#include "mechanics/points/degrees.hpp"

namespace slipproof {

namespace {

/// One angle in one of its forms.
class AngleReader {
 public:
  AngleReader(const TomlValue& value, std::string name, Mistakes& mistakes, std::vector<std::string>& notes)
      : value_(value), name_(std::move(name)), mistakes_(mistakes), notes_(notes) {}

  std::optional<MechanismValues::Circle> read() {
    if (value_.kind != TomlValue::Kind::table) {
      return refuse("found " + std::string(kind_name(value_.kind)) + ", " + expected);
    }
    static constexpr std::array<std::string_view, 5> keys{"cos", "sin", "tan_half", "tan", "degrees"};
    const TableReader table(value_, "the angle " + name_, keys, mistakes_);
    const auto forms = static_cast<int>(table.has("cos") || table.has("sin")) + table.has("tan_half") +
                       table.has("tan") + table.has("degrees");
    if (forms != 1)
      return refuse(std::string(forms == 0 ? "found no angle" : "found more than one angle") + ", " + expected);
    if (table.has("tan_half")) return from_tan_half(table);
    if (table.has("tan")) return from_tan(table);
    if (table.has("degrees")) return from_degrees(table);
    return from_point(table);
  }

 private:
  static constexpr const char* expected = "expected { cos, sin }, { tan_half }, { tan } or { degrees }";

  std::optional<MechanismValues::Circle> refuse(const std::string& message) {
    mistakes_.add(value_.place, name_ + ": " + message);
    return std::nullopt;
  }

  std::optional<MechanismValues::Circle> from_point(const TableReader& table) {
    table.require("cos", "the cosine");
    table.require("sin", "the sine");
    const auto cosine = table.number("cos"), sine = table.number("sin");
    if (!cosine || !sine) return std::nullopt;
    if (Rational(*cosine * *cosine + *sine * *sine) == 1) return MechanismValues::Circle{*cosine, *sine};
    return refuse("found cos^2 + sin^2 = " + decimal_text(*cosine * *cosine + *sine * *sine, 17) +
                  ", expected exactly 1");
  }

  std::optional<MechanismValues::Circle> from_tan_half(const TableReader& table) {
    const auto half = table.number("tan_half");
    return half ? std::optional(point_of_tan_half(*half)) : std::nullopt;
  }

  std::optional<MechanismValues::Circle> from_tan(const TableReader& table) {
    const auto tangent = table.number("tan");
    if (!tangent) return std::nullopt;
    const Integer p = numerator(*tangent), q = denominator(*tangent);
    const auto hypotenuse = exact_root(Integer(p * p + q * q));
    if (!hypotenuse) {
      return refuse("found the tangent " + in_quotes(exact_text(*tangent)) +
                    " of an angle with an irrational sine, expected one such as 3/4, or degrees, which are rounded");
    }
    return MechanismValues::Circle{Rational(q, *hypotenuse), Rational(p, *hypotenuse)};
  }

  std::optional<MechanismValues::Circle> from_degrees(const TableReader& table) {
    const auto degrees = table.number("degrees");
    if (!degrees) return std::nullopt;
    const AngleFromDegrees angle = angle_from_degrees(*degrees);
    if (!angle.difference.is_zero()) {
      notes_.push_back(name_ + " is the rational angle nearest to " + decimal_text(*degrees, 17) +
                       " degrees: it differs by " + decimal_text(angle.difference, 3) + " degrees");
    }
    return angle.point;
  }

  const TomlValue& value_;
  std::string name_;
  Mistakes& mistakes_;
  std::vector<std::string>& notes_;
};

}  // namespace

std::optional<MechanismValues::Circle> read_angle(const TomlValue& value, const std::string& name, Mistakes& mistakes,
                                                  std::vector<std::string>& notes) {
  return AngleReader(value, name, mistakes, notes).read();
}

}  // namespace slipproof

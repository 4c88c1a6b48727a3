#include "report/markup/number.hpp"

#include <fmt/format.h>

#include <cmath>

namespace slipproof {

std::string short_number(double value) {
  const double hundredths = std::round(value * 100);
  if (hundredths == 0) return "0";
  return fmt::format("{}", hundredths / 100);
}

}  // namespace slipproof

#include "report/picture/space/space_view.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "base/number/binary64.hpp"
#include "base/number/parse.hpp"

namespace slipproof {

namespace {

[[noreturn]] void refuse_view(std::string_view text, const std::string& why) {
  throw std::invalid_argument("found " + in_quotes(std::string(text)) + why +
                              ", expected a direction x,y,z to look from, such as 1,-2,1, or azimuth and elevation in "
                              "degrees, such as -60,20");
}

std::vector<double> view_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    std::string part(text.substr(from, comma - from));
    std::erase(part, ' ');
    try {
      numbers.push_back(nearest_binary64(parse_rational(part)));
    } catch (const NumberError&) {
      refuse_view(text, "");
    }
    from = comma + 1;
  }
  return numbers;
}

}  // namespace

Vec3 view_direction(std::string_view text) {
  const std::vector<double> numbers = view_numbers(text);
  if (numbers.size() == 3) {
    const Vec3 direction = direction_of({numbers[0], numbers[1], numbers[2]});
    if (!(length(direction) > 0)) refuse_view(text, ", which is no direction");
    return direction;
  }
  if (numbers.size() != 2) refuse_view(text, "");
  if (std::abs(numbers[1]) > 90) refuse_view(text, ", whose elevation is beyond 90 degrees");
  const double azimuth = numbers[0] * std::numbers::pi / 180, elevation = numbers[1] * std::numbers::pi / 180;
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

SpaceView::SpaceView(const Vec3& from, const Vec3& up) : towards_(direction_of(from)) {
  constexpr double along = 1e-6;
  Vec3 right = cross(up, towards_);
  if (length(right) < along) right = cross(Vec3{0, 1, 0}, towards_);
  if (length(right) < along) right = cross(Vec3{0, 0, 1}, towards_);
  right_ = direction_of(right);
  up_ = cross(towards_, right_);
}

}  // namespace slipproof

#include "mechanics/mechanism/units.hpp"

#ifdef SLIPPROOF_UDUNITS_AT_RUN_TIME
#include "base/os/udunits_at_run_time.hpp"
#else
#include <udunits2.h>
#endif

#include <array>
#include <cmath>
#include <mutex>

namespace slipproof {

namespace {

/// The library keeps its parser, its status and its system of units in global variables.
std::mutex& library() {
  static std::mutex mutex;
  return mutex;
}

/// Null if the library's table of units is not installed. Under the lock.
ut_system* unit_system() {
  static ut_system* const system = []() -> ut_system* {
#ifdef SLIPPROOF_UDUNITS_AT_RUN_TIME
    if (!udunits_is_there()) return nullptr;
#endif
    ut_set_error_message_handler(ut_ignore);
    return ut_read_xml(nullptr);
  }();
  return system;
}

void free_unit(void* unit) {
  const std::scoped_lock lock(library());
  ut_free(static_cast<ut_unit*>(unit));
}

const ut_unit* of(const std::shared_ptr<void>& unit) {
  return static_cast<const ut_unit*>(unit.get());
}

ut_unit* one() {
  ut_system* const system = unit_system();
  return system == nullptr ? nullptr : ut_get_dimensionless_unit_one(system);
}

}  // namespace

bool has_units() {
  const std::scoped_lock lock(library());
  return unit_system() != nullptr;
}

Unit::Unit() {
  const std::scoped_lock lock(library());
  if (ut_unit* const unit = one()) unit_ = std::shared_ptr<void>(unit, free_unit);
}

Unit::Unit(void* unit) {
  if (unit != nullptr) unit_ = std::shared_ptr<void>(unit, free_unit);
}

Unit Unit::operator*(const Unit& other) const {
  if (!known() || !other.known()) return Unit(nullptr);
  const std::scoped_lock lock(library());
  return Unit(ut_multiply(of(unit_), of(other.unit_)));
}

Unit Unit::operator/(const Unit& other) const {
  if (!known() || !other.known()) return Unit(nullptr);
  const std::scoped_lock lock(library());
  return Unit(ut_divide(of(unit_), of(other.unit_)));
}

std::optional<Unit> Unit::power(int exponent) const {
  constexpr int largest = 255;
  if (!known() || std::abs(exponent) > largest) return std::nullopt;
  const std::scoped_lock lock(library());
  ut_unit* const raised = ut_raise(of(unit_), exponent);
  return raised == nullptr ? std::nullopt : std::optional(Unit(raised));
}

bool Unit::same_dimension(const Unit& other) const {
  if (!unit_ || !other.unit_) return false;
  const Unit ratio = *this / other;
  const std::scoped_lock lock(library());
  return ratio.unit_ && ut_is_dimensionless(of(ratio.unit_)) != 0;
}

bool Unit::operator==(const Unit& other) const {
  if (!same_dimension(other)) return false;
  const std::scoped_lock lock(library());
  cv_converter* const converter =
      ut_get_converter(static_cast<ut_unit*>(unit_.get()), static_cast<ut_unit*>(other.unit_.get()));
  if (converter == nullptr) return false;
  const double size = cv_convert_double(converter, 1);
  cv_free(converter);
  constexpr double rounding = 1e-9;  // the library computes factors in binary64
  return std::abs(size - 1) < rounding;
}

std::string Unit::text() const {
  if (!unit_) return "no unit";
  const std::scoped_lock lock(library());
  std::array<char, 256> buffer{};
  const int length = ut_format(of(unit_), buffer.data(), buffer.size() - 1, UT_ASCII | UT_DEFINITION);
  return length < 0 ? "a unit" : std::string(buffer.data());
}

std::optional<Unit> parse_unit(std::string_view text) {
  constexpr std::size_t longest = 100;
  if (text.size() > longest || text.find('\0') != std::string_view::npos) return std::nullopt;
  const std::string whole(text);
  std::unique_lock lock(library());
  ut_system* const system = unit_system();
  if (system == nullptr) return std::nullopt;
  ut_unit* const unit = ut_parse(system, whole.c_str(), UT_UTF8);
  if (unit == nullptr) return std::nullopt;
  lock.unlock();
  return Unit(static_cast<void*>(unit));
}

}  // namespace slipproof

// A column: one number for each of many points.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace slipproof {

/// An array, which must outlive the column, or one number for all points.
class Column {
 public:
  Column() = default;  ///< nothing given
  Column(double of_all) : of_all_(of_all), size_(1) {}
  Column(std::span<const double> values)
      : of_all_(values.size() == 1 ? values[0] : 0), values_(values.data()), size_(values.size()) {}
  Column(const std::vector<double>& values) : Column(std::span<const double>(values)) {}
  Column(std::vector<double>&&) = delete;

  /// The same column, whose numbers count as the nearest binary64 of what is meant, or as exact.
  Column rounded(bool is_rounded = true) const {
    Column result = *this;
    result.exact_ = !is_rounded;
    return result;
  }

  /// The part of the column for some points.
  Column part(std::size_t begin, std::size_t size) const {
    if (size_ <= 1) return *this;
    Column result(std::span<const double>(values_ + begin, size));
    result.exact_ = exact_;
    return result;
  }

  /// Whether it is an array, be it of one number.
  bool varies() const { return values_ != nullptr; }
  /// 1: the same for all.
  std::size_t size() const { return size_; }
  bool exact() const { return exact_; }
  /// The values, if there is one for each point.
  const double* data() const { return values_; }
  double operator[](std::size_t point) const { return size_ == 1 ? of_all_ : values_[point]; }

 private:
  double of_all_ = 0;
  const double* values_ = nullptr;
  std::size_t size_ = 0;
  bool exact_ = true;
};

}  // namespace slipproof

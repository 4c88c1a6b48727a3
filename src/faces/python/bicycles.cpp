#include <pybind11/numpy.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "faces/python/bind.hpp"
#include "faces/python/interruptible.hpp"
#include "floating/batch/bicycle_batch.hpp"
#include "records/record/bicycle_records.hpp"

namespace slipproof::python {

namespace {

namespace py = pybind11;

/// How many bicycles are decided between two checks for signals: as many as take 20 ms. A bicycle decided by binary64
/// takes a hundredth of the time of an exact one.
class Piece {
 public:
  static constexpr std::size_t largest = 1U << 18U;
  std::size_t size() const { return size_; }
  void took(std::chrono::duration<double> time) {
    const double wanted = static_cast<double>(size_) * 0.02 / std::max(time.count(), 1e-9);
    size_ = static_cast<std::size_t>(std::clamp(wanted, 256.0, double{largest}));
  }

 private:
  std::size_t size_ = 2048;
};

BicycleColumns columns_of(const py::dict& given, bool external) {
  BicycleColumns columns;
  columns.external = external;
  for (const auto& [key, value] : given) {
    const auto symbol = key.cast<std::string>();
    const auto array = py::reinterpret_borrow<py::array_t<double>>(value);
    const auto place = std::ranges::find(BicycleColumns::symbols, symbol) - BicycleColumns::symbols.begin();
    Column& column = symbol == "F" ? columns.F : columns.numbers.at(static_cast<std::size_t>(place));
    column = Column(std::span<const double>(array.data(), static_cast<std::size_t>(array.size())));
  }
  return columns;
}

BicycleColumns part(BicycleColumns columns, std::size_t begin, std::size_t size) {
  for (Column& column : columns.numbers) column = column.part(begin, size);
  columns.F = columns.F.part(begin, size);
  return columns;
}

/// `arrays`: contiguous float64 arrays whose length is `size` or 1.
py::tuple modes_of_columns(const py::dict& arrays, bool external, std::size_t size, unsigned threads) {
  const BicycleColumns columns = columns_of(arrays, external);
  const auto count = static_cast<py::ssize_t>(size);
  py::array_t<std::uint16_t> consistent(count), strict(count);
  py::array_t<std::uint8_t> tier(count);
  std::uint16_t* const to_consistent = consistent.mutable_data();
  std::uint16_t* const to_strict = strict.mutable_data();
  std::uint8_t* const to_tier = tier.mutable_data();
  TierCounts counts{};
  const std::uint64_t since = interrupts();
  Piece piece;
  for (std::size_t begin = 0, some = 0; begin < size; begin += some) {
    if (begin > 0) check_signals(since);
    some = std::min(piece.size(), size - begin);
    const WithoutInterpreter released;
    const auto start = std::chrono::steady_clock::now();
    const BicycleModes found = consistent_modes(part(columns, begin, some), threads, begin);
    std::ranges::copy(found.consistent, to_consistent + begin);
    std::ranges::copy(found.strict, to_strict + begin);
    std::ranges::transform(found.tiers, to_tier + begin, [](Tier x) { return static_cast<std::uint8_t>(x); });
    for (std::size_t i = 0; i < tier_count; ++i) counts[i] += found.counts()[i];
    piece.took(std::chrono::steady_clock::now() - start);
  }
  py::dict tiers;
  for (std::size_t i = 0; i < tier_count; ++i) tiers[py::str(std::string(name(static_cast<Tier>(i))))] = counts[i];
  return py::make_tuple(std::move(consistent), std::move(strict), std::move(tier), std::move(tiers));
}

}  // namespace

void bind_bicycles(py::module_& module) {
  module.def("consistent_modes", &modes_of_columns);
  py::list names;
  const RecordFields fields(bicycle_records());
  for (std::size_t i = 0; i < fields.modes().size(); ++i) names.append(fields.mode_name(i));
  module.attr("mode_names") = py::tuple(names);
}

}  // namespace slipproof::python

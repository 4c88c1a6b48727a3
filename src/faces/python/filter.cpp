#include "floating/filter/filter.hpp"

#include <fmt/format.h>
#include <pybind11/numpy.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "faces/python/bind.hpp"
#include "faces/python/interruptible.hpp"
#include "floating/filter/batch.hpp"
#include "mechanics/bicycle/domain.hpp"

namespace slipproof::python {

namespace {

namespace py = pybind11;

/// The 15 numbers of a scene, in the order in which they come: arrays of float64 side by side, of one length or 1.
using Columns = std::vector<py::array_t<double>>;

/// How many scenes are decided between two looks at the signals: as many as take 20 ms. Those of the filter's tier take
/// a hundredth of what exact ones do.
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

/// Part of a column, or the number that is the same for all.
Column part(const py::array_t<double>& column, std::size_t begin, std::size_t size) {
  if (column.size() == 1) return Column(*column.data());
  return Column(std::span<const double>(column.data() + begin, size));
}

ForcedScene<Column> scenes(const Columns& c, ForceKind kind, std::size_t begin, std::size_t size) {
  const auto at = [&](std::size_t i) { return part(c[i], begin, size); };
  ForcedScene<Column> result{.bicycle = {.M = at(0),
                                         .R = at(1),
                                         .h = at(2),
                                         .b2 = at(3),
                                         .b3 = at(4),
                                         .I1 = at(5),
                                         .I2 = at(6),
                                         .I3 = at(7),
                                         .r1 = at(8),
                                         .r2 = at(9),
                                         .L = at(10),
                                         .J = std::nullopt},
                             .road = {.f = at(11), .g = at(12)},
                             .force_kind = kind,
                             .F = at(13)};
  if (c.size() > 14) result.bicycle.J = at(14);
  return result;
}

ForcedScene<double> scene_at(const ForcedScene<Column>& scenes, std::size_t i) {
  ForcedScene<double> scene = convert<Column, double>(scenes, [i](const Column& column) { return column[i]; });
  scene.force_kind = scenes.force_kind;
  return scene;
}

/// The first number out of its domain, and the domain.
std::string complaint(const ForcedScene<double>& s) {
  const Bicycle<double>& p = s.bicycle;
  const auto told = [](const char* name, double found, const char* expected) {
    return fmt::format("{}: found {}, expected {}", name, found, expected);
  };
  for (const auto& [name, value] : {std::pair("M", p.M), {"R", p.R}, {"r1", p.r1}, {"r2", p.r2}, {"g", s.road.g}}) {
    if (!(value > 0)) return told(name, value, "a number > 0");
  }
  for (const auto& [name, value] : {std::pair("I1", p.I1), {"I2", p.I2}, {"I3", p.I3}, {"f", s.road.f}}) {
    if (!(value >= 0)) return told(name, value, "a number >= 0");
  }
  if (p.J && !(*p.J > 0)) return told("J", *p.J, "a number > 0");
  if (!(p.h > -p.R)) return told("h", p.h, "h > -R");
  return told("b2 + b3", p.b2 + p.b3, "b2 + b3 > 0");
}

void refuse_out_of_domain(const ForcedScene<Column>& some, std::size_t begin, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    const ForcedScene<double> scene = scene_at(some, i);
    if (in_domain(scene.bicycle, scene.road)) continue;
    throw std::invalid_argument(fmt::format("scene {}: {}", begin + i, complaint(scene)));
  }
}

/// The answers of some scenes, and where they are written to, side by side.
struct Answers {
  std::uint16_t* consistent;
  std::uint16_t* strict;
  std::uint8_t* tier;
  TierCounts counts{};
  std::vector<ConsistentModes> buffer;

  void add(const ForcedScene<Column>& some, std::size_t begin, std::size_t size, unsigned threads) {
    const std::span<ConsistentModes> found(buffer.data(), size);
    refuse_out_of_domain(some, begin, size);
    consistent_modes(some, found, counts, threads);
    for (std::size_t i = 0; i < size; ++i) {
      consistent[begin + i] = found[i].consistent;
      strict[begin + i] = found[i].strict;
      tier[begin + i] = static_cast<std::uint8_t>(found[i].tier);
    }
  }
};

py::tuple modes_of_columns(const Columns& columns, bool external, std::size_t size, unsigned threads) {
  const ForceKind kind = external ? ForceKind::external : ForceKind::internal;
  const auto count = static_cast<py::ssize_t>(size);
  py::array_t<std::uint16_t> consistent(count), strict(count);
  py::array_t<std::uint8_t> tier(count);
  Answers answers{consistent.mutable_data(), strict.mutable_data(), tier.mutable_data(), {}, {}};
  answers.buffer.resize(std::min(size, Piece::largest));
  const std::uint64_t since = interrupts();
  Piece piece;
  for (std::size_t begin = 0, some = 0; begin < size; begin += some) {
    if (begin > 0) check_signals(since);
    some = std::min(piece.size(), size - begin);
    const ForcedScene<Column> part = scenes(columns, kind, begin, some);
    const WithoutInterpreter released;
    const auto start = std::chrono::steady_clock::now();
    answers.add(part, begin, some, threads);
    piece.took(std::chrono::steady_clock::now() - start);
  }
  py::dict tiers;
  for (std::size_t i = 0; i < tier_count; ++i) {
    tiers[py::str(std::string(name(static_cast<Tier>(i))))] = answers.counts[i];
  }
  return py::make_tuple(std::move(consistent), std::move(strict), std::move(tier), std::move(tiers));
}

}  // namespace

void bind_filter(py::module_& module) {
  module.def("consistent_modes", [](const py::list& list, bool external, std::size_t size, unsigned threads) {
    Columns columns;
    for (const auto& column : list) columns.push_back(py::reinterpret_borrow<py::array_t<double>>(column));
    return modes_of_columns(columns, external, size, threads);
  });
  py::list names;
  for (const ContactMode mode : all_modes()) names.append(name(mode));
  module.attr("mode_names") = py::tuple(names);
}

}  // namespace slipproof::python

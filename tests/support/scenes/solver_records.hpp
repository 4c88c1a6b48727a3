// Correct solver outputs to certify: the exact motion of a scene that has just one, every number the nearest binary64.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "records/certify/certify.hpp"
#include "support/bicycle/motions.hpp"
#include "support/scenes/bicycle_populations.hpp"

namespace slipproof::test {

/// The columns of the lines below.
inline const std::vector<std::string> record_columns{"M",   "R",   "h",    "b2",   "b3", "I1", "I2",   "I3",   "r1",
                                                     "r2",  "L",   "f",    "g",    "F",  "J",  "kind", "mode", "a",
                                                     "a_y", "phi", "eps2", "eps3", "S2", "S3", "N2",   "N3"};
inline constexpr std::size_t kind_cell = 15, mode_cell = 16, answer_cell = 17;

using Cells = std::vector<std::string>;

inline std::string joined(const Cells& cells) {
  std::string line;
  for (const auto& cell : cells) line += (&cell == &cells.front() ? "" : ",") + cell;
  return line + '\n';
}

inline std::string header() {
  return joined(record_columns);
}

class SolverRecords {
 public:
  /// Of bicycles as they are built, or, every second one, of anything that a scene may be.
  explicit SolverRecords(std::uint64_t seed, bool wide = true) : random_(seed), wide_(wide) {}

  /// The next record; scenes with several motions or none are passed over.
  Cells next() {
    while (true) {
      if (left_ == 0) {
        scene_ = to_rational(
            nearest_binary64(random_.scene(wide_ && !random_.coin() ? Population::wide : Population::bicycles)));
        table_.emplace(scene_.bicycle, scene_.road, scene_.force_kind);
        left_ = 8;
      }
      --left_;
      const double F = random_.signed_log(1, 3000);
      const Rational force = to_rational(F);
      const ModeSolution* only = nullptr;
      int consistent = 0;
      for (const ModeSolution& s : table_->solutions()) {
        if (!s.closed().contains(force)) continue;
        ++consistent;
        only = &s;
      }
      if (consistent != 1 || only->kind() != ModeSolution::Kind::regular) continue;
      return cells(F, *only);
    }
  }

  RandomBicycles& random() { return random_; }

 private:
  Cells cells(double F, const ModeSolution& mode) const {
    Cells result;
    auto s = nearest_binary64(scene_);
    s.F = F;
    convert<double, double>(s, [&](double x) {
      result.push_back(fmt::format("{}", x));
      return x;
    });
    if (!s.bicycle.J) result.emplace_back();
    result.emplace_back(s.force_kind == ForceKind::internal ? "internal" : "external");
    result.push_back(name(mode.mode()));
    for (const Quantity q : {Quantity::a, Quantity::a_y, Quantity::phi, Quantity::eps2, Quantity::eps3, Quantity::S2,
                             Quantity::S3, Quantity::N2, Quantity::N3}) {
      result.push_back(fmt::format("{}", nearest_binary64(mode.quantity(q).at(to_rational(F)))));
    }
    return result;
  }

  RandomBicycles random_;
  ForcedScene<Rational> scene_;
  std::optional<ModeTable> table_;
  int left_ = 0;
  bool wide_;
};

}  // namespace slipproof::test

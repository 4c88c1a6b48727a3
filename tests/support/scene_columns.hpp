// Scenes gathered into columns, as the batch of the filter takes them.
#pragma once

#include <array>
#include <vector>

#include "floating/filter/batch.hpp"

namespace slipproof::test {

/// Scenes that are all with J or all without, and of one kind of force.
class SceneColumns {
 public:
  void add(const ForcedScene<double>& s) {
    std::size_t i = 0;
    convert<double, double>(s, [&](double x) {
      columns_[i++].push_back(x);
      return x;
    });
    detachment_ = s.bicycle.J.has_value();
    kind_ = s.force_kind;
  }
  std::size_t size() const { return columns_[0].size(); }

  /// Valid until the next add().
  ForcedScene<Column> scenes() const {
    ForcedScene<double> order;  // convert() visits J last
    if (detachment_) order.bicycle.J = 0;
    order.force_kind = kind_;
    std::size_t i = 0;
    return convert<double, Column>(order, [&](double) { return Column(columns_[i++]); });
  }

 private:
  std::array<std::vector<double>, 15> columns_;
  bool detachment_ = false;
  ForceKind kind_ = ForceKind::internal;
};

}  // namespace slipproof::test

// All motions of bodies on contacts in space, by the tree of patterns; and by interval bisection, as a yardstick:
// branch and prune over the forces and slips of each mode, with Krawczyk's operator. Its intervals are not rounded
// outwards, and forces up to 16 and slips up to 64 are looked at: it proves nothing, and is faster than one that would.
#include "contact/complete/complete.hpp"

#include <benchmark/benchmark.h>

#include <Eigen/Dense>
#include <cmath>

#include "contact/complete/random_contacts.hpp"

namespace {

using namespace slipproof;

struct Interval {
  double low = 0, high = 0;

  double width() const { return high - low; }
  double middle() const { return (low + high) / 2; }
  double nearest_to_0() const { return low > 0 ? low : high < 0 ? -high : 0; }
  bool has_0() const { return low <= 1e-12 && high >= -1e-12; }
};

Interval point(double x) {
  return {x, x};
}
Interval operator+(Interval x, Interval y) {
  return {x.low + y.low, x.high + y.high};
}
Interval operator-(Interval x, Interval y) {
  return {x.low - y.high, x.high - y.low};
}
Interval operator*(Interval x, Interval y) {
  const double a = x.low * y.low, b = x.low * y.high, c = x.high * y.low, d = x.high * y.high;
  return {std::min(std::min(a, b), std::min(c, d)), std::max(std::max(a, b), std::max(c, d))};
}
Interval square(Interval x) {
  const double least = x.nearest_to_0();
  return {least * least, std::max(x.low * x.low, x.high * x.high)};
}

using Box = std::vector<Interval>;
enum class Mode { open, stick, slip };

/// The equations of a mode: unknowns are r of each contact that is closed, and s with u_T = -s r_T of each that slips.
class ModeBoxes {
 public:
  ModeBoxes(const FloatingContacts& contacts, std::vector<Mode> modes) : contacts_(contacts), modes_(std::move(modes)) {
    for (const Mode mode : modes_) {
      first_.push_back(whole_.size());
      if (mode == Mode::open) continue;
      const double friction = 16 * contacts.mu[first_.size() - 1];
      whole_.insert(whole_.end(), {{0, 16}, {-friction, friction}, {-friction, friction}});
      if (mode == Mode::slip) whole_.push_back({0, 64});
    }
  }

  /// How many boxes a search looks at.
  std::size_t search() {
    std::vector<Box> waiting{whole_};
    std::size_t boxes = 0;
    while (!waiting.empty()) {
      Box box = std::move(waiting.back());
      waiting.pop_back();
      ++boxes;
      if (!is_possible(box) || whole_.empty()) continue;
      const double before = total(box);
      if (!contract(box)) continue;
      if (total(box) < 0.7 * before) {
        waiting.push_back(std::move(box));
        continue;
      }
      const std::size_t widest = widest_of(box);
      if (box[widest].width() < 1e-7 * whole_[widest].width()) continue;
      Box other = box;
      other[widest].low = box[widest].high = box[widest].middle();
      waiting.push_back(std::move(other));
      waiting.push_back(std::move(box));
    }
    return boxes;
  }

 private:
  Box velocities(const Box& z) const {
    Box u;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      u.push_back(point(contacts_.q[i]));
      for (std::size_t k = 0; k < modes_.size(); ++k) {
        for (std::size_t t = 0; t < 3 && modes_[k] != Mode::open; ++t) {
          u[i] = u[i] + point(contacts_.W[i][3 * k + t]) * z[first_[k] + t];
        }
      }
    }
    return u;
  }

  bool is_possible(const Box& z) const {
    const Box u = velocities(z);
    for (std::size_t k = 0; k < modes_.size(); ++k) {
      if (modes_[k] == Mode::open && u[3 * k].high < 0) return false;
      if (modes_[k] != Mode::stick) continue;
      const Interval* r = &z[first_[k]];
      if (std::hypot(r[1].nearest_to_0(), r[2].nearest_to_0()) > contacts_.mu[k] * r[0].high + 1e-12) return false;
    }
    return true;
  }

  struct System {
    Box values;
    std::vector<Box> slopes;
  };

  System system_at(const Box& z) const {
    System result;
    const Box u = velocities(z);
    const auto add = [&](Interval value) -> Box& {
      result.values.push_back(value);
      return result.slopes.emplace_back(z.size());
    };
    const auto add_velocity = [&](std::size_t i, Interval more) -> Box& {
      Box& slope = add(u[i] + more);
      for (std::size_t k = 0; k < modes_.size(); ++k) {
        for (std::size_t t = 0; t < 3 && modes_[k] != Mode::open; ++t) {
          slope[first_[k] + t] = point(contacts_.W[i][3 * k + t]);
        }
      }
      return slope;
    };
    for (std::size_t k = 0; k < modes_.size(); ++k) {
      const std::size_t f = first_[k];
      if (modes_[k] == Mode::open) continue;
      add_velocity(3 * k, {});
      for (std::size_t t = 1; t < 3; ++t) {
        const bool slips = modes_[k] == Mode::slip;
        Box& slope = add_velocity(3 * k + t, slips ? z[f + 3] * z[f + t] : Interval{});
        if (!slips) continue;
        slope[f + t] = slope[f + t] + z[f + 3];
        slope[f + 3] = slope[f + 3] + z[f + t];
      }
      if (modes_[k] != Mode::slip) continue;
      const Interval mu = point(contacts_.mu[k] * contacts_.mu[k]);
      Box& slope = add(square(z[f + 1]) + square(z[f + 2]) - mu * square(z[f]));
      for (std::size_t t = 1; t < 3; ++t) slope[f + t] = point(2) * z[f + t];
      slope[f] = point(-2) * mu * z[f];
    }
    return result;
  }

  /// By Krawczyk's operator; false if the box has no zero, or is proved to have one.
  bool contract(Box& z) const {
    const System system = system_at(z);
    for (const Interval& value : system.values) {
      if (!value.has_0()) return false;
    }
    const auto n = static_cast<Eigen::Index>(z.size());
    Eigen::MatrixXd middle(n, n);
    Box center;
    for (const Interval& x : z) center.push_back(point(x.middle()));
    for (Eigen::Index i = 0; i < n * n; ++i) {
      middle(i / n, i % n) = system.slopes[static_cast<std::size_t>(i / n)][static_cast<std::size_t>(i % n)].middle();
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(middle);
    if (!lu.isInvertible() || lu.rcond() < 1e-9) return true;
    const Eigen::MatrixXd inverse = lu.inverse();
    const System at_center = system_at(center);
    bool inside = true;
    for (std::size_t i = 0; i < z.size(); ++i) {
      Interval x = center[i];
      for (std::size_t j = 0; j < z.size(); ++j) {
        Interval rest = point(i == j ? 1 : 0);
        for (std::size_t k = 0; k < z.size(); ++k) rest = rest - entry(inverse, i, k) * system.slopes[k][j];
        x = x - entry(inverse, i, j) * at_center.values[j] + rest * (z[j] - center[j]);
      }
      inside = inside && x.low >= z[i].low && x.high <= z[i].high;
      z[i] = {std::max(x.low, z[i].low), std::min(x.high, z[i].high)};
      if (z[i].low > z[i].high) return false;
    }
    return !inside;
  }

  static Interval entry(const Eigen::MatrixXd& matrix, std::size_t i, std::size_t j) {
    return point(matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  }

  static double total(const Box& box) {
    double sum = 0;
    for (const Interval& x : box) sum += x.width();
    return sum;
  }

  std::size_t widest_of(const Box& box) const {
    std::size_t widest = 0;
    for (std::size_t j = 1; j < box.size(); ++j) {
      if (box[j].width() / whole_[j].width() > box[widest].width() / whole_[widest].width()) widest = j;
    }
    return widest;
  }

  const FloatingContacts& contacts_;
  const std::vector<Mode> modes_;
  std::vector<std::size_t> first_;
  Box whole_;
};

constexpr int bodies = 4;

std::vector<ExactContacts> some_bodies(const benchmark::State& state) {
  RandomContacts random(1);
  std::vector<ExactContacts> result;
  for (int i = 0; i < bodies; ++i) result.push_back(random.body(static_cast<std::size_t>(state.range(0))));
  return result;
}

void all_motions(benchmark::State& state) {
  std::size_t nodes = 0;
  for (auto _ : state) {
    for (const ExactContacts& body : some_bodies(state)) nodes += all_solutions(body).nodes.size();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(nodes));
}

void all_motions_by_bisection(benchmark::State& state) {
  std::size_t boxes = 0;
  for (auto _ : state) {
    for (const ExactContacts& body : some_bodies(state)) {
      const ScaledContacts scaled(body);
      const FloatingContacts contacts(scaled.contacts);
      std::vector<Mode> modes(body.contacts());
      for (std::size_t code = 0, all = static_cast<std::size_t>(std::pow(3, modes.size())); code < all; ++code) {
        std::size_t rest = code;
        for (Mode& mode : modes) mode = static_cast<Mode>(rest % 3), rest /= 3;
        boxes += ModeBoxes(contacts, modes).search();
      }
    }
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(boxes));
}

BENCHMARK(all_motions)->DenseRange(1, 4)->Unit(benchmark::kMillisecond);
BENCHMARK(all_motions_by_bisection)->DenseRange(1, 2)->Unit(benchmark::kMillisecond);

}  // namespace

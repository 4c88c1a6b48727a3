#include "mechanics/rest_on_slope/body.hpp"

#include <fmt/format.h>

#include <cmath>

namespace slipproof::test::rest_on_slope {

bool State::at_rest() const {
  return at[1] == 0 && at[2] == 0 && velocity == Triple{};
}

std::string text(const State& state) {
  const auto [x, v1, v2] = state.velocity;
  return fmt::format("z1 = {}, z2 = {}, x' = {}, z1' = {}, z2' = {}", state.at[1], state.at[2], x, v1, v2);
}

std::string text(const Body& body) {
  return fmt::format("u = {}, h = {}, J = {}, mu = {}, t = {}", body.u, body.h, body.J, body.mu, body.t);
}

std::array<Triple, 3> Body::delassus() const {
  const double x1 = -h * b1() / J, x2 = h * b2() / J, both = 1 - b1() * b2() / J;
  return {{{1 + h * h / J, x1, x2}, {x1, 1 + b1() * b1() / J, both}, {x2, both, 1 + b2() * b2() / J}}};
}

Contact::Contact(const Body& body, const Triple& load, int slip)
    : delassus_(body.delassus()), load_(load), mu_(body.mu), slip_(slip), friction_{0, -slip * mu_, -slip * mu_} {
  if (slip == 0) {
    const Triple& row = delassus_[0];
    friction_ = {-load[0] / row[0], -row[1] / row[0], -row[2] / row[0]};
  }
}

Triple Contact::with_friction(Triple forces) const {
  forces[0] = friction_[0] + friction_[1] * forces[1] + friction_[2] * forces[2];
  return forces;
}

Triple Contact::acceleration(const Triple& forces) const {
  Triple result = load_;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i] += delassus_[i][j] * forces[j];
  }
  if (slip_ == 0) result[0] = 0;
  return result;
}

bool Contact::lawful(double velocity_along, const Triple& forces) const {
  const bool moves = velocity_along != 0;
  if (slip_ == 0) return !moves && std::abs(forces[0]) <= (1 + 1e-12) * mu_ * (forces[1] + forces[2]);
  return moves ? slip_ * velocity_along > 0 : slip_ * acceleration(forces)[0] >= 0;
}

Triple Contact::keeping(const std::array<bool, 3>& pushing, Triple forces) const {
  const auto factor = [&](std::size_t i, std::size_t j) { return delassus_[i][j] + delassus_[i][0] * friction_[j]; };
  Triple without{};  // accelerations without the forces that are sought
  for (const std::size_t i : feet) {
    if (pushing[i]) forces[i] = 0;
  }
  for (const std::size_t i : feet) {
    without[i] = load_[i] + delassus_[i][0] * friction_[0] + factor(i, 1) * forces[1] + factor(i, 2) * forces[2];
  }
  if (pushing[1] && pushing[2]) {
    const double determinant = factor(1, 1) * factor(2, 2) - factor(1, 2) * factor(2, 1);
    forces[1] = (factor(1, 2) * without[2] - factor(2, 2) * without[1]) / determinant;
    forces[2] = (factor(2, 1) * without[1] - factor(1, 1) * without[2]) / determinant;
  } else {
    for (const std::size_t i : feet) {
      if (pushing[i]) forces[i] = -without[i] / factor(i, i);
    }
  }
  return with_friction(forces);
}

double between(Dice& dice, double low, double high) {
  constexpr int steps = 1'000'000'000;
  return low + (high - low) * dice.number(0, steps) / steps;
}

}  // namespace slipproof::test::rest_on_slope

#include "contact/complete/splitting.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slipproof {

namespace {

using Kind = ContactState::Kind;

constexpr double narrow_arc = 0x1p-8;      ///< arc, in radians: it is not cut off any more, but halved
constexpr double narrowest_arc = 0x1p-30;  ///< arc that is split
constexpr int direction_bits = 12;         ///< of an end of a wide arc; narrow ones have more

/// A direction strictly within an arc, as near to an angle as the arc's width asks for.
std::optional<Direction> within(const ContactState& arc, double angle) {
  const double width = arc.width();
  const int bits = direction_bits + std::max(0, static_cast<int>(-std::log2(width)));
  Direction d = Direction::near(angle, std::min(bits, 50));
  if (cross(arc.from, d).sign() > 0 && cross(d, arc.to).sign() > 0) return d;
  return std::nullopt;
}

/// An arc, cut at directions in it that go round counterclockwise.
std::vector<ContactState> cut_at(const ContactState& arc, const std::vector<Direction>& cuts) {
  std::vector<ContactState> states;
  Direction last = arc.from;
  for (const Direction& d : cuts) {
    if (!states.empty() && cross(last, d).sign() <= 0) continue;
    states.push_back({Kind::slip, last, d});
    last = d;
  }
  states.push_back({Kind::slip, last, arc.to});
  return states;
}

/// The ends of an arc in which no motion seems to be.
std::vector<Direction> ends_to_cut_off(const ContactState& arc, const std::array<double, 2>& left) {
  constexpr double kept = 0.03;
  const double from = arc.from.angle(), width = arc.width();
  std::vector<Direction> cuts;
  for (const double share : {left[0] - kept, left[1] + kept}) {
    if (share < 0.05 || share > 0.95) continue;
    if (const auto d = within(arc, from + share * width)) cuts.push_back(*d);
  }
  return cuts;
}

/// In the middle; around the direction of a known motion in three, so that it is alone in a narrow arc.
std::vector<Direction> cuts_of(const ContactState& arc, std::size_t contact,
                               const std::vector<SpatialMotion>& motions) {
  const double from = arc.from.angle(), width = arc.width();
  std::vector<Direction> cuts;
  for (const SpatialMotion& motion : motions) {
    if (motion.mode[contact].kind != Kind::slip || motion.is_exact()) continue;
    const std::size_t i = 3 * contact;
    double angle = std::atan2(-motion.r[i + 2].to_double(), -motion.r[i + 1].to_double()) - from;
    if (angle < 0) angle += 2 * std::numbers::pi;
    if (angle >= width) continue;
    for (const double side : {-1.0, 1.0}) {
      if (const auto d = within(arc, from + angle + side * width / 8)) cuts.push_back(*d);
    }
    break;
  }
  if (cuts.empty()) {
    if (const auto d = within(arc, from + width / 2)) cuts.push_back(*d);
  }
  return cuts;
}

std::vector<ContactState> ways_to_touch(std::size_t dimension) {
  std::vector<ContactState> states{{Kind::stick, {}, {}}};
  if (dimension == 2) {
    for (const Direction& d : {Direction{1, 0, 1}, Direction{-1, 0, 1}}) states.push_back({Kind::slip, d, d});
    return states;
  }
  // Not along the axes and diagonals: symmetric problems slip there, and would be at the ends of two arcs.
  const Direction a{12, 5, 13}, b{-5, 12, 13}, c{-12, -5, 13}, d{5, -12, 13};
  states.insert(states.end(), {{Kind::slip, a, b}, {Kind::slip, b, c}, {Kind::slip, c, d}, {Kind::slip, d, a}});
  return states;
}

/// First a contact that touches, then any, then the widest arc.
std::optional<std::size_t> contact_to_split(const ExactContacts& exact, const FloatingContacts& contacts,
                                            const ContactPattern& pattern, const ProposedPoint& point) {
  std::optional<std::size_t> best;
  double most = -1;
  const auto consider = [&](std::size_t k, double worth) {
    if (worth > most) most = worth, best = k;
  };
  for (const Kind kind : {Kind::closed, Kind::any}) {
    for (std::size_t k = 0; k < pattern.size(); ++k) {
      if (pattern[k].kind == kind && !is_decided(exact, pattern, k)) consider(k, violation(contacts, k, point));
    }
    if (best) return best;
  }
  for (std::size_t k = 0; k < pattern.size(); ++k) {
    if (pattern[k].kind != Kind::slip || exact.dimension != 3) continue;
    const double width = pattern[k].width();
    if (width > narrowest_arc) consider(k, width);
  }
  return best;
}

PatternSplit split_into(const ContactPattern& pattern, std::size_t contact, const std::vector<ContactState>& states) {
  PatternSplit result{contact, {}};
  for (const ContactState& state : states) {
    result.children.push_back(pattern);
    result.children.back()[contact] = state;
  }
  return result;
}

}  // namespace

double violation(const FloatingContacts& contacts, std::size_t k, const ProposedPoint& point) {
  const std::size_t i = contacts.normal(k);
  double speed = 0, power = 0;
  for (std::size_t t = 1; t < contacts.dimension; ++t) {
    speed = std::hypot(speed, point.u[i + t]);
    power += point.u[i + t] * point.r[i + t];
  }
  return std::min(point.u[i], point.r[i]) + std::max(0.0, contacts.mu[k] * point.r[i] * speed + power);
}

std::optional<ShrunkArc> shrink_widest_arc(const ContactPattern& pattern, PatternProgram& program) {
  constexpr double enough = 0.75;  // less is left: a cut is worth it
  std::optional<std::size_t> widest;
  for (std::size_t k = 0; k < pattern.size(); ++k) {
    const ContactState& state = pattern[k];
    if (state.kind != Kind::slip || state.from == state.to || state.width() < narrow_arc) continue;
    if (!widest || state.width() > pattern[*widest].width()) widest = k;
  }
  if (!widest) return std::nullopt;
  const std::array<double, 2> left = program.directions(*widest);
  return left[1] - left[0] < enough ? std::optional(ShrunkArc{*widest, left}) : std::nullopt;
}

PatternSplit split_pattern(const ExactContacts& exact, const FloatingContacts& contacts, const ContactPattern& pattern,
                           const ProposedPoint& point, const std::optional<ShrunkArc>& shrunk,
                           const std::vector<SpatialMotion>& motions) {
  if (shrunk) {
    const ContactState& arc = pattern[shrunk->contact];
    const std::vector<Direction> cuts = ends_to_cut_off(arc, shrunk->left);
    if (!cuts.empty()) return split_into(pattern, shrunk->contact, cut_at(arc, cuts));
  }
  const auto k = contact_to_split(exact, contacts, pattern, point);
  if (!k) return {};
  const ContactState& state = pattern[*k];
  if (state.kind == Kind::any) return split_into(pattern, *k, {{Kind::open, {}, {}}, {Kind::closed, {}, {}}});
  if (state.kind == Kind::closed) return split_into(pattern, *k, ways_to_touch(exact.dimension));
  const std::vector<Direction> cuts = cuts_of(state, *k, motions);
  return cuts.empty() ? PatternSplit{} : split_into(pattern, *k, cut_at(state, cuts));
}

}  // namespace slipproof

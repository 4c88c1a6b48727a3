#include "contact/complete/motion_list.hpp"

#include <algorithm>

#include "contact/complete/solve_near.hpp"

namespace slipproof {

namespace {

using End = PatternNode::End;

bool have_one_mode(const ContactPattern& a, const ContactPattern& b) {
  return std::ranges::equal(a, b, {}, &ContactState::kind, &ContactState::kind);
}

}  // namespace

void MotionList::add(SpatialMotion&& motion) {
  std::size_t same = 0;
  for (std::size_t m = 0; m < found_.motions.size(); ++m) {
    if (!found_.motions[m].differs(motion)) return;
    if (motion.pinned.empty() || found_.motions[m].pinned.empty()) continue;
    if (places_[m].contains(VelocityBox::of(motion))) return;
    const bool near = places_[m].widened(power_of_two(-continuum_bits)).contains(VelocityBox::of(motion));
    same += near && have_one_mode(found_.motions[m].mode, motion.mode) ? 1 : 0;
  }
  if (same > 1) return;
  places_.push_back(VelocityBox::of(motion));
  found_.motions.push_back(std::move(motion));
}

void MotionList::keep_only(SpatialMotion&& motion) {
  places_ = {VelocityBox::of(motion)};
  found_.motions = {std::move(motion)};
}

bool MotionList::is_known(const ContactPattern& mode, std::span<const double> u) const {
  constexpr double rounding = 1e-11;
  std::size_t same = 0;
  for (std::size_t m = 0; m < places_.size(); ++m) {
    if (places_[m].is_near(u, rounding)) return true;
    const SpatialMotion& motion = found_.motions[m];
    const bool counts = !motion.pinned.empty() && have_one_mode(motion.mode, mode);
    same += counts && places_[m].is_near(u, 1.0 / (1 << continuum_bits)) ? 1 : 0;
  }
  return same > 1;
}

bool MotionList::is_in_continuum(std::size_t m) const {
  const VelocityBox near = places_[m].widened(2 * power_of_two(-continuum_bits));
  for (std::size_t o = 0; o < found_.motions.size(); ++o) {
    const SpatialMotion& other = found_.motions[o];
    const bool same = o != m && have_one_mode(other.mode, found_.motions[m].mode);
    if (same && other.open_directions > 0 && near.contains(VelocityBox::of(other))) return true;
  }
  return false;
}

void MotionList::settle() {
  while (join_two_places()) {
  }
  forget_what_stands_for_nothing();
  for (std::size_t m = 0; m < places_.size(); ++m) found_.within.push_back(reach(m));
}

/// Places that overlap become one, that of the first motion.
bool MotionList::join_two_places() {
  for (std::size_t m = 0; m < places_.size(); ++m) {
    for (std::size_t n = m + 1; n < places_.size(); ++n) {
      const bool alone = !found_.motions[m].alone.is_zero() || !found_.motions[n].alone.is_zero();
      if (alone || !places_[m].overlaps(places_[n]) || places_[m].contains(places_[n])) continue;
      places_[m].add(places_[n]);
      places_[n] = VelocityBox::of(found_.motions[n]);
      for (PatternNode& node : found_.nodes) {
        if (node.end == End::motion && node.motion == n) node.motion = m;
      }
      return true;
    }
  }
  return false;
}

/// Of the motions in a place of a motion that stands for nodes, one that differs from it is kept.
void MotionList::forget_what_stands_for_nothing() {
  const std::size_t count = found_.motions.size();
  std::vector<bool> stands(count, false), has_companion(count, false);
  for (const PatternNode& node : found_.nodes) {
    if (node.end == End::motion) stands[node.motion] = true;
  }
  std::vector<bool> kept(count, true);
  for (std::size_t m = 0; m < count; ++m) {
    for (std::size_t h = 0; h < count && !stands[m]; ++h) {
      if (!stands[h] || !places_[h].contains(places_[m])) continue;
      kept[m] = !has_companion[h] && found_.motions[h].differs(found_.motions[m]);
      has_companion[h] = has_companion[h] || kept[m];
      break;
    }
  }
  keep(kept);
}

void MotionList::keep(const std::vector<bool>& kept) {
  std::vector<std::size_t> moved(kept.size());
  std::size_t left = 0;
  for (std::size_t m = 0; m < kept.size(); ++m) {
    if (!kept[m]) continue;
    moved[m] = left;
    if (left != m) {
      found_.motions[left] = std::move(found_.motions[m]);
      places_[left] = std::move(places_[m]);
    }
    ++left;
  }
  found_.motions.resize(left);
  places_.resize(left);
  for (PatternNode& node : found_.nodes) {
    if (node.end == End::motion) node.motion = moved[node.motion];
  }
}

/// How far from a motion its place reaches, in each row.
std::vector<Rational> MotionList::reach(std::size_t m) const {
  const VelocityBox own = VelocityBox::of(found_.motions[m]);
  std::vector<Rational> result;
  bool any = false;
  for (std::size_t i = 0; i < own.low.size(); ++i) {
    const Rational below = own.low[i] - places_[m].low[i], above = places_[m].high[i] - own.high[i];
    result.push_back(-rounded_down(-std::max(below, above), 2 * near_bits));
    any = any || !result.back().is_zero();
  }
  return any ? result : std::vector<Rational>();
}

}  // namespace slipproof

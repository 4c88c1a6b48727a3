#include "mechanics/elements/force_interval.hpp"

#include <utility>

#include "base/number/simplest.hpp"

namespace slipproof {

ForceInterval ForceInterval::nothing() {
  ForceInterval result;
  result.empty_ = true;
  return result;
}

ForceInterval ForceInterval::point(Rational force) {
  ForceInterval result;
  result.lower_ = force;
  result.upper_ = std::move(force);
  result.lower_closed_ = result.upper_closed_ = true;
  return result;
}

ForceInterval ForceInterval::open_between(std::optional<Rational> lower, std::optional<Rational> upper) {
  return between(std::move(lower), false, std::move(upper), false);
}

ForceInterval ForceInterval::between(std::optional<Rational> lower, bool lower_closed, std::optional<Rational> upper,
                                     bool upper_closed) {
  ForceInterval result;
  result.lower_closed_ = lower && lower_closed;
  result.upper_closed_ = upper && upper_closed;
  result.lower_ = std::move(lower);
  result.upper_ = std::move(upper);
  result.settle();
  return result;
}

bool ForceInterval::contains(const Rational& force) const {
  if (empty_) return false;
  if (lower_ && (lower_closed_ ? force < *lower_ : force <= *lower_)) return false;
  return !(upper_ && (upper_closed_ ? force > *upper_ : force >= *upper_));
}

void ForceInterval::clear() {
  *this = nothing();
}

void ForceInterval::settle() {
  if (lower_ && upper_ && (*lower_ > *upper_ || (*lower_ == *upper_ && !(lower_closed_ && upper_closed_)))) clear();
}

void ForceInterval::restrict_to(const Affine<Rational>& condition, bool strict) {
  if (empty_) return;
  const int slope = sign(condition.beta);
  if (slope == 0) {
    const int s = sign(condition.alpha);
    if (s < 0 || (strict && s == 0)) clear();
    return;
  }
  const Rational root = -condition.alpha / condition.beta;
  intersect(slope > 0 ? between(root, !strict, std::nullopt, false) : between(std::nullopt, false, root, !strict));
}

void ForceInterval::intersect(const ForceInterval& other) {
  if (empty_) return;
  if (other.empty_) return clear();
  if (other.lower_ && (!lower_ || *other.lower_ >= *lower_)) {
    lower_closed_ = other.lower_closed_ && (!lower_ || *other.lower_ > *lower_ || lower_closed_);
    lower_ = other.lower_;
  }
  if (other.upper_ && (!upper_ || *other.upper_ <= *upper_)) {
    upper_closed_ = other.upper_closed_ && (!upper_ || *other.upper_ < *upper_ || upper_closed_);
    upper_ = other.upper_;
  }
  settle();
}

ForceInterval ForceInterval::interior() const {
  return empty_ ? nothing() : between(lower_, false, upper_, false);
}

Rational ForceInterval::sample() const {
  return is_point() ? *lower_ : simplest_between(lower_, upper_);
}

std::vector<ForceInterval> difference(const std::vector<ForceInterval>& from, const ForceInterval& what) {
  if (what.empty()) return from;
  std::vector<ForceInterval> rest;
  const auto keep = [&](ForceInterval part, const ForceInterval& beside) {
    part.intersect(beside);
    if (!part.empty()) rest.push_back(std::move(part));
  };
  for (const ForceInterval& part : from) {
    if (what.lower()) keep(part, ForceInterval::between(std::nullopt, false, what.lower(), !what.lower_closed()));
    if (what.upper()) keep(part, ForceInterval::between(what.upper(), !what.upper_closed(), std::nullopt, false));
  }
  return rest;
}

std::string to_string(const ForceInterval& interval) {
  if (interval.empty()) return "{}";
  if (interval.is_point()) return "{" + interval.lower()->str() + "}";
  std::string text = interval.lower_closed() ? "[" : "(";
  text += interval.lower() ? interval.lower()->str() : "-oo";
  text += ", ";
  text += interval.upper() ? interval.upper()->str() : "+oo";
  text += interval.upper_closed() ? "]" : ")";
  return text;
}

}  // namespace slipproof

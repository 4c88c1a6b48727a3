#include "mechanics/planes/sets_along.hpp"

#include <algorithm>

namespace slipproof {

namespace {

class ChangeSearch {
 public:
  ChangeSearch(const Axis& x, std::size_t parts,
               const std::function<std::optional<MotionSet>(const Rational& x)>& solve)
      : solve_(solve), narrow_((x.to - x.from) / Rational(1024 * parts)) {
    found_.x = x;
  }

  /// With what changes since the value before.
  void add(const Rational& x) {
    SetsAlong::Place right{x, solve_(x)};
    if (!found_.places.empty()) between(SetsAlong::Place(found_.places.back()), right);
    found_.places.push_back(std::move(right));
  }
  SetsAlong found() { return std::move(found_); }

 private:
  void between(const SetsAlong::Place& left, const SetsAlong::Place& right) {
    if (left.set == right.set || right.x - left.x <= narrow_) return;
    const Rational x = (left.x + right.x) / 2;
    const SetsAlong::Place middle{x, solve_(x)};
    between(left, middle);
    found_.places.push_back(middle);
    between(middle, right);
  }

  const std::function<std::optional<MotionSet>(const Rational& x)>& solve_;
  const Rational narrow_;
  SetsAlong found_;
};

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> SetsAlong::runs() const {
  std::vector<std::pair<std::size_t, std::size_t>> all;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i == 0 || places[i].set != places[i - 1].set) all.emplace_back(i, i);
    all.back().second = i;
  }
  return all;
}

bool SetsAlong::is_complete() const {
  return std::ranges::all_of(places, [](const Place& place) { return !place.set || place.set->complete; });
}

SetsAlong sets_along(const Axis& x, std::size_t parts,
                     const std::function<std::optional<MotionSet>(const Rational& x)>& solve,
                     const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  ChangeSearch search(x, parts, solve);
  for (std::size_t i = 0; i <= parts; ++i) {
    search.add(x.from + (x.to - x.from) * Rational(i, parts));
    if (progress) progress(i + 1, parts + 1);
  }
  return search.found();
}

}  // namespace slipproof

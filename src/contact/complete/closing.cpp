#include "contact/complete/closing.hpp"

#include <algorithm>

namespace slipproof {

namespace {

using Kind = ContactState::Kind;
using Bounds = std::vector<PatternNode::Bound>;

/// Whether u is 0 in a row in all motions of the pattern, by definition.
bool is_zero_row(const ContactPattern& pattern, std::size_t dimension, std::size_t row) {
  const Kind kind = pattern[row / dimension].kind;
  const bool normal = row % dimension == 0;
  return kind == Kind::stick || (normal && kind != Kind::any && kind != Kind::open);
}

/// What the equations of a pattern determine.
class DeterminedVelocities {
 public:
  DeterminedVelocities(const SearchProblem& problem, const ContactPattern& pattern)
      : problem_(problem), exact_(problem.exact), pattern_(pattern) {
    for (std::size_t i = 0; i < exact_.size(); ++i) {
      (is_zero_row(pattern, exact_.dimension, i) ? equations_ : rows_).push_back(i);
    }
  }

  /// If they determine u, and it is this motion's.
  std::optional<Bounds> bounds(const SpatialMotion& motion) const {
    for (const std::size_t i : equations_) {
      if (!motion.u[i].is_zero()) return std::nullopt;
    }
    const RationalMatrix combinations = determining();
    if (combinations.size() != rows_.size()) return std::nullopt;
    Bounds result;
    for (std::size_t c = 0; c < rows_.size(); ++c) {
      for (const int side : {1, -1}) {
        std::vector<Rational> y;
        for (const Rational& x : combinations[c]) y.push_back(side * x);
        const ContactForm form{{{rows_[c], Rational(side)}}, {}};
        const auto proved = lower_bound(exact_, problem_.integers, pattern_, form, y);
        if (!proved || proved->value < side * motion.u[rows_[c]]) return std::nullopt;
        result.push_back({form, std::move(y)});
      }
    }
    return result;
  }

 private:
  /// For each row i of u that is not 0 the y with u_i = y . q wherever the equations hold; nothing if they do not
  /// determine all of them. Unknowns are the y of rows that are equations; conditions are that forces do not matter.
  RationalMatrix determining() const {
    RationalMatrix result(rows_.size(), std::vector<Rational>(exact_.size()));
    for (std::size_t c = 0; c < rows_.size(); ++c) result[c][rows_[c]] = 1;
    const RationalMatrix system = conditions();
    if (system.empty()) return result;
    const std::size_t unknowns = equations_.size();
    const Echelon echelon = eliminate(system);
    if (echelon.rank(unknowns) != echelon.rank()) return {};
    for (std::size_t c = 0; c < rows_.size(); ++c) {
      for (std::size_t p = 0; p < echelon.rank(); ++p) {
        result[c][equations_[echelon.pivot_columns[p]]] = Rational(echelon.rows[p][unknowns + c], echelon.pivot);
      }
    }
    return result;
  }

  /// A row for each direction that forces can have.
  RationalMatrix conditions() const {
    RationalMatrix system;
    const auto add = [&](const auto& entry) {  // entry(i): what row i of W gives in the direction
      std::vector<Rational>& condition = system.emplace_back();
      for (const std::size_t i : equations_) condition.push_back(entry(i));
      for (const std::size_t i : rows_) condition.push_back(-entry(i));
    };
    for (std::size_t k = 0; k < pattern_.size(); ++k) {
      const ContactState& state = pattern_[k];
      const std::size_t normal = exact_.normal(k);
      if (state.kind == Kind::open) continue;
      if (state.kind == Kind::slip && exact_.dimension == 2) {
        const Rational mu = state.from.x.sign() > 0 ? Rational(-exact_.mu[k]) : exact_.mu[k];
        add([&](std::size_t i) { return exact_.W[i][normal] + mu * exact_.W[i][normal + 1]; });
        continue;
      }
      const std::size_t forces = exact_.has_friction(k) ? exact_.dimension : 1;
      for (std::size_t t = 0; t < forces; ++t) {
        add([&](std::size_t i) { return exact_.W[i][normal + t]; });
      }
    }
    return system;
  }

  const SearchProblem& problem_;
  const ExactContacts& exact_;
  const ContactPattern& pattern_;
  std::vector<std::size_t> equations_, rows_;  ///< where u is 0 by the pattern, and the others
};

/// The box in which a motion is alone, and bounds that keep a pattern in it.
class AloneBox {
 public:
  AloneBox(const SearchProblem& problem, const ContactPattern& pattern, const SpatialMotion& motion)
      : problem_(problem), pattern_(pattern), motion_(motion), unknowns_(problem.exact, motion.mode) {}

  std::optional<Bounds> bounds(std::size_t& programs) {
    if (motion_.alone.is_zero() || !has_mode()) return std::nullopt;
    PatternProgram program(problem_.exact, problem_.integers, problem_.floating, pattern_);
    const bool closed = program.feasibility().point && bound_all(program);
    programs += program.solved();
    return closed ? std::optional(std::move(bounds_)) : std::nullopt;
  }

 private:
  bool has_mode() const {
    return std::ranges::equal(pattern_, motion_.mode, {}, &ContactState::kind, &ContactState::kind);
  }

  bool bound_all(PatternProgram& program) {
    for (std::size_t k = 0; k < pattern_.size(); ++k) {
      const std::size_t first = unknowns_.first[k], i = problem_.exact.normal(k);
      for (std::size_t t = 0; t < unknowns_.forces(k); ++t) {
        const Rational center = motion_.center[first + t], width = alone(first + t);
        if (!bound(program, {{}, {{i + t, Rational(1)}}}, center - width)) return false;
        if (!bound(program, {{}, {{i + t, Rational(-1)}}}, -center - width)) return false;
      }
      if (unknowns_.slips_in_space(k) && !bound_slip(program, k)) return false;
    }
    return true;
  }

  Rational alone(std::size_t unknown) const { return motion_.radius[unknown] * Rational(motion_.alone); }

  /// With m = from + to and c = 1 + from . to, c <= d . m <= 1 + c / 2 for all d in the arc, and u_T . m =
  /// s mu r_N d . m: so s is at most S if u_T . m <= S mu c r_N, and at least S if u_T . m >= S mu (1 + c / 2) r_N.
  bool bound_slip(PatternProgram& program, std::size_t k) {
    const std::size_t i = problem_.exact.normal(k), s = unknowns_.first[k] + 3;
    const Rational center = motion_.center[s], width = alone(s), mu = problem_.exact.mu[k];
    const auto [x, y] = pattern_[k].middle();
    const Rational c = (x * x + y * y) / 2;
    if (!bound(program, {{{i + 1, -x}, {i + 2, -y}}, {{i, (center + width) * mu * c}}}, 0)) return false;
    ContactForm form{{{i + 1, x}, {i + 2, y}}, {{i, -((center - width) * mu * (1 + c / 2))}}};
    if (width < center) return bound(program, std::move(form), 0);
    bounds_.push_back({std::move(form), std::vector<Rational>(problem_.exact.size())});
    return true;
  }

  /// Adds a bound if it is proved to be at least `least`.
  bool bound(PatternProgram& program, ContactForm form, const Rational& least) {
    std::vector<Rational> y = program.prove_least(form, least);
    if (y.empty()) return false;
    bounds_.push_back({std::move(form), std::move(y)});
    return true;
  }

  const SearchProblem& problem_;
  const ContactPattern& pattern_;
  const SpatialMotion& motion_;
  const ModeUnknowns unknowns_;
  Bounds bounds_;
};

}  // namespace

VelocityBox VelocityBox::of(const SpatialMotion& motion) {
  VelocityBox result;
  for (std::size_t i = 0; i < motion.u.size(); ++i) {
    result.low.push_back(motion.u[i] - motion.u_radius[i]);
    result.high.push_back(motion.u[i] + motion.u_radius[i]);
  }
  return result;
}

void VelocityBox::add(const VelocityBox& other) {
  for (std::size_t i = 0; i < low.size(); ++i) {
    low[i] = std::min(low[i], other.low[i]);
    high[i] = std::max(high[i], other.high[i]);
  }
}

bool VelocityBox::contains(const VelocityBox& other) const {
  for (std::size_t i = 0; i < low.size(); ++i) {
    if (other.low[i] < low[i] || other.high[i] > high[i]) return false;
  }
  return true;
}

bool VelocityBox::is_near(std::span<const double> u, double distance) const {
  for (std::size_t i = 0; i < low.size(); ++i) {
    if (u[i] < low[i].to_double() - distance || u[i] > high[i].to_double() + distance) return false;
  }
  return true;
}

bool VelocityBox::overlaps(const VelocityBox& other) const {
  for (std::size_t i = 0; i < low.size(); ++i) {
    if (other.high[i] < low[i] || other.low[i] > high[i]) return false;
  }
  return true;
}

VelocityBox VelocityBox::widened(const Rational& distance) const {
  VelocityBox result = *this;
  for (Rational& x : result.low) x -= distance;
  for (Rational& x : result.high) x += distance;
  return result;
}

VelocityBox place_of(const CompleteSolutions& found, std::size_t motion) {
  VelocityBox place = VelocityBox::of(found.motions[motion]);
  for (std::size_t i = 0; i < found.within[motion].size(); ++i) {
    place.low[i] -= found.within[motion][i];
    place.high[i] += found.within[motion][i];
  }
  return place;
}

std::optional<BoundedVelocities> bound_velocities(const SearchProblem& problem, const ContactPattern& pattern,
                                                  const VelocityBox* limits, std::size_t& programs) {
  const std::size_t n = problem.exact.size();
  BoundedVelocities result{{std::vector<Rational>(n), std::vector<Rational>(n)}, {}};
  PatternProgram program(problem.exact, problem.integers, problem.floating, pattern);
  bool found = program.feasibility().point.has_value();
  for (std::size_t i = 0; i < n && found; ++i) {
    if (is_zero_row(pattern, problem.exact.dimension, i)) continue;
    for (const int side : {1, -1}) {
      const ContactForm form{{{i, Rational(side)}}, {}};
      auto y = program.prove_best(form);
      found = found && !y.empty();
      if (!found) break;
      (side > 0 ? result.box.low : result.box.high)[i] =
          side * lower_bound(problem.exact, problem.integers, pattern, form, y)->value;
      result.bounds.push_back({form, std::move(y)});
    }
    if (found && limits != nullptr)
      found = result.box.low[i] >= limits->low[i] && result.box.high[i] <= limits->high[i];
  }
  programs += program.solved();
  if (!found || (limits != nullptr && !limits->contains(result.box))) return std::nullopt;
  return result;
}

std::optional<Bounds> bounds_to_motion(const SearchProblem& problem, const ContactPattern& pattern,
                                       const SpatialMotion& motion, std::size_t& programs) {
  if (motion.is_exact()) return DeterminedVelocities(problem, pattern).bounds(motion);
  return AloneBox(problem, pattern, motion).bounds(programs);
}

}  // namespace slipproof

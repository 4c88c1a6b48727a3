#include "contact/complete/closing.hpp"

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
class Neighbourhood {
 public:
  Neighbourhood(const SearchProblem& problem, const ContactPattern& pattern, const SpatialMotion& motion)
      : problem_(problem), pattern_(pattern), motion_(motion), unknowns_(problem.exact, motion.mode) {}

  std::optional<Bounds> bounds(std::size_t& programs) {
    if (motion_.alone.empty() || !has_mode()) return std::nullopt;
    PatternProgram program(problem_.exact, problem_.integers, problem_.floating, pattern_);
    const bool closed = program.feasibility().point && bound_all(program);
    programs += program.solved();
    return closed ? std::optional(std::move(bounds_)) : std::nullopt;
  }

 private:
  bool has_mode() const {
    for (std::size_t k = 0; k < pattern_.size(); ++k) {
      if (pattern_[k].kind != motion_.mode[k].kind) return false;
      if (unknowns_.of(k) == 4 && !arc_lies_within(pattern_[k], unknowns_.first[k] + 1)) return false;
    }
    return true;
  }

  /// Whether all directions of an arc are in the box: they lie in the triangle of its ends and the corner where their
  /// tangents meet.
  bool arc_lies_within(const ContactState& arc, std::size_t d) const {
    const std::array<Rational, 2> a{Rational(arc.from.x, arc.from.length), Rational(arc.from.y, arc.from.length)};
    const std::array<Rational, 2> b{Rational(arc.to.x, arc.to.length), Rational(arc.to.y, arc.to.length)};
    const Rational corner = 1 + a[0] * b[0] + a[1] * b[1];
    for (std::size_t t = 0; t < 2; ++t) {
      for (const Rational& x : {a[t], b[t], Rational((a[t] + b[t]) / corner)}) {
        if (abs(x - motion_.center[d + t]) > motion_.alone[d + t]) return false;
      }
    }
    return true;
  }

  bool bound_all(PatternProgram& program) {
    for (std::size_t k = 0; k < pattern_.size(); ++k) {
      const std::size_t first = unknowns_.first[k], i = problem_.exact.normal(k);
      const bool slips = unknowns_.of(k) == 4;
      for (std::size_t t = 0; t < (slips ? 1 : unknowns_.of(k)); ++t) {
        const Rational &center = motion_.center[first + t], &width = motion_.alone[first + t];
        if (!bound(program, {{}, {{i + t, Rational(1)}}}, center - width)) return false;
        if (!bound(program, {{}, {{i + t, Rational(-1)}}}, -center - width)) return false;
      }
      if (slips && !bound_speed(program, k)) return false;
    }
    return true;
  }

  /// With m = from + to and c = 1 + from . to, c <= d . m <= 1 + c / 2 for all d in the arc: v = u_T . d is between
  /// u_T . m / (1 + c / 2) and u_T . m / c.
  bool bound_speed(PatternProgram& program, std::size_t k) {
    const ContactState& arc = pattern_[k];
    const std::size_t i = problem_.exact.normal(k) + 1, v = unknowns_.first[k] + 3;
    const Rational &center = motion_.center[v], &width = motion_.alone[v];
    const Rational a(arc.from.length), b(arc.to.length);
    const Rational x = Rational(arc.from.x) / a + Rational(arc.to.x) / b;
    const Rational y = Rational(arc.from.y) / a + Rational(arc.to.y) / b;
    const Rational c = (x * x + y * y) / 2;
    if (!bound(program, {{{i, -x}, {i + 1, -y}}, {}}, -(center + width) * c)) return false;
    return width >= center || bound(program, {{{i, x}, {i + 1, y}}, {}}, (center - width) * (1 + c / 2));
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

std::optional<Bounds> bounds_to_motion(const SearchProblem& problem, const ContactPattern& pattern,
                                       const SpatialMotion& motion, std::size_t& programs) {
  if (motion.is_exact()) return DeterminedVelocities(problem, pattern).bounds(motion);
  return Neighbourhood(problem, pattern, motion).bounds(programs);
}

}  // namespace slipproof

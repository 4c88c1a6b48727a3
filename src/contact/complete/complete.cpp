#include "contact/complete/complete.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel/in_parallel.hpp"

namespace slipproof {

namespace {

using Kind = ContactState::Kind;
using End = PatternNode::End;

constexpr double narrow = 0x1p-8;      ///< arc, in radians: it is not cut off any more, but halved
constexpr double narrowest = 0x1p-30;  ///< arc that is split
constexpr int direction_bits = 12;     ///< of an end of a wide arc; narrow ones have more

double width_of(const ContactState& state) {
  const double width = state.to.angle() - state.from.angle();
  return width < 0 ? width + 2 * std::numbers::pi : width;
}

/// A direction strictly within an arc, as near to an angle as the arc's width asks for.
std::optional<Direction> within(const ContactState& arc, double angle) {
  const double width = width_of(arc);
  const int bits = direction_bits + std::max(0, static_cast<int>(-std::log2(width)));
  Direction d = Direction::near(angle, std::min(bits, 50));
  if (cross(arc.from, d).sign() > 0 && cross(d, arc.to).sign() > 0) return d;
  return std::nullopt;
}

class Search {
 public:
  Search(CompleteSolutions& solutions, const CompleteOptions& options)
      : found_(solutions), options_(options), exact_(solutions.scaled.contacts), integers_(exact_), floating_(exact_) {}

  void run() {
    PatternNode root;
    root.pattern.resize(exact_.contacts());
    found_.nodes.push_back(root);
    std::vector<std::size_t> level{0};
    const Work n = exact_.size(), each = plus(100'000, times(200, n * n * n));
    Effort effort(options_.effort);
    while (!level.empty() && found_.nodes.size() < options_.most_nodes) {
      if (!effort.allows(times(each, level.size()))) return;
      effort.spend(times(each, level.size()));
      if (options_.progress) options_.progress(level.size(), found_.motions.size());
      level = next_generation(level);
    }
  }

 private:
  struct Visit {
    std::size_t programs = 0;
    std::optional<ProposedPoint> point;
    std::optional<SpatialMotion> candidate;
    std::vector<ContactPattern> children;
    std::size_t contact = 0;
    std::optional<std::size_t> shrinks;  ///< the arc of which most can be cut off, and what is left of it
    std::array<double, 2> left{0, 1};
  };

  /// Each node sees the motions that were known when its generation began: so threads change nothing.
  std::vector<std::size_t> next_generation(const std::vector<std::size_t>& level) {
    std::vector<Visit> visits(level.size());
    in_parallel(0, level.size(), [&](std::size_t i) { look(found_.nodes[level[i]], visits[i]); });
    for (Visit& visit : visits) {
      if (visit.candidate) add(std::move(*visit.candidate));
    }
    in_parallel(0, level.size(), [&](std::size_t i) {
      PatternNode& node = found_.nodes[level[i]];
      if (visits[i].point && node.end == End::undecided && !close_by_motion(node, visits[i])) split(node, visits[i]);
    });
    std::vector<std::size_t> next;
    for (std::size_t i = 0; i < level.size(); ++i) {
      found_.programs += visits[i].programs;
      if (visits[i].children.empty()) continue;
      const std::size_t first = found_.nodes.size();
      PatternNode& node = found_.nodes[level[i]];
      node.end = End::split;
      node.contact = visits[i].contact;
      node.first_child = first;
      node.children = visits[i].children.size();
      for (ContactPattern& pattern : visits[i].children) {
        next.push_back(found_.nodes.size());
        found_.nodes.emplace_back().pattern = std::move(pattern);
      }
    }
    return next;
  }

  // --- one node ---

  void look(PatternNode& node, Visit& visit) const {
    PatternProgram program(exact_, integers_, floating_, node.pattern);
    auto [point, y] = program.feasibility();
    if (y.empty() && point) y = program.strict_multipliers(*point);
    visit.programs += program.solved();
    if (!y.empty()) {
      node.end = End::empty;
      node.y = std::move(y);
      return;
    }
    if (!point) {  // given up: split without a point
      point = ProposedPoint{std::vector<double>(exact_.size()), floating_.q};
    }
    visit.point = std::move(point);
    const auto mode = mode_of(node.pattern, *visit.point);
    if (!mode) return;
    if (*mode == node.pattern) shrink(node.pattern, program, visit);
    visit.candidate = find_motion(exact_, floating_, *mode, *visit.point);
    if (visit.candidate) return;
    if (*mode == node.pattern) visit.candidate = find_motion(exact_, floating_, *mode, program.middle());
  }

  /// Finds the arc of which linear programs leave least.
  void shrink(const ContactPattern& pattern, PatternProgram& program, Visit& visit) const {
    double best = 0.75;
    for (std::size_t k = 0; k < pattern.size() && exact_.dimension == 3; ++k) {
      if (pattern[k].kind != Kind::slip || width_of(pattern[k]) < narrow) continue;
      const std::array<double, 2> range = program.directions(k);
      if (range[1] - range[0] >= best) continue;
      best = range[1] - range[0];
      visit.shrinks = k;
      visit.left = range;
    }
    visit.programs = program.solved();
  }

  bool is_decided(std::size_t k, const ContactState& state) const {
    return state.kind == Kind::open || state.kind == Kind::stick || state.kind == Kind::slip ||
           (state.kind == Kind::closed && !exact_.has_friction(k));
  }

  /// The mode that a point has, if nothing is left to decide or the point is nearly a solution.
  std::optional<ContactPattern> mode_of(const ContactPattern& pattern, const ProposedPoint& point) const {
    ContactPattern mode = pattern;
    for (std::size_t k = 0; k < mode.size(); ++k) {
      if (is_decided(k, pattern[k])) continue;
      if (violation(k, point) > 1e-7) return std::nullopt;
      const std::size_t i = exact_.normal(k);
      if (pattern[k].kind == Kind::any && point.r[i] < 1e-7) {
        mode[k].kind = Kind::open;
      } else if (!exact_.has_friction(k)) {
        mode[k].kind = Kind::closed;
      } else {
        double speed = 0;
        for (std::size_t t = 1; t < exact_.dimension; ++t) speed = std::hypot(speed, point.u[i + t]);
        mode[k].kind = speed < 1e-7 ? Kind::stick : Kind::slip;
        if (exact_.dimension == 2) mode[k].from = mode[k].to = {point.u[i + 1] > 0 ? 1 : -1, 0, 1};
      }
    }
    return mode;
  }

  /// How far a point is from the law at a contact: 0 where it obeys it.
  double violation(std::size_t k, const ProposedPoint& point) const {
    const std::size_t i = exact_.normal(k);
    double speed = 0, power = 0;
    for (std::size_t t = 1; t < exact_.dimension; ++t) {
      speed = std::hypot(speed, point.u[i + t]);
      power += point.u[i + t] * point.r[i + t];
    }
    return std::min(point.u[i], point.r[i]) + std::max(0.0, floating_.mu[k] * point.r[i] * speed + power);
  }

  // --- motions ---

  void add(SpatialMotion&& motion) {
    for (const SpatialMotion& known : found_.motions) {
      bool same = true;
      for (std::size_t i = 0; i < exact_.size() && same; ++i) {
        same = abs(known.u[i] - motion.u[i]) <= known.u_radius[i] + motion.u_radius[i];
      }
      if (same) return;
    }
    found_.motions.push_back(std::move(motion));
  }

  bool close_by_motion(PatternNode& node, Visit& visit) const {
    for (std::size_t m = 0; m < found_.motions.size(); ++m) {
      const SpatialMotion& motion = found_.motions[m];
      if (motion.is_exact() ? close_determined(node, motion) : close_alone(node, visit, motion)) {
        node.motion = m;
        node.end = End::motion;
        return true;
      }
      node.bounds.clear();
    }
    return false;
  }

  /// Adds a bound if it is proved to be at least `least`.
  bool add_bound(PatternNode& node, ContactForm form, std::vector<Rational> y, const Rational& least) const {
    if (y.empty()) return false;
    const auto proved = lower_bound(exact_, integers_, node.pattern, form, y);
    if (!proved || proved->value < least) return false;
    node.bounds.push_back({std::move(form), std::move(y)});
    return true;
  }

  /// Whether u is 0 in a row in all motions of the pattern, by definition.
  bool is_zero_row(const ContactPattern& pattern, std::size_t row) const {
    const Kind kind = pattern[row / exact_.dimension].kind;
    const bool normal = row % exact_.dimension == 0;
    return kind == Kind::stick || (normal && kind != Kind::any && kind != Kind::open);
  }

  /// Where the equations of a pattern determine u, and it is this motion's.
  bool close_determined(PatternNode& node, const SpatialMotion& motion) const {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < exact_.size(); ++i) {
      if (!is_zero_row(node.pattern, i)) {
        rows.push_back(i);
      } else if (!motion.u[i].is_zero()) {
        return false;
      }
    }
    const RationalMatrix combinations = determining(node.pattern, rows);
    if (combinations.size() != rows.size()) return false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      std::vector<Rational> negative;
      for (const Rational& y : combinations[i]) negative.push_back(-y);
      if (!add_bound(node, {{{rows[i], Rational(1)}}, {}}, combinations[i], motion.u[rows[i]])) return false;
      if (!add_bound(node, {{{rows[i], Rational(-1)}}, {}}, negative, -motion.u[rows[i]])) return false;
    }
    return true;
  }

  /// For each row i of u the y with u_i = y . q wherever the equations of the pattern hold; nothing if they do not
  /// determine all of them.
  RationalMatrix determining(const ContactPattern& pattern, const std::vector<std::size_t>& rows) const {
    // Unknowns are the y of rows that are equations; conditions are that forces do not matter.
    std::vector<std::size_t> equations;
    for (std::size_t i = 0; i < exact_.size(); ++i) {
      if (is_zero_row(pattern, i)) equations.push_back(i);
    }
    RationalMatrix system;
    std::vector<std::vector<std::size_t>> targets;
    const auto add_condition = [&](const auto& entry) {  // entry(i): what row i of W gives in a direction of forces
      std::vector<Rational>& condition = system.emplace_back();
      for (const std::size_t i : equations) condition.push_back(entry(i));
      for (const std::size_t i : rows) condition.push_back(-entry(i));
    };
    for (std::size_t k = 0; k < pattern.size(); ++k) {
      const ContactState& state = pattern[k];
      const std::size_t normal = exact_.normal(k);
      if (state.kind == Kind::open) continue;
      if (state.kind == Kind::slip && exact_.dimension == 2) {
        const Rational mu = state.from.x.sign() > 0 ? Rational(-exact_.mu[k]) : exact_.mu[k];
        add_condition([&](std::size_t i) { return exact_.W[i][normal] + mu * exact_.W[i][normal + 1]; });
        continue;
      }
      const std::size_t forces = exact_.has_friction(k) ? exact_.dimension : 1;
      for (std::size_t t = 0; t < forces; ++t) {
        add_condition([&](std::size_t i) { return exact_.W[i][normal + t]; });
      }
    }
    const std::size_t unknowns = equations.size();
    RationalMatrix result(rows.size(), std::vector<Rational>(exact_.size()));
    if (!system.empty()) {
      const Echelon echelon = eliminate(system);
      if (echelon.rank(unknowns) != echelon.rank()) return {};
      for (std::size_t c = 0; c < rows.size(); ++c) {
        for (std::size_t p = 0; p < echelon.rank(); ++p) {
          result[c][equations[echelon.pivot_columns[p]]] = Rational(echelon.rows[p][unknowns + c], echelon.pivot);
        }
      }
    }
    for (std::size_t c = 0; c < rows.size(); ++c) result[c][rows[c]] = 1;
    return result;
  }

  /// Where all forces and slips of the pattern are in the neighbourhood in which its mode has this motion only.
  bool close_alone(PatternNode& node, Visit& visit, const SpatialMotion& motion) const {
    if (motion.alone.empty()) return false;
    const ModeUnknowns unknowns(exact_, motion.mode);
    for (std::size_t k = 0; k < node.pattern.size(); ++k) {
      if (node.pattern[k].kind != motion.mode[k].kind) return false;
      if (unknowns.of(k) == 4 && !arc_lies_within(node.pattern[k], motion, unknowns.first[k] + 1)) return false;
    }
    PatternProgram program(exact_, integers_, floating_, node.pattern);
    const bool closed = program.feasibility().point && lies_in_neighbourhood(node, program, motion);
    visit.programs += program.solved();
    return closed;
  }

  /// Whether all directions of an arc are in the neighbourhood: they lie in the triangle of its ends and the corner
  /// where their tangents meet.
  static bool arc_lies_within(const ContactState& arc, const SpatialMotion& motion, std::size_t d) {
    const std::array<Rational, 2> a{Rational(arc.from.x, arc.from.length), Rational(arc.from.y, arc.from.length)};
    const std::array<Rational, 2> b{Rational(arc.to.x, arc.to.length), Rational(arc.to.y, arc.to.length)};
    const Rational corner = 1 + a[0] * b[0] + a[1] * b[1];
    for (std::size_t t = 0; t < 2; ++t) {
      for (const Rational& x : {a[t], b[t], Rational((a[t] + b[t]) / corner)}) {
        if (abs(x - motion.center[d + t]) > motion.alone[d + t]) return false;
      }
    }
    return true;
  }

  bool lies_in_neighbourhood(PatternNode& node, PatternProgram& program, const SpatialMotion& motion) const {
    const ModeUnknowns unknowns(exact_, motion.mode);
    const auto bounded = [&](ContactForm form, const Rational& least) {
      std::vector<Rational> y = program.prove_least(form, least);
      return add_bound(node, std::move(form), std::move(y), least);
    };
    for (std::size_t k = 0; k < node.pattern.size(); ++k) {
      const std::size_t first = unknowns.first[k], i = exact_.normal(k);
      const bool slips = unknowns.of(k) == 4;
      for (std::size_t t = 0; t < (slips ? 1 : unknowns.of(k)); ++t) {
        const Rational &center = motion.center[first + t], &width = motion.alone[first + t];
        if (!bounded({{}, {{i + t, Rational(1)}}}, center - width)) return false;
        if (!bounded({{}, {{i + t, Rational(-1)}}}, -center - width)) return false;
      }
      if (slips &&
          !speed_lies_within(node.pattern[k], i + 1, motion.center[first + 3], motion.alone[first + 3], bounded)) {
        return false;
      }
    }
    return true;
  }

  /// With m = from + to and c = 1 + from . to, c <= d . m <= 1 + c / 2 for all d in the arc: v = u_T . d is between
  /// u_T . m / (1 + c / 2) and u_T . m / c.
  template <class Bounded>
  static bool speed_lies_within(const ContactState& arc, std::size_t i, const Rational& center, const Rational& width,
                                const Bounded& bounded) {
    const Rational a(arc.from.length), b(arc.to.length);
    const Rational x = Rational(arc.from.x) / a + Rational(arc.to.x) / b;
    const Rational y = Rational(arc.from.y) / a + Rational(arc.to.y) / b;
    const Rational c = (x * x + y * y) / 2;
    if (!bounded({{{i, -x}, {i + 1, -y}}, {}}, -(center + width) * c)) return false;
    return width >= center || bounded({{{i, x}, {i + 1, y}}, {}}, (center - width) * (1 + c / 2));
  }

  // --- splitting ---

  void split(const PatternNode& node, Visit& visit) const {
    if (visit.shrinks && cut_off(node, visit)) return;
    const auto k = contact_to_split(node.pattern, *visit.point);
    if (!k) return;
    visit.contact = *k;
    const ContactState& state = node.pattern[*k];
    if (state.kind == Kind::any) {
      split_into(node, visit, {{Kind::open, {}, {}}, {Kind::closed, {}, {}}});
    } else if (state.kind == Kind::closed) {
      std::vector<ContactState> states{{Kind::stick, {}, {}}};
      const Direction x{1, 0, 1}, y{0, 1, 1}, minus_x{-1, 0, 1}, minus_y{0, -1, 1};
      if (exact_.dimension == 2) {
        states.push_back({Kind::slip, x, x});
        states.push_back({Kind::slip, minus_x, minus_x});
      } else {
        states.push_back({Kind::slip, x, y});
        states.push_back({Kind::slip, y, minus_x});
        states.push_back({Kind::slip, minus_x, minus_y});
        states.push_back({Kind::slip, minus_y, x});
      }
      split_into(node, visit, states);
    } else {
      split_arc(node, visit, state);
    }
  }

  void split_into(const PatternNode& node, Visit& visit, const std::vector<ContactState>& states) const {
    for (const ContactState& state : states) {
      visit.children.push_back(node.pattern);
      visit.children.back()[visit.contact] = state;
    }
  }

  std::optional<std::size_t> contact_to_split(const ContactPattern& pattern, const ProposedPoint& point) const {
    std::optional<std::size_t> best;
    double most = -1;
    const auto consider = [&](std::size_t k, double worth) {
      if (worth > most) most = worth, best = k;
    };
    for (const Kind kind : {Kind::closed, Kind::any}) {
      for (std::size_t k = 0; k < pattern.size(); ++k) {
        if (pattern[k].kind == kind && !is_decided(k, pattern[k])) consider(k, violation(k, point));
      }
      if (best) return best;
    }
    for (std::size_t k = 0; k < pattern.size(); ++k) {
      if (pattern[k].kind != Kind::slip || exact_.dimension != 3) continue;
      const double width = width_of(pattern[k]);
      if (width > narrowest) consider(k, width);
    }
    return best;
  }

  /// The ends of an arc in which no motion seems to be.
  bool cut_off(const PatternNode& node, Visit& visit) const {
    visit.contact = *visit.shrinks;
    const ContactState& arc = node.pattern[visit.contact];
    const double from = arc.from.angle(), width = width_of(arc), kept = 0.03;
    std::vector<Direction> cuts;
    for (const double share : {visit.left[0] - kept, visit.left[1] + kept}) {
      if (share < 0.05 || share > 0.95) continue;
      if (const auto d = within(arc, from + share * width)) cuts.push_back(*d);
    }
    if (cuts.empty()) return false;
    split_at(node, visit, arc, cuts);
    return true;
  }

  void split_at(const PatternNode& node, Visit& visit, const ContactState& arc,
                const std::vector<Direction>& cuts) const {
    std::vector<ContactState> states;
    Direction last = arc.from;
    for (const Direction& d : cuts) {
      if (cross(last, d).sign() <= 0) continue;  // rounded to the same
      states.push_back({Kind::slip, last, d});
      last = d;
    }
    states.push_back({Kind::slip, last, arc.to});
    split_into(node, visit, states);
  }

  /// In the middle; around the direction of a known motion in three, so that it is alone in a narrow arc.
  void split_arc(const PatternNode& node, Visit& visit, const ContactState& arc) const {
    const double from = arc.from.angle(), width = width_of(arc);
    std::vector<Direction> cuts;
    for (const SpatialMotion& motion : found_.motions) {
      if (motion.mode[visit.contact].kind != Kind::slip || motion.is_exact()) continue;
      const std::size_t i = exact_.normal(visit.contact);
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
    split_at(node, visit, arc, cuts);
  }

  CompleteSolutions& found_;
  const CompleteOptions& options_;
  const ExactContacts& exact_;
  const IntegerContacts integers_;
  const FloatingContacts floating_;
};

}  // namespace

std::size_t CompleteSolutions::undecided() const {
  return static_cast<std::size_t>(std::ranges::count(nodes, PatternNode::End::undecided, &PatternNode::end));
}

bool CompleteSolutions::complete() const {
  return undecided() == 0;
}

CompleteSolutions all_solutions(const ExactContacts& contacts, const CompleteOptions& options) {
  CompleteSolutions result{ScaledContacts(contacts), {}, {}, 0};
  Search(result, options).run();
  return result;
}

}  // namespace slipproof

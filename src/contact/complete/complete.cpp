#include "contact/complete/complete.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel/in_parallel.hpp"
#include "contact/complete/motion/forces_at.hpp"
#include "contact/complete/motion/frictionless.hpp"
#include "contact/complete/motion_list.hpp"
#include "contact/complete/splitting.hpp"

namespace slipproof {

namespace {

using Kind = ContactState::Kind;
using End = PatternNode::End;

class SolutionSearch {
 public:
  SolutionSearch(CompleteSolutions& solutions, const CompleteOptions& options)
      : found_(solutions),
        options_(options),
        problem_(solutions.scaled.contacts),
        exact_(problem_.exact),
        list_(solutions) {}

  void run() {
    PatternNode root;
    root.pattern.resize(exact_.contacts());
    found_.nodes.push_back(root);
    std::vector<std::size_t> level{0};
    if (is_without_friction(std::vector<Rational>(exact_.size()))) level.clear();
    bool seeks_rest = exact_.dimension == 3;
    while (!level.empty() && found_.nodes.size() < options_.most_nodes && work_with(level.size()) <= options_.effort) {
      if (seeks_rest && found_.nodes.size() > few_nodes) seeks_rest = false, find_rest();
      const std::size_t known = found_.motions.size();
      if (options_.progress) options_.progress({found_.nodes.size(), level.size(), known});
      level = next_generation(level);
      for (std::size_t m = known; m < found_.motions.size(); ++m) {
        if (found_.motions[m].is_exact() && is_without_friction(found_.motions[m].u)) level.clear();
      }
    }
    list_.settle();
  }

 private:
  static constexpr std::size_t few_nodes = 500;

  struct Visit {
    std::size_t programs = 0;
    std::optional<ProposedPoint> point;
    std::vector<SpatialMotion> candidates;
    bool has_known = false;  ///< a candidate that was known before
    std::optional<ShrunkArc> shrunk;
    std::optional<VelocityBox> place;  ///< of its motions, if they are only near one that is known
    PatternSplit split;
  };

  /// What has been done, and what a generation would add, if its nodes are like those before.
  Work work_with(std::size_t nodes) const {
    const Work n = exact_.size(), program = 25'000 + 120 * n * n;  // in nanoseconds, about
    const std::size_t looked_at = found_.nodes.size() - nodes;
    const Work each = looked_at == 0 ? 1 : 1 + found_.programs / looked_at;
    return times(program, found_.programs + nodes * each);
  }

  /// Whether a motion with these velocities needs no friction, and is the only one; then the tree has no other node.
  bool is_without_friction(std::span<const Rational> u) {
    auto motion = motion_without_friction(exact_, u);
    if (!motion) return false;
    auto squares = squares_of(exact_.W);
    if (!squares) return false;
    found_.squares = std::move(*squares);
    found_.nodes.resize(1);
    found_.nodes[0] = {ContactPattern(exact_.contacts()), End::frictionless, {}, 0, {}, 0, 0, 0};
    list_.keep_only(std::move(*motion));
    return true;
  }

  /// Rest, where patterns become many: with several bodies the search may end before it comes to where all stick.
  void find_rest() {
    const ContactPattern pattern = rest_pattern(exact_);
    Visit visit;
    PatternProgram program(exact_, problem_.integers, problem_.floating, pattern, PatternProgram::Cones::within);
    if (program.feasibility().point) find_from(pattern, program.middle(), visit);
    visit.programs = program.solved();
    if (visit.candidates.empty()) {  // perhaps at a border of the cones, as at a threshold
      if (auto motion = rest_by_short_forces(exact_)) visit.candidates.push_back(std::move(*motion));
    }
    found_.programs += visit.programs;
    for (SpatialMotion& candidate : visit.candidates) list_.add(std::move(candidate));
  }

  /// Each node sees the motions that were known when its generation began: so threads change nothing.
  std::vector<std::size_t> next_generation(const std::vector<std::size_t>& level) {
    std::vector<Visit> visits(level.size());
    in_parallel(0, level.size(), [&](std::size_t i) { look(found_.nodes[level[i]], visits[i]); });
    for (Visit& visit : visits) {
      for (SpatialMotion& candidate : visit.candidates) list_.add(std::move(candidate));
    }
    in_parallel(0, level.size(), [&](std::size_t i) { close_or_split(found_.nodes[level[i]], visits[i]); });
    std::vector<std::size_t> next;
    for (std::size_t i = 0; i < level.size(); ++i) {
      found_.programs += visits[i].programs;
      if (visits[i].place) list_.count_as(found_.nodes[level[i]].motion, *visits[i].place);
      PatternSplit& split = visits[i].split;
      if (split.children.empty()) continue;
      PatternNode& node = found_.nodes[level[i]];
      node.end = End::split;
      node.contact = split.contact;
      node.first_child = found_.nodes.size();
      node.children = split.children.size();
      for (ContactPattern& pattern : split.children) {
        next.push_back(found_.nodes.size());
        found_.nodes.emplace_back().pattern = std::move(pattern);
      }
    }
    return next;
  }

  /// Whether a node is empty; if not, what one sees of it.
  void look(PatternNode& node, Visit& visit) const {
    PatternProgram program(exact_, problem_.integers, problem_.floating, node.pattern);
    auto [point, y] = program.feasibility();
    if (y.empty() && point) y = program.strict_multipliers(*point);
    visit.programs += program.solved();
    if (!y.empty()) {
      node.end = End::empty;
      node.y = std::move(y);
      return;
    }
    if (!point) {  // given up: split without a point
      point = ProposedPoint{std::vector<double>(exact_.size()), problem_.floating.q};
    }
    visit.point = std::move(point);
    const bool decided = is_decided(exact_, node.pattern);
    if (decided) visit.shrunk = shrink_widest_arc(node.pattern, program);
    find_from(node.pattern, *visit.point, visit);
    const bool open = std::ranges::any_of(visit.candidates, [](const auto& m) { return m.open_directions > 0; });
    const bool none = visit.candidates.empty() && !visit.has_known;
    if (decided && (none || (open && widest_arc(node.pattern) == 0))) {
      find_from(node.pattern, program.middle(), visit);
    }
    visit.programs = program.solved();
    const bool nothing = visit.candidates.empty() && !visit.has_known;
    if (decided && nothing && widest_arc(node.pattern) < 0x1p-10) find_inside(node.pattern, visit);
  }

  /// A motion whose forces are inside of the cones, though they nearly touch these.
  void find_inside(const ContactPattern& pattern, Visit& visit) const {
    PatternProgram program(exact_, problem_.integers, problem_.floating, pattern, PatternProgram::Cones::within);
    const auto point = program.feasibility().point;
    if (point) find_from(pattern, *point, visit);
    visit.programs += program.solved();
  }

  void find_from(const ContactPattern& pattern, const ProposedPoint& start, Visit& visit) const {
    const auto mode = mode_of(pattern, start);
    if (!mode) return;
    const auto is_known = [&](std::span<const double> u) { return list_.is_known(*mode, u); };
    MotionCandidate found = find_motion(exact_, problem_.floating, *mode, start, is_known);
    visit.has_known = visit.has_known || found.is_known;
    if (found.motion) visit.candidates.push_back(std::move(*found.motion));
  }

  /// The mode that a point has, if nothing is left to decide or the point is nearly a solution. A contact that slips
  /// without a force is open there, and touches.
  std::optional<ContactPattern> mode_of(const ContactPattern& pattern, const ProposedPoint& point) const {
    ContactPattern mode = pattern;
    for (std::size_t k = 0; k < mode.size(); ++k) {
      const std::size_t i = exact_.normal(k);
      const bool decided = is_decided(exact_, pattern, k), loaded = point.r[i] > 1e-7;
      if (decided && (loaded || pattern[k].kind != Kind::slip)) continue;
      if (!decided && violation(problem_.floating, k, point) > 1e-7) return std::nullopt;
      if (!loaded) {
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

  void close_or_split(PatternNode& node, Visit& visit) const {
    if (!visit.point || node.end != End::undecided) return;
    for (std::size_t m = 0; m < found_.motions.size(); ++m) {
      auto bounds = bounds_to_motion(problem_, node.pattern, found_.motions[m], visit.programs);
      if (bounds) return close(node, m, std::move(*bounds));
    }
    if (close_near(node, visit) || close_in_continuum(node, visit)) return;
    visit.split = split_pattern(exact_, problem_.floating, node.pattern, *visit.point, visit.shrunk, found_.motions);
  }

  static void close(PatternNode& node, std::size_t motion, std::vector<PatternNode::Bound>&& bounds) {
    node.end = End::motion;
    node.motion = motion;
    node.bounds = std::move(bounds);
  }

  /// Where all velocities are those of a known motion, nearly.
  bool close_near(PatternNode& node, Visit& visit) const {
    if (!is_decided(exact_, node.pattern)) return false;
    const Rational distance = power_of_two(-MotionList::near_bits);
    for (std::size_t m = 0; m < found_.motions.size(); ++m) {
      const SpatialMotion& motion = found_.motions[m];
      if (!motion.alone.is_zero() || !is_near(motion, *visit.point)) continue;
      const VelocityBox limits = VelocityBox::of(motion).widened(distance);
      auto bounded = bound_velocities(problem_, node.pattern, &limits, visit.programs);
      if (!bounded) continue;
      visit.place = std::move(bounded->box);
      close(node, m, std::move(bounded->bounds));
      return true;
    }
    return false;
  }

  bool is_near(const SpatialMotion& motion, const ProposedPoint& point) const {
    for (std::size_t i = 0; i < point.u.size(); ++i) {
      if (std::abs(motion.u[i].to_double() - point.u[i]) > std::ldexp(1.0, -MotionList::near_bits)) return false;
    }
    return true;
  }

  /// Where velocities are those of a continuum of motions, nearly, and nothing but narrow arcs is left to split.
  bool close_in_continuum(PatternNode& node, Visit& visit) const {
    const double width = widest_arc(node.pattern);
    if (!is_decided(exact_, node.pattern) || width > std::ldexp(1.0, -MotionList::continuum_bits)) return false;
    std::optional<BoundedVelocities> bounded;
    for (std::size_t m = 0; m < found_.motions.size(); ++m) {
      const SpatialMotion& motion = found_.motions[m];
      if (motion.open_directions == 0 || !list_.is_in_continuum(m)) continue;
      if (!bounded) bounded = bound_velocities(problem_, node.pattern, nullptr, visit.programs);
      if (!bounded) return false;
      if (!list_.place(m).widened(power_of_two(-MotionList::continuum_bits)).contains(bounded->box)) continue;
      visit.place = std::move(bounded->box);
      close(node, m, std::move(bounded->bounds));
      return true;
    }
    return false;
  }

  double widest_arc(const ContactPattern& pattern) const {
    double width = 0;
    for (const ContactState& state : pattern) {
      if (state.kind == Kind::slip && exact_.dimension == 3) width = std::max(width, state.width());
    }
    return width;
  }

  CompleteSolutions& found_;
  const CompleteOptions& options_;
  const SearchProblem problem_;
  const ExactContacts& exact_;
  MotionList list_;
};

}  // namespace

std::size_t CompleteSolutions::undecided() const {
  return static_cast<std::size_t>(std::ranges::count(nodes, PatternNode::End::undecided, &PatternNode::end));
}

bool CompleteSolutions::complete() const {
  return undecided() == 0;
}

CompleteSolutions all_solutions(const ExactContacts& contacts, const CompleteOptions& options) {
  CompleteSolutions result{ScaledContacts(contacts), {}, {}, {}, {}, 0};
  SolutionSearch(result, options).run();
  return result;
}

}  // namespace slipproof

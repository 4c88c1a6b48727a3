#include "contact/complete/complete.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel/in_parallel.hpp"
#include "contact/complete/closing.hpp"
#include "contact/complete/splitting.hpp"

namespace slipproof {

namespace {

using Kind = ContactState::Kind;
using End = PatternNode::End;

class SolutionSearch {
 public:
  SolutionSearch(CompleteSolutions& solutions, const CompleteOptions& options)
      : found_(solutions), options_(options), problem_(solutions.scaled.contacts), exact_(problem_.exact) {}

  void run() {
    PatternNode root;
    root.pattern.resize(exact_.contacts());
    found_.nodes.push_back(root);
    std::vector<std::size_t> level{0};
    while (!level.empty() && found_.nodes.size() < options_.most_nodes && work_with(level.size()) <= options_.effort) {
      level = next_generation(level);
    }
  }

 private:
  struct Visit {
    std::size_t programs = 0;
    std::optional<ProposedPoint> point;
    std::optional<SpatialMotion> candidate;
    std::optional<ShrunkArc> shrunk;
    PatternSplit split;
  };

  /// What has been done, and what a generation would add, if its nodes are like those before.
  Work work_with(std::size_t nodes) const {
    const Work n = exact_.size(), program = 50'000 + 500 * n * n;  // in nanoseconds, about
    const std::size_t looked_at = found_.nodes.size() - nodes;
    const Work each = looked_at == 0 ? 1 : 1 + found_.programs / looked_at;
    return times(program, found_.programs + nodes * each);
  }

  /// Each node sees the motions that were known when its generation began: so threads change nothing.
  std::vector<std::size_t> next_generation(const std::vector<std::size_t>& level) {
    std::vector<Visit> visits(level.size());
    in_parallel(0, level.size(), [&](std::size_t i) { look(found_.nodes[level[i]], visits[i]); });
    for (Visit& visit : visits) {
      if (visit.candidate) add(std::move(*visit.candidate));
    }
    in_parallel(0, level.size(), [&](std::size_t i) { close_or_split(found_.nodes[level[i]], visits[i]); });
    std::vector<std::size_t> next;
    for (std::size_t i = 0; i < level.size(); ++i) {
      found_.programs += visits[i].programs;
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
    const auto mode = mode_of(node.pattern, *visit.point);
    if (!mode) return;
    const bool decided = *mode == node.pattern;
    if (decided) visit.shrunk = shrink_an_arc(node.pattern, program);
    visit.candidate = find_motion(exact_, problem_.floating, *mode, *visit.point);
    if (!visit.candidate && decided) {
      visit.candidate = find_motion(exact_, problem_.floating, *mode, program.middle());
    }
    visit.programs = program.solved();
  }

  /// The mode that a point has, if nothing is left to decide or the point is nearly a solution.
  std::optional<ContactPattern> mode_of(const ContactPattern& pattern, const ProposedPoint& point) const {
    ContactPattern mode = pattern;
    for (std::size_t k = 0; k < mode.size(); ++k) {
      if (is_decided(exact_, pattern, k)) continue;
      if (violation(problem_.floating, k, point) > 1e-7) return std::nullopt;
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

  /// Motions that may be the same are one.
  void add(SpatialMotion&& motion) {
    const auto is_same = [&](const SpatialMotion& known) {
      for (std::size_t i = 0; i < exact_.size(); ++i) {
        if (abs(known.u[i] - motion.u[i]) > known.u_radius[i] + motion.u_radius[i]) return false;
      }
      return true;
    };
    if (std::ranges::none_of(found_.motions, is_same)) found_.motions.push_back(std::move(motion));
  }

  void close_or_split(PatternNode& node, Visit& visit) const {
    if (!visit.point || node.end != End::undecided) return;
    for (std::size_t m = 0; m < found_.motions.size(); ++m) {
      auto bounds = bounds_to_motion(problem_, node.pattern, found_.motions[m], visit.programs);
      if (!bounds) continue;
      node.end = End::motion;
      node.motion = m;
      node.bounds = std::move(*bounds);
      return;
    }
    visit.split = split_pattern(exact_, problem_.floating, node.pattern, *visit.point, visit.shrunk, found_.motions);
  }

  CompleteSolutions& found_;
  const CompleteOptions& options_;
  const SearchProblem problem_;
  const ExactContacts& exact_;
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
  SolutionSearch(result, options).run();
  return result;
}

}  // namespace slipproof

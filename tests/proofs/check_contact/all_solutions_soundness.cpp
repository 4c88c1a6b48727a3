// Lists of all solutions of problems whose solutions are known: what is accepted is true of them.
#include <map>
#include <set>

#include "proofs/check_contact/examples.hpp"
#include "proofs/check_contact/known_problems.hpp"

using namespace slipproof::check_contact;

namespace {

/// A tree of which only the multipliers of the leaves are missing.
struct Tree {
  struct Leaf {
    std::string before;  ///< the text up to its multipliers
    std::size_t node;
    bool holds = false;  ///< whether there is a solution in it that the list does not have
    std::string y;       ///< of `known`
  };
  std::vector<Leaf> leaves;
  std::string text;  ///< after the last leaf
  std::size_t nodes = 0;

  void split(const std::string& node) { text += node, ++nodes; }
  void add_leaf(const std::string& node, bool holds, const std::string& y = "") {
    leaves.push_back({text + node, nodes++, holds, y});
    text.clear();
  }
};

std::string random_multipliers(std::size_t n) {
  Numbers y;
  const int scale = 1 + below(2);
  for (std::size_t i = 0; i < n; ++i) {
    mpq_class& x = y.emplace_back(from_to(-3, 3), scale);
    x.canonicalize();
  }
  return listed(y);
}

/// Looks for multipliers of each leaf in turn, at random: a rejection names the first one that has none. Returns the
/// last verdict.
std::string search(const std::string& header, Tree& tree, std::size_t n, int tries, std::map<bool, int>& tried) {
  for (auto& leaf : tree.leaves) {
    if (leaf.y.empty() && leaf.before.ends_with("empty")) leaf.y = random_multipliers(n);
  }
  std::string found;
  for (std::size_t i = 0; i < tree.leaves.size(); ++i) {
    for (int k = 0; k < tries; ++k) {
      std::string text = header;
      for (const auto& leaf : tree.leaves) text += leaf.before + leaf.y;
      found = verdict(text + tree.text + " end");
      CAPTURE(text);
      REQUIRE(!found.starts_with("unreadable: "));
      const bool here = found.starts_with("rejected: node " + std::to_string(tree.leaves[i].node) + ":");
      ++tried[tree.leaves[i].holds];
      if (tree.leaves[i].holds) REQUIRE(here);
      if (!here) break;
      if (!tree.leaves[i].before.ends_with("empty") || k + 1 == tries) return found;
      tree.leaves[i].y = random_multipliers(n);
    }
  }
  return found;
}

constexpr std::array<std::array<int, 2>, 4> kQuarters{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// Decides contact k and those after it; `holds`: the solution is in the pattern so far.
void add_cases(Tree& tree, const Solved& problem, std::size_t k, bool holds) {
  if (k == problem.contacts) return tree.add_leaf(" empty", holds);
  const auto first = static_cast<std::ptrdiff_t>(problem.free + problem.dimension * k);
  const auto dimension = static_cast<std::ptrdiff_t>(problem.dimension);
  const Numbers r(problem.x.begin() + first, problem.x.begin() + first + dimension);
  Numbers u(problem.w.begin() + first, problem.w.begin() + first + dimension);
  u.resize(3);
  const bool open = u[0] > 0, sticks = !open && u[1] == 0 && u[2] == 0, slips = !open && !sticks;
  const std::string contact = std::to_string(k);
  tree.split(" decide " + contact);
  add_cases(tree, problem, k + 1, holds && open);
  if (problem.dimension == 1) return add_cases(tree, problem, k + 1, holds && !open);
  tree.split(" slips " + contact + (problem.dimension == 3 ? " 4 1 0 0 1 -1 0 0 -1" : ""));
  add_cases(tree, problem, k + 1, holds && sticks);
  if (problem.dimension == 2) {
    for (const int d : {1, -1}) add_cases(tree, problem, k + 1, holds && slips && d * u[1] > 0);
    return;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const auto &a = kQuarters[i], &b = kQuarters[(i + 1) % 4];
    const bool within = a[0] * u[1] + a[1] * u[2] >= 0 && b[0] * u[1] + b[1] * u[2] >= 0;
    add_cases(tree, problem, k + 1, holds && slips && within);
  }
}

/// A pattern of a small problem, in which forces are multiples of `force` or anything (both rows of u are 0).
struct SmallCase {
  std::vector<std::size_t> zero_rows, others;
  Numbers force;
  std::string first, second;  ///< its mode; in the plane `second` means nothing
};

/// Whether a solution does.
bool lies_in(const Small& problem, const SmallCase& pattern, const Numbers& x) {
  const Numbers u = problem.motion(x);
  for (const std::size_t i : pattern.zero_rows) {
    if (u[i] != 0) return false;
  }
  if (problem.planar && !pattern.others.empty())
    return pattern.zero_rows.empty() ? u[0] > 0 : u[1] * pattern.force[1] < 0;
  return std::all_of(pattern.others.begin(), pattern.others.end(), [&](std::size_t i) { return u[i] > 0; });
}

/// y at the row that is 0 such that what y and h make of forces does not matter.
void balance(const Small& problem, const SmallCase& pattern, const Numbers& h, Numbers& y) {
  const auto along = [&](const Numbers& row) {
    return mpq_class(row[0] * pattern.force[0] + row[1] * pattern.force[1]);
  };
  mpq_class rest = along(h);
  for (std::size_t i = 0; i < 2; ++i) rest += y[i] * along(problem.A[i]);
  for (const std::size_t z : pattern.zero_rows) y[z] -= rest / along(problem.A[z]);
}

/// That determine u in a pattern: y_i = 1.
std::string determining(const Small& problem, const SmallCase& pattern) {
  std::string result;
  for (const std::size_t i : pattern.others) {
    for (const int side : {1, -1}) {
      Numbers y(2);
      y[i] = side;
      balance(problem, pattern, {0, 0}, y);
      result += listed(y);
    }
  }
  return result;
}

std::vector<Numbers> inverse(const std::vector<Numbers>& A) {
  const mpq_class det = A[0][0] * A[1][1] - A[0][1] * A[1][0];
  return {{A[1][1] / det, -A[0][1] / det}, {-A[1][0] / det, A[0][0] / det}};
}

/// A motion in a box of its mode, alone there, and the multipliers that keep r of its pattern in it. Empty at the
/// border of the mode.
struct Boxed {
  std::string motion, multipliers;

  Boxed(const Small& problem, const SmallCase& pattern, const Numbers& x) {
    const Numbers u = problem.motion(x);
    const bool both = pattern.zero_rows.size() == 2;
    mpq_class room = problem.planar && both ? mpq_class(x[0] - abs(x[1])) : mpq_class(1);
    for (const std::size_t i : pattern.others) room = std::min<mpq_class>(room, abs(u[i]));
    std::vector<std::size_t> unknowns = pattern.zero_rows;
    if (problem.planar && !unknowns.empty()) unknowns = {0, 1};
    for (const std::size_t j : unknowns) {
      if (j == 0 || !problem.planar) room = std::min(room, x[j]);
    }
    if (room <= 0) return;
    const mpq_class radius = room / 16;
    const std::vector<Numbers> whole = inverse(problem.equations(pattern.first, pattern.second).first);
    Numbers center, radii;
    std::vector<Numbers> R;
    for (const std::size_t j : unknowns) {
      center.emplace_back(x[j] + radius * from_to(-4, 4) / 4);
      radii.push_back(radius);
      R.emplace_back();
      for (const std::size_t i : unknowns) R.back().push_back(whole[j][i]);
      for (const int side : {1, -1}) multipliers += listed(holding(problem, pattern, j, side));
    }
    motion = " motion box modes " + pattern.first + (problem.planar ? "" : " " + pattern.second) + " center" +
             listed(center) + " radius" + listed(radii) + " pinned 0 dropped 0 inverse " + listed(R) + " alone " +
             std::to_string(from_to(1, 3));
  }

 private:
  static Numbers holding(const Small& problem, const SmallCase& pattern, std::size_t j, int side) {
    Numbers y(2), h(2);
    h[j] = side;
    if (pattern.zero_rows.size() == 1) {
      balance(problem, pattern, h, y);
    } else {
      for (std::size_t i = 0; i < 2; ++i) y[i] = -side * inverse(problem.A)[j][i];
    }
    return y;
  }
};

const std::vector<SmallCase> kPlanar{{{}, {0, 1}, {0, 0}, "open", "stick"},
                                     {{0, 1}, {}, {0, 0}, "stick", "stick"},
                                     {{0}, {1}, {1, -1}, "slide+", "stick"},
                                     {{0}, {1}, {1, 1}, "slide-", "stick"}};
const std::vector<SmallCase> kNormal{{{}, {0, 1}, {0, 0}, "open", "open"},
                                     {{1}, {0}, {0, 1}, "open", "stick"},
                                     {{0}, {1}, {1, 0}, "stick", "open"},
                                     {{0, 1}, {}, {0, 0}, "stick", "stick"}};

bool is_near(const Numbers& u, const Numbers& v, const mpq_class& distance) {
  return abs(u[0] - v[0]) <= distance && abs(u[1] - v[1]) <= distance;
}

/// A list of the motions of a small problem, without one of them every other time.
struct Told {
  struct Motion {
    Numbers u;
    std::string multipliers;  ///< if it is in a box
    mpq_class within;         ///< otherwise
  };
  const Small& problem;
  const std::vector<SmallCase>& cases;
  const std::vector<Numbers>& solutions;
  std::vector<Motion> motions;
  std::set<Numbers> all;  ///< by their velocities
  std::string list;

  Told(const Small& small, const std::vector<Numbers>& points)
      : problem(small), cases(small.planar ? kPlanar : kNormal), solutions(points) {
    const auto omitted = static_cast<std::size_t>(below(2) == 0 ? below(3) : 9);
    for (const Numbers& x : solutions) {
      if (all.insert(problem.motion(x)).second && all.size() != omitted + 1) tell(x);
    }
  }

  void add_leaf(Tree& tree, const SmallCase& pattern) const {
    const auto x = std::find_if(solutions.begin(), solutions.end(),
                                [&](const Numbers& point) { return lies_in(problem, pattern, point); });
    if (x == solutions.end()) return tree.add_leaf(" empty", false);
    const Numbers u = problem.motion(*x);
    const auto own = std::find_if(motions.begin(), motions.end(), [&](const Motion& motion) { return motion.u == u; });
    auto m = static_cast<std::size_t>(own - motions.begin());
    if (!motions.empty() && (own == motions.end() || below(3) == 0)) {  // may be near another
      const auto other = static_cast<std::size_t>(below(static_cast<int>(motions.size())));
      if (motions[other].multipliers.empty()) m = other;
    }
    if (m == motions.size()) return tree.add_leaf(" empty", true);
    const bool holds = !is_near(u, motions[m].u, motions[m].within);
    const std::string& y = motions[m].multipliers;
    tree.add_leaf(" known " + std::to_string(m), holds, y.empty() ? determining(problem, pattern) : y);
  }

  /// Of what is accepted, how far motions are from the list.
  mpq_class reach() const {
    mpq_class result;
    for (const Motion& motion : motions) result = std::max(result, motion.within);
    return result;
  }

  std::string established() const {
    const std::string count = std::to_string(motions.size()) + " motions and";
    const bool one = motions.size() == 1;
    if (reach() > 0) return "at least " + (one ? "one motion, and" : replaced(count, " and", ", and"));
    return motions.empty() ? "no motion at all" : one ? "one motion and no other" : count + " no others";
  }

 private:
  void tell(const Numbers& x) {
    Motion& motion = motions.emplace_back(Motion{problem.motion(x), {}, 0});
    const auto pattern =
        std::find_if(cases.begin(), cases.end(), [&](const SmallCase& c) { return lies_in(problem, c, x); });
    const Boxed boxed(problem, *pattern, x);
    if (below(2) == 0 && !boxed.multipliers.empty()) {
      list += boxed.motion, motion.multipliers = boxed.multipliers;
      return;
    }
    list += " motion exact" + listed(x);
    if (below(3) > 0) return;
    motion.within = from_to(1, 4);
    list += " within" + listed({motion.within, motion.within});
  }
};

}  // namespace

TEST_CASE("all solutions: a case with a solution in it is never empty") {
  std::map<bool, int> tried;
  for (int i = 0; i < 1'500; ++i) {
    const Solved problem = random_solved();
    if (problem.free > 0 && problem.A[0][0] == 0) continue;
    const std::size_t n = problem.dimension * problem.contacts;
    std::string header = problem.header(problem.x) + " all-solutions 0";
    if (problem.free > 0) header += " eliminated 1 0 0" + listed({1 / problem.A[0][0]});
    Tree tree;
    add_cases(tree, problem, 0, true);
    CHECK(search(header, tree, n, 20, tried).starts_with("rejected: node "));
  }
  CHECK(tried[true] > 5'000);  // forgeries
  CHECK(tried[false] > 5'000);
}

TEST_CASE("all solutions: those that are told are all, and a list without one of them is rejected") {
  std::map<std::string, int> accepted;
  std::map<bool, int> tried;
  for (int i = 0; i < 2'000; ++i) {
    Small problem{below(2) == 0, {}, {from_to(-4, 4), from_to(-4, 4)}};
    for (int row = 0; row < 2; ++row) problem.A.push_back({from_to(-3, 3), from_to(-3, 3)});
    bool complete = false;
    const auto solutions = problem.solutions(complete);
    if (!complete) continue;
    const Told told(problem, solutions);
    Tree tree;
    tree.split(" decide 0");
    if (!problem.planar) tree.split(" decide 1");
    for (std::size_t c = 0; c < 4; ++c) {
      if (problem.planar ? c == 1 : c == 2) tree.split(problem.planar ? " slips 0" : " decide 1");
      told.add_leaf(tree, told.cases[c]);
    }
    const std::string header = std::string("slipproof-contact 1 dimension ") +
                               (problem.planar ? "2 free 0 contacts 1 mu 1" : "1 free 0 contacts 2 mu 0 0") +
                               " matrix " + listed(problem.A) + " constant" + listed(problem.c) +
                               " no-answer all-solutions " + std::to_string(told.motions.size()) + told.list;
    const std::string found = search(header, tree, 2, 100, tried);
    CAPTURE(header);
    CHECK(!found.starts_with("rejected: motion"));
    if (!found.starts_with("accepted: ")) continue;
    for (const Numbers& u : told.all) {
      CHECK(std::any_of(told.motions.begin(), told.motions.end(),
                        [&](const auto& motion) { return is_near(u, motion.u, told.reach()); }));
    }
    CHECK(found.starts_with("accepted: " + told.established()));
    ++accepted[told.reach() > 0 ? "near" : told.motions.size() < 2 ? told.established() : "several"];
    accepted["in a box"] += told.list.find("box") != std::string::npos ? 1 : 0;
    accepted["without one"] += told.motions.size() < told.all.size() ? 1 : 0;
  }
  CHECK(accepted.size() == 6);
  for (const auto& [kind, count] : accepted) CHECK_MESSAGE(count > 10, kind);
  CHECK(tried[true] > 5'000);
}

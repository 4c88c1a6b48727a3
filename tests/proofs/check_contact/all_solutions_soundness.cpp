// Lists of all solutions of problems whose solutions are known: what is accepted is true of them.
#include <map>

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
      if (tree.leaves[i].before.ends_with("empty")) tree.leaves[i].y = random_multipliers(n);
      if (k + 1 == tries) return found;
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
  const bool open = r[0] == 0, sticks = !open && u[1] == 0 && u[2] == 0, slips = !open && !sticks;
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
};

bool lies_in(const Small& problem, const SmallCase& pattern, const Numbers& x) {
  if (pattern.zero_rows.empty()) return x[0] == 0 && x[1] == 0;
  const Numbers u = problem.motion(x);
  for (const std::size_t i : pattern.zero_rows) {
    if (u[i] != 0) return false;
  }
  if (pattern.others.empty()) return x[0] > 0 && (problem.planar || x[1] > 0);
  const auto& s = pattern.force;
  if (s[0] * x[1] != s[1] * x[0] || s[0] * x[0] + s[1] * x[1] <= 0) return false;
  return !problem.planar || u[1] * x[1] < 0;
}

/// That determine u in a pattern: y_i = 1, and y at the row that is 0 such that forces do not matter.
std::string determining(const Small& problem, const SmallCase& pattern) {
  std::string result;
  for (const std::size_t i : pattern.others) {
    Numbers y(2);
    y[i] = 1;
    const auto along = [&](std::size_t row) {
      return mpq_class(problem.A[row][0] * pattern.force[0] + problem.A[row][1] * pattern.force[1]);
    };
    for (const std::size_t z : pattern.zero_rows) y[z] = -along(i) / along(z);
    result += listed(y);
    for (mpq_class& a : y) a = -a;
    result += listed(y);
  }
  return result;
}

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
  std::map<std::size_t, int> accepted;
  std::map<bool, int> tried;
  for (int i = 0; i < 1'500; ++i) {
    Small problem{below(2) == 0, {}, {from_to(-4, 4), from_to(-4, 4)}};
    for (int row = 0; row < 2; ++row) problem.A.push_back({from_to(-3, 3), from_to(-3, 3)});
    bool complete = false;
    const auto solutions = problem.solutions(complete);
    if (!complete) continue;
    std::map<Numbers, std::size_t> motions;  // by their velocities
    std::string list;
    std::vector<Numbers> points;
    const std::size_t omitted = below(2) == 0 ? static_cast<std::size_t>(below(3)) : 9;
    for (const Numbers& x : solutions) {
      if (!motions.emplace(problem.motion(x), motions.size()).second || motions.size() == omitted + 1) continue;
      list += " motion exact" + listed(x);
    }
    const bool all = omitted >= motions.size();
    const auto place = [&](std::size_t m) { return std::to_string(m > omitted ? m - 1 : m); };
    Tree tree;
    const auto add = [&](const SmallCase& pattern) {
      for (const Numbers& x : solutions) {
        if (!lies_in(problem, pattern, x)) continue;
        const std::size_t m = motions.at(problem.motion(x));
        if (m == omitted) return tree.add_leaf(" empty", true);
        return tree.add_leaf(" known " + place(m), false, determining(problem, pattern));
      }
      tree.add_leaf(" empty", false);
    };
    tree.split(" decide 0");
    if (problem.planar) {
      add({{}, {0, 1}, {0, 0}});
      tree.split(" slips 0");
      add({{0, 1}, {}, {0, 0}});
      add({{0}, {1}, {1, -1}});
      add({{0}, {1}, {1, 1}});
    } else {
      tree.split(" decide 1");
      add({{}, {0, 1}, {0, 0}});
      add({{1}, {0}, {0, 1}});
      tree.split(" decide 1");
      add({{0}, {1}, {1, 0}});
      add({{0, 1}, {}, {0, 0}});
    }
    const std::string header = std::string("slipproof-contact 1 dimension ") +
                               (problem.planar ? "2 free 0 contacts 1 mu 1" : "1 free 0 contacts 2 mu 0 0") +
                               " matrix " + listed(problem.A) + " constant" + listed(problem.c) +
                               " no-answer all-solutions " + std::to_string(motions.size() - (all ? 0 : 1)) + list;
    const std::string found = search(header, tree, 2, 100, tried);
    CAPTURE(header);
    CHECK((all || found.starts_with("rejected: node ")));
    if (!found.starts_with("accepted: ")) continue;
    ++accepted[motions.size()];
    const std::string count = motions.empty()       ? "no motion at all"
                              : motions.size() == 1 ? "one motion and no other"
                                                    : std::to_string(motions.size()) + " motions and no others";
    CHECK(found.starts_with("accepted: " + count));
  }
  for (std::size_t count = 0; count <= 3; ++count) CHECK(accepted[count] > 10);
  CHECK(tried[true] > 5'000);
}

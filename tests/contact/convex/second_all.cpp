// Lists of all solutions in the second reading: the motions, and the tree of cases.
#include <array>
#include <functional>
#include <optional>

#include "contact/convex/second_enclosure.hpp"

namespace slipproof::test::second {

namespace {

using Point = std::array<Q, 2>;

/// Of a contact: any, open, closed, stick, slip, slip+, slip-.
struct Case {
  std::string name = "any";
  Point a, b;
};

Q dot(const Point& x, const Point& y) {
  return x[0] * y[0] + x[1] * y[1];
}
Q cross(const Point& x, const Point& y) {
  return x[0] * y[1] - x[1] * y[0];
}

struct Listed {
  std::optional<Box> box;  ///< otherwise exact
  std::optional<Q> alone;
  Vec r, within;
  std::vector<Interval> u;
};

class All {
 public:
  All(const Certificate& problem, Words& words)
      : given_(problem), words_(words), n_(problem.D * problem.K), pattern_(problem.K) {
    p_.D = problem.D, p_.K = problem.K, p_.n = n_, p_.mu = problem.mu;
    p_.c.resize(n_);
    p_.A.assign(n_, Vec(n_));
    read();
  }

 private:
  bool rubs(std::size_t k) const { return p_.D > 1 && p_.mu[k] != 0; }
  std::size_t row(std::size_t k) const { return p_.D * k; }

  /// What is wrong first waits until all is read.
  void when_read(const std::function<void()>& check) {
    if (no_) return;
    try {
      check();
    } catch (const No& why) {
      no_ = why;
    }
  }

  void read() {
    const std::size_t M = words_.count(100000000);
    Mat B;
    if (given_.F > 0) {
      words_.expect("eliminated");
      B = words_.entries(given_.F, given_.F);
    }
    when_read([&] { need(given_.law == "coulomb", "law"), eliminate(B); });
    for (std::size_t m = 0; m < M; ++m) read_motion();
    read_node();
    if (no_) throw No(*no_);
  }

  /// Leaves w = W r + q. Velocities for no force, and for each force of 1, give q and the columns of W.
  void eliminate(const Mat& B) {
    const std::size_t F = given_.F;
    for (std::size_t i = 0; i < F; ++i) {
      for (std::size_t j = 0; j < F; ++j) {
        Q sum;
        for (std::size_t k = 0; k < F; ++k) sum += B[i][k] * given_.A[k][j];
        need(sum == (i == j ? 1 : 0), "inverse");
      }
    }
    const auto velocities = [&](std::size_t j) {
      Vec x(given_.n);
      if (j < n_) x[F + j] = 1;
      const Vec w = given_.motion(x);
      for (std::size_t i = 0; i < F; ++i) {
        for (std::size_t k = 0; k < F; ++k) x[i] -= B[i][k] * w[k];
      }
      const Vec all = given_.motion(x);
      for (std::size_t i = 0; i < F; ++i) need(all[i] == 0, "free row");
      return Vec(all.begin() + static_cast<std::ptrdiff_t>(F), all.end());
    };
    p_.c = velocities(n_);
    for (std::size_t j = 0; j < n_; ++j) {
      const Vec u = velocities(j);
      for (std::size_t i = 0; i < n_; ++i) p_.A[i][j] = u[i] - p_.c[i];
    }
  }

  void read_motion() {
    words_.expect("motion");
    Listed& m = motions_.emplace_back();
    m.u.resize(n_);
    m.within.resize(n_);
    if (words_.take("exact")) {
      m.r = words_.numbers(n_);
    } else {
      words_.expect("box");
      m.box.emplace(p_, words_, false);
      if (words_.take("alone")) m.alone = words_.number();
    }
    if (!m.alone && words_.take("within")) m.within = words_.numbers(n_);
    when_read([&] {
      need(!m.alone || (*m.alone >= 1 && m.box->pinned.empty()), "alone");
      for (const Q& e : m.within) need(e >= 0, "within");
      check_motion(m);
    });
  }

  void check_motion(Listed& m) const {
    if (m.box) m.box->check(m.alone.value_or(0));
    const Vec u = m.box ? Vec() : p_.motion(m.r);
    for (std::size_t k = 0; k < p_.K && !m.box; ++k) need(lawful(p_, k, m.r, u), "motion");
    for (std::size_t i = 0; i < n_; ++i) m.u[i] = m.box ? m.box->w(i) : Interval{u[i], u[i]};
  }

  /// Reads a child, in which contact k is in another state.
  void read_child(std::size_t k, const Case& state) {
    const Case before = pattern_[k];
    pattern_[k] = state;
    read_node();
    pattern_[k] = before;
  }

  void read_node() {
    const std::string word = words_.next();
    if (word == "empty") return read_empty();
    if (word == "known") return read_known();
    if (word == "frictionless") return read_frictionless();
    if (word != "decide" && word != "slips" && word != "arcs") throw Garbled();
    const std::size_t k = words_.count(p_.K);
    if (word == "decide") {
      when_read([&] { need(pattern_[k].name == "any", "decided"); });
      read_child(k, {"open", {}, {}});
      read_child(k, {"closed", {}, {}});
      return;
    }
    const bool slips = word == "slips";
    when_read([&] { need(slips ? pattern_[k].name == "closed" && rubs(k) : pattern_[k].name == "slip", "state"); });
    std::vector<Point> points;
    if (!slips || p_.D == 3) {
      for (std::size_t left = words_.count(100000000); left > 0; --left) {
        const Q x = words_.number(), y = words_.number();
        points.push_back({x, y});
        when_read([&] { need(x * x + y * y == 1, "length"); });
      }
    }
    if (slips) {
      when_read([&] { need(p_.D < 3 || points.size() > 2, "few arcs"); });
      read_child(k, {"stick", {}, {}});
      if (p_.D < 3) {
        read_child(k, {"slip+", {}, {}});
        read_child(k, {"slip-", {}, {}});
      }
      if (!points.empty()) points.push_back(points.front());
    } else {
      points.insert(points.begin(), pattern_[k].a);
      points.push_back(pattern_[k].b);
    }
    for (std::size_t i = 1; i < points.size(); ++i) {
      when_read([&] { need(cross(points[i - 1], points[i]) > 0, "arc"); });
      read_child(k, {"slip", points[i - 1], points[i]});
    }
  }

  /// What is proved of f . u + h . r; whether it is more than that.
  std::pair<Q, bool> proved(const Vec& f, const Vec& h, const Vec& y) const {
    bool more = false;
    Q value;
    Vec v = f, g = h;
    for (std::size_t i = 0; i < n_; ++i) {
      value += y[i] * p_.c[i];
      v[i] -= y[i];
      for (std::size_t j = 0; j < n_; ++j) g[j] += p_.A[i][j] * y[i];
    }
    for (std::size_t k = 0; k < p_.K; ++k) {
      const std::size_t i = row(k);
      Point vT, gT;
      for (std::size_t t = 1; t < p_.D; ++t) vT[t - 1] = v[i + t], gT[t - 1] = g[i + t];
      const Case& c = pattern_[k];
      const Q &m = p_.mu[k], &N = g[i];
      const bool slips = c.name.rfind("slip", 0) == 0;
      if (c.name == "any" || c.name == "open") need(v[i] >= 0, "v");
      if (!slips && c.name != "stick") need(vT[0] == 0 && vT[1] == 0, "v");
      more = more || (c.name == "open" && v[i] > 0);
      const Q room = N * N - m * m * dot(gT, gT);
      if (!slips && c.name != "open") need(N >= 0 && room >= 0, "g");
      if (!slips) continue;
      const Point one = c.name == "slip-" ? Point{-1, 0} : Point{1, 0};
      const Point &a = c.name == "slip" ? c.a : one, &b = c.name == "slip" ? c.b : one;
      need(dot(vT, a) >= 0 && dot(vT, b) >= 0, "v");
      more = more || (dot(vT, a) > 0 && dot(vT, b) > 0);
      // g_T = alpha a + beta b by Cramer's rule: both are positive in the cone of the arc.
      const Q area = cross(a, b);
      const bool within = area != 0 && cross(gT, b) / area > 0 && cross(a, gT) / area > 0;
      const Q at_a = N - m * dot(gT, a), at_b = N - m * dot(gT, b);
      need(within ? N >= 0 && room >= 0 : at_a >= 0 && at_b >= 0, "g");
    }
    return {value, more};
  }

  void read_empty() {
    const Vec y = words_.numbers(n_);
    when_read([&] {
      const auto [value, more] = proved(Vec(n_), Vec(n_), y);
      need(more ? value >= 0 : value > 0, "empty");
    });
  }

  /// That f . u + h . r >= least.
  using Entries = std::vector<std::pair<std::size_t, Q>>;
  void read_bound(const Entries& f, const Entries& h, const Q& least) {
    const Vec y = words_.numbers(n_);
    when_read([&] {
      Vec of_u(n_), of_r(n_);
      for (const auto& [i, a] : f) of_u[i] = a;
      for (const auto& [i, a] : h) of_r[i] = a;
      need(proved(of_u, of_r, y).first >= least, "bound");
    });
  }

  void read_known() {
    const Listed& m = motions_[words_.count(motions_.size())];
    if (m.alone) return read_mode(m);
    for (std::size_t i = 0; i < n_; ++i) {
      const Q low = m.u[i].low - m.within[i], high = m.u[i].high + m.within[i];
      const std::string& state = pattern_[i / p_.D].name;
      if (state == "stick" || (i % p_.D == 0 && state != "any" && state != "open")) {
        when_read([&] { need(low <= 0 && high >= 0, "row"); });
        continue;
      }
      read_bound({{i, 1}}, {}, low);
      read_bound({{i, -1}}, {}, -high);
    }
  }

  /// The motion is the one of its mode.
  void read_mode(const Listed& m) {
    const Box& box = *m.box;
    const auto around = [&](std::size_t j, int side) { return Q(box.z[j] + side * *m.alone * box.radius[j]); };
    for (std::size_t k = 0; k < p_.K; ++k) {
      const std::string& mode = box.mode[k];
      const std::string state = mode.rfind("slide", 0) == 0   ? "slip" + mode.substr(5)
                                : mode == "stick" && !rubs(k) ? "closed"
                                                              : mode;
      when_read([&] { need(pattern_[k].name == state, "mode"); });
      for (std::size_t i = row(k); i < row(k + 1); ++i) {
        if (box.at[i] == none) continue;
        read_bound({}, {{i, 1}}, around(box.at[i], -1));
        read_bound({}, {{i, -1}}, -around(box.at[i], 1));
      }
      if (mode != "slide") continue;
      const Point &a = pattern_[k].a, &b = pattern_[k].b;
      const std::size_t i = row(k);
      const Q x = a[0] + b[0], y = a[1] + b[1], c = 1 + dot(a, b), m = p_.mu[k];
      read_bound({{i + 1, -x}, {i + 2, -y}}, {{i, around(box.slip[k], 1) * m * c}}, 0);
      read_bound({{i + 1, x}, {i + 2, y}}, {{i, -around(box.slip[k], -1) * m * (1 + c / 2)}}, 0);
    }
  }

  /// W = L^T D L, and a motion that does without friction.
  void read_frictionless() {
    const Listed& m = motions_[words_.count(motions_.size())];
    Vec d;
    Mat L;
    for (std::size_t left = words_.count(100000000); left > 0; --left) {
      d.push_back(words_.number());
      L.push_back(words_.numbers(n_));
    }
    when_read([&] {
      need(!m.box, "box");
      for (std::size_t k = 0; k < p_.K; ++k) {
        for (std::size_t i = row(k) + 1; i < row(k + 1); ++i)
          need(m.r[i] == 0 && (!rubs(k) || m.u[i].low == 0), "rubs");
      }
      for (const Q& factor : d) need(factor >= 0, "factor");
      for (std::size_t i = 0; i < n_; ++i) {
        for (std::size_t j = 0; j < n_; ++j) {
          Q sum;
          for (std::size_t s = 0; s < d.size(); ++s) sum += d[s] * L[s][i] * L[s][j];
          need(sum == p_.A[i][j], "squares");
        }
      }
    });
  }

  const Certificate& given_;
  Certificate p_;  ///< without free unknowns
  Words& words_;
  std::size_t n_;
  std::vector<Listed> motions_;
  std::vector<Case> pattern_;
  std::optional<No> no_;
};

}  // namespace

void all_solutions(const Certificate& p, Words& words) {
  All(p, words);
}

}  // namespace slipproof::test::second

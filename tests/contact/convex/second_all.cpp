// Lists of all solutions in the second reading: the tree of cases.
#include "contact/convex/second_motions.hpp"

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

class All : Motions {
 public:
  All(const Certificate& problem, Words& words) : Motions(problem, words) { read(); }

 private:
  void read() {
    const std::size_t M = words_.count(100000000);
    Mat B;
    if (p_.F > 0) {
      words_.expect("eliminated");
      B = words_.entries(p_.F, p_.F);
    }
    when_read([&] { need(p_.law == "coulomb", "law"), eliminate(B); });
    for (std::size_t m = 0; m < M; ++m) read_motion();
    pattern_.resize(p_.K);
    read_node();
    if (no_) throw No(*no_);
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
      value += y[i] * q_[i];
      v[i] -= y[i];
      for (std::size_t j = 0; j < n_; ++j) g[j] += W_[i][j] * y[i];
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
      const Q room = N * N - m * m * dot(gT, gT);
      if (c.name == "any" || c.name == "closed" || c.name == "stick") {
        need(N >= 0 && room >= 0, "g");
        more = more || (c.name != "any" && N > 0 && room > 0);
      }
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
      more = more || (within ? N > 0 && room > 0 : at_a > 0 && at_b > 0);
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

  /// The form has entries f for u and h for r.
  using Entries = std::vector<std::pair<std::size_t, Q>>;
  void read_bound(const std::function<std::pair<Entries, Q>()>& bound, bool of_forces) {
    const Vec y = words_.numbers(n_);
    when_read([&] {
      const auto [entries, least] = bound();
      Vec form(n_);
      for (const auto& [i, a] : entries) form[i] = a;
      need((of_forces ? proved(Vec(n_), form, y) : proved(form, Vec(n_), y)).first >= least, "bound");
    });
  }

  void read_known() {
    const std::size_t which = words_.count(motions_.size());
    const Listed& m = motions_[which];
    for (std::size_t i = 0; i < n_ && m.exact; ++i) {
      const std::string& state = pattern_[i / p_.D].name;
      const bool zero = state == "stick" || (i % p_.D == 0 && state != "any" && state != "open");
      if (zero) when_read([&] { need(m.u[i].low == 0, "row"); });
      for (int sign = 1; !zero && sign >= -1; sign -= 2) {
        read_bound([&] { return std::pair(Entries{{i, sign}}, Q(sign * m.u[i].low)); }, false);
      }
    }
    if (m.exact) return;
    when_read([&] { need(m.alone(), "alone"); });
    for (std::size_t k = 0; k < p_.K; ++k) {
      const std::string& mode = m.modes[k];
      const std::string& state = pattern_[k].name;
      when_read([&] { need(state == (mode.rfind("slide", 0) == 0 ? "slip" + mode.substr(5) : mode), "mode"); });
      const std::size_t f = m.first[k], i = row(k);
      const std::size_t own = mode == "open" ? 0 : mode == "stick" ? p_.D : 1;
      for (std::size_t t = 0; t < own; ++t) {
        read_bound([&] { return std::pair(Entries{{i + t, 1}}, Q(m.z[f + t] - m.P[f + t])); }, true);
        read_bound([&] { return std::pair(Entries{{i + t, -1}}, Q(-m.z[f + t] - m.P[f + t])); }, true);
      }
      if (mode != "slide") continue;
      const Point a = pattern_[k].a, b = pattern_[k].b, sum{a[0] + b[0], a[1] + b[1]};
      const Q c = 1 + dot(a, b), v = m.z[f + 3], P = m.P[f + 3];
      when_read([&] {
        for (std::size_t t = 0; t < 2; ++t) {
          for (const Q& x : {a[t], b[t], Q(sum[t] / c)}) need(absolute(x - m.z[f + 1 + t]) <= m.P[f + 1 + t], "arc");
        }
      });
      read_bound([&] { return std::pair(Entries{{i + 1, -sum[0]}, {i + 2, -sum[1]}}, Q(-(v + P) * c)); }, false);
      read_bound([&] { return std::pair(Entries{{i + 1, sum[0]}, {i + 2, sum[1]}}, Q((v - P) * (1 + c / 2))); }, false);
    }
  }

  std::vector<Case> pattern_;
};

}  // namespace

void all_solutions(const Certificate& p, Words& words) {
  All(p, words);
}

}  // namespace slipproof::test::second

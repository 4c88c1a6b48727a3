#include "contact/convex/second_reading.hpp"

#include <algorithm>
#include <optional>

#include "contact/convex/second_words.hpp"

namespace slipproof::test {

namespace second {

struct Pair {
  Q N, uN;
  Vec r, u;  // tangential
};

Pair pair_at(const Certificate& p, std::size_t k, const Vec& x, const Vec& w) {
  const std::size_t first = p.F + p.D * k;
  Pair result{x[first], w[first], {}, {}};
  for (std::size_t i = 1; i < p.D; ++i) {
    result.r.push_back(x[first + i]);
    result.u.push_back(w[first + i]);
  }
  return result;
}

/// r . u = -limit |u|, with |r| <= limit: the most that friction can dissipate (Cauchy and Schwarz).
bool dissipates_most(const Pair& c, const Q& limit) {
  const Q work = dot(c.r, c.u);
  return dot(c.r, c.r) <= limit * limit && work <= 0 && work * work == limit * limit * dot(c.u, c.u);
}

bool lawful(const Certificate& p, std::size_t k, const Vec& x, const Vec& w) {
  const Pair c = pair_at(p, k, x, w);
  const Q m = p.mu[k], limit = m * c.N, speed2 = dot(c.u, c.u);
  if (c.N < 0 || c.uN < 0) return false;
  if (p.law == "associated") {
    const bool cones = dot(c.r, c.r) <= limit * limit && m * m * speed2 <= c.uN * c.uN;
    return cones && c.N * c.uN + dot(c.r, c.u) == 0;
  }
  if (c.N != 0 && c.uN != 0) return false;
  if (p.law == "coulomb") return dissipates_most(c, limit);
  if (p.law == "diamond") {
    Q size, least = 0;
    for (std::size_t i = 0; i < c.r.size(); ++i) {
      size += absolute(c.r[i]);
      least = std::min({least, Q(limit * c.u[i]), Q(-limit * c.u[i])});  // the corners of the pyramid
    }
    return size <= limit && dot(c.r, c.u) == least;
  }
  if (p.law == "box" || p.law == "fixed") {
    Q work, most;
    for (std::size_t i = 0; i < c.r.size(); ++i) {
      const Q b = p.law == "box" ? limit : p.bounds[(p.D - 1) * k + i];
      if (absolute(c.r[i]) > b) return false;
      work += c.r[i] * c.u[i];
      most += b * absolute(c.u[i]);
    }
    return work == -most;  // so each of them is
  }
  const Q v2 = p.slip_speed * p.slip_speed;
  if (p.law == "linear" && speed2 <= v2) {
    for (std::size_t i = 0; i < c.r.size(); ++i) {
      if (c.r[i] * p.slip_speed != -limit * c.u[i]) return false;
    }
    return true;
  }
  if (p.law == "linear") return dissipates_most(c, limit) && dot(c.r, c.r) == limit * limit;
  const Q work = dot(c.r, c.u), root2 = v2 + speed2;  // soft: r root = -limit u
  return work <= 0 && work * work * root2 == limit * limit * speed2 * speed2 &&
         dot(c.r, c.r) * root2 == limit * limit * speed2;
}

void eps(const Certificate& p, Words& words) {
  const Q bound = words.number(), moved = words.number();
  const Vec point = words.named("point", p.n), motion = words.named("motion", p.n);
  need(p.has_answer && bound >= 0 && moved >= 0, "answer");
  const Vec w = p.motion(point);
  for (std::size_t i = 0; i < p.n; ++i) {
    need(i >= p.F || motion[i] == 0, "free row");
    need(absolute(motion[i] - w[i]) <= bound && absolute(point[i] - p.x[i]) <= moved, "bound");
  }
  for (std::size_t k = 0; k < p.K; ++k) need(lawful(p, k, point, motion), "law");
}

void every(const Certificate& p, Words& words) {
  const Q rho = words.number(), eta = words.number();
  const Vec d = words.named("moduli", p.n);
  words.expect("factor");
  const Mat L = words.entries(p.n, p.n);
  const Vec point = words.named("point", p.n), motion = words.named("motion", p.n);
  const Vec shares = words.named("shares", p.n), gaps = words.named("gaps", p.K);
  words.expect("energy");
  const Q S = words.number();
  const Vec radii = words.named("radii", p.n);
  need(p.has_answer && rho >= 0 && eta >= 0 && S >= 0, "answer");
  bool symmetric = true;
  for (std::size_t i = 0; i < p.n; ++i) {  // A + A^T - 2 D - L L^T, by Gershgorin
    Q excess;
    need(d[i] >= 0, "modulus");
    for (std::size_t j = 0; j < p.n; ++j) {
      need(j <= i || L[i][j] == 0, "above the diagonal");
      symmetric = symmetric && p.A[i][j] == p.A[j][i];
      Q s = p.A[i][j] + p.A[j][i] - (i == j ? Q(2 * d[i]) : Q(0));
      for (std::size_t k = 0; k <= std::min(i, j); ++k) s -= L[i][k] * L[j][k];
      excess += i == j ? s : Q(-absolute(s));
    }
    need(excess >= 0, "semidefinite");
  }
  const Vec w = p.motion(point), own = p.motion(p.x);
  Q squares, missing;
  for (std::size_t i = 0; i < p.n; ++i) {
    const Q rest = w[i] - motion[i];
    need(shares[i] >= 0 && rest * rest <= d[i] * shares[i] * shares[i], "share");
    need(i >= p.F || motion[i] == 0, "free row");
    squares += shares[i] * shares[i];
  }
  for (std::size_t k = 0; k < p.K; ++k) {
    const Pair c = pair_at(p, k, point, motion);
    const Q limit = p.mu[k] * c.N;
    Q gap = c.N * c.uN + dot(c.r, c.u);
    need(c.N >= 0 && c.uN >= 0, "normal");
    if (p.law == "associated") {
      need(dot(c.r, c.r) <= limit * limit && p.mu[k] * p.mu[k] * dot(c.u, c.u) <= c.uN * c.uN, "cones");
    } else if (p.law == "fixed") {
      for (std::size_t i = 0; i < c.r.size(); ++i) {
        const Q b = p.bounds[(p.D - 1) * k + i];
        need(absolute(c.r[i]) <= b, "bound");
        gap += b * absolute(c.u[i]);
      }
    } else {
      need(p.mu[k] == 0 && dot(c.r, c.r) == 0, "friction");
    }
    need(gaps[k] >= 0 && gap <= gaps[k], "gap");
    missing += gaps[k];
  }
  // e . A e <= missing + sqrt(squares) sqrt(e . A e) holds up to S
  need(S * S >= missing && (S * S - missing) * (S * S - missing) >= S * S * squares, "energy");
  for (std::size_t i = 0; i < p.n; ++i) {
    if (d[i] == 0) continue;
    need(radii[i] >= 0 && radii[i] * radii[i] * d[i] >= S * S, "radius");
    need(absolute(point[i] - p.x[i]) + radii[i] <= rho, "rho");
  }
  for (std::size_t i = p.F; i < p.n; ++i) {
    const Q left = eta - absolute(w[i] - own[i]);
    need(left >= 0, "eta");
    if (symmetric && p.A[i][i] * S * S <= left * left) continue;
    Q reach;
    for (std::size_t j = 0; j < p.n; ++j) {
      need(p.A[i][j] == 0 || d[j] > 0, "open");
      reach += absolute(p.A[i][j]) * radii[j];
    }
    need(reach <= left, "eta");
  }
}

void read_mirrored(Certificate& p, Words& words) {
  const std::size_t turned = words.count(p.n + 1);
  p.A.assign(p.n, Vec(p.n));
  for (std::size_t i = 0; i < p.n; ++i) {
    std::set<std::size_t> seen;
    for (std::size_t left = words.count(i + 2); left > 0; --left) {
      const std::size_t j = words.count(i + 1);
      if (!seen.insert(j).second) throw Garbled();
      p.A[i][j] = p.A[j][i] = words.number();
      if (j < turned && turned <= i) p.A[j][i] *= -1;
    }
  }
}

Certificate read_problem(Words& words) {
  Certificate p;
  words.expect("slipproof-contact");
  words.expect("1");
  if (words.take("problem")) words.next();
  words.expect("dimension");
  p.D = words.count(4);
  if (p.D == 0) throw Garbled();
  words.expect("free");
  p.F = words.count(10000);
  words.expect("contacts");
  p.K = words.count(10000);
  p.n = p.F + p.D * p.K;
  p.mu = words.named("mu", p.K);
  if (words.take("mirrored")) {
    read_mirrored(p, words);
  } else {
    words.expect("matrix");
    p.A = words.entries(p.n, p.n);
  }
  p.c = words.named("constant", p.n);
  if (words.take("law")) {
    p.law = words.next();
    if (p.law == "fixed") p.bounds = words.numbers((p.D - 1) * p.K);
    if (p.law == "regularised") {
      p.law = words.next();
      if (p.law != "linear" && p.law != "soft") throw Garbled();
      p.slip_speed = words.number();
    } else if (p.law != "fixed" && p.law != "associated" && p.law != "box" && p.law != "diamond") {
      throw Garbled();
    }
  }
  p.has_answer = !words.take("no-answer");
  if (p.has_answer) p.x = words.named("answer", p.n);
  return p;
}

void check_numbers(const Certificate& p) {
  for (const Q& m : p.mu) need(m >= 0 && (p.D > 1 || m == 0), "mu");
  for (const Q& b : p.bounds) need(b >= 0, "bounds");
  need((p.law != "linear" && p.law != "soft") || p.slip_speed > 0, "slip speed");
  need(p.D > 1 || p.law == "coulomb", "law");
}

}  // namespace second

std::string second_reading(const std::string& text) {
  try {
    second::Words words(text);
    const second::Certificate p = second::read_problem(words);
    std::optional<second::No> no;
    bool any = false;
    while (!words.is("end")) {
      any = true;
      try {
        if (words.take("eps")) {
          second::eps(p, words);
        } else if (words.take("enclosure")) {
          second::enclosure(p, words, false);
        } else if (words.take("ball")) {
          second::enclosure(p, words, true);
        } else if (words.take("every-solution")) {
          second::every(p, words);
        } else if (words.take("all-solutions")) {
          second::all_solutions(p, words);
        } else {
          return "unreadable";
        }
      } catch (const second::No& why) {
        no = why;
      }
    }
    words.expect("end");
    if (!any || !words.at_end()) return "unreadable";
    if (no) return "rejected: " + no->why;
    second::check_numbers(p);
    return "accepted";
  } catch (const second::No& no) {
    return "rejected: " + no.why;
  } catch (const second::Garbled&) {
    return "unreadable";
  }
}

}  // namespace slipproof::test

#include "contact/convex/second_reading.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <vector>

namespace slipproof::test {

namespace second {

using Q = mpq_class;
using Vec = std::vector<Q>;
using Mat = std::vector<Vec>;  // dense

constexpr std::size_t none = static_cast<std::size_t>(-1);

struct No {
  std::string why;
};
struct Garbled {};

void need(bool holds, const char* why) {
  if (!holds) throw No{why};
}

Q power_of_two(long e) {
  mpz_class two = 1;
  two <<= static_cast<mp_bitcnt_t>(std::labs(e));
  return e < 0 ? Q(1, two) : Q(two);
}

bool only(const std::string& text, const char* allowed) {
  return !text.empty() && text.find_first_not_of(allowed) == std::string::npos;
}

Q to_number(std::string text) {
  const bool minus = text[0] == '-';
  if (minus) text.erase(0, 1);
  if (text.size() > 5000) throw Garbled();
  Q value;
  if (text.rfind("0x", 0) == 0) {
    const std::size_t p = text.find('p');
    if (p == std::string::npos) throw Garbled();
    std::string digits = text.substr(2, p - 2), power = text.substr(p + 1);
    long places = 0;
    if (const std::size_t dot = digits.find('.'); dot != std::string::npos) {
      places = static_cast<long>(digits.size() - dot - 1);
      if (dot == 0 || places == 0) throw Garbled();
      digits.erase(dot, 1);
    }
    const bool down = !power.empty() && power[0] == '-';
    if (down || (!power.empty() && power[0] == '+')) power.erase(0, 1);
    if (!only(digits, "0123456789abcdef") || !only(power, "0123456789") || power.size() > 6) throw Garbled();
    if (std::stol(power) > 5000) throw Garbled();
    value = Q(mpz_class(digits, 16)) * power_of_two((down ? -1 : 1) * std::stol(power) - 4 * places);
  } else {
    const std::size_t slash = text.find('/');
    const std::string over = text.substr(0, slash), under = slash == std::string::npos ? "1" : text.substr(slash + 1);
    if (!only(over, "0123456789") || !only(under, "0123456789") || mpz_class(under) == 0) throw Garbled();
    value = Q(mpz_class(over), mpz_class(under));
    value.canonicalize();
  }
  return minus ? Q(-value) : value;
}

class Words {
 public:
  explicit Words(const std::string& text) {
    for (const char c : text) {
      if (c != ' ' && c != '\t' && c != '\n' && (c < ' ' || c > '~')) throw Garbled();
    }
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line.substr(0, line.find('#')));
      for (std::string word; words >> word;) words_.push_back(word);
    }
  }
  std::string next() {
    if (at_ == words_.size()) throw Garbled();
    return words_[at_++];
  }
  bool is(const std::string& word) const { return at_ < words_.size() && words_[at_] == word; }
  bool take(const std::string& word) {
    if (!is(word)) return false;
    ++at_;
    return true;
  }
  void expect(const std::string& word) {
    if (!take(word)) throw Garbled();
  }
  bool at_end() const { return at_ == words_.size(); }
  Q number() { return to_number(next()); }
  std::size_t count(std::size_t end) {
    const std::string word = next();
    if (!only(word, "0123456789") || word.size() > 9) throw Garbled();
    const std::size_t value = std::stoul(word);
    if (value >= end) throw Garbled();
    return value;
  }
  Vec numbers(std::size_t n) {
    if (n > words_.size()) throw Garbled();
    Vec result;
    for (std::size_t i = 0; i < n; ++i) result.push_back(number());
    return result;
  }
  Vec named(const std::string& name, std::size_t n) {
    expect(name);
    return numbers(n);
  }
  Mat entries(std::size_t rows, std::size_t columns) {
    Mat result(rows, Vec(columns));
    std::set<std::pair<std::size_t, std::size_t>> seen;
    for (std::size_t left = count(words_.size()); left > 0; --left) {
      const std::size_t i = count(rows), j = count(columns);
      if (!seen.emplace(i, j).second) throw Garbled();
      result[i][j] = number();
    }
    return result;
  }

 private:
  std::vector<std::string> words_;
  std::size_t at_ = 0;
};

struct Certificate {
  std::size_t D = 0, F = 0, K = 0, n = 0;
  Vec mu, c, x, bounds;
  Mat A;
  std::string law = "coulomb";
  Q slip_speed;
  bool has_answer = false;

  Vec motion(const Vec& at) const {
    Vec w = c;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        if (A[i][j] != 0) w[i] += A[i][j] * at[j];
      }
    }
    return w;
  }
};

Q absolute(const Q& x) {
  return x < 0 ? Q(-x) : x;
}

Q dot(const Vec& a, const Vec& b) {
  Q sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

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

/// value + slope . d + quadratic terms with |.| <= rest.
struct Form {
  Q value;
  Vec slope;
  Q rest;
  bool linear = true;
};

void enclosure(const Certificate& p, Words& words, bool ball) {
  const Q rho = words.number();
  words.expect("modes");
  std::vector<std::string> mode;
  std::vector<std::size_t> at(p.n, none), unknowns_of(p.K), slip(p.K);
  std::size_t N = 0;
  for (std::size_t j = 0; j < p.F; ++j) at[j] = N++;
  for (std::size_t k = 0; k < p.K; ++k) {
    mode.push_back(words.next());
    const std::string& s = mode.back();
    const bool rubs = p.D > 1 && p.mu[k] != 0, plus = s == "slide+" || s == "slide-";
    const bool face = s.size() == 7 && s.rfind("slide", 0) == 0 && only(s.substr(5), "+-0") && s != "slide00";
    const bool space = p.D == 3 && (p.law == "box" ? face : s == "slide");
    if (s != "open" && s != "stick" && !(rubs && (space || (p.D == 2 && plus)))) throw Garbled();
    unknowns_of[k] = s == "open" ? 0 : rubs ? p.D : 1;
    for (std::size_t t = 0; t < unknowns_of[k]; ++t) at[p.F + p.D * k + t] = N++;
    if (s == "slide") slip[k] = N++;
  }
  const Vec z = words.named("center", N);
  Vec radius = words.named("radius", N);
  words.expect("pinned");
  std::set<std::size_t> pinned;
  for (std::size_t left = words.count(N + 1); left > 0; --left) {
    if (!pinned.insert(words.count(N)).second) throw Garbled();
  }
  words.expect("dropped");
  std::map<std::size_t, std::map<std::size_t, Q>> dropped;
  for (std::size_t left = words.count(N + 1); left > 0; --left) {
    const std::size_t row = words.count(N);
    if (dropped.count(row) > 0) throw Garbled();
    auto& combination = dropped[row];
    for (std::size_t more = words.count(N + 1); more > 0; --more) {
      const std::size_t i = words.count(N);
      if (combination.count(i) > 0) throw Garbled();
      combination[i] = words.number();
    }
  }
  const std::size_t M = N - pinned.size(), equations = N - dropped.size();
  Vec D;
  Q least_singular, defect, bend;
  if (ball) {
    D = words.named("rows", equations);
    words.expect("least");
    least_singular = words.number();
    words.expect("defect");
    defect = words.number();
    words.expect("bend");
    bend = words.number();
  }
  words.expect(ball ? "factor" : "inverse");
  const Mat R = words.entries(M, ball ? M : equations);
  need(p.has_answer && rho >= 0, "answer");
  need(p.law == "coulomb" || p.law == "associated" || p.law == "box", "law");
  // The sign with which a contact slides in direction t, from 1; 0 where it does not.
  const auto slides = [&](std::size_t k, std::size_t t) {
    const std::string& s = mode[k];
    return s.size() < 5 + t || s[4 + t] == '0' ? 0 : s[4 + t] == '+' ? 1 : -1;
  };
  for (const Q& r : radius) need(r > 0, "radius");
  for (const std::size_t j : pinned) radius[j] = 0;
  const auto row = [&](std::size_t i) {
    Form f{p.c[i], Vec(N), 0};
    for (std::size_t j = 0; j < p.n; ++j) {
      if (at[j] == none || p.A[i][j] == 0) continue;
      f.value += p.A[i][j] * z[at[j]];
      f.slope[at[j]] += p.A[i][j];
    }
    return f;
  };
  const auto add_product = [&](Form& f, const Q& factor, std::size_t a, std::size_t b) {
    f.value += factor * z[a] * z[b];
    f.slope[a] += factor * z[b];
    f.slope[b] += factor * z[a];
    f.rest += absolute(factor) * radius[a] * radius[b];
    f.linear = false;
  };
  std::vector<Form> F;
  for (std::size_t i = 0; i < p.F; ++i) F.push_back(row(i));
  for (std::size_t k = 0; k < p.K; ++k) {
    const std::size_t first = p.F + p.D * k;
    const Q m = p.mu[k];
    if (mode[k] == "open") continue;
    Form normal = row(first);
    const bool opens = p.law == "associated";
    if (mode[k] == "slide" && opens) add_product(normal, -m * m, slip[k], at[first]);
    if (slides(k, 1) != 0 && opens) {
      const Form along = row(first + 1);
      const Q sign = -slides(k, 1);
      normal.value += sign * m * along.value;
      for (std::size_t j = 0; j < N; ++j) normal.slope[j] += sign * m * along.slope[j];
    }
    F.push_back(normal);
    if (mode[k] == "stick") {
      for (std::size_t t = 1; t < unknowns_of[k]; ++t) F.push_back(row(first + t));
    } else if (mode[k] == "slide") {
      for (std::size_t t = 1; t < 3; ++t) {
        F.push_back(row(first + t));
        add_product(F.back(), 1, slip[k], at[first + t]);
      }
      Form cone{0, Vec(N), 0};
      const std::size_t n = at[first];
      add_product(cone, 1, n + 1, n + 1);
      add_product(cone, 1, n + 2, n + 2);
      const Q up = cone.rest;
      cone.rest = 0;
      add_product(cone, -m * m, n, n);
      cone.rest = std::max(up, cone.rest);
      F.push_back(cone);
    } else {
      for (std::size_t t = 1; t < p.D; ++t) {
        const Q sign = slides(k, t);
        Form edge{0, Vec(N), 0};
        edge.value = z[at[first] + t] + sign * m * z[at[first]];
        edge.slope[at[first] + t] = 1;
        edge.slope[at[first]] = sign * m;
        F.push_back(sign == 0 ? row(first + t) : edge);
      }
    }
  }
  need(pinned.size() == dropped.size(), "not square");
  for (const auto& [i, combination] : dropped) {
    Form f = F[i];
    need(f.linear, "dropped");
    for (const auto& [j, q] : combination) {
      need(dropped.count(j) == 0 && F[j].linear, "combination");
      f.value -= q * F[j].value;
      for (std::size_t l = 0; l < N; ++l) f.slope[l] -= q * F[j].slope[l];
    }
    need(f.value == 0, "combination at the center");
    for (std::size_t l = 0; l < N; ++l) need(f.slope[l] == 0 || pinned.count(l) > 0, "combination in a column");
  }
  std::vector<std::size_t> kept, left;
  for (std::size_t i = 0; i < N; ++i) {
    if (dropped.count(i) == 0) kept.push_back(i);
    if (pinned.count(i) == 0) left.push_back(i);
  }
  if (ball) {  // as if with the inverse of D J P: |y| <= 1 is mapped into itself
    Q defects, bends;
    Mat rows(M, Vec(M));
    for (std::size_t i = 0; i < M; ++i) {
      const Form& f = F[kept[i]];
      defects += D[i] * D[i] * f.value * f.value;
      bends += D[i] * D[i] * f.rest * f.rest;
      for (std::size_t j = 0; j < M; ++j) rows[i][j] = D[i] * f.slope[left[j]] * radius[left[j]];
    }
    need(least_singular > 0 && defect >= 0 && bend >= 0 && defect + bend <= least_singular, "ball");
    need(defects <= defect * defect && bends <= bend * bend, "defect or bend");
    for (std::size_t i = 0; i < M; ++i) {
      Q excess;
      for (std::size_t j = 0; j < M; ++j) {
        Q g = i == j ? Q(-least_singular * least_singular) : Q(0);
        for (std::size_t k = 0; k < M; ++k) g += rows[k][i] * rows[k][j] - R[i][k] * R[j][k];
        excess += i == j ? g : Q(-absolute(g));
      }
      need(excess >= 0, "least singular value");
    }
  }
  for (std::size_t a = 0; a < left.size() && !ball; ++a) {
    Q shift, rest, spread;
    for (std::size_t b = 0; b < kept.size(); ++b) {
      shift += R[a][b] * F[kept[b]].value;
      rest += absolute(R[a][b]) * F[kept[b]].rest;
    }
    for (const std::size_t l : left) {
      Q entry = l == left[a] ? 1 : 0;
      for (std::size_t b = 0; b < kept.size(); ++b) entry -= R[a][b] * F[kept[b]].slope[l];
      spread += absolute(entry) * radius[l];
    }
    need(spread < radius[left[a]] && absolute(shift) + spread + rest <= radius[left[a]], "contraction");
  }
  const auto reach = [&](const Form& f) {
    Q sum;
    for (std::size_t j = 0; j < N; ++j) sum += absolute(f.slope[j]) * radius[j];
    return sum;
  };
  for (std::size_t k = 0; k < p.K; ++k) {
    const std::size_t first = p.F + p.D * k;
    const Q m = p.mu[k];
    if (mode[k] == "open") {
      const Form f = row(first);
      const Q least = f.value - reach(f);
      need(least >= 0, "opens");
      Q square;
      for (std::size_t t = 1; t < p.D && p.law == "associated"; ++t) {
        const Form u = row(first + t);
        square += (absolute(u.value) + reach(u)) * (absolute(u.value) + reach(u));
      }
      need(m * m * square <= least * least, "opens");
      continue;
    }
    const Q least = z[at[first]] - radius[at[first]];
    need(least >= 0, "presses");
    if (mode[k] == "slide") {
      need(z[slip[k]] >= radius[slip[k]], "slips");
      continue;
    }
    Q square, largest;
    for (std::size_t t = 1; t < unknowns_of[k]; ++t) {
      if (slides(k, t) == 0) {
        const Q most = absolute(z[at[first] + t]) + radius[at[first] + t];
        square += most * most;
        largest = std::max(largest, most);
      } else {
        const Form u = row(first + t);
        need(slides(k, t) * u.value >= reach(u), "slips");
      }
    }
    need(p.law == "box" ? largest <= m * least : square <= m * m * least * least || mode[k] != "stick", "inside");
  }
  for (std::size_t i = 0; i < p.n; ++i) {
    const Q away = at[i] == none ? absolute(p.x[i]) : Q(absolute(z[at[i]] - p.x[i]) + radius[at[i]]);
    need(away <= rho, "distance");
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
  words.expect("matrix");
  p.A = words.entries(p.n, p.n);
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

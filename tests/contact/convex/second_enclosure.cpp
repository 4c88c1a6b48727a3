// Enclosures and balls in the second reading.
#include "contact/convex/second_enclosure.hpp"

#include <algorithm>

namespace slipproof::test::second {

Box::Box(const Certificate& problem, Words& words, bool ball)
    : at(problem.n, none), slip(problem.K), p_(problem), ball_(ball), unknowns_of_(problem.K) {
  words.expect("modes");
  read_modes(words);
  z = words.named("center", N_);
  radius = words.named("radius", N_);
  words.expect("pinned");
  for (std::size_t left = words.count(N_ + 1); left > 0; --left) {
    if (!pinned.insert(words.count(N_)).second) throw Garbled();
  }
  read_dropped(words);
  for (std::size_t i = 0; i < N_; ++i) {
    if (dropped_.count(i) == 0) kept_.push_back(i);
    if (pinned.count(i) == 0) left_.push_back(i);
  }
  if (ball) {
    rows_ = words.named("rows", kept_.size());
    words.expect("least");
    least_singular_ = words.number();
    words.expect("defect");
    defect_ = words.number();
    words.expect("bend");
    bend_ = words.number();
  }
  if (ball && words.take("order")) {
    read_order(words);
    return;
  }
  words.expect(ball ? "factor" : "inverse");
  R_ = words.entries(left_.size(), ball ? left_.size() : kept_.size());
}

void Box::read_order(Words& words) {
  grid_ = words.count(5000);
  std::set<std::size_t> seen;
  while (order_.size() < left_.size()) {
    order_.push_back(words.count(left_.size()));
    if (!seen.insert(order_.back()).second) throw Garbled();
  }
}

void Box::read_modes(Words& words) {
  for (std::size_t j = 0; j < p_.F; ++j) at[j] = N_++;
  for (std::size_t k = 0; k < p_.K; ++k) {
    const std::string& s = mode.emplace_back(words.next());
    const bool rubs = p_.D > 1 && p_.mu[k] != 0, plus = s == "slide+" || s == "slide-";
    const bool face = s.size() == 7 && s.rfind("slide", 0) == 0 && only(s.substr(5), "+-0") && s != "slide00";
    const bool space = p_.D == 3 && (p_.law == "box" ? face : s == "slide");
    if (s != "open" && s != "touch" && s != "stick" && !(rubs && (space || (p_.D == 2 && plus)))) throw Garbled();
    unknowns_of_[k] = s == "open" ? 0 : rubs && s != "touch" ? p_.D : 1;
    for (std::size_t t = 0; t < unknowns_of_[k]; ++t) at[p_.F + p_.D * k + t] = N_++;
    if (s == "slide") slip[k] = N_++;
  }
}

void Box::read_dropped(Words& words) {
  words.expect("dropped");
  for (std::size_t left = words.count(N_ + 1); left > 0; --left) {
    const auto [row, is_new] = dropped_.try_emplace(words.count(N_));
    if (!is_new) throw Garbled();
    for (std::size_t more = words.count(N_ + 1); more > 0; --more) {
      const auto [term, is_first] = row->second.try_emplace(words.count(N_));
      if (!is_first) throw Garbled();
      term->second = words.number();
    }
  }
}

void Box::check(const Q& alone) {
  need(p_.law == "coulomb" || p_.law == "associated" || p_.law == "box", "law");
  for (const Q& r : radius) need(r > 0, "radius");
  for (const std::size_t j : pinned) radius[j] = 0;
  list_equations();
  need(pinned.size() == dropped_.size(), "not square");
  check_dropped();
  if (ball_) {
    check_ball();
  } else {
    check_inverse(alone);
  }
  for (std::size_t k = 0; k < p_.K; ++k) check_contact(k);
}

Interval Box::x(std::size_t i) const {
  if (at[i] == none) return {};
  return {z[at[i]] - radius[at[i]], z[at[i]] + radius[at[i]]};
}
Interval Box::w(std::size_t i) const {
  const Form f = row(i);
  return {f.value - reach(f), f.value + reach(f)};
}

Form Box::row(std::size_t i) const {
  Form f{p_.c[i], Vec(N_), 0};
  for (std::size_t j = 0; j < p_.n; ++j) {
    if (at[j] == none || p_.A[i][j] == 0) continue;
    f.value += p_.A[i][j] * z[at[j]];
    f.slope[at[j]] += p_.A[i][j];
  }
  return f;
}
Q Box::reach(const Form& f) const {
  Q sum;
  for (std::size_t j = 0; j < N_; ++j) sum += absolute(f.slope[j]) * radius[j];
  return sum;
}

/// The sign with which a contact slides in direction t, from 1; 0 where it does not.
int Box::slides(std::size_t k, std::size_t t) const {
  const std::string& s = mode[k];
  return s.size() < 5 + t || s[4 + t] == '0' ? 0 : s[4 + t] == '+' ? 1 : -1;
}

void Box::add_product(Form& f, const Q& factor, std::size_t a, std::size_t b) const {
  f.value += factor * z[a] * z[b];
  f.slope[a] += factor * z[b];
  f.slope[b] += factor * z[a];
  f.rest += absolute(factor) * radius[a] * radius[b];
  f.linear = false;
}

void Box::list_equations() {
  for (std::size_t i = 0; i < p_.F; ++i) F_.push_back(row(i));
  for (std::size_t k = 0; k < p_.K; ++k) {
    if (mode[k] == "open") continue;
    const std::size_t first = p_.F + p_.D * k;
    const Q m = p_.mu[k];
    Form normal = row(first);
    const bool opens = p_.law == "associated";
    if (mode[k] == "slide" && opens) add_product(normal, -m * m, slip[k], at[first]);
    if (slides(k, 1) != 0 && opens) {
      const Form along = row(first + 1);
      const Q sign = -slides(k, 1);
      normal.value += sign * m * along.value;
      for (std::size_t j = 0; j < N_; ++j) normal.slope[j] += sign * m * along.slope[j];
    }
    F_.push_back(normal);
    list_friction(k);
  }
}

void Box::list_friction(std::size_t k) {
  const std::size_t first = p_.F + p_.D * k, n = at[first];
  const Q m = p_.mu[k];
  for (std::size_t t = 1; t < unknowns_of_[k]; ++t) {
    const Q sign = slides(k, t);
    Form edge{z[n + t] + sign * m * z[n], Vec(N_), 0};
    edge.slope[n + t] = 1;
    edge.slope[n] = sign * m;
    F_.push_back(sign == 0 ? row(first + t) : edge);
    if (mode[k] == "slide") add_product(F_.back(), 1, slip[k], n + t);
  }
  if (mode[k] != "slide") return;
  Form cone{0, Vec(N_), 0};
  add_product(cone, 1, n + 1, n + 1);
  add_product(cone, 1, n + 2, n + 2);
  const Q up = cone.rest;
  cone.rest = 0;
  add_product(cone, -m * m, n, n);
  cone.rest = std::max(up, cone.rest);
  F_.push_back(cone);
}

void Box::check_dropped() const {
  for (const auto& [i, combination] : dropped_) {
    Form f = F_[i];
    need(f.linear, "dropped");
    for (const auto& [j, q] : combination) {
      need(dropped_.count(j) == 0 && F_[j].linear, "combination");
      f.value -= q * F_[j].value;
      for (std::size_t l = 0; l < N_; ++l) f.slope[l] -= q * F_[j].slope[l];
    }
    need(f.value == 0, "combination at the center");
    for (const std::size_t l : left_) need(f.slope[l] == 0, "combination in a column");
  }
}

/// As if with the inverse of D J P: |y| <= 1 is mapped into itself.
void Box::check_ball() const {
  const std::size_t M = left_.size();
  Q defects, bends;
  Mat rows(M, Vec(M));
  for (std::size_t i = 0; i < M; ++i) {
    const Form& f = F_[kept_[i]];
    defects += rows_[i] * rows_[i] * f.value * f.value;
    bends += rows_[i] * rows_[i] * f.rest * f.rest;
    for (std::size_t j = 0; j < M; ++j) rows[i][j] = rows_[i] * f.slope[left_[j]] * radius[left_[j]];
  }
  need(least_singular_ > 0 && defect_ >= 0 && bend_ >= 0 && defect_ + bend_ <= least_singular_, "ball");
  need(defects <= defect_ * defect_ && bends <= bend_ * bend_, "defect or bend");
  const Mat L = order_.empty() ? R_ : factor(rows);
  for (std::size_t i = 0; i < M; ++i) {
    Q excess;
    for (std::size_t j = 0; j < M; ++j) {
      Q g = i == j ? Q(-least_singular_ * least_singular_) : Q(0);
      for (std::size_t k = 0; k < M; ++k) g += rows[k][i] * rows[k][j] - L[i][k] * L[j][k];
      excess += i == j ? g : Q(-absolute(g));
    }
    need(excess >= 0, "least singular value");
  }
}

/// Cholesky's factor of M^T M - 2 s^2 in the order, on the grid, column by column from the columns before.
Mat Box::factor(const Mat& M) const {
  const std::size_t n = order_.size();
  const Q unit = power_of_two(static_cast<long>(grid_));
  const auto below = [](const Q& x) {
    mpz_class floor;
    mpz_fdiv_q(floor.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
    return floor;
  };
  Mat L(n, Vec(n));
  for (std::size_t a = 0; a < n; ++a) {
    const std::size_t j = order_[a];
    Vec left(n);
    for (std::size_t b = a; b < n; ++b) {
      const std::size_t i = order_[b];
      if (b == a) left[i] = -2 * least_singular_ * least_singular_;
      for (std::size_t k = 0; k < n; ++k) left[i] += M[k][i] * M[k][j];
      for (std::size_t k = 0; k < a; ++k) left[i] -= L[i][k] * L[j][k];
    }
    const mpz_class root = left[j] > 0 ? mpz_class(sqrt(below(Q(left[j] * unit * unit)))) : mpz_class(0);
    for (std::size_t b = a; b < n && root > 0; ++b) {
      const std::size_t i = order_[b];
      L[i][a] = below(Q(left[i] * unit * unit / root)) / unit;
    }
  }
  return L;
}

void Box::check_inverse(const Q& alone) const {
  for (std::size_t a = 0; a < left_.size(); ++a) {
    Q shift, rest, spread;
    for (std::size_t b = 0; b < kept_.size(); ++b) {
      shift += R_[a][b] * F_[kept_[b]].value;
      rest += absolute(R_[a][b]) * F_[kept_[b]].rest;
    }
    for (const std::size_t l : left_) {
      Q entry = l == left_[a] ? 1 : 0;
      for (std::size_t b = 0; b < kept_.size(); ++b) entry -= R_[a][b] * F_[kept_[b]].slope[l];
      spread += absolute(entry) * radius[l];
    }
    const Q& p = radius[left_[a]];
    need(spread < p && absolute(shift) + spread + rest <= p, "contraction");
    need(spread + 4 * alone * rest < p, "alone");
  }
}

void Box::check_open(std::size_t k) const {
  const std::size_t first = p_.F + p_.D * k;
  const Q least = w(first).low;
  need(least >= 0, "opens");
  Q square;
  for (std::size_t t = 1; t < p_.D && p_.law == "associated"; ++t) {
    const Form u = row(first + t);
    square += (absolute(u.value) + reach(u)) * (absolute(u.value) + reach(u));
  }
  need(p_.mu[k] * p_.mu[k] * square <= least * least, "opens");
}

void Box::check_contact(std::size_t k) const {
  if (mode[k] == "open") return check_open(k);
  const std::size_t first = p_.F + p_.D * k;
  const Q m = p_.mu[k];
  if (mode[k] == "touch") {
    need(pinned.count(at[first]) > 0 && z[at[first]] == 0, "touches");
    return need(p_.law != "associated" || m == 0, "touches by the associated law");
  }
  const Q least = x(first).low;
  need(least >= 0, "presses");
  if (mode[k] == "slide") return need(z[slip[k]] >= radius[slip[k]], "slips");
  Q square, largest;
  for (std::size_t t = 1; t < unknowns_of_[k]; ++t) {
    if (slides(k, t) == 0) {
      const Q most = absolute(z[at[first] + t]) + radius[at[first] + t];
      square += most * most;
      largest = std::max(largest, most);
    } else {
      const Form u = row(first + t);
      need(slides(k, t) * u.value >= reach(u), "slips");
    }
  }
  need(p_.law == "box" ? largest <= m * least : square <= m * m * least * least || mode[k] != "stick", "inside");
}

void enclosure(const Certificate& p, Words& words, bool ball) {
  const Q rho = words.number();
  const bool of_velocities = words.take("velocities");
  const Q eta = of_velocities ? words.number() : Q(0);
  Box box(p, words, ball);
  need(p.has_answer && rho >= 0, "answer");
  box.check(0);
  const auto is_near = [](const Interval& range, const Q& to, const Q& distance) {
    return range.high - to <= distance && to - range.low <= distance;
  };
  const Vec own = p.motion(p.x);
  for (std::size_t i = 0; i < p.n; ++i) {
    need(is_near(box.x(i), p.x[i], rho), "distance");
    need(!of_velocities || i < p.F || is_near(box.w(i), own[i], eta), "eta");
  }
}

}  // namespace slipproof::test::second

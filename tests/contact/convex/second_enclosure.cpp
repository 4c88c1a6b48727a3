// Enclosures and balls in the second reading.
#include <algorithm>
#include <map>

#include "contact/convex/second_words.hpp"

namespace slipproof::test::second {

/// value + slope . d + quadratic terms with |.| <= rest.
struct Form {
  Q value;
  Vec slope;
  Q rest;
  bool linear = true;
};

void enclosure(const Certificate& p, Words& words, bool ball) {
  const Q rho = words.number();
  const bool of_velocities = words.take("velocities");
  const Q eta = of_velocities ? words.number() : Q(0);
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
    if (s != "open" && s != "touch" && s != "stick" && !(rubs && (space || (p.D == 2 && plus)))) throw Garbled();
    unknowns_of[k] = s == "open" ? 0 : rubs && s != "touch" ? p.D : 1;
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
    if (mode[k] == "touch") continue;
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
  const Vec own = p.motion(p.x);
  for (std::size_t i = p.F; of_velocities && i < p.n; ++i) {
    const Form f = row(i);
    need(absolute(f.value - own[i]) + reach(f) <= eta, "eta");
  }
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
    if (mode[k] == "touch") {
      need(pinned.count(at[first]) > 0 && z[at[first]] == 0, "touches");
      need(p.law != "associated" || unknowns_of[k] == p.D || m == 0, "touches by the associated law");
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

}  // namespace slipproof::test::second

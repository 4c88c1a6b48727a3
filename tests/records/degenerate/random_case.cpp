#include "records/degenerate/random_case.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace slipproof::test::degenerate {

namespace {

using Json = nlohmann::json;
using Numbers = std::vector<double>;
using Rows = std::vector<Numbers>;

class Maker {
 public:
  explicit Maker(std::uint64_t i) : dice_(6101, i) {}

  RandomCase make() {
    p_.dimension = size(1, 3);
    p_.form = p_.dimension == 1 ? ProblemForm::complementarity : ProblemForm::local;
    contacts_ = dice_.chance(20) ? 0 : size(1, dice_.chance(4) ? 4 : 2);
    n_ = contacts_ * p_.dimension;
    choose_law();
    choose_matrix();
    r_.assign(n_, 0), u_.assign(n_, 0);
    for (std::size_t k = 0; k < contacts_; ++k) choose_state(k);
    if (dice_.chance(8)) add_bilateral_rows();
    set_constants();
    spoil();
    SolverAnswer& answer = result_.answer;
    answer.r = r_;
    if (dice_.chance(4)) answer.u = u_;
    if (!lambda_.empty() && dice_.chance(2)) answer.lambda = lambda_;
    return std::move(result_);
  }

 private:
  std::size_t size(int low, int high) { return static_cast<std::size_t>(dice_.number(low, high)); }
  template <std::size_t n>
  double one_of(const std::array<double, n>& values) {
    return values[size(0, static_cast<int>(n) - 1)];
  }

  void choose_law() {
    if (p_.dimension > 1) {
      for (std::size_t k = 0; k < contacts_; ++k) p_.mu.push_back(one_of(std::array{0.0, 0.25, 0.5, 1.0, 3.0}));
    }
    if (!dice_.chance(3)) return;
    p_.law.kind = static_cast<FrictionLaw>(dice_.number(0, 5));
    if (p_.law.kind == FrictionLaw::fixed) {
      for (std::size_t i = 0; i < n_ - contacts_; ++i) p_.law.bounds.push_back(dice_.number(0, 2));
    }
    if (p_.law.kind == FrictionLaw::regularised) {
      p_.law.slip_speed = one_of(std::array{1.0, 4.0});
      p_.law.function = dice_.chance(2) ? Regularisation::soft : Regularisation::linear;
    }
    if (!dice_.chance(3)) return;
    for (std::size_t i = 0; i < n_; ++i) {
      p_.compliance.push_back(dice_.number(0, 1));
      p_.bias.push_back(dice_.number(-1, 1));
    }
  }

  void choose_matrix() {
    W_.assign(n_, Numbers(n_, 0));
    const int kind = dice_.number(0, 7);
    if (kind == 0) return;
    if (kind == 1) {
      for (Numbers& row : W_) {
        for (double& a : row) a = dice_.chance(2) ? 0 : dice_.number(-3, 3);
      }
      return;
    }
    Rows J(n_, Numbers(size(1, 6)));
    for (std::size_t i = 0; i < n_; ++i) {
      const std::size_t k = i / p_.dimension;
      const bool twin = k > 0 && (k * 2654435761U >> 7U) % 3 == static_cast<std::size_t>(kind % 3);
      for (std::size_t a = 0; a < J[i].size(); ++a) {  // a second contact at the same place, or one that nothing moves
        J[i][a] = twin ? J[i - p_.dimension][a] : kind == 7 && k % 2 == 1 ? 0 : dice_.number(-2, 2);
      }
    }
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j < n_; ++j) {
        for (std::size_t a = 0; a < J[i].size(); ++a) W_[i][j] += J[i][a] * J[j][a];
        if (kind == 6 && dice_.chance(4)) W_[i][j] *= 1 + 0x1p-50;
      }
    }
    if (kind != 6) result_.J = std::move(J);
  }

  /// Forces and velocities that obey the law for the most part.
  void choose_state(std::size_t k) {
    const std::size_t n = k * p_.dimension, d = p_.dimension;
    const double mu = d == 1 ? 0 : p_.mu[k];
    const int state = dice_.number(0, 5);
    if (state <= 1) {  // open, or touching without load
      u_[n] = state == 0 ? dice_.number(1, 3) : 0;
      for (std::size_t t = 1; t < d; ++t) u_[n + t] = dice_.chance(3) ? 0 : dice_.number(-2, 2);
      return;
    }
    const bool triple = d == 3 && mu > 0 && mu < 3;
    r_[n] = triple ? 5 * dice_.number(1, 3) / mu : dice_.number(1, 4);
    if (d == 1 || (state == 2 && mu > 0)) return;  // it sticks, and is not pulled
    const double friction = mu * r_[n] * (state == 3 ? 0.5 : 1), slip = state >= 4 ? dice_.number(1, 3) : 0;
    const double sign = dice_.chance(2) ? 1 : -1;
    const bool second = d == 3 && dice_.chance(2);
    if (triple && dice_.chance(2)) {
      r_[n + 1] = -sign * friction / 5 * 3, r_[n + 2] = friction / 5 * 4;
      u_[n + 1] = sign * 3 * slip, u_[n + 2] = -4 * slip;
    } else {
      r_[n + (second ? 2 : 1)] = -sign * friction;
      u_[n + (second ? 2 : 1)] = sign * slip;
    }
    if (p_.law.kind == FrictionLaw::associated) u_[n] = mu * std::hypot(u_[n + 1], d == 3 ? u_[n + 2] : 0);
    if (p_.law.kind == FrictionLaw::fixed) {
      for (std::size_t t = 1; t < d; ++t) {
        const double bound = p_.law.bounds[k * (d - 1) + t - 1];
        r_[n + t] = u_[n + t] == 0 ? bound / 2 : u_[n + t] > 0 ? -bound : bound;
      }
    }
  }

  void add_bilateral_rows() {
    const std::size_t m = size(1, 2);
    V_.assign(n_, Numbers(m)), R_.assign(m, Numbers(m, 0));
    for (Numbers& row : V_) {
      for (double& a : row) a = dice_.chance(2) ? 0 : dice_.number(-2, 2);
    }
    for (std::size_t i = 0; i < m; ++i) R_[i][i] = dice_.chance(3) ? 0 : dice_.number(1, 3);
    for (std::size_t i = 0; i < m; ++i) lambda_.push_back(dice_.number(-2, 2));
    for (std::size_t i = 0; i < m; ++i) {
      p_.s.push_back(-R_[i][i] * lambda_[i]);
      for (std::size_t j = 0; j < n_; ++j) p_.s[i] -= V_[j][i] * r_[j];
    }
    p_.V = matrix(V_, n_, m);
    p_.R = matrix(R_, m, m);
    result_.J.clear();
  }

  /// q so that u is the velocity by the law, W r + V lambda + q with compliance and bias; and W, in the file's form.
  void set_constants() {
    for (std::size_t i = 0; i < n_; ++i) {
      double sum = u_[i];
      for (std::size_t j = 0; j < n_; ++j) sum -= W_[i][j] * r_[j];
      for (std::size_t j = 0; j < lambda_.size(); ++j) sum -= V_[i][j] * lambda_[j];
      if (!p_.compliance.empty()) {
        const double own = p_.compliance[i] * r_[i] + p_.bias[i];
        sum -= own;
        u_[i] -= own;  // what bodies have
      }
      p_.q.push_back(sum);
    }
    p_.W = matrix(W_, n_, n_);
  }

  /// An answer with an error, constants that have nothing to do with it, numbers that rounding left.
  void spoil() {
    if (n_ == 0) return;
    const std::size_t i = size(0, static_cast<int>(n_) - 1), j = size(0, static_cast<int>(n_) - 1);
    switch (dice_.number(0, 11)) {
      case 0:
      case 1:
        r_[i] += one_of(std::array{1e-8, 1e-7, -1e-4, 0.3, -2.0});
        break;
      case 2:
        p_.q[i] += one_of(std::array{1e-16, -1e-16, 1e-7, -1.0});
        p_.q[j] += one_of(std::array{1e-16, -1e-16, 0.0, 1.0});
        break;
      case 3:
        for (double& q : p_.q) q = dice_.chance(3) ? 0 : dice_.number(-3, 3);
        break;
      case 4:
        std::fill(r_.begin(), r_.end(), 0);
        break;
      case 5:
        if (dice_.chance(3)) r_[i] = std::numeric_limits<double>::quiet_NaN();
        break;
      default:
        break;
    }
  }

  static SparseMatrix matrix(const Rows& rows, std::size_t height, std::size_t width) {
    Numbers all;
    for (const Numbers& row : rows) all.insert(all.end(), row.begin(), row.end());
    return from_dense(height, width, all);
  }

  Dice dice_;
  RandomCase result_;
  ProblemFile& p_ = result_.problem;
  std::size_t contacts_ = 0, n_ = 0;
  Rows W_, V_, R_;
  Numbers r_, u_, lambda_;
};

Json rows_of(const SparseMatrix& m) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < m.rows; ++i) {
    Numbers row(m.columns, 0);
    for (std::size_t e = m.starts[i]; e < m.starts[i + 1]; ++e) row[m.column[e]] = m.value[e];
    rows.push_back(row);
  }
  return rows;
}

Json list_of_entries(const SparseMatrix& m) {
  Json entries = Json::array();
  for (std::size_t i = 0; i < m.rows; ++i) {
    for (std::size_t e = m.starts[i]; e < m.starts[i + 1]; ++e) entries.push_back({i, m.column[e], m.value[e]});
  }
  return {{"rows", m.rows}, {"columns", m.columns}, {"entries", std::move(entries)}};
}

/// With NaN as a text, which JSON's numbers cannot say.
Json list_of(const Numbers& values) {
  Json list = Json::array();
  for (const double x : values) list.push_back(std::isnan(x) ? Json("NaN") : Json(x));
  return list;
}

void add_law(const ProblemFile& p, Json& line) {
  if (p.law.kind != FrictionLaw::cone) line["law"] = word(p.law.kind);
  if (p.law.kind == FrictionLaw::fixed) line["bounds"] = p.law.bounds;
  if (p.law.kind == FrictionLaw::regularised) {
    line["slip_speed"] = p.law.slip_speed;
    line["function"] = word(p.law.function);
  }
  if (!p.compliance.empty()) line["compliance"] = p.compliance, line["bias"] = p.bias;
}

}  // namespace

RandomCase random_case(std::uint64_t i) {
  return Maker(i).make();
}

Json line_of(const RandomCase& random, Notation notation) {
  const ProblemFile& p = random.problem;
  const auto matrix = [&](const SparseMatrix& m) {
    return notation == Notation::dense ? rows_of(m) : list_of_entries(m);
  };
  Json line;
  if (p.dimension > 1) line["dimension"] = p.dimension, line["mu"] = p.mu;
  if (notation == Notation::global) {  // M = 1, f = (1, 1, ...): u = J (J^T r + f) + w
    if (random.J.empty() || p.dimension == 1) return {};
    const std::size_t coordinates = random.J[0].size();
    Rows M(coordinates, Numbers(coordinates, 0)), H(coordinates, Numbers(p.q.size()));
    Numbers w = p.q;
    for (std::size_t a = 0; a < coordinates; ++a) {
      M[a][a] = 1;
      for (std::size_t i = 0; i < w.size(); ++i) {
        H[a][i] = random.J[i][a];
        w[i] -= random.J[i][a];
      }
    }
    for (std::size_t i = 0; i < w.size(); ++i) {  // a sum that was rounded is another problem
      double sum = w[i];
      for (const double moved : random.J[i]) sum += moved;
      if (sum != p.q[i]) return {};
    }
    line["M"] = M, line["H"] = H, line["f"] = Numbers(coordinates, 1), line["w"] = w;
  } else {
    line["W"] = matrix(p.W), line["q"] = p.q;
    if (!p.s.empty()) line["V"] = matrix(p.V), line["R"] = matrix(p.R), line["s"] = p.s;
  }
  add_law(p, line);
  line["r"] = list_of(random.answer.r);
  if (!random.answer.u.empty()) line["u"] = list_of(random.answer.u);
  if (!random.answer.lambda.empty()) line["lambda"] = random.answer.lambda;
  return line;
}

}  // namespace slipproof::test::degenerate

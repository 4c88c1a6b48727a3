#include <algorithm>
#include <array>

#include "base/input/diagnostic.hpp"
#include "contact/space/space_problem.hpp"

namespace slipproof {

namespace {

/// M v - G lambda = H r + f and G^T v = -b, solved for v and lambda. M falls into small blocks, at most one of three
/// rows for each body's turning. With the inverse of the regular ones, v = M^-1 (G lambda + H r + f), what is left to
/// eliminate are lambda and the accelerations of bodies without a mass or an inertia.
class Elimination {
 public:
  Elimination(const SpaceProblem& problem, const Mechanism& mechanism)
      : p_(problem.global), m_(mechanism), v_(p_.f.size()), held_(p_.b.size()), r_(p_.w.size()), inverse_(v_) {
    invert_blocks();
    pushes_ = pushes();
    right_ = times_inverse(pushes_);
    RationalMatrix links(v_, std::vector<Rational>(held_));
    for (std::size_t i = 0; i < v_; ++i) links[i] = p_.G[i];
    links_ = times_inverse(links);
    echelon_ = eliminate(rows());
  }

  ReducedSpace result() {
    const std::size_t unknowns = singular_.size() + held_;
    if (echelon_.rank(unknowns + r_) > echelon_.rank(unknowns)) refuse_contacts();
    if (echelon_.rank() > echelon_.rank(unknowns)) refuse_contradiction();
    row_of_.assign(unknowns, std::nullopt);
    for (std::size_t i = 0; i < echelon_.rank(); ++i) row_of_[echelon_.pivot_columns[i]] = i;
    RationalMatrix solved;  // of each unknown, over r and 1
    for (std::size_t j = 0; j < unknowns; ++j) {
      std::vector<Rational> over(r_ + 1);
      for (std::size_t k = 0; k <= r_ && row_of_[j]; ++k) over[k] = entry(j, unknowns + k);
      solved.push_back(std::move(over));
    }
    ReducedSpace result;
    for (std::size_t j = 0; j < held_; ++j) {
      result.determined.push_back(is_determined(singular_.size() + j));
      put(solved[singular_.size() + j], result.L, result.l0);
    }
    std::size_t next = 0;
    for (std::size_t i = 0; i < v_; ++i) {
      std::vector<Rational> own = right_[i];  // over r and 1
      const bool is_singular = next < singular_.size() && singular_[next] == i;
      if (is_singular && !is_determined(next)) refuse_free(i);
      if (is_singular) own = solved[next++];
      for (std::size_t j = 0; j < held_ && !is_singular; ++j) add(own, links_[i][j], solved[singular_.size() + j]);
      put(own, result.V, result.v0);
    }
    return result;
  }

 private:
  static void add(std::vector<Rational>& to, const Rational& factor, const std::vector<Rational>& row) {
    if (factor.is_zero()) return;
    for (std::size_t k = 0; k < to.size(); ++k) {
      if (!row[k].is_zero()) to[k] += factor * row[k];
    }
  }
  static void put(std::vector<Rational> over, RationalMatrix& matrix, std::vector<Rational>& constants) {
    constants.push_back(std::move(over.back()));
    over.pop_back();
    matrix.push_back(std::move(over));
  }

  /// Rows that M couples, each block once.
  std::vector<std::size_t> block_of(std::size_t first, std::vector<bool>& seen) const {
    std::vector<std::size_t> block{first};
    seen[first] = true;
    for (std::size_t at = 0; at < block.size(); ++at) {
      for (std::size_t j = 0; j < v_; ++j) {
        if (seen[j] || p_.M[block[at]][j].is_zero()) continue;
        seen[j] = true;
        block.push_back(j);
      }
    }
    std::ranges::sort(block);
    return block;
  }

  void invert_blocks() {
    std::vector<bool> seen(v_);
    for (std::size_t i = 0; i < v_; ++i) {
      if (seen[i]) continue;
      const std::vector<std::size_t> block = block_of(i, seen);
      const std::size_t size = block.size();
      RationalMatrix rows(size, std::vector<Rational>(2 * size));
      for (std::size_t a = 0; a < size; ++a) {
        for (std::size_t b = 0; b < size; ++b) rows[a][b] = p_.M[block[a]][block[b]];
        rows[a][size + a] = 1;
      }
      const Echelon echelon = eliminate(rows);
      if (echelon.rank(size) < size) {
        singular_.insert(singular_.end(), block.begin(), block.end());
        continue;
      }
      for (std::size_t a = 0; a < size; ++a) {
        for (std::size_t b = 0; b < size; ++b) {
          inverse_[block[a]].emplace_back(block[b], Rational(echelon.rows[a][size + b], echelon.pivot));
        }
      }
    }
    std::ranges::sort(singular_);
  }

  /// H and f, side by side.
  RationalMatrix pushes() const {
    RationalMatrix result;
    for (std::size_t i = 0; i < v_; ++i) {
      result.push_back(p_.H[i]);
      result.back().push_back(p_.f[i]);
    }
    return result;
  }
  /// M^-1 times a matrix, in the regular rows; 0 in others.
  RationalMatrix times_inverse(const RationalMatrix& matrix) const {
    RationalMatrix result(v_, std::vector<Rational>(v_ == 0 ? 0 : matrix[0].size()));
    for (std::size_t i = 0; i < v_; ++i) {
      for (const auto& [j, weight] : inverse_[i]) add(result[i], weight, matrix[j]);
    }
    return result;
  }

  /// For the accelerations of singular blocks and lambda, over r and 1.
  RationalMatrix rows() const {
    const std::size_t own = singular_.size();
    RationalMatrix result(own + held_, std::vector<Rational>(own + held_ + r_ + 1));
    for (std::size_t a = 0; a < own; ++a) {
      const std::size_t i = singular_[a];
      for (std::size_t b = 0; b < own; ++b) result[a][b] = p_.M[i][singular_[b]];
      for (std::size_t j = 0; j < held_; ++j) {
        result[a][own + j] = -p_.G[i][j];
        result[own + j][a] = p_.G[i][j];
      }
      std::ranges::copy(pushes_[i], result[a].end() - static_cast<std::ptrdiff_t>(r_ + 1));
    }
    for (std::size_t j = 0; j < held_; ++j) {
      std::vector<Rational>& row = result[own + j];
      for (std::size_t i = 0; i < v_; ++i) {
        const Rational& weight = p_.G[i][j];
        if (weight.is_zero()) continue;
        for (std::size_t k = 0; k < held_; ++k) {
          if (!links_[i][k].is_zero()) row[own + k] += weight * links_[i][k];
        }
        for (std::size_t k = 0; k <= r_; ++k) {
          if (!right_[i][k].is_zero()) row[own + held_ + k] -= weight * right_[i][k];
        }
      }
      row.back() -= p_.b[j];
    }
    return result;
  }

  Rational entry(std::size_t unknown, std::size_t column) const {
    return {echelon_.rows[*row_of_[unknown]][column], echelon_.pivot};
  }
  /// By a row in which no unknown stands that may be anything.
  bool is_determined(std::size_t unknown) const {
    if (!row_of_[unknown]) return false;
    for (std::size_t j = 0; j < row_of_.size(); ++j) {
      if (!row_of_[j] && !echelon_.rows[*row_of_[unknown]][j].is_zero()) return false;
    }
    return true;
  }
  [[noreturn]] void refuse(Place place, const std::string& message) const {
    throw InputError({{m_.file, place.line, place.column, message}});
  }
  [[noreturn]] void refuse_contacts() const {
    refuse({},
           "found contact forces on a body without mass or inertia, which nothing but each other can balance, expected "
           "a mass and an inertia of what is touched");
  }
  [[noreturn]] void refuse_contradiction() const {
    refuse({},
           "found joints that no accelerations satisfy: they contradict each other, or force a prescribed motion, "
           "expected joints that fit");
  }
  [[noreturn]] void refuse_free(std::size_t unknown) const {
    const MechanismUnknown& one = m_.unknowns[unknown];
    refuse(one.place, "found that neither a mass nor an inertia nor a joint determines " + one.symbol +
                          ", expected bodies that forces move in one way");
  }

  const GlobalProblem& p_;
  const Mechanism& m_;
  std::size_t v_, held_, r_;
  std::vector<std::vector<std::pair<std::size_t, Rational>>> inverse_;  ///< of M; empty rows in singular blocks
  std::vector<std::size_t> singular_;
  RationalMatrix pushes_, right_, links_;  ///< (H f), M^-1 (H f), M^-1 G
  Echelon echelon_;
  std::vector<std::optional<std::size_t>> row_of_;  ///< of each unknown that is a pivot
};

/// Column N of a contact that slides becomes N - mu (d1 T1 + d2 T2), and T1 and T2 are none.
void slide(RationalMatrix& matrix, const std::vector<SpaceContact>& contacts) {
  for (auto& row : matrix) {
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      if (!contacts[k].sliding) continue;
      const auto& d = *contacts[k].sliding;
      row[3 * k] -= contacts[k].mu * (d[0] * row[3 * k + 1] + d[1] * row[3 * k + 2]);
      row[3 * k + 1] = row[3 * k + 2] = 0;
    }
  }
}

/// For a contact that slides in a direction that is not rational; as large as other constants.
void slide_toward(ExactContacts& contacts, std::size_t contact, std::array<Rational, 2> toward) {
  Rational largest, own = std::max(abs(toward[0]), abs(toward[1]));
  for (const Rational& q : contacts.q) largest = std::max(largest, abs(q));
  if (largest.is_zero()) largest = 1;
  for (const std::size_t t : {1U, 2U}) {
    const std::size_t i = contacts.normal(contact) + t;
    contacts.W[i].assign(contacts.size(), Rational());
    contacts.q[i] = toward[t - 1] / own * largest;
  }
}

}  // namespace

ReducedSpace reduced(const SpaceProblem& problem, const Mechanism& mechanism) {
  ReducedSpace result = Elimination(problem, mechanism).result();
  slide(result.V, problem.contacts);
  slide(result.L, problem.contacts);
  const GlobalProblem& p = problem.global;
  ExactContacts& contacts = result.contacts;
  contacts.W.assign(p.w.size(), std::vector<Rational>(p.w.size()));
  contacts.q = p.w;
  for (const SpaceContact& one : problem.contacts) contacts.mu.push_back(one.sliding ? Rational(0) : one.mu);
  for (std::size_t v = 0; v < result.V.size(); ++v) {
    for (std::size_t i = 0; i < p.w.size(); ++i) {
      const Rational& weight = p.H[v][i];
      if (weight.is_zero()) continue;
      for (std::size_t j = 0; j < p.w.size(); ++j) {
        if (!result.V[v][j].is_zero()) contacts.W[i][j] += weight * result.V[v][j];
      }
      contacts.q[i] += weight * result.v0[v];
    }
  }
  for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
    if (problem.contacts[k].toward) slide_toward(contacts, k, *problem.contacts[k].toward);
  }
  return result;
}

}  // namespace slipproof

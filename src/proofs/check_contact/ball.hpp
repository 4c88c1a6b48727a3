// A ball around a solution in given modes (FORMAT.md, `ball`): for many unknowns with few entries.
#pragma once

#include "proofs/check_contact/enclosure.hpp"

namespace slipproof::check_contact {

/// By a lower bound on the least singular value of the derivative, in the Euclidean norm.
class Ball : public Neighbourhood {
 public:
  Ball(const Problem& problem, Reader& reader) : Neighbourhood(problem, reader) {
    rows_ = reader.numbers("rows", unknowns_ - dropped_.size());
    reader.expect("least");
    least_ = reader.number();
    reader.expect("defect");
    defect_ = reader.number();
    reader.expect("bend");
    bend_ = reader.number();
    const std::size_t left = unknowns_ - pinned_.size();
    if (!reader.accept("order")) {
      factor_ = reader.entries("factor", left, left);
      return;
    }
    grid_ = static_cast<long>(reader.index(kMaxExponent));
    for (std::size_t next = 0; next < left; ++next) place_.emplace(reader.index(left, place_), next);
  }

 private:
  /// With d_j = p_j y_j, |y| <= 1: |D (F(z + d) - J d)| <= defect + bend <= least <= |D J P y| / |y|.
  void check_zero() const override {
    require(least_.sign() > 0, "the least singular value is not positive");
    require(defect_.sign() >= 0 && bend_.sign() >= 0, "the defect or the bend is negative");
    require(defect_ + bend_ <= least_, "the ball is not mapped into itself");
    Number defects, bends;
    Matrix scaled;
    const std::vector<const Equation*> kept = this->kept();
    const std::vector<std::size_t> place = places();
    for (std::size_t i = 0; i < kept.size(); ++i) {
      defects += square(rows_[i] * kept[i]->value);
      bends += square(rows_[i] * kept[i]->rest);
      Row& row = scaled.emplace_back();
      for (const auto& [j, a] : kept[i]->slope) {
        if (pinned_.count(j) == 0) row[place[j]] = rows_[i] * a * radius_[j];
      }
    }
    require(defects <= square(defect_), "the center is farther from the equations than the defect");
    require(bends <= square(bend_), "the equations bend more");
    place_.empty() ? check_least(scaled) : check_least_in_order(scaled);
  }

  /// Of each unknown among those that are left, or in their order.
  std::vector<std::size_t> places() const {
    std::vector<std::size_t> result(unknowns_);
    for (std::size_t j = 0, next = 0; j < unknowns_; ++j) {
      if (pinned_.count(j) > 0) continue;
      result[j] = place_.empty() ? next : place_.at(next);
      ++next;
    }
    return result;
  }

  /// M^T M - least^2 - L L^T is semidefinite.
  void check_least(const Matrix& M) const {
    Matrix rest(factor_.size());
    for (const Row& row : M) add_square(rest, 1, row);
    for (std::size_t j = 0; j < rest.size(); ++j) rest[j][j] += -square(least_);
    subtract_square(rest, factor_);
    check_semidefinite(rest);
  }

  /// The same with an L that is found here: by Cholesky's method on a grid for M^T M - 2 least^2, so that least^2 pays
  /// for rounding. Any L would do: what it leaves counts. A row of M is squared when its first column comes, so that
  /// memory has only what is not eliminated yet.
  void check_least_in_order(const Matrix& M) const {
    Matrix rest(M.size());  // on and above the diagonal
    Vector excess(M.size(), square(least_));
    std::vector<std::vector<const Row*>> starting(M.size());
    for (const Row& row : M) {
      if (!row.empty()) starting[row.begin()->first].push_back(&row);
    }
    for (std::size_t j = 0; j < M.size(); ++j) {
      for (const Row* row : starting[j]) add_square(rest, 1, *row, true);
      rest[j][j] += -2 * square(least_);
      add_square(rest, -1, column(rest[j]), true);
      for (const auto& [i, a] : rest[j]) {
        excess[j] += i == j ? a : -abs(a);
        if (i != j) excess[i] += -abs(a);
      }
      rest[j].clear();
    }
    for (std::size_t j = 0; j < M.size(); ++j)
      require(excess[j].sign() >= 0, "row", j, "the diagonal is less than the others");
  }

  /// Of L, from the first row of what is left; nothing where its diagonal is not positive.
  Row column(const Row& row) const {
    Row result;
    const Number& diagonal = row.begin()->second;
    const mpz_class root = diagonal.sign() > 0 ? mpz_class(sqrt(diagonal.floor(2 * grid_))) : mpz_class(0);
    if (root == 0) return result;
    for (const auto& [i, a] : row) {
      mpz_class l = a.floor(2 * grid_);
      mpz_fdiv_q(l.get_mpz_t(), l.get_mpz_t(), root.get_mpz_t());
      if (l != 0) result.emplace(i, Number(std::move(l), -grid_, 1));
    }
    return result;
  }

  Vector rows_;
  Number least_, defect_, bend_;
  Matrix factor_;                             ///< L, where there is no order
  long grid_ = 0;                             ///< bits after the point in L
  std::map<std::size_t, std::size_t> place_;  ///< in the order, of the unknowns that are left
};

}  // namespace slipproof::check_contact

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
    factor_ = reader.entries("factor", unknowns_ - pinned_.size(), unknowns_ - pinned_.size());
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
    check_least(scaled);
  }

  /// Of each unknown among those that are left.
  std::vector<std::size_t> places() const {
    std::vector<std::size_t> result(unknowns_);
    for (std::size_t j = 0, next = 0; j < unknowns_; ++j) result[j] = pinned_.count(j) > 0 ? 0 : next++;
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

  Vector rows_;
  Number least_, defect_, bend_;
  Matrix factor_;
};

}  // namespace slipproof::check_contact

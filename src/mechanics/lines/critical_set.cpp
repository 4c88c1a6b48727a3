#include "mechanics/lines/critical_set.hpp"

#include <algorithm>
#include <iterator>

namespace slipproof {

void CriticalSet::add(const IntegerPolynomial& p) {
  if (p.degree() > 0) polynomials_.insert(p.primitive());
}

void CriticalSet::add(const Affine<IntegerPolynomial>& form, std::size_t mode) {
  if (form.beta.is_zero()) {
    add(form.alpha);
    return;
  }
  add(form.beta);
  IntegerPolynomial common = gcd(form.alpha, form.beta);
  if (form.beta.coefficient(form.beta.degree()) < 0) common = -std::move(common);
  groups_[group_].insert({exact_quotient(form.alpha, common), exact_quotient(form.beta, common), mode});
}

void CriticalSet::add(const ForcePolynomial& p) {
  if (p.size() == 2) {
    add(Affine<IntegerPolynomial>(p[0], p[1]));
  } else {
    for (const IntegerPolynomial& coefficient : p) add(coefficient);
  }
}

void CriticalSet::add(const LineFunction& x) {
  add(x.numerator());
  add(x.denominator());
}

void CriticalSet::add_coefficients(const LineFunction& x) {
  for (const ForcePolynomial* part : {&x.numerator(), &x.denominator()}) {
    for (const IntegerPolynomial& coefficient : *part) add(coefficient);
  }
}

void CriticalSet::add_order(const IntegerPolynomial& p) {
  add(p);
  if (p.degree() > 0) orders_.insert(p.primitive());
}

std::size_t CriticalSet::branch_of(const LineFunction& difference) {
  add(difference);
  const auto known = std::find(branches_.begin(), branches_.end(), difference.numerator());
  if (known != branches_.end()) return static_cast<std::size_t>(known - branches_.begin());
  branches_.push_back(difference.numerator());
  return branches_.size() - 1;
}

std::set<IntegerPolynomial> CriticalSet::polynomials() const {
  std::set<IntegerPolynomial> result = polynomials_;
  const auto meet = [&](const Form& x, const Form& y) {
    if (x.mode != 0 && x.mode == y.mode) return;
    const IntegerPolynomial determinant = x.alpha * y.beta - y.alpha * x.beta;
    if (determinant.degree() > 0) result.insert(determinant.primitive());
  };
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    for (auto x = groups_[i].begin(); x != groups_[i].end(); ++x) {
      for (auto y = std::next(x); y != groups_[i].end(); ++y) meet(*x, *y);
      if (i == 0) continue;
      for (const Form& y : groups_[0]) meet(*x, y);
    }
  }
  return result;
}

bool LineField::is_zero(const LineFunction& divisor) const {
  if (at_infinity) {
    found->add_coefficients(divisor);
  } else {
    found->add(divisor);
  }
  return divisor.is_zero();
}

std::optional<int> LineField::compare(const LineFunction& x, const LineFunction& y) const {
  const LineFunction difference = x - y;
  if (difference.is_zero()) return 0;
  if (at_infinity) {
    found->add_coefficients(difference);
  } else if (!difference.without_force()) {
    const std::size_t branch = found->branch_of(difference);
    return ((branches >> branch) & 1U) != 0 ? -1 : 1;
  }
  const IntegerPolynomial &n = difference.numerator().back(), &d = difference.denominator().back();
  found->add_order(n);
  found->add_order(d);
  const int sign = n.sign_at(here) * d.sign_at(here);
  return sign == 0 ? 1 : sign;
}

}  // namespace slipproof

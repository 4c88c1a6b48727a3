#include "mechanics/kernel/affine_space.hpp"

#include <algorithm>
#include <utility>

namespace slipproof {

namespace {

/// form += factor * addend, entry by entry.
void add(AffineForm& form, const Rational& factor, const AffineForm& addend) {
  if (!addend.constant.is_zero()) form.constant += factor * addend.constant;
  for (std::size_t i = 0; i < addend.coefficients.size(); ++i) {
    if (!addend.coefficients[i].is_zero()) form.coefficients[i] += factor * addend.coefficients[i];
  }
}

}  // namespace

AffineSpace::AffineSpace(std::size_t unknowns, bool has_load)
    : free_(unknowns + 1, true), fixed_(unknowns + 1), dimension_(unknowns) {
  if (!has_load) {
    free_.back() = false;
    fixed_.back().coefficients.resize(unknowns + 1);
  }
}

AffineSpace::AffineSpace(std::vector<AffineForm> solution, const std::optional<Rational>& load)
    : free_(solution.size() + 1), fixed_(std::move(solution)), dimension_(0) {
  free_.back() = !load;
  fixed_.emplace_back();
  if (load) fixed_.back() = {*load, std::vector<Rational>(free_.size())};
}

AffineForm AffineSpace::on(const AffineForm& form) const {
  AffineForm result{form.constant, std::vector<Rational>(free_.size())};
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const Rational& c = form.coefficients[i];
    if (c.is_zero()) continue;
    if (free_[i]) {
      result.coefficients[i] += c;
    } else {
      add(result, c, fixed_[i]);
    }
  }
  return result;
}

bool AffineSpace::require(const AffineForm& form) {
  AffineForm equation = on(form);
  const auto begin = equation.coefficients.begin();
  const auto pivot = std::find_if(begin, equation.coefficients.end(), [](const Rational& c) { return !c.is_zero(); });
  if (pivot == equation.coefficients.end()) return equation.constant.is_zero();
  const auto variable = static_cast<std::size_t>(pivot - begin);
  const Rational factor = Rational(-1) / std::exchange(*pivot, Rational(0));
  if (!equation.constant.is_zero()) equation.constant *= factor;
  for (Rational& c : equation.coefficients) {
    if (!c.is_zero()) c *= factor;
  }
  fix(variable, std::move(equation));
  return true;
}

void AffineSpace::fix(std::size_t variable, AffineForm form) {
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (free_[i] || fixed_[i].coefficients[variable].is_zero()) continue;
    const Rational factor = std::exchange(fixed_[i].coefficients[variable], Rational(0));
    add(fixed_[i], factor, form);
  }
  free_[variable] = false;
  if (variable != unknowns()) --dimension_;
  fixed_[variable] = std::move(form);
}

std::vector<std::size_t> AffineSpace::free_unknowns() const {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < unknowns(); ++i) {
    if (free_[i]) result.push_back(i);
  }
  return result;
}

AffineForm compressed(const AffineSpace& space, const std::vector<std::size_t>& free, const AffineForm& form) {
  AffineForm whole = space.on(form), result{std::move(whole.constant), {}};
  for (const std::size_t i : free) result.coefficients.push_back(std::move(whole.coefficients[i]));
  result.coefficients.push_back(std::move(whole.coefficients.back()));
  return result;
}

std::vector<Rational> at_origin(const AffineSpace& space, const std::vector<AffineForm>& forms) {
  std::vector<Rational> values;
  for (const AffineForm& form : forms) values.push_back(space.on(form).constant);
  return values;
}

AffineForm load_minus(const Rational& value, std::size_t unknowns) {
  AffineForm form{-value, std::vector<Rational>(unknowns + 1)};
  form.coefficients.back() = 1;
  return form;
}

bool is_free_of_unknowns(const AffineForm& form) {
  return std::all_of(form.coefficients.begin(), form.coefficients.end() - 1,
                     [](const Rational& c) { return c.is_zero(); });
}

bool is_constant(const AffineForm& form) {
  return is_free_of_unknowns(form) && form.coefficients.back().is_zero();
}

}  // namespace slipproof

// What is plainly of one sign in the domain of a setting, so that no statement has to say or show it.
//
// A parameter with the domain `R > 0` is positive; sums, products, quotients and powers of what is positive are, too;
// and where the domain says h > -R, so is h + R. Nothing else is plain. Whatever is left out of a statement for this
// reason follows from the domains that the statement assumes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "claims/paper/setting_names.hpp"

namespace slipproof {

class PlainSigns {
 public:
  /// The setting must outlive it.
  PlainSigns(const Setting& setting, Reading reading);

  bool positive(const Expression& number) const { return sign(number) == Sign::positive; }
  bool not_negative(const Expression& number) const { return sign(number) >= Sign::not_negative; }
  /// Whether a condition plainly holds in the whole domain.
  bool true_everywhere(const Expression& truth) const;
  /// Everything that the expression, and what it is defined by, divides by is plainly positive or negative.
  bool defined(const Expression& e) const;

 private:
  enum class Sign { unknown, not_negative, positive };
  using Terms = std::map<std::string, Rational>;  ///< coefficients of the terms of a sum, by their texts

  Sign sign(const Expression& number) const;
  Sign sign_of_sum(const Expression& sum) const;
  Sign sign_of_terms(Terms terms) const;
  Sign sign_of_symbol(const std::string& symbol) const;
  bool never_zero(const Expression& number) const;
  bool link_holds(const Expression& left, Relation relation, const Expression& right) const;
  void add_terms(const Expression& number, const Rational& factor, Terms& terms) const;
  void add_fact(const Expression& domain);

  Reading reading_;
  SettingNames names_;
  struct Fact {
    Terms terms;
    Sign sign;
  };
  std::vector<Fact> facts_;            ///< sums of several terms
  std::map<std::string, Sign> signs_;  ///< of single parameters
};

}  // namespace slipproof

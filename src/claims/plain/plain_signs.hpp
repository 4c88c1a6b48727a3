// Signs that are plain in the domain of a setting, so that no statement has to state or prove them.
//
// A parameter with the domain `R > 0` is positive. So are sums, products, quotients and powers of positive numbers; and
// if the domain says h > -R, so is h + R. No other sign is plain. Everything that a statement leaves out for this
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
  /// Whether all divisors in the expression and in its definitions are plainly positive or negative.
  bool defined(const Expression& e) const;

 private:
  enum class Sign { unknown, not_negative, positive };
  using Terms = std::map<std::string, Rational>;  ///< by the text of each term of a sum, its coefficient

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
  std::vector<Fact> facts_;            ///< about sums of several terms
  std::map<std::string, Sign> signs_;  ///< signs of single parameters
};

}  // namespace slipproof

// Whether a statement (proofs/FORMAT.md) that was made of a claim is true at one bicycle: its parameters have the
// bicycle's values, and all other variables run over all values that matter.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "claims/meaning/random/random_claims.hpp"
#include "claims/meaning/second_judge/second_judge.hpp"
#include "proofs/statement/statement_text.hpp"

namespace slipproof::meaning {

/// Truth of formulas at numbers: there are two values only, "a comparison holds only where every divisor in it is
/// different from zero", in what `let` abbreviates, too.
class StatementValues {
 public:
  explicit StatementValues(const StatementText& statement);

  void set(const std::string& variable, const Rational& value) { variables_[variable] = value; }
  const Rational& value(const std::string& variable) const { return variables_.at(variable); }
  bool holds(const Expression& formula) const;
  /// The names of all variables in it, in what it abbreviates, too.
  std::set<std::string> variables(const Expression& formula) const;

 private:
  Number number(const Expression& expression) const;

  std::map<std::string, Expression> abbreviations_;  ///< of `let` and `define`
  std::map<std::string, Rational> variables_;
};

class StatementJudge {
 public:
  /// Those of a `limit` are about all values of its parameter. Throws OutOfReach.
  StatementJudge(const File& file, const World& world, std::size_t claim, Dice& dice);

  bool is_true(const std::string& text) const;

 private:
  using Point = Row;  ///< values of the model's unknowns, and of the force variable

  /// The variables of a statement that are not parameters.
  struct Free {
    bool force = false;
    std::vector<std::string> endings;  ///< of the names of the unknowns, a motion for each: "", "_2"
  };
  struct Reading {
    StatementText text;
    std::vector<std::string> known, sought;  ///< names of `real`, and of `exists`
    std::vector<Expression> assumed;
    Expression shown;
  };
  static Reading read(const std::string& text);
  Free free_of(const std::vector<std::string>& names) const;

  bool conclusion(const Reading& reading, StatementValues& values) const;
  bool some_sought(const Reading& reading, StatementValues& values) const;
  /// Whether `wanted` is true for one of the points at least, tried for each ending, and for each force.
  /// possible(i) is asked as soon as the unknowns with the first i endings have values; false passes them over.
  template <class Possible, class Wanted>
  bool some(const Free& free, StatementValues& values, const Possible& possible, const Wanted& wanted) const;
  template <class Possible, class Wanted>
  bool some_points(const Free& free, std::size_t from, const std::vector<Point>& points, StatementValues& values,
                   const Possible& possible, const Wanted& wanted) const;
  /// By how many endings their variables have: the assumptions that can be asked then.
  std::vector<std::vector<Expression>> assumed_after(const Reading& reading, const StatementValues& values,
                                                     const Free& free) const;
  void set(StatementValues& values, const Point& point, const std::string& ending) const;

  void find_motions(const SecondJudge& judge, const Claim& claim);
  Point motion_point(const Motion& motion, const Rational& x) const;
  bool is_true_at(const Reading& reading, const Names& names) const;
  void find_solutions(const SecondJudge& judge, const Claim& claim);
  Point random_point();
  /// What is known, completed to a solution of the hypotheses where there is one.
  Point completed(const Reading& reading, const StatementValues& values) const;

  const World& world_;
  Dice& dice_;
  bool linear_;
  std::string parameter_;         ///< of a limit
  std::vector<Rational> values_;  ///< its values
  Rows hypotheses_;
  std::map<Rational, std::vector<Point>> points_;  ///< by force
};

}  // namespace slipproof::meaning

// Boxes and balls around a solution in given modes, in the second reading.
#pragma once

#include <map>

#include "contact/convex/second_words.hpp"

namespace slipproof::test::second {

struct Interval {
  Q low, high;
};

/// value + slope . d + quadratic terms with |.| <= rest.
struct Form {
  Q value;
  Vec slope;
  Q rest;
  bool linear = true;
};

/// What an `enclosure` or a `ball` has from `modes` on.
class Box {
 public:
  Box(const Certificate& problem, Words& words, bool ball);

  /// That a solution is in it, and no second zero within `alone` times the radii.
  void check(const Q& alone);

  /// Component i of the solution, and row i of A x + c.
  Interval x(std::size_t i) const;
  Interval w(std::size_t i) const;

  std::vector<std::string> mode;
  std::vector<std::size_t> at, slip;  ///< unknown of each component of x, or none; of s of each contact
  Vec z, radius;
  std::set<std::size_t> pinned;

 private:
  void read_modes(Words& words);
  void read_dropped(Words& words);
  void read_order(Words& words);
  Form row(std::size_t i) const;
  Q reach(const Form& f) const;
  int slides(std::size_t k, std::size_t t) const;
  void add_product(Form& f, const Q& factor, std::size_t a, std::size_t b) const;
  void list_equations();
  void list_friction(std::size_t k);
  void check_dropped() const;
  void check_ball() const;
  Mat factor(const Mat& M) const;
  void check_inverse(const Q& alone) const;
  void check_open(std::size_t k) const;
  void check_contact(std::size_t k) const;

  const Certificate& p_;
  bool ball_;
  std::vector<std::size_t> unknowns_of_, kept_, left_;
  std::size_t N_ = 0;
  std::map<std::size_t, std::map<std::size_t, Q>> dropped_;
  Vec rows_;
  Q least_singular_, defect_, bend_;
  Mat R_;                           ///< the inverse, or L where there is no order
  std::vector<std::size_t> order_;  ///< of what is left
  std::size_t grid_ = 0;
  std::vector<Form> F_;
};

}  // namespace slipproof::test::second

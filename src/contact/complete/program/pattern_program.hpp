// Linear programs over the motions of a pattern, in floating point: they propose what pattern.hpp proves.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "contact/complete/pattern.hpp"
#include "contact/complete/program/column_program.hpp"

namespace slipproof {

/// A problem in binary64.
struct FloatingContacts {
  std::size_t dimension = 3;
  std::vector<std::vector<double>> W;
  std::vector<double> q, mu;

  explicit FloatingContacts(const ExactContacts& contacts);
  std::size_t size() const { return q.size(); }
  std::size_t normal(std::size_t contact) const { return dimension * contact; }
};

/// A point of a pattern's relaxation.
struct ProposedPoint {
  std::vector<double> r, u;
};

/// Whether any u is allowed in a row: a multiplier there is that of the form.
bool allows_any_velocity(const ContactPattern& pattern, std::size_t dimension, std::size_t row);

/// The linear program of a pattern: velocities in the convex hull of those that the states allow, forces in a polygon
/// around it, and u = W r + q. Clp solves it, in its dual: a row for each equation, a column for each edge of these
/// cones. Not for more than one thread at a time.
class PatternProgram {
 public:
  enum class Cones : std::uint8_t {
    around,  ///< polygons have all forces of the cones
    within   ///< and none but these: for a point inside of the cones, not for proofs
  };

  PatternProgram(const ExactContacts& exact, const IntegerContacts& integers, const FloatingContacts& contacts,
                 const ContactPattern& pattern, Cones cones = Cones::around);
  PatternProgram(const PatternProgram&) = delete;
  PatternProgram& operator=(const PatternProgram&) = delete;

  /// A point, and, if it only comes near the pattern, multipliers y that prove that there is none. Both are empty if
  /// the program gave up.
  struct Feasibility {
    std::optional<ProposedPoint> point;
    std::vector<Rational> y;
  };
  Feasibility feasibility();
  /// Multipliers that prove that there is no motion because a condition that holds strictly cannot: that a contact
  /// slips, or that it opens. Empty where it can. After feasibility(), where that found a point.
  std::vector<Rational> strict_multipliers(ProposedPoint point);
  /// Multipliers that prove that a form is at least `least`; empty where none were found. After feasibility(), where
  /// that found a point.
  std::vector<Rational> prove_least(const ContactForm& form, const Rational& least);
  /// Multipliers that prove nearly the greatest lower bound of a form that there is; empty where none were found. After
  /// feasibility(), where that found a point.
  std::vector<Rational> prove_best(const ContactForm& form);
  /// Where in the arc of a contact that slips, from 0 to 1 of its angle, velocities and forces of the program point,
  /// about. After feasibility(), where that found a point.
  std::array<double, 2> directions(std::size_t contact);
  /// The mean of the points at which components of forces are least and greatest: where forces are open, a point
  /// between their bounds. After feasibility(), where that found a point.
  ProposedPoint middle();
  /// How many programs were solved.
  std::size_t solved() const { return solved_; }

  /// What conditions keep, so that multipliers can be rounded, and to how many bits after the leading one of the
  /// largest.
  struct Precision {
    double margin;
    int places;
    double tolerance;  ///< of the program
  };

 private:
  struct Edge {
    std::size_t normal = 0;  ///< of the contact
    bool force = false;
    std::array<double, 3> v{};
  };

  void add_cones();
  void add_polygon(std::size_t contact);
  void add_arc(std::size_t contact);
  void build();
  bool solve(double tolerance);
  const std::vector<Rational>& prove_empty();
  void set_costs(std::span<const double> f, std::span<const double> h, double kept);
  bool cut(const ProposedPoint& point);
  double column_cost(const Edge& edge, std::span<const double> f, std::span<const double> h) const;
  ProposedPoint point() const;
  std::vector<double> duals() const;
  std::vector<Rational> rounded(std::span<const double> y, const ContactForm& form, int places, double kept = 0) const;
  std::optional<std::vector<double>> least_duals(std::span<const double> f, std::span<const double> h, double kept,
                                                 bool exactly = false, double slack = 0);
  std::vector<Rational> proposed(const ContactForm& form, const Precision* precision, double& value);
  std::optional<double> least_slope(bool forces, std::size_t row, double middle, double side);
  ContactForm reversed(std::size_t contact) const;
  static double value_at(const ContactForm& form, const ProposedPoint& point);
  std::vector<Rational> excluded(const ContactForm& form, ProposedPoint* least);
  std::vector<Rational> on_face(std::span<const double> y, const ContactForm& form) const;

  static constexpr double small = 1e-9;            ///< what rounding may have made of 0
  static constexpr double quick_tolerance = 1e-9;  ///< of programs, to begin with

  const ExactContacts& exact_;
  const IntegerContacts& integers_;
  const FloatingContacts& contacts_;
  const ContactPattern& pattern_;
  const Cones cones_;
  std::vector<std::vector<double>> tangents_;  ///< angles of the polygon around each contact's circle
  std::vector<Edge> edges_;
  std::vector<Rational> proved_;
  std::unique_ptr<ColumnProgram> program_;
  std::size_t solved_ = 0;
};

}  // namespace slipproof

// The linear programs about a scene at rest, with polygons in place of circles of friction.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/algebra/sparse/sparse_program.hpp"
#include "contact/rest/rest_problem.hpp"

namespace slipproof {

/// A point of the unit circle.
using CirclePoint = std::array<Rational, 2>;
/// The point nearest to an angle, about, of small numbers.
CirclePoint circle_point_near(double angle);

/// For each contact in space with friction points of the circle, counterclockwise, with less than half a turn between
/// neighbours; the others have none.
using RestPolygons = std::vector<std::vector<CirclePoint>>;
RestPolygons first_polygons(const RestProblem& problem);

/// What pushes: f, and the constants of the limits.
struct RestPush {
  std::vector<Rational> f, limits;

  bool operator==(const RestPush&) const = default;
};
/// At a load; without one, per unit of the load.
RestPush push_at(const RestProblem& problem, const std::optional<Rational>& load);

/// A load that varies: what it pushes for each unit, its cost, and the values between which it stays.
struct VariedLoad {
  RestPush unit;
  Rational cost;
  std::optional<Rational> from, to;
};

/// Forces as sums, with weights >= 0, of the edges of cones. In the plane the cones are the true ones.
class RestProgram {
 public:
  enum class Cones : std::uint8_t { within, around };

  RestProgram(const RestProblem& problem, const RestPolygons& polygons, Cones cones);

  /// The greatest margin t with which all weights are at least t: minimise -t. It is at most the largest push.
  SparseProgram margin(const RestPush& push) const;
  /// Minimises the costs of the loads where these push as well.
  SparseProgram extreme(const RestPush& push, const std::vector<VariedLoad>& loads) const;

  /// The forces at a solution of extreme(), or of margin().
  template <class Number>
  std::vector<Number> forces(const std::vector<Number>& x, bool margin) const {
    std::vector<Number> result(problem_.forces.size(), Number(0));
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      Number weight = x[j];
      if (margin && !columns_[j].is_free) weight += x[columns_.size()];
      for (const auto& [force, part] : parts_[j]) result[force] += weight * static_cast<Number>(part);
    }
    return result;
  }
  /// Where the loads begin among the columns, or the margin stands.
  std::size_t last_column() const { return columns_.size(); }

 private:
  using Parts = std::vector<std::pair<std::size_t, Rational>>;
  void add(Parts parts, bool is_free, std::optional<std::size_t> limit = std::nullopt);
  void add_contact(const RestProblem::Contact& contact, const std::vector<CirclePoint>& polygon, Cones cones);
  std::vector<Rational> right_side(const RestPush& push) const;

  const RestProblem& problem_;
  std::vector<ProgramColumn> columns_;
  std::vector<Parts> parts_;  ///< of each column: its forces
};

/// A solution in floating point, which proposes the basis of an exact one.
struct ProposedOptimum {
  enum class Kind : std::uint8_t { optimal, infeasible, other };
  Kind kind = Kind::other;
  double least = 0;
  std::vector<double> x, y;
  std::vector<std::size_t> basis;
};
/// By Clp; nothing in a build without it, or where it gave up.
std::optional<ProposedOptimum> proposed(const SparseProgram& program);

}  // namespace slipproof

// What holds a scene at rest: the forces that may act, and what they must balance.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/algebra/sparse/sparse_basis.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// A scene rests if no acceleration is other than 0. Then its equations are those of balance: in each row the sum of
/// along[j] x_j over the forces, and f + F f_load, are 0 together. Where equations follow by virtual work, rows are
/// accelerations, and along[j] is the motion along which force j works.
struct RestProblem {
  /// N >= 0, and tangents of length at most mu N.
  struct Contact {
    std::string name;
    std::size_t normal = 0;             ///< among the forces
    std::vector<std::size_t> tangents;  ///< none without friction, one in the plane, two in space
    Rational mu;                        ///< the static coefficient
  };
  /// |force| <= constant + F load + the sum of terms over the forces.
  struct Limit {
    std::string name;
    std::size_t force = 0;
    std::vector<std::pair<std::size_t, Rational>> terms;
    Rational constant, load;
  };

  std::string title, file;
  std::vector<std::string> rows;    ///< names of accelerations; of equations, where they are given
  std::vector<std::string> forces;  ///< as force_names()
  std::vector<SparseVector> along;  ///< of each force, by row
  std::vector<Rational> f, f_load;
  std::vector<Contact> contacts;  ///< those that are closed
  std::vector<Limit> limits;
  std::vector<std::size_t>
      free;  ///< forces of either sign: of links, of guides without friction, of nothing that touches
  bool by_virtual_work = false;
  bool only_links_are_free = true;  ///< no free force works along a motion that is possible
  std::optional<std::string> load;  ///< its symbol

  /// Along which a force works where the rows change at these rates.
  Rational rate_along(std::size_t force, const std::vector<Rational>& rates) const;
  /// f + F f_load.
  std::vector<Rational> push_at(const Rational& load_value) const;
};

/// Problems of one mechanism at many values. Throws InputError for a scene that moves, for prescribed accelerations,
/// for guides with friction (whose forces are no cone), and for a division by 0.
class RestProblemMaker {
 public:
  /// The mechanism must outlive the maker.
  explicit RestProblemMaker(const Mechanism& mechanism) : m_(mechanism), maker_(mechanism) {}
  RestProblem problem(const MechanismScene& scene) const;
  const ProblemMaker& points() const { return maker_; }

 private:
  const Mechanism& m_;
  ProblemMaker maker_;
};

}  // namespace slipproof

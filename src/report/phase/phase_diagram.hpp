// Phase diagrams: which motions there are at each point of a plane of one parameter (horizontal) and the load
// (vertical). In every column the answer is exact, for all loads at once; between columns it is joined up.
#pragma once

#include <compare>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/kernel/motions.hpp"

namespace slipproof {

struct Axis {
  std::string symbol;
  Rational from, to;      ///< from < to
  std::string unit = {};  ///< empty: none is told
  bool is_angle = false;  ///< the values are tan(angle/2), and it is labelled in degrees
};

/// One value of the parameter, solved for all loads.
struct PhaseColumn {
  Rational x;
  bool even = true;                                   ///< one of the evenly spaced ones
  bool after_gap = false;                             ///< between it and the column before x leaves the domain
  std::vector<LoadCell> cells;                        ///< modes only; the load is the vertical axis' variable
  std::vector<std::optional<Rational>> curves;        ///< where the plane's curves are
  std::vector<std::optional<ForceInterval>> refuted;  ///< for each claim of the plane: loads at which it is false
};

/// A number of a motion that has a name.
struct MotionQuantity {
  std::string name;
  bool is_force = false;  ///< in MotionOverLoads, one of forces; if not, one of accelerations
  std::size_t index = 0;
};

/// What is to be drawn.
struct Plane {
  /// A value of x that has a name.
  struct Line {
    std::string symbol;
    Rational x;
    bool misprint = false;  ///< as printed, where another value is meant
  };
  std::string id;     ///< letters, digits and -, unique in a page
  std::string title;  ///< any text
  Axis x, y;
  std::vector<std::string> curves;  ///< symbols of the thresholds that a paper gives
  std::vector<Line> lines;
  std::vector<std::string> claims;  ///< ids of the claims that are held against the plane
  struct Mark {
    Rational x, y;
    std::string label;
  };
  std::optional<Mark> mark;
  std::string note;  ///< what a reader must know of the motions; may be empty
  /// Whether the borders of the domain are looked for. What is beyond stays white, and no motion is not.
  bool finds_domain = false;
  /// Whether neighbours in a column with the same motions, also between them, are one region.
  bool joins_alike = false;
  std::vector<MotionQuantity> quantities;                  ///< that are told of a motion
  std::function<std::string(const MechanismMode&)> words;  ///< what a mode is for people
  /// Solves a column; nothing where the parameter has no meaning.
  std::function<std::optional<PhaseColumn>(const Rational& x)> solve;
  /// The cells of a column that there is, with the numbers of the motions, which cost more than all else.
  std::function<std::vector<LoadCell>(const Rational& x)> numbers;
};

struct PhaseDiagram {
  Plane plane;
  std::vector<PhaseColumn> columns;  ///< in the order of x
};

/// Solves evenly spaced columns, the named values of x, and, where two neighbours differ in their sets of motions, more
/// between them, until the change is narrower than can be seen.
PhaseDiagram phase_diagram(Plane plane, std::size_t columns);

/// Which motions there are: each by its modes, in the order of the modes; and the continua. Of a motion that is strict
/// somewhere, the modes in which it is.
struct MotionSet {
  std::vector<std::vector<MechanismMode>> motions;
  std::vector<MechanismMode> continua;

  bool operator==(const MotionSet& other) const { return motions == other.motions && continua == other.continua; }
};
MotionSet motion_set(const LoadCell& cell);
/// `stick/stick, stick/lift`; `no motion`.
std::string name(const MotionSet& set);

/// All modes of a motion, strict or not, in their order.
std::vector<MechanismMode> modes_in_order(const MotionOverLoads& motion);

/// A region in a column: an open interval of loads.
struct PhaseBand {
  MotionSet set;
  std::optional<Rational> lower, upper;  ///< nothing: infinite
};
/// The regions of a column, upwards; `joined` as Plane::joins_alike.
std::vector<PhaseBand> bands(const PhaseColumn& column, bool joined);

/// The open intervals of a column, upwards.
std::vector<const LoadCell*> open_cells(const PhaseColumn& column);

/// The cell that a value of the vertical axis is in; null if that is out of the load's domain.
const LoadCell* find_cell(const PhaseColumn& column, const Rational& y);

}  // namespace slipproof

// Phase diagrams: the motions at each point of a plane of one parameter (horizontal) and the load (vertical). In every
// column the answer is exact for all loads; neighbouring columns are joined. In space it is exact at single places.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/kernel/motion.hpp"

namespace slipproof {

struct Axis {
  std::string symbol;
  Rational from, to;      ///< from < to
  std::string unit = {};  ///< empty: no unit is shown
  bool is_angle = false;  ///< the values are tan(angle/2), and the axis has labels in degrees
};

/// One value of the parameter, solved for all loads.
struct PhaseColumn {
  Rational x;
  bool even = true;                             ///< one of the evenly spaced columns
  bool after_gap = false;                       ///< between the column before and this one, x leaves the domain
  std::vector<LoadCell> cells;                  ///< with modes only; the load is the variable of the vertical axis
  std::vector<std::optional<Rational>> curves;  ///< the values of the plane's curves at this x
  std::vector<std::optional<ForceInterval>> refuted;  ///< for each claim of the plane: the loads at which it is false
};

/// A quantity of a motion that has a name.
struct MotionQuantity {
  std::string name;
  bool is_force = false;  ///< in MotionOverLoads, one of `forces`; otherwise one of `accelerations`
  std::size_t index = 0;
};

/// A set of motions: each by its modes, in the order of the modes; and the continua. If a motion is strict somewhere,
/// only the modes in which it is strict.
struct MotionSet {
  std::vector<std::vector<MechanismMode>> motions;
  std::vector<MechanismMode> continua;
  bool in_space = false;  ///< each motion has one mode there, in which slip_forward says slip, in whatever direction
  bool complete = true;   ///< it is proved that there are no others

  bool operator==(const MotionSet& other) const = default;
};

/// What to draw.
struct Plane {
  /// A value of x with a name.
  struct Line {
    std::string symbol;
    Rational x;
    bool misprint = false;  ///< it is the printed value, and another value is meant
  };
  std::string id;     ///< letters, digits and -, unique in a page
  std::string title;  ///< any text
  Axis x, y;
  std::vector<std::string> curves;  ///< symbols of thresholds that a paper states
  std::vector<Line> lines;
  std::vector<std::string> claims;  ///< ids of the claims that are compared with the plane
  struct Mark {
    Rational x, y;
    std::string label;
  };
  std::optional<Mark> mark;
  std::string note;  ///< what readers must know about the motions; may be empty
  /// Whether the borders of the domain are searched for. Points outside stay white; points without a motion do not.
  bool finds_domain = false;
  /// Whether neighbours in a column form one region if they have the same motions, also at the load between them.
  bool joins_alike = false;
  std::vector<MotionQuantity> quantities;                  ///< quantities that are shown for a motion
  std::function<std::string(const MechanismMode&)> words;  ///< a mode in words for people
  /// Solves a column; nothing if the parameter has no meaning there.
  std::function<std::optional<PhaseColumn>(const Rational& x)> solve;
  /// Of a raster, in place of columns: the motions at a place; nothing outside of the domain.
  std::function<std::optional<MotionSet>(const Rational& x, const Rational& y)> place;
  /// The cells of an existing column with the numbers of the motions, which cost more than all the rest.
  std::function<std::vector<LoadCell>(const Rational& x)> numbers;
};

/// Exact motions at single places, each the middle of a rectangle of the plane; nothing is proved between them.
struct PhaseRaster {
  struct Place {
    Rational x, y;
    std::optional<MotionSet> set;  ///< nothing outside of the domain

    bool is_complete() const { return !set || set->complete; }
  };
  std::size_t across = 0, up = 0;
  std::vector<Place> places;  ///< column by column, each from below

  std::size_t complete() const;
};

struct PhaseDiagram {
  Plane plane;
  std::vector<PhaseColumn> columns;        ///< in the order of x
  std::optional<PhaseRaster> raster = {};  ///< then there are no columns
};

/// Solves evenly spaced columns and the named values of x. Where two neighbours have different sets of motions, solves
/// more columns between them, until the change is too narrow to see.
PhaseDiagram phase_diagram(Plane plane, std::size_t columns);

MotionSet motion_set(const LoadCell& cell);
/// Solves the places of a raster of so many columns and rows. `progress` may be empty.
PhaseDiagram raster_diagram(Plane plane, std::size_t across, std::size_t up,
                            const std::function<void(std::uint64_t done, std::uint64_t all)>& progress);

/// Whether the set is one motion in which a contact is open.
bool opens(const MotionSet& set);
/// `stick/slip+`; in space `stick/slip`.
std::string mode_name(const MotionSet& set, const MechanismMode& mode);
/// `stick/stick, stick/lift`; `no motion`; `slip/lift, perhaps others`; `not decided`.
std::string name(const MotionSet& set);

/// All modes of a motion, strict or not, in their order.
std::vector<MechanismMode> modes_in_order(const MotionOverLoads& motion);

/// A region in a column: an open interval of loads.
struct PhaseBand {
  MotionSet set;
  std::optional<Rational> lower, upper;  ///< nothing: infinite
};
/// The regions of a column, upwards; `joined` is as in Plane::joins_alike.
std::vector<PhaseBand> bands(const PhaseColumn& column, bool joined);

/// The open intervals of a column, upwards.
std::vector<const LoadCell*> open_cells(const PhaseColumn& column);

/// The cell that contains a value of the vertical axis; null if the value is outside the load's domain.
const LoadCell* find_cell(const PhaseColumn& column, const Rational& y);

}  // namespace slipproof

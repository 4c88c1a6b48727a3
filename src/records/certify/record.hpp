// One output of a solver: parameters and answer, each a binary64 or, where that is not what was written, a rational.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "floating/filter/filter.hpp"
#include "records/certify/cells.hpp"
#include "records/certify/field.hpp"

namespace slipproof {

/// What the answer's fields say, in their order.
inline constexpr std::array<Quantity, answer_count> answer_quantities{Quantity::a,    Quantity::a_y,  Quantity::phi,
                                                                      Quantity::eps2, Quantity::eps3, Quantity::S2,
                                                                      Quantity::S3,   Quantity::N2,   Quantity::N3};

/// In a column of modes by their index: the solver names none.
inline constexpr std::uint8_t no_mode = 255;

struct Record {
  std::array<double, field_count> values{};
  std::uint32_t present = 0;                      ///< bit(Field) of those that are given
  std::vector<std::pair<Field, Rational>> exact;  ///< those that `values` only rounds
  const Record* base = nullptr;                   ///< where the fields not set here come from, exactly
  std::uint32_t own = 0;                          ///< bit(Field) of those set here
  std::optional<ContactMode> mode;                ///< claimed by the solver
  ForceKind force_kind = ForceKind::internal;
  std::optional<NotFinite> not_finite;  ///< the first in the line

  bool has(Field f) const { return (present & bit(f)) != 0; }
  double operator[](Field f) const { return values[index(f)]; }
  void set(Field f, double value) {
    values[index(f)] = value;
    present |= bit(f);
    own |= bit(f);
    if (!exact.empty()) std::erase_if(exact, [f](const auto& x) { return x.first == f; });
  }
  void set(Field f, const Rational& value);
  /// No field that still counts is rounded.
  bool is_exact() const;
  /// What was written, exactly; the field must be there and finite.
  Rational exactly(Field f) const;
  /// Forgets what `f` says in another form: setting h0 over a scene's h leaves no h.
  void replace_other_forms(Field f);
};

/// The parameters of a scene as a record without an answer.
Record to_record(const Scene& scene);

/// A record that says what `base` says, whose exact values it refers to.
Record fresh_record(const Record& base);
/// For records that all have the `given` fields: takes from `base` the forms that those replace, and returns the fields
/// that a record has then.
std::uint32_t over_scene(Record& base, std::uint32_t given);

/// What a floating-point solver says of a scene, for who calls the library: all forces and the acceleration of the
/// frame, and what else the solver has.
struct SolverOutput {
  std::optional<ContactMode> mode = std::nullopt;  ///< if it names one
  double a{}, S2{}, S3{}, N2{}, N3{};
  std::optional<double> a_y = std::nullopt, phi = std::nullopt, eps2 = std::nullopt, eps3 = std::nullopt;
};

/// The numbers of the scene exactly as they are.
Record to_record(const ForcedScene<double>& scene, const SolverOutput& output);
Record to_record(const ForcedScene<Rational>& scene, const SolverOutput& output);

/// What is missing from a set of fields for a complete record, or given twice; empty if nothing is.
std::string incomplete(std::uint32_t present);

/// The least binary64 of a field that is inside its domain for certain, however it was rounded.
double lowest_inside(Field f);

/// The first field that is NaN, infinite or outside the domain, with what was expected; empty if all is well.
std::string outside_domain(const Record& record);

/// The scene that a complete record in the domain means.
ForcedScene<Rational> exact_scene(const Record& record);

/// The same rounded, each number the nearest binary64; nothing if that takes exact arithmetic.
std::optional<ForcedScene<double>> rounded_scene(const Record& record);

}  // namespace slipproof

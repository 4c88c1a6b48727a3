#include "records/certify/record.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/number/binary64.hpp"
#include "base/number/format.hpp"

namespace slipproof {

namespace {

/// Two ways to say the same.
struct Forms {
  std::uint32_t first, second;
};
constexpr std::array<Forms, 5> forms{{
    {bit(Field::h), bit(Field::h0)},
    {bit(Field::b2) | bit(Field::b3), bit(Field::b)},
    {bit(Field::r1) | bit(Field::r2), bit(Field::mu)},
    {bit(Field::F), bit(Field::P)},
    {bit(Field::I1) | bit(Field::I2) | bit(Field::I3), bit(Field::M2) | bit(Field::M3)},
}};
constexpr std::uint32_t reduced = bit(Field::M2) | bit(Field::M3);

std::string listed(std::uint32_t fields) {
  std::string text;
  for (std::size_t i = 0; i < field_count; ++i) {
    if ((fields >> i & 1U) != 0) text += (text.empty() ? "" : ", ") + std::string(field_names[i]);
  }
  return text;
}

}  // namespace

void Record::set(Field f, const Rational& value) {
  const double nearest = nearest_binary64(value);
  set(f, nearest);
  if (!std::isfinite(nearest) || to_rational(nearest) != value) exact.emplace_back(f, value);
}

Rational Record::exactly(Field f) const {
  for (const auto& [field, value] : exact) {
    if (field == f) return value;
  }
  if (base != nullptr && (own & bit(f)) == 0) return base->exactly(f);
  return to_rational((*this)[f]);
}

bool Record::is_exact() const {
  if (!exact.empty()) return false;
  if (base == nullptr) return true;
  return std::none_of(base->exact.begin(), base->exact.end(),
                      [&](const auto& x) { return has(x.first) && (own & bit(x.first)) == 0; });
}

void Record::replace_other_forms(Field f) {
  for (const Forms& x : forms) {
    if ((x.first & bit(f)) != 0) present &= ~x.second;
    if ((x.second & bit(f)) != 0) present &= ~x.first;
  }
  if ((reduced & bit(f)) != 0) present &= ~(bit(Field::r1) | bit(Field::r2) | bit(Field::mu) | bit(Field::M));
}

namespace {

/// What a scene says, F where it is known.
template <class T>
Record record_of(const Bicycle<T>& p, const Road<T>& road, ForceKind kind, const T* F) {
  Record r;
  r.force_kind = kind;
  const std::array<const T*, direct_count> values{&p.M,    &p.R,    &p.h,  &p.b2, &p.b3, &p.I1,
                                                  &p.I2,   &p.I3,   &p.r1, &p.r2, &p.L,  p.J ? &*p.J : nullptr,
                                                  &road.f, &road.g, F};
  for (std::size_t i = 0; i < direct_count; ++i) {
    if (values[i] != nullptr) r.set(static_cast<Field>(i), *values[i]);
  }
  return r;
}

template <class T>
Record record_of(const ForcedScene<T>& scene, const SolverOutput& output) {
  Record r = record_of(scene.bicycle, scene.road, scene.force_kind, &scene.F);
  r.mode = output.mode;
  for (const auto& [field, value] :
       std::initializer_list<std::pair<Field, std::optional<double>>>{{Field::a, output.a},
                                                                      {Field::a_y, output.a_y},
                                                                      {Field::phi, output.phi},
                                                                      {Field::eps2, output.eps2},
                                                                      {Field::eps3, output.eps3},
                                                                      {Field::S2, output.S2},
                                                                      {Field::S3, output.S3},
                                                                      {Field::N2, output.N2},
                                                                      {Field::N3, output.N3}}) {
    if (value) r.set(field, *value);
  }
  return r;
}

}  // namespace

Record to_record(const Scene& scene) {
  return record_of(scene.bicycle, scene.road, scene.force_kind, scene.F ? &*scene.F : nullptr);
}

Record fresh_record(const Record& base) {
  Record record;
  record.values = base.values;
  record.present = base.present;
  record.force_kind = base.force_kind;
  record.base = &base;
  return record;
}

std::uint32_t over_scene(Record& base, std::uint32_t given) {
  for (auto rest = given; rest != 0; rest &= rest - 1)
    base.replace_other_forms(static_cast<Field>(std::countr_zero(rest)));
  return base.present | given;
}

Record to_record(const ForcedScene<double>& scene, const SolverOutput& output) {
  return record_of(scene, output);
}

Record to_record(const ForcedScene<Rational>& scene, const SolverOutput& output) {
  return record_of(scene, output);
}

std::string incomplete(std::uint32_t present) {
  for (const Forms& x : forms) {
    if ((present & x.first) != 0 && (present & x.second) != 0) {
      return "found " + listed(present & (x.first | x.second)) + " together, expected either " + listed(x.first) +
             " or " + listed(x.second);
    }
    const bool first = (present & x.first) == x.first, second = (present & x.second) == x.second;
    if (!first && !second && !((present & reduced) == reduced && (x.second & bit(Field::mu)) != 0)) {
      return "missing " + listed(x.first & ~present) + ", expected " + listed(x.first) + " or " + listed(x.second);
    }
  }
  constexpr auto fixed_by_reduced = bit(Field::r1) | bit(Field::r2) | bit(Field::mu) | bit(Field::M);
  if ((present & reduced) != 0 && (present & fixed_by_reduced) != 0) {
    return "found " + listed(present & fixed_by_reduced) + " with M2, M3, which mean M = 1 and mu = 1";
  }
  constexpr auto always = bit(Field::R) | bit(Field::L) | bit(Field::f) | bit(Field::g) | bit(Field::a) |
                          bit(Field::S2) | bit(Field::S3) | bit(Field::N2) | bit(Field::N3);
  auto missing = always & ~present;
  if ((present & reduced) == 0) missing |= bit(Field::M) & ~present;
  return missing == 0 ? "" : "missing " + listed(missing);
}

namespace {

constexpr auto positive = bit(Field::M) | bit(Field::R) | bit(Field::r1) | bit(Field::r2) | bit(Field::J) |
                          bit(Field::g) | bit(Field::h0) | bit(Field::b) | bit(Field::mu);
constexpr auto not_negative =
    bit(Field::I1) | bit(Field::I2) | bit(Field::I3) | bit(Field::M2) | bit(Field::M3) | bit(Field::f);

/// The least binary64 that is inside for certain, for each field.
constexpr auto lowest_of_fields = [] {
  std::array<double, field_count> lowest{};
  for (std::size_t i = 0; i < field_count; ++i) {
    const auto mask = std::uint32_t{1} << i;
    lowest[i] = (positive & mask) != 0       ? std::numeric_limits<double>::denorm_min()
                : (not_negative & mask) != 0 ? 0
                                             : std::numeric_limits<double>::lowest();
  }
  return lowest;
}();

/// Enough for most records: every number is written exactly and inside on its own, and so are the sums.
bool surely_inside(const Record& r) {
  std::uint32_t inside = 0;
  for (std::size_t i = 0; i < field_count; ++i) {
    const double x = r.values[i];
    const bool in = x >= lowest_of_fields[i] && x <= std::numeric_limits<double>::max();
    inside |= std::uint32_t{in} << i;
  }
  return (r.present & ~inside) == 0 && r.is_exact() && (!r.has(Field::h) || r[Field::h] > -r[Field::R]) &&
         (!r.has(Field::b2) || r[Field::b2] > -r[Field::b3]);
}

}  // namespace

double lowest_inside(Field f) {
  return lowest_of_fields[index(f)];
}

std::string outside_domain(const Record& r) {
  if (surely_inside(r)) return {};
  const auto report = [&](std::size_t i, const char* expected) {
    return std::string(field_names[i]) + ": " + expected;
  };
  for (auto rest = r.present; rest != 0; rest &= rest - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(rest));
    const double x = r.values[i];
    if (std::isnan(x)) return report(i, "found NaN, expected a finite number");
    if (std::isinf(x)) {
      return report(i, "found infinity or a number beyond the largest binary64, expected a finite number");
    }
    // A positive number may round to 0: the exact one decides then.
    const auto negative_or = [&](bool zero_counts) {
      if (x != 0) return x < 0;
      const int s = sign(r.exactly(static_cast<Field>(i)));
      return zero_counts ? s <= 0 : s < 0;
    };
    const auto mask = std::uint32_t{1} << i;
    if ((positive & mask) != 0 && negative_or(true)) return report(i, "expected a number > 0");
    if ((not_negative & mask) != 0 && negative_or(false)) return report(i, "expected a number >= 0");
  }
  if (r.has(Field::h)) {
    if (!(r[Field::h] > 0) && !(r.exactly(Field::h) + r.exactly(Field::R) > 0)) return "h: expected h > -R";
  }
  if (r.has(Field::b2) && !(r[Field::b2] > 0 && r[Field::b3] > 0)) {
    if (!(r.exactly(Field::b2) + r.exactly(Field::b3) > 0)) return "b2, b3: expected b2 + b3 > 0";
  }
  return {};
}

ForcedScene<Rational> exact_scene(const Record& r) {
  const auto x = [&](Field f) { return r.exactly(f); };
  const bool section3 = r.has(Field::M2), ratio = r.has(Field::mu);
  ForcedScene<Rational> s;
  Bicycle<Rational>& p = s.bicycle;
  p.R = x(Field::R);
  p.h = r.has(Field::h) ? x(Field::h) : Rational(x(Field::h0) - p.R);
  p.b2 = x(r.has(Field::b) ? Field::b : Field::b2);
  p.b3 = x(r.has(Field::b) ? Field::b : Field::b3);
  p.L = x(Field::L);
  p.M = section3 ? Rational(1) : x(Field::M);
  p.I1 = section3 ? Rational(0) : x(Field::I1);
  p.I2 = section3 ? Rational(x(Field::M2) * p.R * p.R) : x(Field::I2);
  p.I3 = section3 ? Rational(x(Field::M3) * p.R * p.R) : x(Field::I3);
  p.r1 = section3 || ratio ? Rational(1) : x(Field::r1);
  p.r2 = section3 ? Rational(1) : x(ratio ? Field::mu : Field::r2);
  if (r.has(Field::J)) p.J = x(Field::J);
  s.road = {x(Field::f), x(Field::g)};
  s.force_kind = r.force_kind;
  s.F = r.has(Field::F) ? x(Field::F) : Rational(x(Field::P) / sigma(p));
  return s;
}

std::optional<ForcedScene<double>> rounded_scene(const Record& r) {
  if (r.has(Field::M2) || r.has(Field::P)) return std::nullopt;
  // h0 - R is one rounding of the exact h only where h0 and R are exact.
  if (r.has(Field::h0) && !r.is_exact()) return std::nullopt;
  const bool ratio = r.has(Field::mu), equal = r.has(Field::b);
  ForcedScene<double> s{{.M = r[Field::M],
                         .R = r[Field::R],
                         .h = r.has(Field::h) ? r[Field::h] : r[Field::h0] - r[Field::R],
                         .b2 = r[equal ? Field::b : Field::b2],
                         .b3 = r[equal ? Field::b : Field::b3],
                         .I1 = r[Field::I1],
                         .I2 = r[Field::I2],
                         .I3 = r[Field::I3],
                         .r1 = ratio ? 1 : r[Field::r1],
                         .r2 = r[ratio ? Field::mu : Field::r2],
                         .L = r[Field::L],
                         .J = std::nullopt},
                        {r[Field::f], r[Field::g]},
                        r.force_kind,
                        r[Field::F]};
  if (r.has(Field::J)) s.bicycle.J = r[Field::J];
  return s;
}

}  // namespace slipproof

#include <array>
#include <limits>

#include "c/call.hpp"
#include "certify/record.hpp"
#include "filter/batch.hpp"

namespace slipproof::c {

namespace {

using Columns = std::array<const slipproof_column*, direct_count>;

/// In the order of Field.
Columns columns_of(const slipproof_bicycles& b) {
  return {&b.M, &b.R, &b.h, &b.b2, &b.b3, &b.I1, &b.I2, &b.I3, &b.r1, &b.r2, &b.L, &b.J, &b.f, &b.g, &b.F};
}

double at(const slipproof_column& column, std::size_t i) {
  return column.values[column.size == 1 ? 0 : i];
}

void check_sizes(const Columns& columns, std::size_t count) {
  for (std::size_t i = 0; i < direct_count; ++i) {
    const slipproof_column& column = *columns[i];
    const std::string symbol(field_names[i]);
    if (column.size == 0 && static_cast<Field>(i) == Field::J) continue;
    if (column.size != 1 && (column.size != count || count == 0)) {
      throw BadArgument(symbol,
                        "found " + std::to_string(column.size) + " numbers, expected 1 or " + std::to_string(count));
    }
    need(column.values, symbol.c_str());
  }
}

/// The judgement of one bicycle alone, which also weighs h and b2 against R and b3.
void check_alone(const Columns& columns, std::size_t bicycle) {
  Record record;
  for (std::size_t i = 0; i < direct_count; ++i) {
    if (columns[i]->size != 0) record.set(static_cast<Field>(i), at(*columns[i], bicycle));
  }
  const std::string message = outside_domain(record);
  if (!message.empty()) throw BadArgument("bicycle " + std::to_string(bicycle + 1), message);
}

/// Column by column, as that takes a fraction of the time.
void check_domain(const Columns& columns, std::size_t count) {
  for (std::size_t i = 0; i < direct_count; ++i) {
    const slipproof_column& column = *columns[i];
    const auto field = static_cast<Field>(i);
    const double least = field == Field::h || field == Field::b2 ? std::numeric_limits<double>::denorm_min()
                         : field == Field::b3                    ? 0
                                                                 : lowest_inside(field);
    for (std::size_t k = 0; k < std::min(column.size, count); ++k) {
      const double x = column.values[k];
      if (x >= least && x <= std::numeric_limits<double>::max()) continue;
      const std::size_t last = column.size == 1 ? count : k + 1;  // the same number beside others
      for (std::size_t bicycle = k; bicycle < last; ++bicycle) check_alone(columns, bicycle);
    }
  }
}

Column column(const slipproof_column& given) {
  return Column(std::span<const double>(given.values, given.size));
}

ForcedScene<Column> scenes_of(const slipproof_bicycles& b) {
  ForcedScene<Column> s{.bicycle = {.M = column(b.M),
                                    .R = column(b.R),
                                    .h = column(b.h),
                                    .b2 = column(b.b2),
                                    .b3 = column(b.b3),
                                    .I1 = column(b.I1),
                                    .I2 = column(b.I2),
                                    .I3 = column(b.I3),
                                    .r1 = column(b.r1),
                                    .r2 = column(b.r2),
                                    .L = column(b.L)},
                        .road = {column(b.f), column(b.g)},
                        .force_kind = b.external != 0 ? ForceKind::external : ForceKind::internal,
                        .F = column(b.F)};
  if (b.J.size != 0) s.bicycle.J = column(b.J);
  return s;
}

}  // namespace

}  // namespace slipproof::c

slipproof_status slipproof_consistent_modes(const slipproof_bicycles* bicycles, size_t count, uint16_t* consistent,
                                            uint16_t* strict, uint64_t tiers[3], unsigned threads,
                                            slipproof_error** error) {
  using namespace slipproof;
  return c::call(error, [&] {
    c::need(bicycles, "bicycles");
    const c::Columns columns = c::columns_of(*bicycles);
    c::check_sizes(columns, count);
    if (count == 0) return;
    c::need(consistent, "consistent");
    c::check_domain(columns, count);
    std::vector<ConsistentModes> answers(count);
    TierCounts counts{};
    consistent_modes(c::scenes_of(*bicycles), answers, counts, threads);
    for (std::size_t i = 0; i < count; ++i) {
      consistent[i] = answers[i].consistent;
      if (strict != nullptr) strict[i] = answers[i].strict;
    }
    if (tiers == nullptr) return;
    for (std::size_t i = 0; i < tier_count; ++i) tiers[i] += counts[i];
  });
}

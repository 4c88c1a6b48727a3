#include <array>
#include <limits>

#include "faces/c_interface/call.hpp"
#include "faces/c_interface/options.hpp"
#include "floating/filter/batch.hpp"
#include "records/certify/columns.hpp"

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

void check_size(const slipproof_column& column, std::size_t count, Field field) {
  const std::string symbol(field_names[index(field)]);
  if (column.size != 1 && (column.size != count || count == 0)) {
    throw BadArgument(symbol,
                      "found " + std::to_string(column.size) + " numbers, expected 1 or " + std::to_string(count));
  }
  need(column.values, symbol.c_str());
}

void check_sizes(const Columns& columns, std::size_t count) {
  for (std::size_t i = 0; i < direct_count; ++i) {
    const auto field = static_cast<Field>(i);
    if (columns[i]->size != 0 || field != Field::J) check_size(*columns[i], count, field);
  }
}

/// Checks one bicycle by itself, including h and b2 against R and b3.
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
      const std::size_t last = column.size == 1 ? count : k + 1;  // one number for all bicycles
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

/// All columns as the library takes them; one that is not given stays away.
RecordColumns records_of(const slipproof_bicycles& bicycles, const slipproof_answers& answers, std::size_t count) {
  RecordColumns records{.records = count};
  const auto put = [&](Field field, const slipproof_column& column) {
    if (column.size == 0) return;
    check_size(column, count, field);
    records[field] = {column.values, column.size == 1 ? 0 : static_cast<std::ptrdiff_t>(sizeof(double))};
  };
  const Columns parameters = columns_of(bicycles);
  for (std::size_t i = 0; i < direct_count; ++i) put(static_cast<Field>(i), *parameters[i]);
  const slipproof_answers& x = answers;
  const std::array<const slipproof_column*, answer_count> given{&x.a,  &x.a_y, &x.phi, &x.eps2, &x.eps3,
                                                                &x.S2, &x.S3,  &x.N2,  &x.N3};
  for (std::size_t i = 0; i < answer_count; ++i) put(static_cast<Field>(parameter_count + i), *given[i]);
  static constexpr std::array<std::uint8_t, 2> kinds{0, 1};
  records.kinds = {&kinds[bicycles.external != 0 ? 1 : 0], 0};
  if (answers.modes != nullptr) records.modes = {answers.modes, 1};
  return records;
}

template <class T>
std::span<T> wanted(T* array, std::size_t count) {
  return {array, array == nullptr ? 0 : count};
}

/// An enumeration has a type of its own, which C does not know.
template <class Enumeration>
void copy_codes(const std::vector<Enumeration>& from, std::uint8_t* to) {
  for (std::size_t i = 0; i < from.size(); ++i) to[i] = static_cast<std::uint8_t>(from[i]);
}

void certify_records(const RecordColumns& records, const ColumnsOptions& options, const slipproof_judgements& to) {
  std::vector<RecordVerdict> verdicts(to.verdicts == nullptr ? 0 : records.records);
  std::vector<Tier> tiers(to.tiers == nullptr ? 0 : records.records);
  try {
    certify(records, options,
            {.verdicts = verdicts,
             .modes = wanted(to.modes, records.records),
             .errors = wanted(to.errors, records.records),
             .tiers = tiers});
  } catch (const std::invalid_argument& error) {
    throw BadArgument("bicycles, answers", error.what());
  }
  copy_codes(verdicts, to.verdicts);
  copy_codes(tiers, to.tiers);
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

slipproof_status slipproof_certify_bicycles(const slipproof_bicycles* bicycles, const slipproof_answers* answers,
                                            size_t count, const slipproof_certify_options* options,
                                            const slipproof_judgements* judgements, unsigned threads,
                                            slipproof_error** error) {
  using namespace slipproof;
  return c::call(error, [&] {
    c::need(bicycles, "bicycles");
    c::need(answers, "answers");
    c::need(judgements, "judgements");
    if (count == 0) return;
    const RecordColumns records = c::records_of(*bicycles, *answers, count);
    c::certify_records(records, {.judge = c::options_of(options).scene, .threads = threads}, *judgements);
  });
}

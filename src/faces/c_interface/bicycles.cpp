#include <array>
#include <string>
#include <utility>

#include "faces/c_interface/call.hpp"
#include "faces/c_interface/options.hpp"
#include "floating/batch/bicycle_batch.hpp"
#include "records/certify/columns.hpp"
#include "records/record/bicycle_records.hpp"

namespace slipproof::c {

namespace {

using NamedColumn = std::pair<std::string_view, const slipproof_column*>;

/// The columns in the order of BicycleColumns, then F.
std::array<NamedColumn, 15> columns_of(const slipproof_bicycles& b) {
  const std::array<const slipproof_column*, 15> given{&b.M,  &b.R,  &b.h, &b.b2, &b.b3, &b.I1, &b.I2, &b.I3,
                                                      &b.r1, &b.r2, &b.L, &b.J,  &b.f,  &b.g,  &b.F};
  std::array<NamedColumn, 15> named;
  for (std::size_t i = 0; i < named.size(); ++i) {
    named[i] = {i + 1 < named.size() ? BicycleColumns::symbols[i] : "F", given[i]};
  }
  return named;
}

void check_size(const NamedColumn& named, std::size_t count) {
  const auto& [symbol, column] = named;
  if (column->size != 1 && (column->size != count || count == 0)) {
    throw BadArgument(std::string(symbol),
                      "found " + std::to_string(column->size) + " numbers, expected 1 or " + std::to_string(count));
  }
  need(column->values, std::string(symbol).c_str());
}

BicycleColumns bicycles_of(const slipproof_bicycles& b, std::size_t count) {
  BicycleColumns result;
  result.external = b.external != 0;
  const auto columns = columns_of(b);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto& [symbol, column] = columns[i];
    if (symbol == "J" && column->size == 0) continue;
    check_size(columns[i], count);
    (i < result.numbers.size() ? result.numbers[i] : result.F) =
        Column(std::span<const double>(column->values, column->size));
  }
  return result;
}

/// Converts each of the solver's codes to a mode number.
std::vector<std::uint16_t> mode_codes(const std::uint8_t* modes, std::size_t count) {
  std::vector<std::uint16_t> codes(modes == nullptr ? 0 : count);
  for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = modes[i] == 255 ? no_mode : modes[i];
  return codes;
}

/// All given columns as the library takes them.
RecordColumns records_of(const RecordFields& fields, const slipproof_bicycles& bicycles, const slipproof_answers& x,
                         const std::vector<std::uint16_t>& modes, const double& external, std::size_t count) {
  RecordColumns records(fields, count);
  const auto put = [&](const NamedColumn& named) {
    const auto& [symbol, column] = named;
    if (column->size == 0) return;
    check_size(named, count);
    records.number(symbol) = {column->values, column->size == 1 ? 0 : static_cast<std::ptrdiff_t>(sizeof(double))};
  };
  for (const NamedColumn& named : columns_of(bicycles)) put(named);
  for (const NamedColumn& named : {NamedColumn{"a", &x.a},
                                   {"a_y", &x.a_y},
                                   {"phi", &x.phi},
                                   {"eps2", &x.eps2},
                                   {"eps3", &x.eps3},
                                   {"S2", &x.S2},
                                   {"S3", &x.S3},
                                   {"N2", &x.N2},
                                   {"N3", &x.N3}}) {
    put(named);
  }
  records.number("external") = {&external, 0};
  if (!modes.empty()) records.modes = std::span<const std::uint16_t>(modes);
  return records;
}

template <class T>
std::span<T> wanted(T* array, std::size_t count) {
  return {array, array == nullptr ? 0 : count};
}

/// Converts an enumeration, which has a type of its own, to the type that C has.
template <class From, class To>
void copy_codes(const std::vector<From>& from, To* to) {
  for (std::size_t i = 0; i < from.size(); ++i) to[i] = static_cast<To>(from[i]);
}

void certify_records(const RecordColumns& records, const RecordJudge& judge, unsigned threads,
                     const slipproof_judgements& to) {
  std::vector<RecordVerdict> verdicts(to.verdicts == nullptr ? 0 : records.records);
  std::vector<std::uint64_t> modes(to.modes == nullptr ? 0 : records.records);
  std::vector<Tier> tiers(to.tiers == nullptr ? 0 : records.records);
  try {
    certify(records, judge,
            {.verdicts = verdicts, .modes = modes, .errors = wanted(to.errors, records.records), .tiers = tiers},
            threads);
  } catch (const std::invalid_argument& error) {
    throw BadArgument("bicycles, answers", error.what());
  }
  copy_codes(verdicts, to.verdicts);
  copy_codes(modes, to.modes);
  copy_codes(tiers, to.tiers);
}

BicycleModes modes_of(const slipproof_bicycles& bicycles, std::size_t count, unsigned threads) {
  const BicycleColumns columns = bicycles_of(bicycles, count);
  try {
    return consistent_modes(columns, threads);
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    const std::size_t colon = message.find(": ");
    throw BadArgument(message.substr(0, colon), message.substr(colon + 2));
  }
}

}  // namespace

}  // namespace slipproof::c

slipproof_status slipproof_consistent_modes(const slipproof_bicycles* bicycles, size_t count, uint16_t* consistent,
                                            uint16_t* strict, uint64_t tiers[2], unsigned threads,
                                            slipproof_error** error) {
  using namespace slipproof;
  return c::call(error, [&] {
    c::need(bicycles, "bicycles");
    if (count == 0) {
      c::bicycles_of(*bicycles, count);
      return;
    }
    c::need(consistent, "consistent");
    const BicycleModes found = c::modes_of(*bicycles, count, threads);
    const TierCounts counts = found.counts();
    for (std::size_t i = 0; i < count; ++i) {
      // If all bicycles are the same one, there is one answer.
      const std::size_t from = found.consistent.size() == 1 ? 0 : i;
      consistent[i] = found.consistent[from];
      if (strict != nullptr) strict[i] = found.strict[from];
    }
    if (tiers == nullptr) return;
    for (std::size_t i = 0; i < tier_count; ++i) tiers[i] += counts[i] * (count / found.consistent.size());
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
    const std::vector<std::uint16_t> modes = c::mode_codes(answers->modes, count);
    const double external = bicycles->external != 0 ? 1 : 0;
    const RecordJudge judge(bicycle_records(), c::options_of(options).scene);
    const RecordColumns records = c::records_of(judge.fields(), *bicycles, *answers, modes, external, count);
    c::certify_records(records, judge, threads, *judgements);
  });
}

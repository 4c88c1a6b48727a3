#include "contact/rest/rest_program.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/number/binary64.hpp"
#include "base/number/simplest.hpp"
#include "contact/complete/program/column_program.hpp"

namespace slipproof {

CirclePoint circle_point_near(double angle) {
  constexpr double near = 1.0 / (1 << 20);
  const double c = std::cos(angle), s = std::sin(angle);
  const double half = s / (1 + std::abs(c));  // the tangent of half the angle to the x axis, from -1 to 1
  const Rational t = simplest_between(to_rational(half - near), to_rational(half + near));
  const Rational square = t * t, length = square + 1;
  const Rational x = (1 - square) / length;
  return {c < 0 ? -x : x, 2 * t / length};
}

RestPolygons first_polygons(const RestProblem& problem) {
  const Rational a(Integer(20), Integer(29)), b(Integer(21), Integer(29));
  const std::vector<CirclePoint> eight{{1, 0}, {a, b}, {0, 1}, {-a, b}, {-1, 0}, {-a, -b}, {0, -1}, {a, -b}};
  RestPolygons result;
  for (const RestProblem::Contact& contact : problem.contacts) {
    result.push_back(contact.tangents.size() == 2 ? eight : std::vector<CirclePoint>());
  }
  return result;
}

RestPush push_at(const RestProblem& problem, const std::optional<Rational>& load) {
  RestPush push{load ? problem.push_at(*load) : problem.f_load, {}};
  for (const RestProblem::Limit& limit : problem.limits) {
    push.limits.push_back(load ? limit.constant + *load * limit.load : limit.load);
  }
  return push;
}

RestProgram::RestProgram(const RestProblem& problem, const RestPolygons& polygons, Cones cones) : problem_(problem) {
  for (std::size_t k = 0; k < problem.contacts.size(); ++k) add_contact(problem.contacts[k], polygons[k], cones);
  for (const std::size_t force : problem.free) add({{force, 1}}, true);
  const Rational half(Integer(1), Integer(2));
  for (std::size_t l = 0; l < problem.limits.size(); ++l) {
    for (const Rational& part : {half, Rational(-half)}) add({{problem.limits[l].force, part}}, false, l);
  }
}

void RestProgram::add_contact(const RestProblem::Contact& contact, const std::vector<CirclePoint>& polygon,
                              Cones cones) {
  const std::pair<std::size_t, Rational> normal{contact.normal, 1};
  if (contact.tangents.empty()) return add({normal}, false);
  if (contact.tangents.size() == 1) {
    add({normal, {contact.tangents[0], contact.mu}}, false);
    return add({normal, {contact.tangents[0], -contact.mu}}, false);
  }
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    CirclePoint d = polygon[i];
    if (cones == Cones::around) {  // where the tangents of neighbours meet
      const CirclePoint& e = polygon[(i + 1) % polygon.size()];
      const Rational scale = 1 + d[0] * e[0] + d[1] * e[1];
      d = {(d[0] + e[0]) / scale, (d[1] + e[1]) / scale};
    }
    Parts parts{normal};
    for (std::size_t t = 0; t < 2; ++t) {
      if (!d[t].is_zero()) parts.emplace_back(contact.tangents[t], contact.mu * d[t]);
    }
    add(std::move(parts), false);
  }
}

/// Rows: balance, then for each limit that the two parts of its force, S = (p - q)/2, are p + q = 2 limit.
void RestProgram::add(Parts parts, bool is_free, std::optional<std::size_t> limit) {
  std::map<std::uint32_t, Rational> entries;
  const auto rows = static_cast<std::uint32_t>(problem_.rows.size());
  for (const auto& [force, part] : parts) {
    for (const auto& [row, value] : problem_.along[force]) entries[row] += part * value;
    for (std::uint32_t l = 0; l < problem_.limits.size(); ++l) {
      for (const auto& [other, value] : problem_.limits[l].terms) {
        if (other == force) entries[rows + l] -= 2 * part * value;
      }
    }
  }
  if (limit) entries[rows + static_cast<std::uint32_t>(*limit)] += 1;
  ProgramColumn column{{}, 0, is_free};
  for (auto& [row, value] : entries) {
    if (!value.is_zero()) column.entries.emplace_back(row, std::move(value));
  }
  columns_.push_back(std::move(column));
  parts_.push_back(std::move(parts));
}

std::vector<Rational> RestProgram::right_side(const RestPush& push) const {
  std::vector<Rational> result;
  for (const Rational& f : push.f) result.push_back(-f);
  for (const Rational& limit : push.limits) result.push_back(2 * limit);
  return result;
}

SparseProgram RestProgram::margin(const RestPush& push) const {
  SparseProgram program{right_side(push), columns_};
  const auto last = static_cast<std::uint32_t>(program.rows());
  Rational most;
  for (const Rational& value : program.right_side) most = std::max(most, abs(value));
  program.right_side.push_back(most.is_zero() ? Rational(1) : most);
  std::vector<Rational> sum(last);
  for (const ProgramColumn& column : columns_) {
    if (column.is_free) continue;
    for (const auto& [row, value] : column.entries) sum[row] += value;
  }
  ProgramColumn margin{{}, -1, true};
  for (std::uint32_t i = 0; i < last; ++i) {
    if (!sum[i].is_zero()) margin.entries.emplace_back(i, std::move(sum[i]));
  }
  margin.entries.emplace_back(last, 1);
  program.columns.push_back(std::move(margin));
  program.columns.push_back({{{last, 1}}, 0, false});
  return program;
}

SparseProgram RestProgram::extreme(const RestPush& push, const std::vector<VariedLoad>& loads) const {
  SparseProgram program{right_side(push), columns_};
  const std::size_t rows = program.rows();
  std::vector<ProgramColumn> beyond;  // how far each load is from its ends: a row each
  for (const VariedLoad& load : loads) {
    const bool from_zero = load.from && load.from->is_zero();
    ProgramColumn column{{}, load.cost, !from_zero};
    const std::vector<Rational> moved = right_side(load.unit);
    for (std::uint32_t i = 0; i < rows; ++i) {
      if (!moved[i].is_zero()) column.entries.emplace_back(i, -moved[i]);
    }
    const auto bound = [&](const Rational& end, int side) {
      const auto row = static_cast<std::uint32_t>(program.rows());
      program.right_side.push_back(end);
      column.entries.emplace_back(row, 1);
      beyond.push_back({{{row, side}}, 0, false});
    };
    if (load.from && !from_zero) bound(*load.from, -1);
    if (load.to) bound(*load.to, 1);
    program.columns.push_back(std::move(column));
  }
  std::ranges::move(beyond, std::back_inserter(program.columns));
  return program;
}

namespace {

/// Powers of two that bring the largest entry of each row, then of each column, near 1.
struct ProgramScales {
  std::vector<double> rows, columns;
  double right_side = 1;

  explicit ProgramScales(const SparseProgram& program) : rows(program.rows(), 0), columns(program.columns.size(), 0) {
    for (const ProgramColumn& column : program.columns) {
      for (const auto& [row, value] : column.entries) rows[row] = std::max(rows[row], std::abs(value.to_double()));
    }
    std::ranges::for_each(rows, invert);
    for (std::size_t j = 0; j < columns.size(); ++j) {
      for (const auto& [row, value] : program.columns[j].entries) {
        columns[j] = std::max(columns[j], std::abs(value.to_double()) * rows[row]);
      }
    }
    std::ranges::for_each(columns, invert);
    double largest = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      largest = std::max(largest, std::abs(program.right_side[i].to_double()) * rows[i]);
    }
    invert(largest);
    right_side = largest;
  }

 private:
  static void invert(double& largest) {
    largest = largest > 0 && std::isfinite(largest) ? std::exp2(-std::ilogb(largest)) : 1;
  }
};

}  // namespace

std::optional<ProposedOptimum> proposed(const SparseProgram& program) {
#ifdef SLIPPROOF_CLP
  constexpr double tolerance = 1e-9, infeasible = 1e-7;
  const ProgramScales scales(program);
  std::vector<double> right_side;
  for (std::size_t i = 0; i < program.rows(); ++i) {
    right_side.push_back(nearest_binary64(program.right_side[i]) * scales.rows[i] * scales.right_side);
  }
  std::vector<ColumnProgram::Column> columns;
  for (std::size_t j = 0; j < program.columns.size(); ++j) {
    columns.emplace_back();
    for (const auto& [row, value] : program.columns[j].entries) {
      columns.back().push_back({static_cast<int>(row), nearest_binary64(value) * scales.rows[row] * scales.columns[j]});
    }
  }
  ColumnProgram clp(right_side, std::vector<bool>(program.rows()), columns);
  clp.allow_pivots(static_cast<int>(20 * (program.rows() + program.columns.size()) + 2000));
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (program.columns[j].is_free) clp.make_free(j);
  }
  if (!clp.solve(tolerance)) return std::nullopt;
  ProposedOptimum result;
  result.kind = ProposedOptimum::Kind::infeasible;
  if (clp.least() <= infeasible) {
    clp.bound_slacks(0);
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (program.columns[j].cost.is_zero()) continue;
      clp.set_cost(j, nearest_binary64(program.columns[j].cost) * scales.columns[j]);
    }
    result.kind = clp.solve(tolerance) ? ProposedOptimum::Kind::optimal : ProposedOptimum::Kind::other;
  }
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (clp.is_basic(j)) result.basis.push_back(j);
    result.x.push_back(clp.value(j) * scales.columns[j] / scales.right_side);
    result.least += result.x.back() * program.columns[j].cost.to_double();
  }
  for (std::size_t i = 0; i < program.rows(); ++i) result.y.push_back(clp.price(i) * scales.rows[i]);
  if (result.basis.size() > program.rows()) return std::nullopt;
  return result;
#else
  static_cast<void>(program);
  return std::nullopt;
#endif
}

}  // namespace slipproof

#include "claims/continua/brute_force.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace slipproof::test {

namespace {

/// Coefficients, and the constant last.
using Row = std::vector<Rational>;

struct Condition {
  Row row;
  bool strict;  ///< > 0, otherwise >= 0
};

struct System {
  std::vector<Row> equations;
  std::vector<Condition> conditions;
};

void add(Row& row, const Rational& factor, const Row& other) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (!other[i].is_zero()) row[i] += factor * other[i];
  }
}

/// Solves the equations: each leaves an unknown out of all other rows. False if they have no solution.
bool eliminate_equations(System& system, std::vector<Row>& kept) {
  for (std::size_t e = 0; e < system.equations.size(); ++e) {
    const Row pivot_row = system.equations[e];
    const auto pivot = std::find_if(pivot_row.begin(), pivot_row.end() - 1, [](const auto& x) { return !x.is_zero(); });
    if (pivot == pivot_row.end() - 1) {
      if (!pivot_row.back().is_zero()) return false;
      continue;
    }
    const auto column = static_cast<std::size_t>(pivot - pivot_row.begin());
    const auto clear = [&](Row& row) {
      if (!row[column].is_zero()) add(row, -row[column] / pivot_row[column], pivot_row);
    };
    for (std::size_t other = e + 1; other < system.equations.size(); ++other) clear(system.equations[other]);
    for (Condition& condition : system.conditions) clear(condition.row);
    for (Row& row : kept) clear(row);
  }
  return true;
}

/// Eliminates one unknown from conditions by Fourier and Motzkin.
std::vector<Condition> without(const std::vector<Condition>& conditions, std::size_t column) {
  std::vector<Condition> result, above, below;
  for (const Condition& c : conditions) {
    const int sign = c.row[column].sign();
    (sign == 0 ? result : sign > 0 ? above : below).push_back(c);
  }
  for (const Condition& x : above) {
    for (const Condition& y : below) {
      Condition sum = x;
      add(sum.row, -x.row[column] / y.row[column], y.row);
      sum.strict = x.strict || y.strict;
      result.push_back(std::move(sum));
    }
  }
  return result;
}

/// The column in which elimination makes the fewest conditions, of those before `end` that occur; nothing if none does.
std::optional<std::size_t> cheapest(const std::vector<Condition>& conditions, std::size_t end) {
  std::optional<std::size_t> best;
  std::size_t least = 0;
  for (std::size_t column = 0; column < end; ++column) {
    std::size_t above = 0, below = 0;
    for (const Condition& c : conditions) (c.row[column].sign() > 0 ? above : below) += c.row[column].is_zero() ? 0 : 1;
    if (above + below == 0) continue;
    if (!best || above * below < least) best = column, least = above * below;
  }
  return best;
}

void eliminate_before(std::vector<Condition>& conditions, std::size_t end) {
  while (const auto column = cheapest(conditions, end)) conditions = without(conditions, *column);
}

bool is_solvable(System system) {
  std::vector<Row> none;
  if (!eliminate_equations(system, none)) return false;
  if (system.conditions.empty()) return true;
  eliminate_before(system.conditions, system.conditions.front().row.size() - 1);
  return std::ranges::all_of(system.conditions, [](const Condition& c) {
    return c.strict ? c.row.back().sign() > 0 : c.row.back().sign() >= 0;
  });
}

/// The one value of a form on all solutions of a system that has some; nothing if it varies.
std::optional<Rational> only_value(System system, Row form) {
  std::vector<Row> kept{std::move(form)};
  eliminate_equations(system, kept);
  Row value = std::move(kept.front());
  if (std::all_of(value.begin(), value.end() - 1, [](const auto& x) { return x.is_zero(); })) return value.back();
  const auto with_value = [](Row row, const Rational& coefficient) {
    row.insert(row.end() - 1, coefficient);
    return row;
  };
  std::vector<Condition> conditions;
  for (Condition& c : system.conditions) conditions.push_back({with_value(std::move(c.row), 0), false});
  Row opposite = value;
  for (Rational& x : opposite) x = -x;
  conditions.push_back({with_value(std::move(value), -1), false});
  conditions.push_back({with_value(std::move(opposite), 1), false});
  const std::size_t column = conditions.front().row.size() - 2;
  eliminate_before(conditions, column);
  std::optional<Rational> lower, upper;
  for (const Condition& c : conditions) {
    const int sign = c.row[column].sign();
    if (sign == 0) continue;
    const Rational end = -c.row.back() / c.row[column];
    if (sign > 0 && (!lower || end > *lower)) lower = end;
    if (sign < 0 && (!upper || end < *upper)) upper = end;
  }
  return lower && upper && *lower == *upper ? lower : std::nullopt;
}

/// The unknowns are ax, ay, alpha, then N and S of each contact.
class AllModes {
 public:
  AllModes(const Body& body, const Rational& load) : body_(body), size_(3 + 2 * body.contacts.size() + 1) {
    for (std::size_t i = 0; i < 3; ++i) {
      Row row(size_);
      row[i] = body.mass[i];
      row.back() = -body.force[i] - body.load[i] * load;
      for (std::size_t k = 0; k < body.contacts.size(); ++k) {
        row[3 + 2 * k] = -body.contacts[k].gap[i];
        row[4 + 2 * k] = -body.contacts[k].slip[i];
      }
      dynamics_.push_back(std::move(row));
    }
  }

  static constexpr std::array<const char*, 4> states{"stick", "slip+", "slip-", "lift"};

  System system(const std::vector<std::size_t>& mode, bool strict) const {
    System result{dynamics_, {}};
    const auto condition = [&](Row row) { result.conditions.push_back({std::move(row), strict}); };
    for (std::size_t k = 0; k < mode.size(); ++k) {
      const BodyContact& contact = body_.contacts[k];
      const Row normal = unit(3 + 2 * k, 1), tangent = unit(4 + 2 * k, 1);
      if (mode[k] == 3) {
        result.equations.insert(result.equations.end(), {normal, tangent});
        condition(motion(contact.gap, 1));
        continue;
      }
      result.equations.push_back(motion(contact.gap, 1));
      condition(normal);
      if (mode[k] == 0) {
        result.equations.push_back(motion(contact.slip, 1));
        condition(friction(k, contact.static_friction, 1));
        condition(friction(k, contact.static_friction, -1));
      } else {
        const int direction = mode[k] == 1 ? 1 : -1;
        result.equations.push_back(friction(k, contact.kinetic_friction, direction));
        condition(motion(contact.slip, direction));
      }
    }
    return result;
  }

  /// That an acceleration has a value.
  Row acceleration(std::size_t i, const Rational& value) const {
    Row row = unit(i, 1);
    row.back() = -value;
    return row;
  }

 private:
  Row unit(std::size_t column, const Rational& value) const {
    Row row(size_);
    row[column] = value;
    return row;
  }
  Row motion(const std::array<Rational, 3>& form, int sign) const {
    Row row(size_);
    for (std::size_t i = 0; i < 3; ++i) row[i] = sign * form[i];
    return row;
  }
  /// mu N + sign S.
  Row friction(std::size_t k, const Rational& mu, int sign) const {
    Row row = unit(3 + 2 * k, mu);
    row[4 + 2 * k] = sign;
    return row;
  }

  const Body& body_;
  std::size_t size_;
  std::vector<Row> dynamics_;
};

std::optional<Accelerations> only_accelerations(const AllModes& modes, const System& system) {
  Accelerations result;
  for (std::size_t i = 0; i < 3; ++i) {
    auto value = only_value(system, modes.acceleration(i, 0));
    if (!value) return std::nullopt;
    result.push_back(std::move(*value));
  }
  return result;
}

}  // namespace

std::set<std::string> BruteMotions::consistent(bool strict) const {
  std::set<std::string> result;
  for (const auto& [accelerations, motion] : motions) {
    result.insert(motion.modes.begin(), motion.modes.end());
    if (!strict) result.insert(motion.boundary_modes.begin(), motion.boundary_modes.end());
  }
  for (const auto& [mode, is_strict] : continua) {
    if (is_strict || !strict) result.insert(mode);
  }
  return result;
}

BruteMotions brute_force(const Body& body, const Rational& load) {
  const AllModes modes(body, load);
  BruteMotions result;
  std::map<std::string, System> continua;
  std::vector<std::size_t> mode(body.contacts.size());
  for (bool more = true; more;) {
    ++result.modes;
    const System closed = modes.system(mode, false);
    if (is_solvable(closed)) {
      std::string name;
      for (const std::size_t state : mode) name += (name.empty() ? "" : "/") + std::string(AllModes::states[state]);
      const bool strict = is_solvable(modes.system(mode, true));
      if (const auto accelerations = only_accelerations(modes, closed)) {
        BruteMotions::Motion& motion = result.motions[*accelerations];
        (strict ? motion.modes : motion.boundary_modes).insert(name);
      } else {
        result.continua[name] = strict;
        continua[name] = closed;
      }
    }
    std::size_t k = 0;
    while (k < mode.size() && ++mode[k] == AllModes::states.size()) mode[k++] = 0;
    more = k < mode.size();
  }
  for (auto& [accelerations, motion] : result.motions) {
    for (const auto& [name, system] : continua) {
      System there = system;
      for (std::size_t i = 0; i < 3; ++i) there.equations.push_back(modes.acceleration(i, accelerations[i]));
      if (is_solvable(std::move(there))) motion.continua.insert(name);
    }
  }
  return result;
}

int RandomBodies::integer(int low, int high) {  // splitmix64
  std::uint64_t x = state_ += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  x ^= x >> 31U;
  return low + static_cast<int>(x % static_cast<std::uint64_t>(high - low + 1));
}

/// At a random point, with a random normal.
BodyContact RandomBodies::contact() {
  constexpr std::array<std::array<int, 2>, 8> normals{
      {{0, 1}, {1, 0}, {-1, 0}, {0, 1}, {3, 4}, {-3, 4}, {1, 1}, {0, -1}}};
  const auto& [nx, ny] = normals[static_cast<std::size_t>(integer(0, 7))];
  const int x = integer(-2, 2), y = integer(-2, 1);
  BodyContact result;
  result.gap = {Rational(nx), Rational(ny), Rational(x * ny - y * nx)};
  result.slip = {Rational(ny), Rational(-nx), Rational(-x * nx - y * ny)};
  result.kinetic_friction = Rational(integer(0, 4), 2);
  result.static_friction = result.kinetic_friction + Rational(integer(0, 3) == 0 ? integer(1, 2) : 0, 2);
  return result;
}

Body RandomBodies::body(std::size_t contacts) {
  Body result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.force[i] = integer(0, 2) == 0 ? 0 : integer(-3, 3);
    result.load[i] = integer(0, 1) == 0 ? 0 : integer(-1, 1);
  }
  const Rational mass = integer(0, 4) == 0 ? 0 : integer(1, 2);
  result.mass = {mass, mass, integer(0, 3) == 0 ? Rational(0) : Rational(integer(1, 4), 2)};
  for (std::size_t k = 0; k < contacts; ++k) {
    BodyContact next = contact();
    if (k > 0) {
      const BodyContact& last = result.contacts.back();
      const int kind = integer(0, 4);
      if (kind == 0) {  // a wall on the other side, straight across
        for (std::size_t i = 0; i < 3; ++i) next.gap[i] = -last.gap[i];
        next.slip = last.slip;
        if (integer(0, 1) == 0) next.slip[2] += integer(-1, 1);
      } else if (kind == 1) {  // the same again
        next = last;
      } else if (kind == 2) {  // on the same level
        const Rational along = integer(-3, 3);
        next.gap = last.gap, next.slip = last.slip;
        next.gap[2] += along;
      }
    }
    result.contacts.push_back(std::move(next));
  }
  return result;
}

}  // namespace slipproof::test

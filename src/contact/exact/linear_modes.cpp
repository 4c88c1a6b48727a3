#include "contact/exact/linear_modes.hpp"

#include <algorithm>

#include "base/number/binary64.hpp"
#include "base/parallel/stop.hpp"

namespace slipproof {

namespace {

enum class Contact : std::uint8_t { open, stick, closed, slides };

/// A contact's state; `closed` has no friction. One that slides does so along a tangential axis.
struct State {
  Contact kind = Contact::open;
  std::size_t axis = 0;  ///< 1 or 2
  int sign = 0;          ///< of the slip
};

std::vector<State> states_of(const MixedProblem& problem, std::size_t k, Slides slides) {
  if (problem.dimension == 1 || problem.mu[k] == 0) return {{Contact::open}, {Contact::closed}};
  std::vector<State> states{{Contact::open}, {Contact::stick}};
  for (std::size_t axis = 1; axis < problem.dimension && (problem.dimension == 2 || slides == Slides::axes); ++axis) {
    for (const int sign : {1, -1}) states.push_back({Contact::slides, axis, sign});
  }
  return states;
}

/// Linear equations between forces: those of closed contacts as far as they are solved, and velocities of contacts that
/// are not decided yet.
class Tableau {
 public:
  explicit Tableau(const ContactProblem& problem) {
    for (std::size_t i = 0; i < problem.size(); ++i) {
      columns_.push_back({i, false});
      rows_.push_back({i, Row::Kind::velocity, problem.W[i], problem.q[i]});
    }
  }

  /// The force is 0.
  void drop_column(std::size_t component) {
    const std::size_t j = column_of(component);
    columns_.erase(columns_.begin() + static_cast<std::ptrdiff_t>(j));
    for (Row& row : rows_) row.a.erase(row.a.begin() + static_cast<std::ptrdiff_t>(j));
  }
  /// The velocity may be anything.
  void drop_row(std::size_t component) {
    std::erase_if(rows_, [&](const Row& row) { return row.is_velocity(component); });
  }

  /// The force of `tangential` is `factor` times that of `normal`.
  void tie(std::size_t tangential, std::size_t normal, const Rational& factor) {
    const std::size_t from = column_of(tangential), to = column_of(normal);
    for (Row& row : rows_) row.a[to] += factor * row.a[from];
    drop_column(tangential);
  }

  /// The force may be anything.
  void free_column(std::size_t component) { columns_[column_of(component)].closed = true; }
  /// The velocity is 0.
  void stop_row(std::size_t component) {
    for (Row& row : rows_) {
      if (row.is_velocity(component)) row.kind = Row::Kind::zero;
    }
  }

  /// Solves the rows that are 0 for forces of closed contacts, as many as can be. False if one of them has no solution
  /// whatever the other contacts do.
  bool eliminate() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (rows_[i].kind != Row::Kind::zero) continue;
      for (std::size_t j = 0; j < columns_.size(); ++j) {
        if (!columns_[j].closed || rows_[i].a[j].is_zero()) continue;
        solve(i, j);
        break;
      }
      const auto is_zero = [](const Rational& a) { return a.is_zero(); };
      if (rows_[i].kind == Row::Kind::zero && !rows_[i].constant.is_zero() && std::ranges::all_of(rows_[i].a, is_zero))
        return false;
    }
    return true;
  }

  /// Once all contacts are decided: whether something leaves forces open.
  bool is_determined() const { return columns_.empty(); }
  /// The forces, with the open ones at value(component).
  template <class Value>
  std::vector<Rational> forces(std::size_t size, const Value& value) const {
    std::vector<Rational> r(size), open;
    for (const Column& column : columns_) {
      open.push_back(value(column.component));
      r[column.component] = open.back();
    }
    for (const Row& row : rows_) {
      if (row.kind != Row::Kind::force) continue;
      Rational& sum = r[row.component] = row.constant;
      for (std::size_t j = 0; j < open.size(); ++j) sum += row.a[j] * open[j];
    }
    return r;
  }

 private:
  struct Column {
    std::size_t component;
    bool closed;  ///< its contact is
  };
  struct Row {
    enum class Kind : std::uint8_t { velocity, zero, force };
    std::size_t component;
    Kind kind;
    std::vector<Rational> a;
    Rational constant;
    bool is_velocity(std::size_t i) const { return kind == Kind::velocity && component == i; }
  };

  std::size_t column_of(std::size_t component) const {
    return static_cast<std::size_t>(std::ranges::find(columns_, component, &Column::component) - columns_.begin());
  }

  /// Row i, which is 0, for the force of column j, which it replaces everywhere.
  void solve(std::size_t i, std::size_t j) {
    Row& pivot = rows_[i];
    const Rational by = -pivot.a[j];
    const auto place = static_cast<std::ptrdiff_t>(j);
    pivot.a.erase(pivot.a.begin() + place);
    for (Rational& a : pivot.a) a /= by;
    pivot.constant /= by;
    pivot.kind = Row::Kind::force;
    pivot.component = columns_[j].component;
    columns_.erase(columns_.begin() + place);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (k == i) continue;
      const Rational factor = rows_[k].a[j];
      rows_[k].a.erase(rows_[k].a.begin() + place);
      if (factor.is_zero()) continue;
      for (std::size_t l = 0; l < pivot.a.size(); ++l) rows_[k].a[l] += factor * pivot.a[l];
      rows_[k].constant += factor * pivot.constant;
    }
  }

  std::vector<Column> columns_;
  std::vector<Row> rows_;
};

class ModeTree {
 public:
  ModeTree(const MixedProblem& problem, const ContactProblem& contacts, Slides slides, std::span<const double> start,
           const std::function<bool(const std::vector<Rational>&)>& visit)
      : problem_(problem), contacts_(contacts), slides_(slides), start_(start), visit_(visit) {
    for (const double mu : problem.mu) mu_.push_back(to_rational(mu));
  }

  /// False if it is to end.
  bool go_on(const Tableau& before) {
    const std::size_t k = mode_.size();
    if (k == problem_.contacts()) return leaf(before);
    for (const State& state : states_of(problem_, k, slides_)) {
      Tableau next = before;
      enter(next, k, state);
      if (!next.eliminate()) continue;
      mode_.push_back(state);
      const bool more = go_on(next);
      mode_.pop_back();
      if (!more) return false;
    }
    return true;
  }

 private:
  std::size_t normal(std::size_t k) const { return problem_.dimension * k; }

  void enter(Tableau& tableau, std::size_t k, const State& state) const {
    const std::size_t n = normal(k);
    if (state.kind == Contact::slides) tableau.tie(n + state.axis, n, factor(k, state));
    for (std::size_t i = n; i < n + problem_.dimension; ++i) {
      const bool closed = state.kind == Contact::stick || (state.kind != Contact::open && i == n);
      const bool along = state.kind == Contact::slides && i == n + state.axis;
      if (closed) {
        tableau.free_column(i);
      } else if (!along) {
        tableau.drop_column(i);
      }
      if (closed || (state.kind == Contact::slides && !along)) {
        tableau.stop_row(i);
      } else {
        tableau.drop_row(i);
      }
    }
  }

  /// r_T / r_N of a contact that slides.
  Rational factor(std::size_t k, const State& state) const { return state.sign > 0 ? Rational(-mu_[k]) : mu_[k]; }

  bool leaf(const Tableau& tableau) const {
    stop_if_asked();
    if (!candidate(tableau.forces(contacts_.size(), [](std::size_t) { return Rational(0); }))) return false;
    return tableau.is_determined() ||
           candidate(tableau.forces(contacts_.size(), [&](std::size_t i) { return to_rational(start_[i]); }));
  }

  /// False if the search is to end.
  bool candidate(std::vector<Rational> r) const {
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      const std::size_t n = normal(k);
      if (r[n].sign() < 0) return true;
      if (mode_[k].kind == Contact::slides) r[n + mode_[k].axis] = factor(k, mode_[k]) * r[n];
      if (mode_[k].kind == Contact::stick && !in_cone(k, r)) return true;
    }
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      if (!moves_rightly(k, r)) return true;
    }
    return visit_(r);
  }

  bool in_cone(std::size_t k, const std::vector<Rational>& r) const {
    const std::size_t n = normal(k);
    Rational square = 0;
    for (std::size_t i = n + 1; i < n + problem_.dimension; ++i) square += r[i] * r[i];
    const Rational bound = mu_[k] * r[n];
    return square <= bound * bound;
  }

  bool moves_rightly(std::size_t k, const std::vector<Rational>& r) const {
    const std::size_t n = normal(k);
    if (mode_[k].kind == Contact::open) return velocity(n, r).sign() >= 0;
    if (mode_[k].kind != Contact::slides || r[n].is_zero()) return true;
    for (std::size_t axis = 1; axis < problem_.dimension; ++axis) {
      const int sign = velocity(n + axis, r).sign();
      if (sign != 0 && (axis != mode_[k].axis || sign != mode_[k].sign)) return false;
    }
    return true;
  }

  Rational velocity(std::size_t i, const std::vector<Rational>& r) const {
    Rational sum = contacts_.q[i];
    for (std::size_t j = 0; j < r.size(); ++j) sum += contacts_.W[i][j] * r[j];
    return sum;
  }

  const MixedProblem& problem_;
  const ContactProblem& contacts_;
  const Slides slides_;
  std::span<const double> start_;
  const std::function<bool(const std::vector<Rational>&)>& visit_;
  std::vector<Rational> mu_;
  std::vector<State> mode_;
};

}  // namespace

Work linear_modes(const MixedProblem& problem, Slides slides) {
  Work modes = 1;
  for (std::size_t k = 0; k < problem.contacts(); ++k) modes = times(modes, states_of(problem, k, slides).size());
  return modes;
}

Work work_of_linear_modes(const MixedProblem& problem, const ContactProblem& contacts, Slides slides) {
  constexpr Work allocated = 40, products = 4;  // of a sum and a product of rational numbers in lowest terms
  std::size_t bits = 1;
  for (const auto& row : contacts.W) {
    for (const Rational& a : row) bits = std::max(bits, bit_count(a));
  }
  const Work n = contacts.size(), an_entry = allocated + products * product_work(bits * n / 2);
  return times(linear_modes(problem, slides), times(n * n, an_entry));
}

void each_linear_solution(const MixedProblem& problem, const ContactProblem& contacts, Slides slides,
                          std::span<const double> start,
                          const std::function<bool(const std::vector<Rational>&)>& visit) {
  ModeTree(problem, contacts, slides, start, visit).go_on(Tableau(contacts));
}

}  // namespace slipproof

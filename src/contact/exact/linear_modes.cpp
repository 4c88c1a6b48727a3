#include "contact/exact/linear_modes.hpp"

#include <algorithm>
#include <optional>
#include <type_traits>

#include "base/number/binary64.hpp"
#include "contact/exact/tableau.hpp"

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

bool is(const State& state, ConeState known) {
  switch (state.kind) {
    case Contact::open:
      return known == ConeState::open;
    case Contact::stick:
    case Contact::closed:
      return known == ConeState::stick;
    case Contact::slides:
      break;
  }
  return known == (state.sign > 0 ? ConeState::slide_plus : ConeState::slide_minus);
}

constexpr Work near_entry = 20;  ///< the work of one entry of an elimination with error bounds

/// About the work of one entry of an exact elimination: numbers grow with each force that is eliminated.
Work work_of_entry(const ContactProblem& contacts) {
  constexpr Work allocated = 40, products = 4;  // of a sum and a product of rational numbers in lowest terms
  std::size_t bits = 1;
  for (const auto& row : contacts.W) {
    for (const Rational& a : row) bits = std::max(bits, bit_count(a));
  }
  return allocated + products * product_work(bits * contacts.size() / 2);
}

/// Modes are solved with error bounds first. What surely has no solution ends there; the others are solved again,
/// exactly, from the first contact on.
class ModeTree {
 public:
  ModeTree(const MixedProblem& problem, const ContactProblem& contacts, Slides slides, std::span<const double> start,
           const ConeMode* known, Effort& effort, const std::function<bool(const std::vector<Rational>&)>& visit)
      : problem_(problem),
        slides_(slides),
        start_(start),
        known_(known),
        exact_{contacts.W, contacts.q, to_rationals(problem.mu)},
        near_(exact_),
        exact_entry_(work_of_entry(contacts)),
        effort_(effort),
        visit_(visit) {}

  void run() { go_on(Tableau<Approximate>(near_)); }

 private:
  template <class Number>
  const LinearProblem<Number>& numbers() const {
    if constexpr (std::is_same_v<Number, Rational>) {
      return exact_;
    } else {
      return near_;
    }
  }

  /// False if it is to end.
  template <class Number>
  bool go_on(const Tableau<Number>& before) {
    const std::size_t k = mode_.size();
    if (k == problem_.contacts()) return leaf(before);
    for (const State& state : states_of(problem_, k, slides_)) {
      Tableau<Number> next = before;
      const Solvable found = enter(next, k, state);
      if (found == Solvable::no) continue;
      mode_.push_back(state);
      const bool more = found == Solvable::unsure ? go_on_exactly() : go_on(next);
      mode_.pop_back();
      if (!more) return false;
    }
    return true;
  }

  /// The same for what is decided so far.
  bool go_on_exactly() {
    Tableau<Rational> exact(exact_);
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      if (enter(exact, k, mode_[k]) == Solvable::no) return true;
    }
    return go_on(exact);
  }

  std::size_t normal(std::size_t k) const { return problem_.dimension * k; }

  template <class Number>
  Solvable enter(Tableau<Number>& tableau, std::size_t k, const State& state) {
    effort_.spend(times(tableau.entries(), std::is_same_v<Number, Rational> ? exact_entry_ : near_entry));
    const std::size_t n = normal(k);
    if (state.kind == Contact::slides) tableau.tie(n + state.axis, n, factor<Number>(k, state));
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
    return tableau.eliminate();
  }

  /// r_T / r_N of a contact that slides.
  template <class Number>
  Number factor(std::size_t k, const State& state) const {
    const Number& mu = numbers<Number>().mu[k];
    return state.sign > 0 ? Number(-mu) : mu;
  }

  bool is_known() const { return known_ != nullptr && std::ranges::equal(mode_, *known_, is); }

  bool leaf(const Tableau<Approximate>& tableau) {
    if (tableau.is_determined() && is_known()) return true;
    const auto may_be = [&](const auto& open) { return may_solve(with_ties(tableau.forces(start_.size(), open))); };
    const auto none = [](std::size_t) { return Approximate(); };
    const auto start = [&](std::size_t i) { return Approximate(start_[i]); };
    const bool surely_none = !may_be(none) && (tableau.is_determined() || !may_be(start));
    return surely_none || go_on_exactly();
  }

  bool leaf(const Tableau<Rational>& tableau) const {
    const auto go_on_from = [&](const auto& open) {
      const std::vector<Rational> r = with_ties(tableau.forces(start_.size(), open));
      return !may_solve(r) || visit_(r);
    };
    if (!go_on_from([](std::size_t) { return Rational(0); })) return false;
    return tableau.is_determined() || go_on_from([&](std::size_t i) { return to_rational(start_[i]); });
  }

  template <class Number>
  std::vector<Number> with_ties(std::vector<Number> r) const {
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      const std::size_t n = normal(k);
      if (mode_[k].kind == Contact::slides) r[n + mode_[k].axis] = factor<Number>(k, mode_[k]) * r[n];
    }
    return r;
  }

  /// False if one of the mode's conditions surely fails.
  template <class Number>
  bool may_solve(const std::vector<Number>& r) const {
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      if (is_surely(-1, sure_sign(r[normal(k)]))) return false;
      if (mode_[k].kind == Contact::stick && is_outside(k, r)) return false;
    }
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      if (moves_wrongly(k, r)) return false;
    }
    return true;
  }

  template <class Number>
  bool is_outside(std::size_t k, const std::vector<Number>& r) const {
    const std::size_t n = normal(k);
    Number square(0);
    for (std::size_t i = n + 1; i < n + problem_.dimension; ++i) square = square + r[i] * r[i];
    const Number bound = numbers<Number>().mu[k] * r[n];
    return is_surely(1, sure_sign(Number(square - bound * bound)));
  }

  template <class Number>
  bool moves_wrongly(std::size_t k, const std::vector<Number>& r) const {
    const std::size_t n = normal(k);
    if (mode_[k].kind == Contact::open) return is_surely(-1, sure_sign(velocity(n, r)));
    if (mode_[k].kind != Contact::slides || !is_surely(1, sure_sign(r[n]))) return false;
    for (std::size_t axis = 1; axis < problem_.dimension; ++axis) {
      const std::optional<int> sign = sure_sign(velocity(n + axis, r));
      if (sign && *sign != 0 && (axis != mode_[k].axis || *sign != mode_[k].sign)) return true;
    }
    return false;
  }

  template <class Number>
  Number velocity(std::size_t i, const std::vector<Number>& r) const {
    const LinearProblem<Number>& problem = numbers<Number>();
    Number sum = problem.q[i];
    for (std::size_t j = 0; j < r.size(); ++j) sum = sum + problem.W[i][j] * r[j];
    return sum;
  }

  const MixedProblem& problem_;
  const Slides slides_;
  std::span<const double> start_;
  const ConeMode* known_;
  const LinearProblem<Rational> exact_;
  const LinearProblem<Approximate> near_;
  const Work exact_entry_;
  Effort& effort_;
  const std::function<bool(const std::vector<Rational>&)>& visit_;
  std::vector<State> mode_;
};

}  // namespace

Work linear_modes(const MixedProblem& problem, Slides slides) {
  Work modes = 1;
  for (std::size_t k = 0; k < problem.contacts(); ++k) modes = times(modes, states_of(problem, k, slides).size());
  return modes;
}

Work least_work_of_linear_modes(const MixedProblem& problem, Slides slides) {
  const Work components = problem.size() - problem.free;
  return times(linear_modes(problem, slides), near_entry * components * components);
}

void each_linear_solution(const MixedProblem& problem, const ContactProblem& contacts, Slides slides,
                          std::span<const double> start, const ConeMode* known, Effort& effort,
                          const std::function<bool(const std::vector<Rational>&)>& visit) {
  ModeTree(problem, contacts, slides, start, known, effort, visit).run();
}

}  // namespace slipproof

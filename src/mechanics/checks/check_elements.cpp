#include <algorithm>

#include "base/algebra/elimination.hpp"
#include "base/number/format.hpp"
#include "mechanics/checks/check_parts.hpp"
#include "mechanics/checks/free_motion.hpp"

namespace slipproof::mechanism_checks {

namespace {

using Check = MechanismFinding::Check;
using Quantity = CheckPoints::Quantity;

/// A column of numbers that one form has at a point.
using Numbers = std::vector<Rational>;

class ElementCheck {
 public:
  explicit ElementCheck(const CheckPoints& points) : points_(points), m_(points.mechanism()) {}

  std::vector<MechanismFinding> check() {
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) {
      const MechanismContact& contact = m_.contacts[i];
      const auto form = [i](auto member) {
        return [i, member](const FrictionProblem& problem) { return problem.elements[i].*member; };
      };
      check_motion(contact.gap, contact.gap_name, form(&ProblemElement::gap));
      if (contact.frictionless()) {
        check_smooth(contact);
        continue;
      }
      check_motion(contact.slip, contact.slip_name, form(&ProblemElement::slip));
      check_friction(i, "coefficient of friction", contact.static_friction, contact.kinetic_friction);
    }
    for (std::size_t i = 0; i < m_.friction.size(); ++i) {
      const MechanismFriction& friction = m_.friction[i];
      const std::size_t element = m_.contacts.size() + i;
      check_motion(friction.slip, friction.slip_name,
                   [element](const FrictionProblem& problem) { return problem.elements[element].slip; });
      check_friction(element, "limit", friction.static_limit, friction.kinetic_limit);
    }
    check_links();
    if (m_.dimension == 2) check_directions();
    return std::move(findings_);
  }

 private:
  void find(const PlacedExpression& placed, std::string message) {
    findings_.push_back(warning(Check::elements, placed.place(), std::move(message)));
  }

  /// A literal 0 is no coefficient of friction that is 0: the contact has other states.
  void check_smooth(const MechanismContact& contact) {
    if (contact.static_friction.text.text().empty()) return;
    find(
        contact.static_friction,
        contact.name +
            ": found friction = \"0\", which makes the contact smooth: its states are touch and lift, and it has no "
            "tangential force. Leave friction out to say so; a parameter that is 0 keeps stick, slip+, slip- and lift");
  }

  Numbers motion_of(const AffineForm& form) const {
    return {form.coefficients.begin(), form.coefficients.begin() + static_cast<std::ptrdiff_t>(m_.accelerations)};
  }
  static bool vanishes(const Numbers& numbers) {
    return std::ranges::all_of(numbers, [](const Rational& x) { return x.is_zero(); });
  }

  template <class Form>
  void check_motion(const PlacedExpression& placed, const std::string& name, Form&& form) {
    const auto still = [&](const CheckPoint& point) { return vanishes(motion_of(form(point.problem))); };
    if (!std::ranges::all_of(points_.all(), still)) return;
    find(placed, name + ": no acceleration moves " + in_quotes(to_string(placed.expression)) +
                     ": all have the factor 0, at each of " + std::to_string(points_.all().size()) + " points tried");
  }

  /// The largest value of a form over all forces that the element's laws allow, with its sign; nothing if it can be
  /// positive, or is 0.
  std::optional<Rational> negative_value(const AffineForm& form, const ForceInterval& loads) const {
    Rational constant = form.constant;
    Rational lowest = 0;
    for (std::size_t i = 0; i < m_.unknowns.size(); ++i) {
      const Rational& coefficient = form.coefficients[i];
      if (coefficient.is_zero()) continue;
      const bool pushes =
          m_.unknowns[i].role == MechanismUnknown::Role::normal && !m_.contacts[m_.unknowns[i].owner].bilateral;
      if (!pushes || coefficient > 0) return std::nullopt;
      lowest = std::min(lowest, coefficient);
    }
    const Rational& per_load = form.coefficients.back();
    if (!per_load.is_zero()) {
      const auto& end = per_load > 0 ? loads.upper() : loads.lower();
      if (!end) return std::nullopt;
      constant += per_load * *end;
      lowest = std::min(lowest, Rational(-abs(per_load)));
    }
    if (constant > 0 || (constant.is_zero() && lowest.is_zero())) return std::nullopt;
    return constant.is_zero() ? lowest : constant;
  }

  /// Of a contact the factor of N, which is what the file says.
  AffineForm limit(const FrictionProblem& problem, std::size_t element, bool kinetic) const {
    const ProblemElement& e = problem.elements[element];
    AffineForm form = kinetic ? e.kinetic_limit : e.static_limit;
    if (element >= m_.contacts.size()) return form;
    return {form.coefficients[m_.contacts[element].normal], std::vector<Rational>(form.coefficients.size())};
  }

  void check_friction(std::size_t element, const std::string& what, const PlacedExpression& at_rest,
                      const PlacedExpression& in_slip) {
    const bool one = at_rest.expression == in_slip.expression;
    const auto negative = [&](const FrictionProblem& problem, bool kinetic) {
      return negative_value(limit(problem, element, kinetic), problem.load_domain);
    };
    const auto above = [&](const CheckPoint& point) {
      const FrictionProblem& problem = point.problem;
      return negative_value(limit(problem, element, false) - limit(problem, element, true), problem.load_domain);
    };
    bool static_reported = false, kinetic_reported = one, above_reported = one;
    for (const CheckPoint& point : points_.all()) {
      for (const bool kinetic : {false, true}) {
        bool& reported = kinetic ? kinetic_reported : static_reported;
        const auto value = reported ? std::nullopt : negative(point.problem, kinetic);
        if (!value) continue;
        reported = true;
        const PlacedExpression& placed = kinetic ? in_slip : at_rest;
        const Quantity quantity = [&](const CheckPoint& there) { return negative(there.problem, kinetic); };
        find(placed, "the " + what + " " + in_quotes(to_string(placed.expression)) +
                         " is negative: " + exact_text(*value) + points_.where(point, quantity) + ", expected it >= 0");
      }
      if (above_reported || static_reported || kinetic_reported || !above(point)) continue;
      above_reported = true;
      find(in_slip, "the kinetic " + what + " " + in_quotes(to_string(in_slip.expression)) + " is above the static " +
                        in_quotes(to_string(at_rest.expression)) + points_.where(point, above) +
                        ", expected [assume] or a domain that forbids it");
    }
  }

  /// Links, then the gap of a contact, as a system for the accelerations and the load.
  std::vector<Numbers> link_rows(const FrictionProblem& problem, std::size_t count) const {
    std::vector<Numbers> rows;
    for (std::size_t i = 0; i < count; ++i) {
      const AffineForm& form = problem.equations[m_.equations.size() + i];
      Numbers row = motion_of(form);
      row.push_back(form.coefficients.back());
      row.push_back(form.constant);
      rows.push_back(std::move(row));
    }
    return rows;
  }
  bool contradict(const FrictionProblem& problem, std::size_t count) const {
    const Echelon echelon = eliminate(link_rows(problem, count));
    return echelon.rank(m_.accelerations + 1) < echelon.rank();
  }

  void check_links() {
    if (m_.links.empty()) return;
    const auto fit = [&](const CheckPoint& point) { return !contradict(point.problem, m_.links.size()); };
    const std::size_t first = std::ranges::all_of(points_.all(), fit) ? m_.links.size() + 1 : 1;
    for (std::size_t count = first; count <= m_.links.size(); ++count) {
      for (const CheckPoint& point : points_.all()) {
        if (!contradict(point.problem, count)) continue;
        const Quantity quantity = [&](const CheckPoint& there) {
          return Rational(contradict(there.problem, count) ? 1 : 0);
        };
        return find(m_.links[count - 1].zero, "the link " + m_.links[count - 1].name + " contradicts " +
                                                  (count == 1 ? "itself" : "those before it") +
                                                  ": no accelerations satisfy all of them" +
                                                  points_.where(point, quantity) + gravity_of(point, count));
      }
    }
    for (const MechanismContact& contact : m_.contacts) check_shut(contact);
  }

  /// Links that hold if g = 0 only.
  std::string gravity_of(const CheckPoint& point, std::size_t count) const {
    for (std::size_t i = 0; i < m_.parameters.size(); ++i) {
      if (!is_gravity(m_, m_.parameters[i])) continue;
      MechanismValues values = point.values;
      values.parameters[i] = 0;
      try {
        if (contradict(points_.maker().problem(values), count)) continue;
      } catch (const NoValue&) {
        continue;
      }
      return "; they fix gravity: they hold with " + m_.parameters[i].symbol + " = 0";
    }
    return {};
  }

  /// A contact that links alone hold shut or open, so that its force is not determined.
  void check_shut(const MechanismContact& contact) {
    if (contact.bilateral || contact.start != ElementKind::Start::rest) return;
    const auto index = static_cast<std::size_t>(&contact - m_.contacts.data());
    const auto fixed = [&](const CheckPoint& point) {
      auto rows = link_rows(point.problem, m_.links.size());
      const std::size_t before = eliminate(rows).rank(m_.accelerations);
      rows.push_back(motion_of(point.problem.elements[index].gap));
      rows.back().resize(m_.accelerations + 2);
      return eliminate(rows).rank(m_.accelerations) == before;
    };
    if (!std::ranges::all_of(points_.all(), fixed)) return;
    find(contact.gap, "the links fix " + contact.gap_name + ": they carry the load of the contact " + contact.name +
                          ", whose force nothing determines");
  }

  struct Sliding {
    std::string name;
    const PlacedExpression* slip;
    std::size_t element;
    int sign;
  };
  std::vector<Sliding> sliding() const {
    std::vector<Sliding> result;
    const auto add = [&](const std::string& name, const PlacedExpression& slip, ElementKind::Start start,
                         std::size_t element) {
      if (!ElementKind{.start = start}.slides()) return;
      result.push_back({name, &slip, element, start == ElementKind::Start::slides_forward ? 1 : -1});
    };
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) {
      add(m_.contacts[i].name, m_.contacts[i].slip, m_.contacts[i].start, i);
    }
    for (std::size_t i = 0; i < m_.friction.size(); ++i) {
      add(m_.friction[i].name, m_.friction[i].slip, m_.friction[i].start, m_.contacts.size() + i);
    }
    return result;
  }

  /// The sign of the factor between two forms; 0 if there is none.
  static int factor(const Numbers& x, const Numbers& y) {
    const auto first = std::ranges::find_if(x, [](const Rational& value) { return !value.is_zero(); });
    if (first == x.end()) return 0;
    const Rational ratio = y[static_cast<std::size_t>(first - x.begin())] / *first;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (ratio * x[i] != y[i]) return 0;
    }
    return sign(ratio);
  }

  void check_directions() {
    const auto all = sliding();
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const int expected = -all[i].sign * all[k].sign;
        const auto opposed = [&](const CheckPoint& point) {
          const auto slip = [&](std::size_t element) { return motion_of(point.problem.elements[element].slip); };
          return factor(slip(all[k].element), slip(all[i].element)) == expected;
        };
        if (!std::ranges::all_of(points_.all(), opposed)) continue;
        find(*all[i].slip, "the slip of " + all[i].name + " is that of " + all[k].name +
                               (expected < 0 ? " with the other sign" : "") +
                               ", but they slide in opposite directions (" + words(all[k].sign) + ", " +
                               words(all[i].sign) + "): expected one direction, unless what they touch moves");
        return;
      }
    }
  }
  static std::string words(int sign) { return sign > 0 ? "slides+" : "slides-"; }

  const CheckPoints& points_;
  const Mechanism& m_;
  std::vector<MechanismFinding> findings_;
};

}  // namespace

std::vector<MechanismFinding> check_elements(const CheckPoints& points) {
  return ElementCheck(points).check();
}

}  // namespace slipproof::mechanism_checks

#include "contact/complete/certificate.hpp"

#include <algorithm>

#include "contact/complete/motion/equations.hpp"

namespace slipproof {

namespace {

using Kind = ContactState::Kind;
using End = PatternNode::End;

class ClaimText {
 public:
  explicit ClaimText(const CompleteSolutions& solutions)
      : found_(solutions), exact_(solutions.scaled.contacts), n_(exact_.size()) {}

  std::string write(const RationalMatrix& eliminated) {
    text_ = "all-solutions " + std::to_string(found_.motions.size()) + '\n';
    if (!eliminated.empty()) write_matrix("eliminated", eliminated);
    for (std::size_t m = 0; m < found_.motions.size(); ++m) {
      const SpatialMotion& motion = found_.motions[m];
      motion.is_exact() ? write_exact(motion) : write_box(motion);
      if (found_.within[m].empty()) continue;
      text_ += "within";
      for (std::size_t i = 0; i < n_; ++i) add(found_.within[m][i] * velocity_unit(i));
      text_ += '\n';
    }
    write_node(found_.nodes[0], 0);
    return std::move(text_);
  }

 private:
  const Rational& force_unit(std::size_t i) const { return found_.scaled.force_unit[i]; }
  const Rational& velocity_unit(std::size_t i) const { return found_.scaled.velocity_unit[i]; }

  void add(const Rational& x) { text_ += ' ' + x.str(); }

  void write_matrix(const char* word, const RationalMatrix& matrix) {
    std::string entries;
    std::size_t count = 0;
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      for (std::size_t j = 0; j < matrix[i].size(); ++j) {
        if (matrix[i][j].is_zero()) continue;
        entries += std::to_string(i) + ' ' + std::to_string(j) + ' ' + matrix[i][j].str() + '\n';
        ++count;
      }
    }
    text_ += std::string(word) + ' ' + std::to_string(count) + '\n' + entries;
  }

  void write_exact(const SpatialMotion& motion) {
    text_ += "motion exact";
    for (std::size_t i = 0; i < n_; ++i) add(motion.r[i] * force_unit(i));
    text_ += '\n';
  }

  /// The units of a mode's unknowns, and of its equations.
  struct Units {
    std::vector<Rational> unknowns, equations;
  };
  Units units(const SpatialMotion& motion, const ModeUnknowns& unknowns) const {
    Units result;
    for (std::size_t k = 0; k < motion.mode.size(); ++k) {
      const Rational &force = force_unit(exact_.normal(k)), &velocity = velocity_unit(exact_.normal(k));
      const bool slips = motion.mode[k].kind == Kind::slip;
      for (std::size_t j = 0; j < unknowns.of(k); ++j) {
        result.unknowns.push_back(j < 3 ? force : Rational(velocity / force));
        result.equations.push_back(j == 3                                     ? Rational(force * force)
                                   : j == 1 && slips && exact_.dimension == 2 ? force
                                                                              : velocity);
      }
    }
    return result;
  }

  const char* mode_word(const SpatialMotion& motion, std::size_t k) const {
    const ContactState& state = motion.mode[k];
    if (state.kind == Kind::open) return !motion.touching.empty() && motion.touching[k] ? " touch" : " open";
    if (state.kind != Kind::slip) return " stick";
    return exact_.dimension == 3 ? " slide" : state.from.x.sign() > 0 ? " slide+" : " slide-";
  }

  void write_box(const SpatialMotion& motion) {
    const ModeUnknowns unknowns(exact_, motion.mode, motion.touching);
    const Units unit = units(motion, unknowns);
    text_ += "motion box modes";
    for (std::size_t k = 0; k < motion.mode.size(); ++k) text_ += mode_word(motion, k);
    text_ += "\ncenter";
    for (std::size_t j = 0; j < unknowns.count(); ++j) add(motion.center[j] * unit.unknowns[j]);
    text_ += "\nradius";  // of a pinned one it means nothing, and is positive
    for (std::size_t j = 0; j < unknowns.count(); ++j) {
      add(motion.radius[j].is_zero() ? unit.unknowns[j] : Rational(motion.radius[j] * unit.unknowns[j]));
    }
    text_ += "\npinned " + std::to_string(motion.pinned.size());
    for (const std::size_t j : motion.pinned) text_ += ' ' + std::to_string(j);
    text_ += "\ndropped " + std::to_string(motion.dropped.size());
    for (const DependentEquation& own : motion.dropped) {
      text_ += ' ' + std::to_string(own.equation) + ' ' + std::to_string(own.combination.size());
      for (const auto& [e, c] : own.combination) {
        text_ += ' ' + std::to_string(e);
        add(c * unit.equations[own.equation] / unit.equations[e]);
      }
    }
    text_ += '\n';
    write_matrix("inverse", inverse_of(motion, unit));
    if (!motion.alone.is_zero()) text_ += "alone " + motion.alone.str() + '\n';
  }

  static RationalMatrix inverse_of(const SpatialMotion& motion, const Units& unit) {
    const auto without = [](std::vector<Rational> units, const auto& places) {
      for (std::size_t p = places.size(); p-- > 0;) units.erase(units.begin() + static_cast<std::ptrdiff_t>(places[p]));
      return units;
    };
    std::vector<std::size_t> dropped;
    for (const DependentEquation& own : motion.dropped) dropped.push_back(own.equation);
    std::ranges::sort(dropped);
    const auto unknowns = without(unit.unknowns, motion.pinned), equations = without(unit.equations, dropped);
    RationalMatrix inverse = motion.inverse;
    for (std::size_t i = 0; i < inverse.size(); ++i) {
      for (std::size_t j = 0; j < inverse.size(); ++j) inverse[i][j] *= unknowns[i] / equations[j];
    }
    return inverse;
  }

  void write_directions(const std::vector<Direction>& directions) {
    text_ += ' ' + std::to_string(directions.size());
    for (const Direction& d : directions) {
      add(Rational(d.x, d.length));
      add(Rational(d.y, d.length));
    }
  }

  void write_node(const PatternNode& node, std::size_t depth) {
    text_.append(depth, ' ');
    if (node.end == End::empty) {
      text_ += "empty";
      write_multipliers(node.y, Rational(1));
    } else if (node.end == End::motion) {
      text_ += "known " + std::to_string(node.motion);
      write_bounds(node);
    } else if (node.end == End::frictionless) {
      text_ += "frictionless " + std::to_string(node.motion);
      write_squares();
    } else {
      write_split(node);
    }
    text_ += '\n';
    for (std::size_t c = 0; c < node.children; ++c) write_node(found_.nodes[node.first_child + c], depth + 1);
  }

  void write_split(const PatternNode& node) {
    const std::size_t k = node.contact;
    const ContactState& state = node.pattern[k];
    const auto child = [&](std::size_t c) -> const ContactState& {
      return found_.nodes[node.first_child + c].pattern[k];
    };
    text_ += (state.kind == Kind::any      ? "decide "
              : state.kind == Kind::closed ? "slips "
                                           : "arcs ") +
             std::to_string(k);
    if (state.kind == Kind::any || exact_.dimension == 2) return;
    std::vector<Direction> directions;
    for (std::size_t c = 1; c < node.children; ++c) directions.push_back(child(c).from);
    write_directions(directions);
  }

  /// Multipliers of a form in scaled units, `unit` times which is the form.
  void write_multipliers(const std::vector<Rational>& y, const Rational& unit) {
    for (std::size_t i = 0; i < n_; ++i) add(y[i] * unit / velocity_unit(i));
  }

  /// Each of them is about velocities of one contact, or about a component of its force.
  void write_bounds(const PatternNode& node) {
    for (const PatternNode::Bound& bound : node.bounds) {
      const auto& [u, r] = bound.form;
      write_multipliers(bound.y, u.empty() ? force_unit(r[0].first) : velocity_unit(u[0].first));
    }
  }

  void write_squares() {
    text_ += ' ' + std::to_string(found_.squares.size());
    for (const WeightedSquare& square : found_.squares) {
      add(square.factor / (force_unit(0) * velocity_unit(0)));  // this product is the same in all rows
      for (std::size_t i = 0; i < n_; ++i) add(square.form[i] * velocity_unit(i));
    }
  }

  const CompleteSolutions& found_;
  const ExactContacts& exact_;
  const std::size_t n_;
  std::string text_;
};

}  // namespace

std::string all_solutions_claim(const CompleteSolutions& solutions, const RationalMatrix& eliminated) {
  return solutions.complete() ? ClaimText(solutions).write(eliminated) : std::string();
}

}  // namespace slipproof

#include "contact/complete/certificate.hpp"

#include <algorithm>

#include "contact/complete/equations.hpp"

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
    for (const SpatialMotion& motion : found_.motions) {
      motion.is_exact() ? write_exact(motion) : write_box(motion);
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
  Units units(const ContactPattern& mode) const {
    const ModeUnknowns unknowns(exact_, mode);
    Units result;
    for (std::size_t k = 0; k < mode.size(); ++k) {
      const std::size_t i = exact_.normal(k);
      if (slips_in_space(exact_, mode, k)) {
        for (const Rational& x : {force_unit(i), Rational(1), Rational(1), velocity_unit(i)}) {
          result.unknowns.push_back(x);
        }
        for (std::size_t e = 0; e < 3; ++e) result.equations.push_back(velocity_unit(i));
        result.equations.emplace_back(1);
        continue;
      }
      for (std::size_t j = 0; j < unknowns.of(k); ++j) {
        result.unknowns.push_back(force_unit(i));
        result.equations.push_back(velocity_unit(i));
      }
    }
    return result;
  }

  const char* mode_word(std::size_t k, const ContactState& state) const {
    if (state.kind == Kind::open) return " open";
    if (!exact_.has_friction(k)) return " closed";
    if (state.kind != Kind::slip) return " stick";
    return exact_.dimension == 3 ? " slide" : state.from.x.sign() > 0 ? " slide+" : " slide-";
  }

  void write_box(const SpatialMotion& motion) {
    const Units unit = units(motion.mode);
    text_ += "motion box modes";
    for (std::size_t k = 0; k < motion.mode.size(); ++k) text_ += mode_word(k, motion.mode[k]);
    const std::vector<Rational> nowhere(motion.center.size());
    const auto numbers = [&](const char* word, const std::vector<Rational>& values) {
      text_ += std::string("\n") + word;
      for (std::size_t j = 0; j < values.size(); ++j) add(values[j] * unit.unknowns[j]);
    };
    numbers("center", motion.center);
    numbers("radius", motion.radius);
    numbers("alone", motion.alone.empty() ? nowhere : motion.alone);
    text_ += '\n';
    RationalMatrix inverse = motion.inverse;
    for (std::size_t i = 0; i < inverse.size(); ++i) {
      for (std::size_t j = 0; j < inverse.size(); ++j) inverse[i][j] *= unit.unknowns[i] / unit.equations[j];
    }
    write_matrix("inverse", inverse);
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

  /// Each of them is about one row of u, one component of r, or the slip of one contact.
  void write_bounds(const PatternNode& node) {
    const SpatialMotion& motion = found_.motions[node.motion];
    const auto write = [&](const PatternNode::Bound& bound) {
      write_multipliers(
          bound.y, bound.form.r.empty() ? velocity_unit(bound.form.u[0].first) : force_unit(bound.form.r[0].first));
    };
    if (motion.is_exact()) {
      std::ranges::for_each(node.bounds, write);
      return;
    }
    const ModeUnknowns unknowns(exact_, motion.mode);
    auto next = node.bounds.begin();
    for (std::size_t k = 0; k < node.pattern.size(); ++k) {
      const bool slips = slips_in_space(exact_, node.pattern, k);
      const std::size_t bounds = slips ? 3 : 2 * unknowns.of(k), speed = unknowns.first[k] + 3;
      for (std::size_t b = 0; b < bounds; ++b) write(*next++);
      if (!slips) continue;
      if (motion.alone[speed] < motion.center[speed]) {
        write(*next++);
      } else {  // slips have a speed above 0, by definition
        write_multipliers(std::vector<Rational>(n_), Rational(1));
      }
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

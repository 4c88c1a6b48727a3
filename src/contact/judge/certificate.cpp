#include "contact/judge/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/number/binary64.hpp"
#include "contact/complete/certificate.hpp"
#include "contact/enclosure/ball.hpp"
#include "contact/judge/problem_name.hpp"
#include "contact/path/solve.hpp"

namespace slipproof {

namespace {

/// As floating point of any length: its divisor is a power of 2.
std::string hexadecimal(const Rational& x) {
  std::size_t places = 0;  // after the point, of 4 bits each
  Rational scaled = abs(x);
  for (; denominator(scaled) != 1; ++places) scaled *= 16;
  return fmt::format("{}0x{}p-{}", x < 0 ? "-" : "", numerator(scaled).str(16), 4 * places);
}

class CertificateWriter {
 public:
  explicit CertificateWriter(const MixedProblem& problem) : problem_(problem) {}

  std::string write(const ContactJudgement& judgement) {
    write_problem();
    write_law();
    vector("answer", judgement.x);
    const bool claimed = write_claims(judgement);
    if (judgement.tree) text_ += all_solutions_claim(judgement.tree->solutions, judgement.tree->eliminated);
    if (!claimed && !judgement.tree) return {};
    line("end");
    return std::move(text_);
  }

 private:
  bool write_claims(const ContactJudgement& judgement) {
    switch (judgement.verdict) {
      case ContactVerdict::velocities_of_a_solution:
        write_eps(judgement);
        with_velocities_ = true;
        return write_solutions(judgement);
      case ContactVerdict::inaccurate:
      case ContactVerdict::not_converged:
      case ContactVerdict::solution_within_rho:
      case ContactVerdict::unique:
      case ContactVerdict::ambiguous:
        return write_solutions(judgement);
      case ContactVerdict::velocities_within_rho:
        write_every(*judgement.every);
        return true;
      case ContactVerdict::no_solution:
        if (judgement.multipliers.empty()) return false;
        line("no-solution");
        vector("multipliers", judgement.multipliers);
        return true;
      case ContactVerdict::wrong:
      case ContactVerdict::none_within_rho:
        if (judgement.every) write_every(*judgement.every);
        if (judgement.exclusion && judgement.exclusion->radius > 0) {
          line("none-within {:a}", judgement.exclusion->radius);
          return true;
        }
        [[fallthrough]];
      case ContactVerdict::eps_solution:
        write_eps(judgement);
        return true;
      default:
        return false;
    }
  }

  bool write_solutions(const ContactJudgement& j) {
    if (j.enclosure) {
      if (!write_enclosure(*j.enclosure, j.x)) return false;
    } else if (!j.exact.empty() && !write_exact(j.exact, j.rho)) {
      return false;
    }
    if (j.every) write_every(*j.every);
    if (j.other && !write_enclosure(*j.other, j.x)) return false;
    if (!j.other_exact.empty()) {
      write_exact(j.other_exact, distance_from(j.other_exact, j.x));
    }
    if (j.unique_by) write_unique(*j.unique_by);
    return true;
  }

  /// Writes an exact solution: its problem needs no change. False if the numbers are longer than the format allows.
  bool write_exact(const std::vector<Rational>& x, double moved) {
    constexpr std::size_t longest = 4900;  // characters of a number in a certificate
    std::vector<Rational> w;
    for (std::size_t i = 0; i < problem_.size(); ++i) w.push_back(exact_row(problem_, i, x));
    const auto short_enough = [](const Rational& value) { return value.str().size() <= longest; };
    if (!std::all_of(x.begin(), x.end(), short_enough) || !std::all_of(w.begin(), w.end(), short_enough)) return false;
    line("eps 0 {:a}", moved);
    vector("point", x);
    vector("motion", w);
    return true;
  }

  /// Nothing where no velocity is bounded.
  void write_every(const EverySolution& every) {
    if (!std::isfinite(every.eta)) return;
    line("every-solution {:a} {:a}", every.rho, every.eta);
    vector("moduli", every.proof.moduli);
    line("factor {}", every.proof.factor.entries());
    entries(every.proof.factor);
    vector("point", every.point);
    vector("motion", every.motion);
    vector("shares", every.shares);
    vector("gaps", every.gaps);
    line("energy {:a}", every.energy);
    std::vector<double> radii = every.radius;
    for (double& r : radii) r = std::isfinite(r) ? r : 0;  // of an open component: not used
    vector("radii", radii);
  }

  void write_unique(const UniqueProof& proof) {
    if (proof.kind == UniqueProof::Class::dominant) {
      text_ += "unique ";
      vector("dominant", proof.scale);
    } else if (proof.kind != UniqueProof::Class::p_matrix) {  // a checker computes its minors again
      line("unique {} {}", class_word(proof.kind), proof.factor.entries());
      entries(proof.factor);
    }
  }

  static std::string_view class_word(UniqueProof::Class kind) {
    return kind == UniqueProof::Class::bound          ? "bound"
           : kind == UniqueProof::Class::determinants ? "determinants"
                                                      : "definite";
  }

  void entries(const SparseMatrix& matrix) {
    for (std::size_t i = 0; i < matrix.rows; ++i) {
      const auto columns = matrix.columns_of(i);
      for (std::size_t e = 0; e < columns.size(); ++e) line("{} {} {:a}", i, columns[e], matrix.values_of(i)[e]);
    }
  }

  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }
  template <class... Values>
  void line(fmt::format_string<Values...> format, Values&&... values) {
    add(format, std::forward<Values>(values)...);
    text_ += '\n';
  }
  void vector(std::string_view name, std::span<const double> values) {
    text_ += name;
    for (const double x : values) add(" {:a}", x);
    text_ += '\n';
  }
  void vector(std::string_view name, const std::vector<Rational>& values) {
    text_ += name;
    for (const Rational& x : values) add(" {}", x.str());
    text_ += '\n';
  }

  void write_problem() {
    line("slipproof-contact 1");
    line("problem {}", problem_name(problem_));
    line("dimension {} free {} contacts {}", problem_.dimension, problem_.free, problem_.contacts());
    vector("mu", problem_.mu);
    write_matrix();
    vector("constant", problem_.c);
  }

  /// Half of a large one, where the other half is its mirror image.
  void write_matrix() {
    const SparseMatrix& A = problem_.A;
    const auto turned = problem_.size() < large ? std::nullopt : turned_rows(A);
    if (!turned) {
      line("matrix {}", A.entries());
      return entries(A);
    }
    line("mirrored {}", *turned);
    for (std::size_t i = 0; i < A.rows; ++i) {
      const auto columns = A.columns_of(i);
      const auto half = static_cast<std::size_t>(std::ranges::upper_bound(columns, i) - columns.begin());
      add("{}", half);
      for (std::size_t e = 0; e < half; ++e) add(" {} {:a}", columns[e], A.values_of(i)[e]);
      text_ += '\n';
    }
  }

  /// Where it is not Coulomb's.
  void write_law() {
    if (problem_.is_coulomb()) return;
    const ContactLaw& law = problem_.law;
    add("law {}", word(law.kind));
    if (law.kind == FrictionLaw::regularised) add(" {} {:a}", word(law.function), law.slip_speed);
    vector("", is_bounded(law.kind) ? law.bounds : std::vector<double>());
  }

  void write_eps(const ContactJudgement& judgement) {
    const Residual& residual = *judgement.residual;
    line("eps {:a} {:a}", residual.change, residual.moved);
    std::vector<Rational> point, motion(problem_.free);
    for (std::size_t i = 0; i < problem_.free; ++i) point.push_back(to_rational(judgement.x[i]));
    for (const FittedContact& c : residual.contacts) {
      point.insert(point.end(), c.r.begin(), c.r.end());
      motion.insert(motion.end(), c.u.begin(), c.u.end());
    }
    vector("point", point);
    vector("motion", motion);
  }

  /// By inverses of its blocks, or as a ball where the problem is large. False where that is too coarse, and a block
  /// has no inverse.
  bool write_enclosure(const Enclosure& box, std::span<const double> answer) {
    if (box.proof) return write_long_enclosure(box, answer);
    const auto is_sparse = [](const SystemBlock& block) { return block.sparse != nullptr; };
    const bool without_inverse = std::ranges::any_of(box.blocks, is_sparse);
    if ((without_inverse || problem_.size() >= large) && write_ball(box, answer)) return true;
    if (without_inverse) return false;
    line("enclosure {:a}", distance_from(box, answer));
    if (with_velocities_) line("velocities {:a}", velocity_distance(problem_, box, answer));
    std::vector<double> radius = box.radius;
    for (const std::size_t j : box.pinned) radius[j] = 1;  // any positive number: it is not used
    write_modes(box);
    vector("center", box.center);
    vector("radius", radius);
    write_dependent(box);
    write_inverse(box);
    return true;
  }

  /// With what its velocities are.
  bool write_long_enclosure(const Enclosure& box, std::span<const double> answer) {
    line("enclosure {:a}", distance_from(box, answer));
    line("velocities {:a}", velocity_distance(problem_, box, answer));
    write_modes(box);
    vector("center", box.proof->center);
    vector("radius", box.proof->radius);
    write_dependent(box);
    line("inverse {}", box.proof->inverse.size());
    for (const LongProof::Entry& e : box.proof->inverse) line("{} {} {}", e.unknown, e.equation, e.value.str());
    return true;
  }

  bool write_ball(const Enclosure& box, std::span<const double> answer) {
    const auto proof = prove_in_ball(box);
    if (!proof) return false;
    Rational rho = 0;
    for (std::size_t i = 0; i < answer.size(); ++i) {
      const std::size_t j = box.system.unknown(i);
      const bool pinned = std::find(box.pinned.begin(), box.pinned.end(), j) != box.pinned.end();
      const Rational center = j == ModeSystem::none ? Rational(0) : proof->center[j];
      const Rational radius = j == ModeSystem::none || pinned ? Rational(0) : to_rational(proof->radius[j]);
      rho = std::max(rho, Rational(abs(center - to_rational(answer[i])) + radius));
    }
    line("ball {:a}", enclose(rho).upper);
    if (with_velocities_) {
      Enclosure ball = box;
      ball.proof = std::make_shared<const LongProof>(LongProof{proof->center, proof->radius, {}});
      line("velocities {:a}", velocity_distance(problem_, ball, answer));
    }
    write_modes(box);
    text_ += "center";
    for (const Rational& z : proof->center) add(" {}", hexadecimal(z));
    text_ += '\n';
    vector("radius", proof->radius);
    write_dependent(box);
    vector("rows", proof->rows);
    line("least {:a}", proof->least);
    line("defect {:a}", proof->defect);
    line("bend {:a}", proof->bend);
    add("order {}", proof->grid);
    for (const std::size_t j : proof->order) add(" {}", j);
    text_ += '\n';
    return true;
  }

  void write_modes(const Enclosure& box) {
    text_ += "modes";
    for (const ConeState state : box.system.mode()) add(" {}", name(state));
    text_ += '\n';
  }

  void write_dependent(const Enclosure& box) {
    add("pinned {}", box.pinned.size());
    for (const std::size_t j : box.pinned) add(" {}", j);
    line("\ndropped {}", box.dropped.size());
    for (const DroppedEquation& d : box.dropped) {
      add("{} {}", d.equation, d.combination.size());
      for (const auto& [equation, coefficient] : d.combination) add(" {} {}", equation, coefficient.str());
      text_ += '\n';
    }
  }

  /// Unknowns and equations are counted without the pinned and the dropped ones.
  void write_inverse(const Enclosure& box) {
    std::vector<std::size_t> unknown(box.system.size(), 0), equation(box.system.size(), 0);
    for (const std::size_t j : box.pinned) unknown[j] = 1;
    for (const DroppedEquation& d : box.dropped) equation[d.equation] = 1;
    for (auto* list : {&unknown, &equation}) {
      std::size_t next = 0;
      for (std::size_t& i : *list) i = i == 1 ? ModeSystem::none : next++;
    }
    std::size_t entries = 0;
    for (const SystemBlock& b : box.blocks) entries += b.unknowns.size() * b.unknowns.size();
    line("inverse {}", entries);
    for (const SystemBlock& b : box.blocks) {
      for (std::size_t j = 0; j < b.unknowns.size(); ++j) {
        for (std::size_t i = 0; i < b.equations.size(); ++i) {
          line("{} {} {:a}", unknown[b.unknowns[j]], equation[b.equations[i]], b.inverse.row(j)[i]);
        }
      }
    }
  }

  static constexpr std::size_t large = 400;  ///< rows from which a certificate has to be short
  const MixedProblem& problem_;
  bool with_velocities_ = false;
  std::string text_;
};

}  // namespace

std::string contact_certificate(const MixedProblem& problem, const ContactJudgement& judgement) {
  return CertificateWriter(problem).write(judgement);
}

}  // namespace slipproof

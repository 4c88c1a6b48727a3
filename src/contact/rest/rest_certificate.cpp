#include "contact/rest/rest_certificate.hpp"

#include <fmt/format.h>

#include <map>

#include "base/input/diagnostic.hpp"
#include "base/os/sha256.hpp"
#include "mechanics/points/problem.hpp"

namespace slipproof {

namespace {

/// w = A x + c with x the accelerations, the free forces, then those of contacts: in the first rows M v - H r - G
/// lambda
/// - f, in the others G^T v and H^T v.
class RestCertificate {
 public:
  explicit RestCertificate(const RestAnswer& answer)
      : answer_(answer),
        p_(answer.problem),
        dimension_(answer.scene.mechanism.dimension),
        accelerations_(p_.rows.size()),
        free_(accelerations_ + p_.free.size()),
        matrix_(free_ + dimension_ * p_.contacts.size()),
        constant_(matrix_.size()) {}

  std::string write() {
    number_forces();
    add_inertia();
    for (std::size_t j = 0; j < p_.forces.size(); ++j) {
      if (column_.contains(j)) add_force(j, column_.at(j));
    }
    for (std::size_t i = 0; i < accelerations_; ++i) constant_[i] = -answer_.push->f[i];
    const std::string problem = problem_text();
    std::string text = "slipproof-contact 1\nproblem " + sha256("slipproof-contact-problem 1\n" + canonical_text()) +
                       "\n" + problem + "no-answer\n";
    text += *answer_.decision.can ? forces_text() : multipliers_text();
    return text + "end\n";
  }

 private:
  void number_forces() {
    for (std::size_t k = 0; k < p_.free.size(); ++k) column_[p_.free[k]] = accelerations_ + k;
    for (std::size_t k = 0; k < p_.contacts.size(); ++k) {
      const RestProblem::Contact& contact = p_.contacts[k];
      const std::size_t normal = free_ + dimension_ * k;
      column_[contact.normal] = normal;
      for (std::size_t t = 0; t < contact.tangents.size(); ++t) column_[contact.tangents[t]] = normal + 1 + t;
    }
  }

  void add_inertia() {
    const Mechanism& m = answer_.scene.mechanism;
    const ProblemMaker maker(m);
    Evaluator<Rational> at = maker.at(answer_.scene.values);
    for (std::size_t i = 0; i < accelerations_; ++i) {
      for (const auto& [j, program] : maker.compiled().equations[i].terms) {
        if (j < accelerations_) matrix_[i][j] = at.number(program).number.value();
      }
    }
  }

  void add_force(std::size_t force, std::size_t column) {
    for (const auto& [row, value] : p_.along[force]) {
      matrix_[row][column] = -value;
      matrix_[column][row] = value;
    }
  }

  std::string numbers(const char* word, const std::vector<Rational>& values) const {
    std::string text = word;
    for (const Rational& value : values) text += " " + value.str();
    return text + "\n";
  }
  std::string head_text() const {
    std::vector<Rational> mu;
    for (const RestProblem::Contact& contact : p_.contacts) {
      mu.push_back(contact.tangents.empty() ? Rational(0) : contact.mu);
    }
    return fmt::format("dimension {} free {} contacts {}\n", dimension_, free_, p_.contacts.size()) + numbers("mu", mu);
  }
  std::string entries_text(std::size_t& count) const {
    std::string text;
    for (std::size_t i = 0; i < matrix_.size(); ++i) {
      for (const auto& [j, value] : matrix_[i]) {
        if (value.is_zero()) continue;
        text += fmt::format("{} {} {}\n", i, j, value.str());
        ++count;
      }
    }
    return text;
  }
  std::string problem_text() const {
    std::size_t count = 0;
    const std::string entries = entries_text(count);
    return head_text() + fmt::format("matrix {}\n", count) + entries + numbers("constant", constant_);
  }
  std::string canonical_text() const {
    std::size_t count = 0;
    return head_text() + "matrix\n" + entries_text(count) + numbers("constant", constant_);
  }

  std::string forces_text() const {
    std::vector<Rational> x(matrix_.size() - accelerations_);
    for (const auto& [force, column] : column_) x[column - accelerations_] = answer_.decision.forces[force];
    return fmt::format("rest {}\n", accelerations_) + numbers("forces", x);
  }
  std::string multipliers_text() const {
    return fmt::format("no-rest {}\n", accelerations_) + numbers("multipliers", answer_.decision.fall->rates);
  }

  const RestAnswer& answer_;
  const RestProblem& p_;
  const std::size_t dimension_, accelerations_, free_;
  std::vector<std::map<std::size_t, Rational>> matrix_;
  std::vector<Rational> constant_;
  std::map<std::size_t, std::size_t> column_;  ///< of each force that may act
};

}  // namespace

std::string rest_certificate(const RestAnswer& answer) {
  const bool proved = answer.decision.can &&
                      (*answer.decision.can ? !answer.decision.forces.empty() : answer.decision.fall.has_value());
  if (!proved) return {};
  if (!answer.problem.by_virtual_work || !answer.problem.limits.empty()) {
    throw InputError({{answer.problem.file, 0, 0,
                       "found equations as printed, or friction with a limit of its own, expected contacts and links "
                       "for a certificate"}});
  }
  return RestCertificate(answer).write();
}

}  // namespace slipproof

#include "claims/identity/identity.hpp"

#include <algorithm>
#include <memory>
#include <numeric>

#include "base/expression/logic.hpp"
#include "base/expression/parser.hpp"
#include "claims/identity/symbolic.hpp"
#include "claims/identity/symbolic_motion.hpp"
#include "claims/plain/plain_setting.hpp"

namespace slipproof {

namespace {

class IdentitySearch {
 public:
  IdentitySearch(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading)
      : file_(file),
        claim_(file.claims[claim]),
        reading_(reading),
        body_(claim_.body(reading)),
        angles_(file.settings[claim_.setting].angles),
        setting_(compiled.settings[claim_.setting]),
        programs_(compiled.claims[claim].body(reading)),
        variables_(force_and_parameters(setting_)),
        ring_(ring_of(setting_.scope(), with_angles(variables_, angles_))) {}

  /// Whether the claim is an identity; if so, divisors() returns what it divides by.
  bool find() {
    if (!is_identity()) return false;
    add_half_tangents(!body_.modes.empty());
    return true;
  }

  /// The irreducible divisors, each once; the search must outlive them.
  const std::vector<MultiPolynomial>& divisors() const { return divisors_; }

 private:
  bool is_identity() {
    if (!body_.kind->may_be_identity(body_)) return false;
    std::vector<Program> programs = programs_.equations;
    programs.push_back(programs_.holds);
    if (!body_.modes.empty()) {
      return std::all_of(body_.modes.begin(), body_.modes.end(),
                         [&](const MechanismMode& mode) { return holds_in(mode, programs); });
    }
    SymbolicEvaluator symbols = symbols_of_setting();
    return std::all_of(programs.begin(), programs.end(), [&](const Program& p) { return is_true(symbols, p); });
  }

  /// The slots of the force and the parameters, which follow each other.
  static std::vector<std::size_t> force_and_parameters(const CompiledSetting& setting) {
    std::vector<std::size_t> slots(1 + setting.domains().size());
    std::iota(slots.begin(), slots.end(), CompiledSetting::force_slot());
    return slots;
  }
  /// Adds the slots of cosines and sines, two for each angle, which follow all parameters.
  static std::vector<std::size_t> with_angles(std::vector<std::size_t> slots, const std::vector<FreeAngle>& angles) {
    for (std::size_t i = 0; i < 2 * angles.size(); ++i) slots.push_back(slots.size());
    return slots;
  }
  SymbolicEvaluator symbols_of_setting() const { return symbolic(setting_.scope(), variables_, *ring_); }

  void add_divisor(const SymbolicNumber& divisor) {
    if (divisor.is_constant()) return;
    for (const auto& [factor, exponent] : in_angles(*divisor.polynomial()).factors().factors) add_factor(factor);
  }
  void add_factor(MultiPolynomial factor) {
    if (factor.is_constant() || std::find(divisors_.begin(), divisors_.end(), factor) != divisors_.end()) return;
    divisors_.push_back(std::move(factor));
  }

  MultiPolynomial cosine(std::size_t angle) const { return variable(variables_.size() + 2 * angle); }
  MultiPolynomial sine(std::size_t angle) const { return variable(variables_.size() + 2 * angle + 1); }
  MultiPolynomial variable(std::size_t index) const { return MultiPolynomial::variable(*ring_, index); }
  MultiPolynomial one_and_cosine(std::size_t angle) const { return cosine(angle) + MultiPolynomial(*ring_, 1); }

  /// A polynomial with the same zeros, except where 1 + c = 0: with s/(1 + c) for the half tangent of each angle, and 1
  /// - c^2 for s^2.
  MultiPolynomial in_angles(MultiPolynomial p) const {
    for (std::size_t i = 0; i < angles_.size(); ++i) {
      p = substitute(p, 1 + angles_[i].parameter, sine(i), one_and_cosine(i));
      const MultiPolynomial square = one_and_cosine(i) * (MultiPolynomial(*ring_, 1) - cosine(i));
      MultiPolynomial reduced(*ring_);
      const std::size_t s = variables_.size() + 2 * i + 1;
      for (std::size_t e = 0; e <= p.degree(s); ++e) {
        reduced += p.coefficient(s, e) * power(square, e / 2) * power(sine(i), e % 2);
      }
      p = std::move(reduced);
    }
    return p;
  }
  /// The half tangent s/(1 + c) adds the divisor 1 + c.
  void add_half_tangents(bool moves) {
    for (std::size_t i = 0; i < angles_.size(); ++i) {
      if (moves || uses(angles_[i])) add_factor(one_and_cosine(i));
    }
  }
  bool uses(const FreeAngle& angle) const {
    const SettingNames names(file_.settings[claim_.setting]);
    const auto all = expressions(body_);
    return std::any_of(all.begin(), all.end(),
                       [&](const Expression& e) { return names.depends(e, reading_, angle.cosine); });
  }

  bool is_true(SymbolicEvaluator& symbols, const Program& program) {
    if (symbols.truth(program) != Truth::yes) return false;
    for (const Program::Instruction& instruction : program.code()) {
      if (instruction.operation != Operation::compare) continue;
      for (const std::uint32_t side : {instruction.first, instruction.second}) {
        const auto value = symbols.number(program, side).number;
        if (!value) return false;  // a part that does not matter has no value, so this identity cannot be judged here
        for (const MultiPolynomial& divisor : value->divisors()) add_divisor(divisor);
      }
    }
    return true;
  }

  bool holds_in(const MechanismMode& mode, const std::vector<Program>& programs) {
    SymbolicEvaluator symbols = symbols_of_setting();
    const SymbolicMotion motion = symbolic_motion(setting_, mode, symbols);
    if (!motion.found) return false;  // singular for all parameters, not modelled, or too large
    for (const SymbolicNumber& divisor : motion.divisors) add_divisor(divisor);
    return std::all_of(programs.begin(), programs.end(), [&](const Program& p) { return is_true(symbols, p); });
  }

  const ClaimsFile& file_;
  const Claim& claim_;
  Reading reading_;
  const ClaimBody& body_;
  const std::vector<FreeAngle>& angles_;
  const CompiledSetting& setting_;
  const CompiledBody& programs_;
  std::vector<std::size_t> variables_;  ///< slots
  std::unique_ptr<const PolynomialRing> ring_;
  std::vector<MultiPolynomial> divisors_;
};

/// Decides whether a polynomial in the force and the parameters has no zero in the claim's region: for the forces of
/// the domain, or for any forces if the claim is about any.
class NeverZero {
 public:
  NeverZero(const ClaimsFile& file, const Claim& claim, Reading reading, LemmaBook* book)
      : file_(file),
        setting_(file.settings[claim.setting]),
        claim_(claim),
        reading_(reading),
        signs_(setting_, reading),
        book_(book) {}

  bool shown(const MultiPolynomial& p) {
    if (is_one_signed(p) && all_positive(p)) return true;
    const Expression number = parse_expression(p.text(), Sort::number);
    if (signs_.positive(number) || signs_.positive(make(Operation::negate, {number}))) return true;
    if (book_ == nullptr) return false;
    if (!read_) read_ = as_read(file_, reading_);
    const ClaimBody& body = claim_.body(reading_);
    Lemmas lemmas;
    const Implications logic(*read_, claim_.setting, *book_);
    return (body.kind->traits().needs_no_force ? logic.of_any_force() : logic)
        .implies({body.region, body.forces}, make_comparison({number, make_number(0)}, {Relation::not_equal}), lemmas);
  }

 private:
  /// Whether all variables of p are positive.
  bool all_positive(const MultiPolynomial& p) const {
    const std::vector<std::size_t> variables = p.variables();
    return std::all_of(variables.begin(), variables.end(),
                       [&](std::size_t i) { return signs_.positive(make_symbol(p.ring().name(i))); });
  }
  /// Whether all coefficients of p have one sign.
  static bool is_one_signed(const MultiPolynomial& p) {
    const std::vector<Term> terms = p.terms();
    return std::all_of(terms.begin(), terms.end(),
                       [&](const Term& term) { return (term.coefficient > 0) == (terms.front().coefficient > 0); });
  }

  const ClaimsFile& file_;
  const Setting& setting_;
  const Claim& claim_;
  Reading reading_;
  PlainSigns signs_;
  LemmaBook* book_;
  std::optional<ClaimsFile> read_;  ///< the file that lemmas are written from
};

}  // namespace

std::optional<Identity> find_identity(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                      Reading reading, LemmaBook* book) {
  const Claim& c = file.claims[claim];
  IdentitySearch search(file, compiled, claim, reading);
  if (!search.find()) return std::nullopt;
  NeverZero never_zero(file, c, reading, book);
  Identity identity;
  identity.has_interval_of_forces = PlainSetting(file.settings[c.setting], reading).has_interval_of_forces();
  for (const MultiPolynomial& divisor : search.divisors()) {
    if (!never_zero.shown(divisor)) identity.unless_zero.push_back(divisor.text());
  }
  const PlainSigns signs(file.settings[c.setting], reading);
  const ClaimBody& body = c.body(reading);
  for (const Expression& condition : {body.region, body.forces}) {
    if (!signs.defined(condition)) identity.unless_zero.push_back("a divisor in " + to_string(condition));
  }
  return identity;
}

}  // namespace slipproof

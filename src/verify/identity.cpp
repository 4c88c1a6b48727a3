#include "verify/identity.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <span>

#include "claims/claims_mutants.hpp"
#include "expression/logic.hpp"
#include "expression/parser.hpp"
#include "model/reduction.hpp"
#include "statements/plain_signs.hpp"
#include "verify/symbolic.hpp"

namespace slipproof {

namespace {

struct SymbolicScene {
  Bicycle<SymbolicNumber> bicycle;
  Road<SymbolicNumber> road;
  SymbolicNumber force;
};

/// Nothing if the scene is not polynomial in the parameters.
std::optional<SymbolicScene> scene_of(const CompiledSetting& setting, SymbolicEvaluator& symbols) {
  SymbolicScene scene;
  Bicycle<SymbolicNumber>& p = scene.bicycle;
  p.J = SymbolicNumber(0);
  const std::array<SymbolicNumber*, 15> targets{&p.M,  &p.R,  &p.h,          &p.b2,         &p.b3,
                                                &p.I1, &p.I2, &p.I3,         &p.r1,         &p.r2,
                                                &p.L,  &*p.J, &scene.road.f, &scene.road.g, &scene.force};
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (!setting.scene()[i]) {
      p.J.reset();
      continue;
    }
    const auto value = symbols.number(*setting.scene()[i]).number;
    if (!value || !value->value().denominator.is_one()) return std::nullopt;
    *targets[i] = value->value().numerator;
  }
  return scene;
}

class IdentitySearch {
 public:
  IdentitySearch(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading)
      : file_(file),
        claim_(file.claims[claim]),
        body_(claim_.body(reading)),
        setting_(compiled.settings[claim_.setting]),
        programs_(compiled.claims[claim].body(reading)),
        variables_(force_and_parameters(setting_)),
        ring_(ring_of(setting_.scope(), variables_)) {}

  /// Whether it is one; then divisors() has what it divides by.
  bool find() {
    if (const auto* formula = std::get_if<Formula>(&body_.says)) {
      if (formula->modes.empty()) {
        SymbolicEvaluator symbols = symbols_of_setting();
        return is_true(symbols, programs_.holds);
      }
      return std::all_of(formula->modes.begin(), formula->modes.end(), [&](ContactMode mode) {
        return holds_in(mode, {&programs_.holds, 1}, Vocabulary::quantities);
      });
    }
    const auto* consequence = std::get_if<Consequence>(&body_.says);
    return consequence != nullptr && consequence->from_model() && consequence->assume.empty() && consequence->mode &&
           holds_in(*consequence->mode, programs_.equations, Vocabulary::unknowns);
  }

  /// Irreducible, each once; the search must outlive them.
  const std::vector<MultiPolynomial>& divisors() const { return divisors_; }

 private:
  /// They stand side by side.
  static std::vector<std::size_t> force_and_parameters(const CompiledSetting& setting) {
    std::vector<std::size_t> slots(1 + setting.domains().size());
    std::iota(slots.begin(), slots.end(), CompiledSetting::force_slot());
    return slots;
  }
  SymbolicEvaluator symbols_of_setting() const { return symbolic(setting_.scope(), variables_, *ring_); }

  void add_divisor(const SymbolicNumber& divisor) {
    if (divisor.is_constant()) return;
    Factorization factorization = divisor.polynomial()->factors();
    for (auto& [factor, exponent] : factorization.factors) {
      if (std::find(divisors_.begin(), divisors_.end(), factor) == divisors_.end()) {
        divisors_.push_back(std::move(factor));
      }
    }
  }

  bool is_true(SymbolicEvaluator& symbols, const Program& program) {
    if (symbols.truth(program) != Truth::yes) return false;
    for (const Program::Instruction& instruction : program.code()) {
      if (instruction.operation != Operation::compare) continue;
      for (const std::uint32_t side : {instruction.first, instruction.second}) {
        const auto value = symbols.number(program, side).number;
        if (!value) return false;  // a part that does not matter has no value: no identity that this could judge
        for (const MultiPolynomial& divisor : value->divisors()) add_divisor(divisor);
      }
    }
    return true;
  }

  bool holds_in(ContactMode mode, std::span<const Program> programs, Vocabulary vocabulary) {
    SymbolicEvaluator symbols = symbols_of_setting();
    const auto scene = scene_of(setting_, symbols);
    if (!scene || (!mode.on_road() && !scene->bicycle.J)) return false;
    const ForceKind kind = file_.settings[claim_.setting].force_kind;
    const auto dynamics =
        reduce<SymbolicNumber, SymbolicNumber>(scene->bicycle, scene->road, kind, scene->force, SymbolicNumber(1));
    const ReducedMotion<SymbolicNumber, SymbolicNumber> motion(dynamics, mode);
    for (const Quantity q : all_quantities()) {
      auto value = motion.quantity(q);
      if (value.denominator.is_zero()) return false;  // singular for all parameters: the mode has no one motion
      add_divisor(value.denominator);
      symbols.set(CompiledSetting::quantity_slot(q),
                  ReducedFraction(std::move(value.numerator), std::move(value.denominator)));
    }
    if (vocabulary == Vocabulary::unknowns) set_unknowns(*scene, symbols);
    return std::all_of(programs.begin(), programs.end(), [&](const Program& p) { return is_true(symbols, p); });
  }

  /// The unknowns of the model by the quantities of a motion; the sprocket and the chain follow from its equations.
  void set_unknowns(const SymbolicScene& scene, SymbolicEvaluator& symbols) const {
    const Bicycle<SymbolicNumber>& p = scene.bicycle;
    const auto value = [&](Quantity q) { return symbols.at(CompiledSetting::quantity_slot(q)).number->value(); };
    const ReducedFraction phi = value(Quantity::phi);
    const ReducedFraction eps1 = ReducedFraction(p.r2, p.r1) * (value(Quantity::eps2) - phi) + phi;
    const ReducedFraction T =
        (ReducedFraction(p.I1) * eps1 - ReducedFraction(p.L * scene.force)) / ReducedFraction(p.r1);
    for (std::size_t i = 0; i < unknown_count; ++i) {
      const auto quantity = parse_quantity(unknown_names[i]);
      symbols.set(setting_.unknown_slot(i), quantity ? value(*quantity) : unknown_names[i] == "T" ? T : eps1);
    }
  }

  const ClaimsFile& file_;
  const Claim& claim_;
  const ClaimBody& body_;
  const CompiledSetting& setting_;
  const CompiledBody& programs_;
  std::vector<std::size_t> variables_;  ///< slots
  std::unique_ptr<const PolynomialRing> ring_;
  std::vector<MultiPolynomial> divisors_;
};

/// Whether a polynomial in the force and the parameters has no zero in the claim's region.
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
    std::vector<Expression> given = {body.region};
    for (const Expression* forces : parts(body, BodyPart::forces)) given.push_back(*forces);
    Lemmas lemmas;
    return Implications(*read_, claim_.setting, *book_)
        .implies(given, make_comparison({number, make_number(0)}, {Relation::not_equal}), lemmas);
  }

 private:
  /// Of its variables.
  bool all_positive(const MultiPolynomial& p) const {
    const std::vector<std::size_t> variables = p.variables();
    return std::all_of(variables.begin(), variables.end(),
                       [&](std::size_t i) { return signs_.positive(make_symbol(p.ring().name(i))); });
  }
  /// Its coefficients.
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
  std::optional<ClaimsFile> read_;  ///< what lemmas are written from
};

}  // namespace

std::optional<Identity> find_identity(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                      Reading reading, LemmaBook* book) {
  const Claim& c = file.claims[claim];
  IdentitySearch search(file, compiled, claim, reading);
  if (!search.find()) return std::nullopt;
  NeverZero never_zero(file, c, reading, book);
  Identity identity;
  for (const MultiPolynomial& divisor : search.divisors()) {
    if (!never_zero.shown(divisor)) identity.unless_zero.push_back(divisor.text());
  }
  const PlainSigns signs(file.settings[c.setting], reading);
  const ClaimBody& body = c.body(reading);
  for (const BodyPart part : {BodyPart::region, BodyPart::forces}) {
    for (const Expression* condition : parts(body, part)) {
      if (!signs.defined(*condition)) identity.unless_zero.push_back("a divisor in " + to_string(*condition));
    }
  }
  return identity;
}

}  // namespace slipproof

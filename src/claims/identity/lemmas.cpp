#include "claims/identity/lemmas.hpp"

#include <algorithm>
#include <utility>

#include "base/expression/logic.hpp"
#include "claims/plain/plain_setting.hpp"
#include "claims/statements/claim_statements.hpp"
#include "proofs/check/judge.hpp"
#include "proofs/search/prove.hpp"
#include "proofs/statement/statement.hpp"

namespace slipproof {

namespace {

/// `shown` without the conjuncts that are in `given`.
Expression not_given(const Expression& shown, const std::vector<Expression>& given) {
  const std::vector<Expression> known = conjuncts(given);
  Expression rest = make_truth(true);
  for (const Expression& e : conjuncts({shown})) {
    if (std::none_of(known.begin(), known.end(), [&](const Expression& k) { return same(k, e); }))
      rest = conjunction(rest, e);
  }
  return rest;
}

void collect_divisors(const Expression& e, std::vector<Expression>& found) {
  if (e->operation == Operation::divide) found.push_back(e->operands[1]);
  if (e->operation == Operation::power && e->exponent < 0) found.push_back(e->operands[0]);
  for (const Expression& operand : e->operands) collect_divisors(operand, found);
}

/// The formula at large values of a variable, in terms of leading coefficients; nothing if an equation is not an
/// identity.
std::optional<std::string> at_infinity(const prove::Formula& formula, std::size_t variable) {
  using prove::Formula;
  if (formula.kind == Formula::Kind::atom) {
    const prove::Polynomial& p = formula.polynomial.front();
    if (formula.sign == prove::Sign::zero) return p.is_zero() ? std::optional<std::string>("0 = 0") : std::nullopt;
    return p.coefficient(variable, p.degree(variable)).text() + " > 0";
  }
  const bool all = formula.kind == Formula::Kind::conjunction;
  if (!all && formula.parts.size() == 2 && formula.parts[0].polynomial.size() == 1 &&
      formula.parts[1].polynomial.size() == 1 && formula.parts[0].polynomial[0] == -formula.parts[1].polynomial[0]) {
    const prove::Polynomial& p = formula.parts[0].polynomial[0];  // p != 0
    return p.coefficient(variable, p.degree(variable)).text() + " != 0";
  }
  std::string text;
  for (const Formula& part : formula.parts) {
    auto inner = at_infinity(part, variable);
    if (!inner && all) return std::nullopt;
    if (!inner) continue;
    if (part.kind != Formula::Kind::atom && part.kind != formula.kind) inner = "{" + *inner + "}";
    text += (text.empty() ? "" : all ? " and " : " or ") + *inner;
  }
  if (!text.empty()) return text;
  return all ? std::optional<std::string>("0 = 0") : std::nullopt;
}

}  // namespace

std::string LemmaBook::certificate(const std::string& statement) {
  {
    const std::scoped_lock lock(mutex_);
    const auto found = known_.find(statement);
    if (found != known_.end()) return found->second;
  }
  std::string certificate = prove_statement("lemma", statement, limits_).certificate;
  // The prover needs no trust: what it writes counts if the checker accepts it.
  if (check::judge(statement, certificate).verdict != check::Verdict::accepted) certificate.clear();
  const std::scoped_lock lock(mutex_);
  return known_.emplace(statement, std::move(certificate)).first->second;
}

bool Implications::prove(const std::string& statement, Lemmas& lemmas) const {
  std::string certificate = book_->certificate(statement);
  if (certificate.empty()) return false;
  lemmas.push_back({statement, std::move(certificate)});
  return true;
}

bool Implications::proves(std::size_t claim, const ClaimBody& body, Lemmas& lemmas) const {
  Claim changed = file_->claims[claim];
  changed.printed = body;
  const auto statements = claim_statements(*file_, changed, Reading::printed);
  return !statements.empty() && std::all_of(statements.begin(), statements.end(),
                                            [&](const NamedStatement& s) { return prove(s.text, lemmas); });
}

bool Implications::implies(std::vector<Expression> given, const Expression& shown, Lemmas& lemmas,
                           const std::optional<MechanismMode>& mode, Obeying obeying) const {
  const Expression rest = not_given(shown, given);
  if (rest->operation == Operation::truth && rest->truth) return true;
  if (prove(given, rest, lemmas, mode, obeying)) return true;
  // A divisor that differs from 0 is positive or negative. Showing which first helps the search with all that follows.
  const std::vector<Expression> known = conjuncts(given);
  const auto unequal = std::find_if(known.begin(), known.end(), [](const Expression& e) {
    return e->operation == Operation::compare && e->relations.front() == Relation::not_equal;
  });
  if (unequal == known.end()) return false;
  const std::size_t before = lemmas.size();
  const auto holds_where = [&](Relation relation) {
    std::vector<Expression> branch{make_comparison((*unequal)->operands, {relation})};
    branch.insert(branch.end(), given.begin(), given.end());
    return prove(branch, rest, lemmas, mode, obeying);
  };
  if (holds_where(Relation::greater) && holds_where(Relation::less)) return true;
  lemmas.resize(before);
  return false;
}

bool Implications::prove(const std::vector<Expression>& given, const Expression& shown, Lemmas& lemmas,
                         const std::optional<MechanismMode>& mode, Obeying obeying) const {
  const auto text = implication_statement(*file_, {.name = "lemma",
                                                   .setting = setting_,
                                                   .given = given,
                                                   .shown = shown,
                                                   .force_domain = force_domain_,
                                                   .on_road = obeying == Obeying::equations_on_road,
                                                   .mode = mode});
  return text && prove(*text, lemmas);
}

bool Implications::has_interval_of_forces() const {
  return PlainSetting(file_->settings[setting_], Reading::printed).has_interval_of_forces();
}

bool Implications::is_linear(const Expression& equation) const {
  return PlainSetting(file_->settings[setting_], Reading::printed).is_linear(equation);
}

bool Implications::has_value(const std::vector<Expression>& given, const Expression& truth, Lemmas& lemmas) const {
  return PlainSetting(file_->settings[setting_], Reading::printed).always_defined(truth) ||
         implies(given, make(Operation::logical_or, {truth, opposite(truth)}), lemmas);
}

bool Implications::equivalent(const std::vector<Expression>& given, const Expression& x, const Expression& y,
                              Lemmas& lemmas, Obeying obeying) const {
  const auto with = [&](const Expression& e) {
    std::vector<Expression> all = given;
    all.push_back(e);
    return all;
  };
  return implies(with(x), y, lemmas, std::nullopt, obeying) && implies(with(y), x, lemmas, std::nullopt, obeying) &&
         divides_alike(given, x, y, lemmas);
}

std::vector<Expression> Implications::divisors(const Expression& e) const {
  std::vector<Expression> found;
  collect_divisors(e, found);
  for (const std::size_t d : names_.needs(e, Reading::printed)) {
    collect_divisors(names_.definition(d, Reading::printed), found);
  }
  std::erase_if(found, [](const Expression& divisor) { return divisor->operation == Operation::number; });
  return found;
}

bool Implications::divides_alike(const std::vector<Expression>& given, const Expression& x, const Expression& y,
                                 Lemmas& lemmas, const Alike& alike) const {
  const auto is_in = [&](const std::vector<Expression>& list, const Expression& divisor) {
    return std::any_of(list.begin(), list.end(), [&](const Expression& other) { return alike(other, divisor); });
  };
  const auto before = divisors(x), after = divisors(y);
  std::vector<Expression> conditions;
  if (sort(*y) == Sort::truth) conditions = conjuncts({y});
  return std::all_of(after.begin(), after.end(), [&](const Expression& divisor) {
    if (is_in(before, divisor)) return true;
    // Assumes the other conditions: where one is false, y is false too, whatever it divides by.
    std::vector<Expression> context = given;
    for (const Expression& e : conditions) {
      if (!is_in(divisors(e), divisor)) context.push_back(e);
    }
    return implies(context, make_comparison({divisor, make_number(0)}, {Relation::not_equal}), lemmas);
  });
}

bool Implications::eventually(const Expression& given, const Expression& shown, std::string_view parameter,
                              Lemmas& lemmas) const {
  if (names_.depends(given, Reading::printed, parameter)) return false;
  if (PlainSetting(file_->settings[setting_], Reading::printed).is_bounded(std::string(parameter))) return false;
  auto text = implication_statement(*file_, {.name = "lemma",
                                             .setting = setting_,
                                             .given = {given},
                                             .shown = shown,
                                             .force_domain = force_domain_,
                                             .mode = std::nullopt});
  if (!text) return false;
  const prove::Statement statement("lemma", *text);
  for (std::size_t variable = 0; variable < statement.ring().size(); ++variable) {
    if (statement.ring().name(variable) != parameter) continue;
    const auto leading = at_infinity(statement.shown(), variable);
    if (!leading) return false;
    text->erase(text->rfind("show "));
    return prove(*text + "show " + *leading + "\n", lemmas);
  }
  return false;
}

}  // namespace slipproof

#include "claims/mutation/settle.hpp"

#include <algorithm>
#include <utility>

#include "base/expression/logic.hpp"
#include "claims/identity/identity.hpp"
#include "claims/identity/same_function.hpp"

namespace slipproof {

struct Settler::State {
  State(const ClaimsFile& f, const CompiledClaims& c, LemmaBook& book) : file(f), compiled(c) {
    for (std::size_t s = 0; s < file.settings.size(); ++s) {
      logic.emplace_back(file, s, book);
      functions.emplace_back(compiled.settings[s]);
    }
  }

  using Result = std::optional<Settlement>;
  using Kind = Settlement::Kind;

  const Implications& in() const { return logic[setting]; }
  static Settlement made(Kind kind, std::size_t claim, std::string argument, Lemmas lemmas) {
    return {kind, claim, std::move(argument), std::move(lemmas)};
  }

  // ---- Claims

  static Expression part(const ClaimBody& body, BodyPart which) {
    const auto found = parts(body, which);
    return found.empty() ? make_truth(true) : *found.front();
  }

  /// Also where it may divide by 0: at samples that is no value, which is noticed.
  bool is_identity(const CompiledClaims& claims, std::size_t claim) const {
    return find_identity(file, claims, claim, Reading::printed, nullptr).has_value();
  }

  /// The claim itself is proved: as an identity, or by the lemmas that are added.
  bool is_proved(std::size_t claim, const ClaimBody& body, Lemmas& lemmas) {
    if (is_identity(compiled, claim)) return true;
    const auto* formula = std::get_if<Formula>(&body.says);
    return formula != nullptr && formula->modes.size() < 2 && follows(body, *formula, lemmas);
  }

  /// A formula about one mode, or none, for all parameters.
  bool follows(const ClaimBody& body, const Formula& formula, Lemmas& lemmas) const {
    const auto mode = formula.modes.empty() ? std::nullopt : std::optional(formula.modes.front());
    return in().implies({body.region, formula.forces}, formula.holds, lemmas, mode);
  }

  Result settle_claim(std::size_t claim, const ClaimBody& before, const ClaimBody& after) {
    const Claim& c = file.claims[claim];
    if (const auto* linear = linear_equations(before)) {
      return settle_linear(claim, before, *linear, after, *linear_equations(after));
    }
    const Expression forces = part(before, BodyPart::forces), now = part(after, BodyPart::forces);
    const bool where = !same(before.region, after.region) || !same(forces, now);
    const bool holds = !same(part(before, BodyPart::holds), part(after, BodyPart::holds));
    if (!where && holds) return settle_holds(claim, before, after);
    if (c.is<Interval>() || c.is<Equivalence>() || c.is<Limit>() || c.is<Unique>() || c.is<Cover>()) {
      Lemmas lemmas;
      if (!in().equivalent({}, before.region, after.region, lemmas)) return std::nullopt;
      if (in().equivalent({before.region}, forces, now, lemmas) && !holds) {
        return made(Kind::equivalent, claim, "before and after imply each other", std::move(lemmas));
      }
      return settle_equivalence(claim, after);
    }
    if (!holds) {
      if (auto result = settle_reach(claim, before, after)) return result;
    }
    return settle_theorem(claim, after);
  }

  static const LinearEquations* linear_equations(const ClaimBody& body) {
    const LinearEquations* found = std::get_if<Consequence>(&body.says);
    return found != nullptr ? found : std::get_if<System>(&body.says);
  }

  Result settle_equivalence(std::size_t claim, const ClaimBody& after) const {
    const auto* equivalence = std::get_if<Equivalence>(&after.says);
    Lemmas lemmas;
    if (equivalence == nullptr || !in().equivalent({after.region}, equivalence->forces, equivalence->holds, lemmas)) {
      return std::nullopt;
    }
    return made(Kind::theorem, claim, "the changed inequalities are equivalent, too", std::move(lemmas));
  }

  /// Another region, or other forces: of the same motions?
  Result settle_reach(std::size_t claim, const ClaimBody& before, const ClaimBody& after) {
    Lemmas lemmas;
    const Expression forces = part(before, BodyPart::forces);
    const Expression x = both(before.region, forces), y = both(after.region, part(after, BodyPart::forces));
    if (in().equivalent({}, x, y, lemmas)) {
      return made(Kind::equivalent, claim, "before and after imply each other", std::move(lemmas));
    }
    const Claim& c = file.claims[claim];
    const Modes modes = slipproof::modes(before.says);
    if (modes.empty() || !(c.is<Exists>() || (c.is<Formula>() && modes.size() == 1))) return std::nullopt;
    // Of several modes all have a motion there: what the motions of one obey is so.
    for (const MechanismMode& mode : modes) {
      lemmas.clear();
      const auto within = [&](const Expression& e, const Expression& other) {
        if (in().implies({e}, other, lemmas)) return true;
        // What the mode's motions obey in this region anyhow.
        const bool original = same(other, x);
        if (original && same(before.region, after.region) && in().implies({before.region}, forces, lemmas, mode)) {
          return true;
        }
        return in().implies({e}, other, lemmas, mode);
      };
      if (!within(x, y) || !within(y, x) || !in().divides_alike({}, x, y, lemmas)) continue;
      return made(Kind::equivalent, claim, "before and after are true of the same motions in " + name(mode),
                  std::move(lemmas));
    }
    return std::nullopt;
  }

  bool is_vacuous(const ClaimBody& body, Lemmas& lemmas) const {
    const auto* formula = std::get_if<Formula>(&body.says);
    return formula != nullptr && !formula->modes.empty() && in().implies({}, formula->holds, lemmas);
  }

  Result settle_holds(std::size_t claim, const ClaimBody& before, const ClaimBody& after) {
    Lemmas lemmas;
    if (is_vacuous(after, lemmas)) {
      return made(Kind::vacuous, claim, "true of all parameters in their domains, whatever the motion",
                  std::move(lemmas));
    }
    const Expression holds = part(before, BodyPart::holds), now = part(after, BodyPart::holds);
    const auto* formula = std::get_if<Formula>(&before.says);
    const std::vector<Expression> given{before.region, formula != nullptr ? formula->forces : make_truth(true)};
    if (in().equivalent(given, holds, now, lemmas)) {
      return made(Kind::equivalent, claim, "before and after imply each other", std::move(lemmas));
    }
    lemmas.clear();
    if (file.claims[claim].is<Equivalence>()) return settle_equivalence(claim, after);
    if (const auto* limit = std::get_if<Limit>(&after.says)) {
      if (!in().eventually(after.region, now, limit->parameter, lemmas)) return std::nullopt;
      return made(Kind::theorem, claim, "true from some value of " + limit->parameter + " on, by leading coefficients",
                  std::move(lemmas));
    }
    if (formula == nullptr) return std::nullopt;
    std::vector<Expression> weaker = given;
    weaker.push_back(holds);
    if (in().implies(weaker, now, lemmas) && is_proved(claim, before, lemmas)) {
      return made(Kind::theorem, claim, "it follows from the claim, which is proved", std::move(lemmas));
    }
    return settle_theorem(claim, after);
  }

  Result settle_theorem(std::size_t claim, const ClaimBody& after) {
    Lemmas lemmas;
    if (const auto* formula = std::get_if<Formula>(&after.says)) {
      if (is_identity(*changed, claim)) {
        return made(Kind::theorem, claim, "an identity of rational functions", {});
      }
      if (formula->modes.size() < 2 && follows(after, *formula, lemmas)) {
        return made(Kind::theorem, claim, "proved for all parameters", std::move(lemmas));
      }
    }
    if (const auto* impossible = std::get_if<Impossible>(&after.says)) {
      for (const MechanismMode& mode : impossible->modes) {
        if (!in().implies({after.region, impossible->forces}, make_truth(false), lemmas, mode)) return std::nullopt;
      }
      return made(Kind::theorem, claim, "proved for all parameters", std::move(lemmas));
    }
    return std::nullopt;
  }

  // ---- Equations

  Equations equations_of(const References& claims) const {
    Equations all;
    for (const std::size_t claim : claims) {
      const Equations& more = linear_equations(file.claims[claim].printed)->equations;
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  }

  Result settle_linear(std::size_t claim, const ClaimBody& before, const LinearEquations& old, const ClaimBody& after,
                       const LinearEquations& now) {
    Lemmas lemmas;
    const bool modelled = old.from_model();
    const Obeying obeying = modelled ? Obeying::equations_on_road : Obeying::nothing;
    if (!same(before.region, after.region)) {
      if (in().equivalent({}, before.region, after.region, lemmas)) {
        return made(Kind::equivalent, claim, "before and after imply each other", std::move(lemmas));
      }
      if (modelled && is_identity(*changed, claim)) {
        return made(Kind::theorem, claim, "an identity of rational functions", {});
      }
    }
    Equations sources = equations_of(old.given);
    const Equations more = equations_of(old.claims);
    sources.insert(sources.end(), more.begin(), more.end());

    // The same solutions, with all that stands beside it.
    std::vector<Expression> beside{before.region};
    Expression x = make_truth(true), y = make_truth(true);
    const auto compare = [&](const Equations& then, const Equations& changed_to) {
      for (std::size_t i = 0; i < then.size(); ++i) {
        if (same(then[i], changed_to[i])) {
          beside.push_back(then[i]);
        } else {
          x = both(x, then[i]);
          y = both(y, changed_to[i]);
        }
      }
    };
    const bool assumed = !std::equal(old.assume.begin(), old.assume.end(), now.assume.begin(), same);
    if (assumed) {
      compare(old.assume, now.assume);
      beside.insert(beside.end(), sources.begin(), sources.end());
    } else {
      compare(old.equations, now.equations);
      const Equations given = equations_of(old.given);
      beside.insert(beside.end(), given.begin(), given.end());
    }
    if (in().equivalent(beside, x, y, lemmas, assumed && !old.mode ? obeying : Obeying::nothing)) {
      return made(Kind::equivalent, claim, "with the equations beside it, before and after have the same solutions",
                  std::move(lemmas));
    }
    lemmas.clear();
    const Claim& c = file.claims[claim];
    // An assumption about what the equations do not have: both may leave the same of what they have.
    if (assumed && c.is<System>() && in().proves(claim, before, lemmas) && in().proves(claim, after, lemmas)) {
      return made(Kind::equivalent, claim, "before and after are proved to come to the same equations",
                  std::move(lemmas));
    }
    lemmas.clear();
    if (assumed || !c.is<Consequence>()) return std::nullopt;
    if (is_identity(*changed, claim)) {
      return made(Kind::theorem, claim, "an identity of rational functions", {});
    }
    std::vector<Expression> given{before.region};
    given.insert(given.end(), sources.begin(), sources.end());
    given.insert(given.end(), old.assume.begin(), old.assume.end());
    if (in().implies(given, y, lemmas, std::nullopt, obeying)) {
      return made(Kind::theorem, claim, "it follows for all parameters", std::move(lemmas));
    }
    return std::nullopt;
  }

  // ---- Mutants

  /// An expression with every definition written out that a changed one leads to, and the changed one replaced.
  Expression rewritten(const Expression& e, const std::string& symbol, const Expression& by) const {
    Expression result = e;
    for (const std::string& used : symbols(e)) {
      if (used == symbol) {
        result = substitute(result, used, by);
        continue;
      }
      const auto entry = in().names().find(used);
      if (!entry || entry->kind != SettingNames::Kind::definition) continue;
      const Expression& definition = in().names().definition(entry->index, Reading::printed);
      if (!in().names().depends(definition, Reading::printed, symbol)) continue;
      result = substitute(result, used, rewritten(definition, symbol, by));
    }
    return result;
  }

  Result settle(const ClaimsMutant& m, const CompiledClaims& now) {
    setting = m.setting;
    changed = &now;
    const Expression& before = m.original(file);
    if (functions[setting].same(before, m.mutant.expression)) {
      Lemmas lemmas;
      if (in().divides_alike({}, before, m.mutant.expression, lemmas,
                             [&](const Expression& x, const Expression& y) { return functions[setting].same(x, y); })) {
        return made(Kind::equivalent, m.claims.front(), "the same rational functions as before", std::move(lemmas));
      }
    }
    if (!m.part) return settle_definition(m);
    const ClaimBody& body = file.claims[m.index].printed;
    ClaimBody after = m.apply(file).claims[m.index].printed;
    return accepted(m, {m.index}, settle_claim(m.index, body, after));
  }

  /// What other claims refer to must say the same as before.
  Result accepted(const ClaimsMutant& m, const std::vector<std::size_t>& direct, Result result) const {
    if (!result || result->kind == Kind::equivalent || m.claims.size() == direct.size()) return result;
    return std::nullopt;
  }

  Result settle_definition(const ClaimsMutant& m) {
    const Definition& definition = file.settings[setting].definitions[m.index];
    Settlement all{Kind::equivalent, m.claims.front(), "", {}};
    std::vector<std::size_t> direct;
    for (const std::size_t claim : m.claims) {
      const ClaimBody& before = file.claims[claim].printed;
      ClaimBody after = before;
      bool uses = false;
      for_each_part(after, [&](BodyPart, std::size_t, Expression& e) {
        if (!in().names().depends(e, Reading::printed, definition.symbol)) return;
        uses = true;
        e = rewritten(e, definition.symbol, m.mutant.expression);
      });
      if (!uses) continue;
      direct.push_back(claim);
      Result one = settle_claim(claim, before, after);
      if (!one) return std::nullopt;
      if (one->kind != Kind::equivalent) all.kind = one->kind;
      all.argument += (all.argument.empty() ? "" : "; ") + file.claims[claim].id + ": " + one->argument;
      all.lemmas.insert(all.lemmas.end(), one->lemmas.begin(), one->lemmas.end());
    }
    return accepted(m, direct, std::move(all));
  }

  const ClaimsFile& file;
  const CompiledClaims& compiled;
  std::vector<Implications> logic;   ///< by setting
  std::vector<Functions> functions;  ///< by setting
  std::size_t setting = 0;           ///< of the mutant
  const CompiledClaims* changed = nullptr;
};

Settler::Settler(const ClaimsFile& file, const CompiledClaims& compiled, LemmaBook& book)
    : state_(std::make_unique<State>(file, compiled, book)) {}
Settler::~Settler() = default;

bool Settler::is_vacuous(std::size_t claim) {
  state_->setting = state_->file.claims[claim].setting;
  Lemmas lemmas;
  return state_->is_vacuous(state_->file.claims[claim].printed, lemmas);
}

std::optional<Settlement> Settler::settle(const ClaimsMutant& mutant, const CompiledClaims& changed) {
  return state_->settle(mutant, changed);
}

}  // namespace slipproof

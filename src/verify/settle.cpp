#include "verify/settle.hpp"

#include <algorithm>
#include <utility>

#include "verify/identity.hpp"
#include "verify/same_function.hpp"

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

  /// The claim itself is proved: as an identity, or by the lemmas that are added.
  bool is_proved(std::size_t claim, const ClaimBody& body, Lemmas& lemmas) {
    const Claim& c = file.claims[claim];
    if (is_identity(file, compiled, claim, Reading::printed)) return true;
    if (c.kind != ClaimKind::formula || body.modes.size() > 1) return false;
    const auto mode = body.modes.empty() ? std::nullopt : std::optional(body.modes.front());
    return in().implies({body.region, body.forces}, body.holds, lemmas, mode);
  }

  Result settle_claim(std::size_t claim, const ClaimBody& before, const ClaimBody& after) {
    Lemmas lemmas;
    const ClaimKind kind = file.claims[claim].kind;
    const bool where = !same(before.region, after.region) || !same(before.forces, after.forces);
    if (kind == ClaimKind::consequence || kind == ClaimKind::system) return settle_linear(claim, before, after);
    if (!where && !same(before.holds, after.holds)) return settle_holds(claim, before, after);
    if (kind == ClaimKind::interval || kind == ClaimKind::equivalence || kind == ClaimKind::limit ||
        kind == ClaimKind::unique || kind == ClaimKind::cover) {
      if (!in().equivalent({}, before.region, after.region, lemmas)) return std::nullopt;
      if (in().equivalent({before.region}, before.forces, after.forces, lemmas) && same(before.holds, after.holds)) {
        return made(Kind::equivalent, claim, "before and after imply each other", std::move(lemmas));
      }
      lemmas.clear();
      if (kind == ClaimKind::equivalence && in().equivalent({after.region}, after.forces, after.holds, lemmas)) {
        return made(Kind::theorem, claim, "the changed inequalities are equivalent, too", std::move(lemmas));
      }
      return std::nullopt;
    }
    if (same(before.holds, after.holds)) {
      if (auto result = settle_reach(claim, before, after)) return result;
    }
    return settle_theorem(claim, after);
  }

  /// Another region, or other forces: of the same motions?
  Result settle_reach(std::size_t claim, const ClaimBody& before, const ClaimBody& after) {
    Lemmas lemmas;
    const Expression x = both(before.region, before.forces), y = both(after.region, after.forces);
    if (in().equivalent({}, x, y, lemmas)) {
      return made(Kind::equivalent, claim, "before and after imply each other", std::move(lemmas));
    }
    const auto& modes = before.modes;
    const ClaimKind kind = file.claims[claim].kind;
    if (modes.size() != 1 || (kind != ClaimKind::formula && kind != ClaimKind::exists)) return std::nullopt;
    lemmas.clear();
    const auto within = [&](const Expression& e, const Expression& other) {
      if (in().implies({e}, other, lemmas)) return true;
      // What the mode's motions obey in this region anyhow.
      const bool original = same(other, x);
      if (original && same(before.region, after.region) &&
          in().implies({before.region}, before.forces, lemmas, modes[0])) {
        return true;
      }
      return in().implies({e}, other, lemmas, modes[0]);
    };
    if (!within(x, y) || !within(y, x) || !in().divides_alike({}, x, y, lemmas)) return std::nullopt;
    return made(Kind::equivalent, claim, "before and after are true of the same motions in " + name(modes[0]),
                std::move(lemmas));
  }

  bool is_vacuous(std::size_t claim, const ClaimBody& body, Lemmas& lemmas) const {
    return file.claims[claim].kind == ClaimKind::formula && !body.modes.empty() && in().implies({}, body.holds, lemmas);
  }

  Result settle_holds(std::size_t claim, const ClaimBody& before, const ClaimBody& after) {
    const ClaimKind kind = file.claims[claim].kind;
    Lemmas lemmas;
    if (is_vacuous(claim, after, lemmas)) {
      return made(Kind::vacuous, claim, "true of all parameters in their domains, whatever the motion",
                  std::move(lemmas));
    }
    const std::vector<Expression> given{before.region, kind == ClaimKind::formula ? before.forces : make_truth(true)};
    if (in().equivalent(given, before.holds, after.holds, lemmas)) {
      return made(Kind::equivalent, claim, "before and after imply each other", std::move(lemmas));
    }
    lemmas.clear();
    if (kind == ClaimKind::equivalence) {
      if (!in().equivalent({after.region}, after.forces, after.holds, lemmas)) return std::nullopt;
      return made(Kind::theorem, claim, "the changed inequalities are equivalent, too", std::move(lemmas));
    }
    if (kind == ClaimKind::limit && in().eventually(after.region, after.holds, after.parameter, lemmas)) {
      return made(Kind::theorem, claim, "true from some value of " + after.parameter + " on, by leading coefficients",
                  std::move(lemmas));
    }
    if (kind != ClaimKind::formula) return std::nullopt;
    std::vector<Expression> weaker = given;
    weaker.push_back(before.holds);
    if (in().implies(weaker, after.holds, lemmas) && is_proved(claim, before, lemmas)) {
      return made(Kind::theorem, claim, "it follows from the claim, which is proved", std::move(lemmas));
    }
    return settle_theorem(claim, after);
  }

  Result settle_theorem(std::size_t claim, const ClaimBody& after) {
    const ClaimKind kind = file.claims[claim].kind;
    Lemmas lemmas;
    if (kind == ClaimKind::formula) {
      if (is_identity(file, *changed, claim, Reading::printed)) {
        return made(Kind::theorem, claim, "an identity of rational functions", {});
      }
      if (after.modes.size() < 2) {
        const auto mode = after.modes.empty() ? std::nullopt : std::optional(after.modes.front());
        if (in().implies({after.region, after.forces}, after.holds, lemmas, mode)) {
          return made(Kind::theorem, claim, "proved for all parameters", std::move(lemmas));
        }
      }
    }
    if (kind == ClaimKind::impossible) {
      for (const ContactMode mode : after.modes) {
        if (!in().implies({after.region, after.forces}, make_truth(false), lemmas, mode)) return std::nullopt;
      }
      return made(Kind::theorem, claim, "proved for all parameters", std::move(lemmas));
    }
    return std::nullopt;
  }

  // ---- Equations

  std::vector<Expression> equations_of(const std::vector<std::size_t>& claims) const {
    std::vector<Expression> all;
    for (const std::size_t claim : claims) {
      const auto& more = file.claims[claim].printed.equations;
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  }

  Result settle_linear(std::size_t claim, const ClaimBody& before, const ClaimBody& after) {
    Lemmas lemmas;
    const bool modelled = before.given.empty() && before.claims.empty();
    if (!same(before.region, after.region)) {
      if (in().equivalent({}, before.region, after.region, lemmas)) {
        return made(Kind::equivalent, claim, "before and after imply each other", std::move(lemmas));
      }
      if (modelled && is_identity(file, *changed, claim, Reading::printed)) {
        return made(Kind::theorem, claim, "an identity of rational functions", {});
      }
    }
    const auto mode = before.modes.empty() ? std::nullopt : std::optional(before.modes.front());
    std::vector<Expression> sources = equations_of(before.given);
    const auto more = equations_of(before.claims);
    sources.insert(sources.end(), more.begin(), more.end());

    // The same solutions, with all that stands beside it.
    std::vector<Expression> beside{before.region};
    Expression x = make_truth(true), y = make_truth(true);
    const auto compare = [&](const std::vector<Expression>& old, const std::vector<Expression>& now) {
      for (std::size_t i = 0; i < old.size(); ++i) {
        if (same(old[i], now[i])) {
          beside.push_back(old[i]);
        } else {
          x = both(x, old[i]);
          y = both(y, now[i]);
        }
      }
    };
    const bool assumed = !std::equal(before.assume.begin(), before.assume.end(), after.assume.begin(), same);
    if (assumed) {
      compare(before.assume, after.assume);
      beside.insert(beside.end(), sources.begin(), sources.end());
    } else {
      compare(before.equations, after.equations);
      const auto given = equations_of(before.given);
      beside.insert(beside.end(), given.begin(), given.end());
    }
    if (in().equivalent(beside, x, y, lemmas, assumed && modelled && !mode)) {
      return made(Kind::equivalent, claim, "with the equations beside it, before and after have the same solutions",
                  std::move(lemmas));
    }
    lemmas.clear();
    // An assumption about what the equations do not have: both may leave the same of what they have.
    if (assumed && file.claims[claim].kind == ClaimKind::system && in().proves(claim, before, lemmas) &&
        in().proves(claim, after, lemmas)) {
      return made(Kind::equivalent, claim, "before and after are proved to come to the same equations",
                  std::move(lemmas));
    }
    lemmas.clear();
    if (assumed || file.claims[claim].kind != ClaimKind::consequence) return std::nullopt;
    if (is_identity(file, *changed, claim, Reading::printed)) {
      return made(Kind::theorem, claim, "an identity of rational functions", {});
    }
    std::vector<Expression> given{before.region};
    given.insert(given.end(), sources.begin(), sources.end());
    given.insert(given.end(), before.assume.begin(), before.assume.end());
    if (in().implies(given, y, lemmas, std::nullopt, modelled)) {
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
    if (functions[setting].same(before, m.mutant.expression, m.is_linear())) {
      Lemmas lemmas;
      if (in().divides_alike({}, before, m.mutant.expression, lemmas,
                             [&](const Expression& x, const Expression& y) { return functions[setting].same(x, y); })) {
        return made(Kind::equivalent, m.claims.front(), "the same rational functions as before", std::move(lemmas));
      }
    }
    if (m.part == ClaimsMutant::Part::definition) return settle_definition(m);
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
      const auto rewrite = [&](Expression& e) {
        if (!in().names().depends(e, Reading::printed, definition.symbol)) return;
        uses = true;
        e = rewritten(e, definition.symbol, m.mutant.expression);
      };
      for (Expression* e : {&after.region, &after.forces, &after.holds}) rewrite(*e);
      for (Expression& e : after.equations) rewrite(e);
      for (Expression& e : after.assume) rewrite(e);
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
  return state_->is_vacuous(claim, state_->file.claims[claim].printed, lemmas);
}

std::optional<Settlement> Settler::settle(const ClaimsMutant& mutant, const CompiledClaims& changed) {
  return state_->settle(mutant, changed);
}

}  // namespace slipproof

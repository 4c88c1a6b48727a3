#include "claims/mutation/settle.hpp"

#include <utility>

namespace slipproof {

Settler::Settler(const ClaimsFile& file, const CompiledClaims& compiled, LemmaBook& book)
    : file_(file), compiled_(compiled) {
  for (std::size_t s = 0; s < file.settings.size(); ++s) {
    logic_.emplace_back(file, s, book);
    functions_.emplace_back(compiled.settings[s]);
  }
}

bool Settler::is_vacuous(std::size_t claim) const {
  Lemmas lemmas;
  return is_true_of_any_motion(logic_[file_.claims[claim].setting], file_.claims[claim].printed, lemmas);
}

Settler::Result Settler::settle_claim(std::size_t claim, const ClaimBody& before, const ClaimBody& after) const {
  return before.kind->settle({file_, compiled_, *changed_, in(), claim, before, after});
}

Expression Settler::rewritten(const Expression& e, const std::string& symbol, const Expression& by) const {
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

Settler::Result Settler::settle(const ClaimsMutant& m, const CompiledClaims& now) {
  setting_ = m.setting;
  changed_ = &now;
  const Expression& before = m.original(file_);
  if (functions_[setting_].same(before, m.mutant.expression)) {
    Lemmas lemmas;
    if (in().divides_alike({}, before, m.mutant.expression, lemmas,
                           [&](const Expression& x, const Expression& y) { return functions_[setting_].same(x, y); })) {
      return Settlement{Settlement::Kind::equivalent, m.claims.front(), "the same rational functions as before",
                        std::move(lemmas)};
    }
  }
  if (!m.part) return settle_definition(m);
  const ClaimBody& body = file_.claims[m.index].printed;
  const ClaimBody after = m.apply(file_).claims[m.index].printed;
  return accepted(m, {m.index}, settle_claim(m.index, body, after));
}

Settler::Result Settler::accepted(const ClaimsMutant& m, const std::vector<std::size_t>& direct, Result result) const {
  if (!result || result->kind == Settlement::Kind::equivalent || m.claims.size() == direct.size()) return result;
  return std::nullopt;
}

Settler::Result Settler::settle_definition(const ClaimsMutant& m) const {
  const Definition& definition = file_.settings[setting_].definitions[m.index];
  Settlement all{Settlement::Kind::equivalent, m.claims.front(), "", {}};
  std::vector<std::size_t> direct;
  for (const std::size_t claim : m.claims) {
    const ClaimBody& before = file_.claims[claim].printed;
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
    if (one->kind != Settlement::Kind::equivalent) all.kind = one->kind;
    all.argument += (all.argument.empty() ? "" : "; ") + file_.claims[claim].id + ": " + one->argument;
    all.lemmas.insert(all.lemmas.end(), one->lemmas.begin(), one->lemmas.end());
  }
  return accepted(m, direct, std::move(all));
}

}  // namespace slipproof

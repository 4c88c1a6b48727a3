#include "claims/mutation/claims_mutants.hpp"

#include <algorithm>
#include <utility>

#include "base/expression/logic.hpp"
#include "claims/paper/setting_names.hpp"

namespace slipproof {

namespace {

/// The expression in a file, which may be const or not.
template <class File>
auto& part_of(File& file, const ClaimsMutant& mutant) {
  if (!mutant.part) return file.settings[mutant.setting].definitions[mutant.index].printed;
  decltype(&file.settings[0].definitions[0].printed) found = nullptr;
  for_each_part(file.claims[mutant.index].printed, [&](BodyPart part, std::size_t item, auto& expression) {
    if (part == *mutant.part && item == mutant.item) found = &expression;
  });
  return *found;
}

Program& part_of(CompiledBody& body, BodyPart part, std::size_t item) {
  if (part == BodyPart::equations) return body.equations[item];
  if (part == BodyPart::assume) return body.assume[item];
  return part == BodyPart::region ? body.region : part == BodyPart::forces ? body.forces : body.holds;
}

class ClaimsEnumeration {
 public:
  explicit ClaimsEnumeration(const ClaimsFile& file) : file_(file) {
    for (const Setting& setting : file.settings) names_.emplace_back(setting);
  }

  std::vector<ClaimsMutant> all() {
    for (std::size_t s = 0; s < file_.settings.size(); ++s) {
      for (std::size_t d = 0; d < file_.settings[s].definitions.size(); ++d) mutate_definition(s, d);
    }
    for (std::size_t c = 0; c < file_.claims.size(); ++c) mutate_claim(c);
    return std::move(found_);
  }

 private:
  void mutate_definition(std::size_t s, std::size_t d) {
    const Definition& definition = file_.settings[s].definitions[d];
    const auto claims = claims_with(s, definition.symbol);
    if (claims.empty()) return;  // the definition is inherited and no claim uses it, so nothing could notice a change
    const bool force = depends_on_force(s, definition.printed);
    std::vector<std::string> symbols;
    for (const auto& [symbol, entry] : names_[s].all()) {
      if (entry.kind == SettingNames::Kind::quantity) continue;
      const Expression use = make_symbol(symbol);
      if (!names_[s].depends(use, Reading::printed, definition.symbol) && (force || !depends_on_force(s, use))) {
        symbols.push_back(symbol);
      }
    }
    const std::string where = "definition " + definition.symbol + " (line " + std::to_string(definition.line) + ")";
    add({std::nullopt, s, d, 0, {}, where, claims}, definition.printed, symbols);
  }

  void mutate_claim(std::size_t c) {
    const Claim& claim = file_.claims[c];
    for_each_part(claim.printed, [&](BodyPart part, std::size_t item, const Expression& original) {
      // An empty condition cannot be changed.
      if (original->operation == Operation::truth) return;
      const bool linear = part == BodyPart::equations || part == BodyPart::assume;
      const std::string where = std::string(name(part)) + (linear ? " " + std::to_string(item + 1) : "") + " of " +
                                claim.id + " (line " + std::to_string(claim.line) + ")";
      ClaimsMutant mutant{part, claim.setting, c, item, {}, where, {c}};
      add_referring(mutant.claims);
      add(std::move(mutant), original, symbols_for(claim, part));
    });
  }

  std::vector<std::string> symbols_for(const Claim& claim, BodyPart part) const {
    std::vector<std::string> symbols;
    const bool linear = part == BodyPart::equations || part == BodyPart::assume;
    const bool quantities = part == BodyPart::holds && !claim.printed.modes.empty();
    for (const auto& [symbol, entry] : names_[claim.setting].all()) {
      const bool quantity = entry.kind == SettingNames::Kind::quantity;
      if (quantity && !(linear ? file_.settings[claim.setting].unknown_index(symbol).has_value() : quantities))
        continue;
      if (part == BodyPart::region && depends_on_force(claim.setting, make_symbol(symbol))) continue;
      symbols.push_back(symbol);
    }
    return symbols;
  }

  bool depends_on_force(std::size_t s, const Expression& expression) const {
    return names_[s].depends(expression, Reading::printed, file_.settings[s].force.symbol);
  }

  std::vector<std::size_t> claims_with(std::size_t s, const std::string& symbol) const {
    std::vector<std::size_t> result;
    for (std::size_t c = 0; c < file_.claims.size(); ++c) {
      if (file_.claims[c].setting != s) continue;
      bool depends = false;
      for_each_part(file_.claims[c].printed, [&](BodyPart, std::size_t, const Expression& expression) {
        depends = depends || names_[s].depends(expression, Reading::printed, symbol);
      });
      if (depends) result.push_back(c);
    }
    add_referring(result);
    return result;
  }

  void add_referring(std::vector<std::size_t>& claims) const {
    const std::vector<std::size_t> direct = claims;
    for (std::size_t c = 0; c < file_.claims.size(); ++c) {
      const References to = file_.claims[c].printed.references();
      if (std::find_first_of(to.begin(), to.end(), direct.begin(), direct.end()) != to.end()) claims.push_back(c);
    }
    std::sort(claims.begin(), claims.end());
    claims.erase(std::unique(claims.begin(), claims.end()), claims.end());
  }

  void add(ClaimsMutant mutant, const Expression& original, const std::vector<std::string>& symbols) {
    for (Mutant& change : mutants(original, symbols)) {
      // Skips a mutant that is no longer an equation.
      if (mutant.is_linear() && change.expression->relations != original->relations) continue;
      mutant.mutant = std::move(change);
      found_.push_back(mutant);
    }
  }

  const ClaimsFile& file_;
  std::vector<SettingNames> names_;
  std::vector<ClaimsMutant> found_;
};

}  // namespace

const Expression& ClaimsMutant::original(const ClaimsFile& file) const {
  return part_of(file, *this);
}

ClaimsFile ClaimsMutant::apply(const ClaimsFile& file) const {
  ClaimsFile changed = file;
  part_of(changed, *this) = mutant.expression;
  return changed;
}

void ClaimsMutant::put(const Expression& expression, CompiledClaims& compiled) const {
  if (!part) return compiled.settings[setting].redefine(index, expression);
  const CompiledSetting& scope = compiled.settings[setting];
  CompiledBody& body = compiled.claims[index].printed;
  Program program =
      is_linear() ? scope.compile_equation(expression, Reading::printed) : scope.compile(expression, Reading::printed);
  part_of(body, *part, item) = std::move(program);
  if (part == BodyPart::forces) body.closure = scope.compile(closure(expression), Reading::printed);
}

std::vector<ClaimsMutant> mutants(const ClaimsFile& file) {
  return ClaimsEnumeration(file).all();
}

}  // namespace slipproof

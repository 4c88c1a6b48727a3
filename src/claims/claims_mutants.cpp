#include "claims/claims_mutants.hpp"

#include <algorithm>
#include <utility>

#include "claims/setting_names.hpp"

namespace slipproof {

ClaimsFile as_read(const ClaimsFile& file, Reading reading) {
  ClaimsFile result = file;
  for (Setting& setting : result.settings) {
    for (Definition& definition : setting.definitions) {
      if (reading == Reading::repaired && definition.repaired) definition.printed = definition.repaired;
      definition.repaired = nullptr;
      definition.why.clear();
    }
  }
  for (Claim& claim : result.claims) {
    claim.printed = ClaimBody(claim.body(reading));
    claim.repaired.reset();
    claim.why.clear();
  }
  return result;
}

namespace {

using Part = ClaimsMutant::Part;

/// Of a ClaimBody or a CompiledBody.
template <class Body>
auto& part_of(Body& body, Part part, std::size_t item) {
  if (part == Part::equation) return body.equations[item];
  if (part == Part::assumption) return body.assume[item];
  return part == Part::region ? body.region : part == Part::forces ? body.forces : body.holds;
}

/// Of a file, const or not.
template <class File>
auto& part_of(File& file, const ClaimsMutant& mutant) {
  if (mutant.part == Part::definition) return file.settings[mutant.setting].definitions[mutant.index].printed;
  return part_of(file.claims[mutant.index].printed, mutant.part, mutant.item);
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
    add({Part::definition, s, d, 0, {}, where, claims_with(s, definition.symbol)}, definition.printed, symbols);
  }

  void mutate_claim(std::size_t c) {
    const Claim& claim = file_.claims[c];
    for (const Part part : {Part::region, Part::forces, Part::holds}) {
      constexpr const char* words[] = {"", "region", "forces", "holds"};
      const std::string where =
          std::string(words[static_cast<int>(part)]) + " of " + claim.id + " (line " + std::to_string(claim.line) + ")";
      ClaimsMutant mutant{part, claim.setting, c, 0, {}, where, {c}};
      add_referring(mutant.claims);
      const ClaimBody& body = claim.printed;
      const Expression& original = part == Part::region ? body.region : part == Part::forces ? body.forces : body.holds;
      // Where nothing is stated, there is nothing to change.
      if (original->operation == Operation::truth) continue;
      add(std::move(mutant), original, symbols_for(claim, part));
    }
    mutate_equations(c, Part::equation, claim.printed.equations);
    mutate_equations(c, Part::assumption, claim.printed.assume);
  }

  void mutate_equations(std::size_t c, Part part, const std::vector<Expression>& equations) {
    const Claim& claim = file_.claims[c];
    for (std::size_t i = 0; i < equations.size(); ++i) {
      const std::string where = (part == Part::equation ? "equation " : "assumption ") + std::to_string(i + 1) +
                                " of " + claim.id + " (line " + std::to_string(claim.line) + ")";
      ClaimsMutant mutant{part, claim.setting, c, i, {}, where, {c}};
      add_referring(mutant.claims);
      add(std::move(mutant), equations[i], symbols_for(claim, part));
    }
  }

  std::vector<std::string> symbols_for(const Claim& claim, Part part) const {
    std::vector<std::string> symbols;
    const bool linear = part == Part::equation || part == Part::assumption;
    for (const auto& [symbol, entry] : names_[claim.setting].all()) {
      if (linear && entry.kind == SettingNames::Kind::quantity && !unknown_index(symbol)) continue;
      if (!linear && entry.kind == SettingNames::Kind::quantity && (part != Part::holds || claim.printed.modes.empty()))
        continue;
      if (part == Part::region && depends_on_force(claim.setting, make_symbol(symbol))) continue;
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
      const ClaimBody& body = file_.claims[c].printed;
      if (file_.claims[c].setting != s) continue;
      std::vector<Expression> all{body.region, body.forces, body.holds};
      all.insert(all.end(), body.equations.begin(), body.equations.end());
      all.insert(all.end(), body.assume.begin(), body.assume.end());
      for (const Expression& expression : all) {
        if (!names_[s].depends(expression, Reading::printed, symbol)) continue;
        result.push_back(c);
        break;
      }
    }
    add_referring(result);
    return result;
  }

  void add_referring(std::vector<std::size_t>& claims) const {
    const std::vector<std::size_t> direct = claims;
    for (std::size_t c = 0; c < file_.claims.size(); ++c) {
      const ClaimBody& body = file_.claims[c].printed;
      const auto refers = [&](const std::vector<std::size_t>& to) {
        return std::find_first_of(to.begin(), to.end(), direct.begin(), direct.end()) != to.end();
      };
      if (refers(body.claims) || refers(body.except) || refers(body.given)) claims.push_back(c);
    }
    std::sort(claims.begin(), claims.end());
    claims.erase(std::unique(claims.begin(), claims.end()), claims.end());
  }

  void add(ClaimsMutant mutant, const Expression& original, const std::vector<std::string>& symbols) {
    for (Mutant& change : mutants(original, symbols)) {
      if (mutant.is_linear() && change.expression->relations != original->relations) continue;  // no longer an equation
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
  if (part == Part::definition) return compiled.settings[setting].redefine(index, expression);
  const CompiledSetting& scope = compiled.settings[setting];
  CompiledBody& body = compiled.claims[index].printed;
  Program program =
      is_linear() ? scope.compile_equation(expression, Reading::printed) : scope.compile(expression, Reading::printed);
  part_of(body, part, item) = std::move(program);
}

std::vector<ClaimsMutant> mutants(const ClaimsFile& file) {
  return ClaimsEnumeration(file).all();
}

}  // namespace slipproof

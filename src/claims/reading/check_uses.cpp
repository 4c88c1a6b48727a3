#include <algorithm>
#include <utility>

#include "base/expression/extent.hpp"
#include "claims/paper/compiled.hpp"
#include "claims/paper/setting_names.hpp"
#include "claims/reading/claims_reader.hpp"

namespace slipproof::claims_reader {

namespace {

class SettingCheck {
 public:
  SettingCheck(const Setting& setting, Context& context) : setting_(setting), names_(setting), context_(context) {}

  void check(const Use& use) {
    bool known = true;
    walk(use, use.expression, known);
    if (!known) return;
    for (const Reading reading : all_readings) {
      if (!use.allowed.force && depends_on_force(use, reading)) return;
      if (!use.independent_of.empty() && names_.depends(use.expression, reading, use.independent_of)) {
        return refuse(use, culprit(use.expression, reading, use.independent_of),
                      "depends on " + use.independent_of + " itself");
      }
    }
  }

  // True if no definition leads back to itself.
  bool check_circles(const Use& use) {
    bool fine = true;
    for (std::size_t i = 0; i < setting_.definitions.size(); ++i) {
      const Definition& definition = setting_.definitions[i];
      const bool is_here = definition.printed == use.expression || definition.repaired == use.expression;
      if (!is_here) continue;
      for (const Reading reading : all_readings) {
        const auto needed = names_.needs(use.expression, reading);
        if (std::find(needed.begin(), needed.end(), i) == needed.end()) continue;
        refuse(use, use.expression, "defines " + definition.symbol + " by itself");
        fine = false;
        break;
      }
    }
    return fine;
  }

  // Requires that definitions have no circles.
  void find_extents() {
    for (const Reading reading : all_readings) find_extents(reading);
  }
  void check_extent(const Use& use) {
    for (const Reading reading : all_readings) {
      const std::string message = too_large(extent(use.expression, reading));
      if (!message.empty()) return refuse(use, use.expression, message);
    }
  }

 private:
  void refuse(const Use& use, const Expression& where, const std::string& message) {
    context_.refuse(use.text, where->column - 1, use.key, message);
  }

  void walk(const Use& use, const Expression& expression, bool& known) {
    for (const Expression& operand : expression->operands) walk(use, operand, known);
    if (expression->operation != Operation::symbol) return;
    const std::string& symbol = expression->symbol;
    if (use.allowed.unknowns && setting_.unknown_index(symbol)) return;
    const auto entry = names_.find(symbol);
    if (!entry) {
      known = false;
      return refuse(use, expression, unknown("symbol", symbol, candidates(use.allowed)));
    }
    using Kind = SettingNames::Kind;
    if (entry->kind == Kind::quantity && !use.allowed.quantities) {
      refuse(use, expression, "found the quantity " + symbol + ", which only `holds` of a claim with a mode knows");
    } else if (entry->kind == Kind::definition && !use.allowed.definitions) {
      refuse(use, expression, "found the defined symbol " + symbol + ", expected parameters only");
    } else {
      return;
    }
    known = false;
  }

  std::vector<std::string_view> candidates(Allowed allowed) const {
    using Kind = SettingNames::Kind;
    std::vector<std::string_view> result;
    for (const auto& [symbol, entry] : names_.all()) {
      const bool fits = entry.kind == Kind::parameter || (entry.kind == Kind::force && allowed.force) ||
                        (entry.kind == Kind::quantity && allowed.quantities) ||
                        (entry.kind == Kind::definition && allowed.definitions);
      if (fits && !symbol.empty()) result.push_back(symbol);
    }
    return result;
  }

  // The first symbol through which an expression depends on another one.
  Expression culprit(const Expression& expression, Reading reading, std::string_view symbol) const {
    for (const Expression& operand : expression->operands) {
      if (names_.depends(operand, reading, symbol)) return culprit(operand, reading, symbol);
    }
    return expression;
  }

  bool depends_on_force(const Use& use, Reading reading) {
    const std::string& force = setting_.force.symbol;
    if (force.empty() || !names_.depends(use.expression, reading, force)) return false;
    refuse(use, culprit(use.expression, reading, force),
           "depends on the force " + force + ", expected the same for all forces");
    return true;
  }

  // Visits the definitions that others need before those, so that their sizes are known.
  void find_extents(Reading reading) {
    const std::size_t count = setting_.definitions.size();
    std::vector<std::pair<std::size_t, std::size_t>> order;
    for (std::size_t i = 0; i < count; ++i) {
      order.emplace_back(names_.needs(names_.definition(i, reading), reading).size(), i);
    }
    std::sort(order.begin(), order.end());
    auto& extents = extents_[static_cast<std::size_t>(reading)];
    extents.assign(count, {});
    for (const auto& [needed, i] : order) extents[i] = extent(names_.definition(i, reading), reading);
  }

  Extent extent(const Expression& expression, Reading reading) const {
    return slipproof::extent(expression, [&](const std::string& symbol) -> std::optional<Extent> {
      const auto entry = names_.find(symbol);
      if (!entry || entry->kind != SettingNames::Kind::definition) return std::nullopt;
      return extents_[static_cast<std::size_t>(reading)][entry->index];
    });
  }

  const Setting& setting_;
  SettingNames names_;
  Context& context_;
  std::array<std::vector<Extent>, 2> extents_;  ///< by reading and definition
};

}  // namespace

void check_uses(Context& context) {
  std::vector<SettingCheck> settings;
  settings.reserve(context.file.settings.size());
  for (const Setting& setting : context.file.settings) settings.emplace_back(setting, context);
  bool no_circles = true;
  for (const Use& use : context.uses) {
    if (use.setting >= settings.size()) continue;
    settings[use.setting].check(use);
    no_circles = settings[use.setting].check_circles(use) && no_circles;
  }
  if (!no_circles) return;
  for (SettingCheck& setting : settings) setting.find_extents();
  for (const Use& use : context.uses) {
    if (use.setting < settings.size()) settings[use.setting].check_extent(use);
  }
}

}  // namespace slipproof::claims_reader

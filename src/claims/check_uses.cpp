#include <algorithm>
#include <cstdlib>
#include <utility>

#include "claims/claims_reader.hpp"
#include "claims/compiled.hpp"
#include "claims/setting_names.hpp"

namespace slipproof::claims_reader {

namespace {

// Bounds on what evaluation costs, all definitions written out: of the size of the numbers, and of the stack.
constexpr double max_terms = 10'000;
constexpr std::size_t max_depth = 1'000;

/// How large an expression becomes when its definitions are written out.
struct Extent {
  double terms = 1;  ///< literals (by their length) and symbols, counted as often as they are multiplied
  std::size_t depth = 1;
};

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

  // Only without circles.
  void find_extents() {
    for (const Reading reading : all_readings) find_extents(reading);
  }
  void check_extent(const Use& use) {
    for (const Reading reading : all_readings) {
      const Extent extent = this->extent(use.expression, reading);
      if (extent.terms > max_terms) {
        return refuse(use, use.expression,
                      "too large to evaluate: more than 10000 terms with all definitions written out");
      }
      if (extent.depth > max_depth) {
        return refuse(use, use.expression, "nested more than 1000 levels deep with all definitions written out");
      }
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
    if (use.allowed.unknowns && unknown_index(symbol)) return;
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

  // The first symbol through which an expression depends on another.
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

  // Definitions first that others need: what a definition needs, needs less than it does itself.
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
    Extent total{0, 1};
    for (const Expression& operand : expression->operands) {
      const Extent part = extent(operand, reading);
      total.terms += part.terms;
      total.depth = std::max(total.depth, part.depth + 1);
    }
    if (expression->operation == Operation::power) total.terms *= std::max(1, std::abs(expression->exponent));
    if (expression->operation == Operation::number) total.terms = literal_terms(expression->number);
    if (expression->operation == Operation::symbol) {
      const auto entry = names_.find(expression->symbol);
      if (!entry || entry->kind != SettingNames::Kind::definition) return {};
      total = extents_[static_cast<std::size_t>(reading)][entry->index];
      ++total.depth;
    }
    return total;
  }

  static double literal_terms(const Rational& value) {
    constexpr std::size_t bits_of_term = 64;
    if (value.is_zero()) return 1;
    const std::size_t whole_terms = (msb(numerator(value)) + msb(denominator(value))) / bits_of_term;
    return 1.0 + static_cast<double>(whole_terms);
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

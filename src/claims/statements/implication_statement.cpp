#include <fmt/format.h>

#include "claims/statements/claim_statements.hpp"
#include "claims/statements/setting_writer.hpp"
#include "proofs/statement/zero_divisors.hpp"

namespace slipproof {
namespace {

class ImplicationWriter : SettingWriter {
 public:
  ImplicationWriter(const ClaimsFile& claims, const Implication& implication)
      : SettingWriter(claims.settings[implication.setting], Reading::printed), implication_(implication) {}

  std::optional<std::string> write() {
    const bool moving = implication_.on_road || implication_.mode;
    std::vector<Expression> uses = implication_.given;
    uses.push_back(implication_.shown);
    WrittenStatement result = begun(implication_.name, setting().id);
    add_parameters(result, implication_.force_domain);
    if (moving) {
      const StatedMotion motion = implication_.mode ? this->motion(*implication_.mode) : equations(std::nullopt);
      add_scene(result, uses);
      result.declare(Directive::Kind::real, mechanics().unknowns());
      result.add(motion.definitions);
      assume(result, "motion", motion.formula);
    } else {
      add_definitions(result, uses);
      result.declare(Directive::Kind::real, free_unknowns(uses));
    }
    for (std::size_t i = 0; i < implication_.given.size(); ++i)
      assume_truth(result, fmt::format("given{}", i + 1), implication_.given[i]);
    result.show(formula(implication_.shown));
    return complete() ? std::optional(without_zero_divisors(result.text())) : std::nullopt;
  }

 private:
  /// The quantities and unknowns that occur, to be declared as any numbers. They replace symbols of the setting with
  /// the same name.
  std::vector<std::string> free_unknowns(const std::vector<Expression>& uses) const {
    std::set<std::string> names;
    for (const Expression& use : uses) {
      for (const std::string& symbol : symbols(use)) names.insert(symbol);
    }
    for (const std::string& known : parameter_names()) names.erase(known);
    for (const Definition& known : setting().definitions) names.erase(known.symbol);
    return {names.begin(), names.end()};
  }

  const Implication& implication_;
};

}  // namespace

std::optional<std::string> implication_statement(const ClaimsFile& claims, const Implication& implication) {
  return ImplicationWriter(claims, implication).write();
}

}  // namespace slipproof

#include <fmt/format.h>
#include <fmt/ranges.h>

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
    std::string result = header(implication_.name, setting().id);
    result += variables() + assumption("domain", domain(implication_.force_domain));
    if (moving) {
      const MotionText motion = implication_.mode ? this->motion(*implication_.mode) : equations(std::nullopt);
      result += scene(uses) + fmt::format("real {}\n", fmt::join(mechanics().unknowns(), " ")) + motion.definitions +
                assumption("motion", motion.formula);
    } else {
      result += definitions(uses) + free_unknowns(uses);
    }
    for (std::size_t i = 0; i < implication_.given.size(); ++i) {
      result += assumption(fmt::format("given{}", i + 1), implication_.given[i]);
    }
    result += fmt::format("show {}\n", text(implication_.shown));
    return complete() ? std::optional(without_zero_divisors(std::move(result))) : std::nullopt;
  }

 private:
  /// The quantities and unknowns that occur, declared as any numbers. They replace symbols of the setting with the same
  /// name.
  std::string free_unknowns(const std::vector<Expression>& uses) const {
    std::set<std::string> names;
    for (const Expression& use : uses) {
      for (const std::string& symbol : symbols(use)) names.insert(symbol);
    }
    for (const std::string& known : parameter_names()) names.erase(known);
    for (const Definition& known : setting().definitions) names.erase(known.symbol);
    return names.empty() ? "" : fmt::format("real {}\n", fmt::join(names, " "));
  }

  const Implication& implication_;
};

}  // namespace

std::optional<std::string> implication_statement(const ClaimsFile& claims, const Implication& implication) {
  return ImplicationWriter(claims, implication).write();
}

}  // namespace slipproof

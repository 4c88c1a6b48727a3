#include "prove/claim_statements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "model/contact_mode.hpp"

namespace slipproof {
namespace {

constexpr std::array<std::string_view, 11> kUnknowns{"a", "a_y", "phi", "eps1", "eps2", "eps3",
                                                     "T", "S2",  "S3",  "N2",   "N3"};

/// The mechanics, as text for a person to compare with the model; tests/prove holds it against the equations of
/// src/model.
std::string mechanics(ForceKind kind) {
  const bool external = kind == ForceKind::external;
  return fmt::format(
      "let gap2 = -(a_y - phi*b2)\n"
      "let gap3 = -(a_y + phi*b3)\n"
      "let slip2 = a - phi*h - eps2*R\n"
      "let slip3 = a - phi*h - eps3*R\n"
      "define forces: M*a = S2 + S3{} and M*a_y = M*g - N2 - N3\n"
      "define pitch: J*phi + I1*eps1 + I2*eps2 + I3*eps3 = N2*b2 - N3*b3 - (S2 + S3)*(h + R){}\n"
      "define bodies: I1*eps1 = F*L + T*r1 and I2*eps2 = -S2*R - T*r2 and I3*eps3 = -S3*R\n"
      "define chain: (eps1 - phi)*r1 = (eps2 - phi)*r2\n",
      external ? " - F" : "", external ? " + F*(L + h)" : "");
}

constexpr const char* kDynamics = "forces and pitch and bodies and chain";

std::string state_name(Wheel wheel, ContactState state) {
  const char* side = wheel == Wheel::rear ? "rear" : "front";
  switch (state) {
    case ContactState::stick:
      return fmt::format("{}_sticks", side);
    case ContactState::slip_forward:
      return fmt::format("{}_slips_forwards", side);
    case ContactState::slip_backward:
      return fmt::format("{}_slips_backwards", side);
    case ContactState::lift:
      break;
  }
  return fmt::format("{}_lifts", side);
}

std::string state_definition(Wheel wheel, ContactState state, bool strict) {
  const char* above = strict ? ">" : ">=";
  const char* below = strict ? "<" : "<=";
  const int j = wheel == Wheel::rear ? 2 : 3;
  std::string body;
  switch (state) {
    case ContactState::stick:
      body = fmt::format("gap{0} = 0 and slip{0} = 0 and N{0} {1} 0 and -f*N{0} {2} S{0} {2} f*N{0}", j, above, below);
      break;
    case ContactState::slip_forward:
      body = fmt::format("gap{0} = 0 and S{0} = -f*N{0} and N{0} {1} 0 and slip{0} {1} 0", j, above);
      break;
    case ContactState::slip_backward:
      body = fmt::format("gap{0} = 0 and S{0} = f*N{0} and N{0} {1} 0 and slip{0} {2} 0", j, above, below);
      break;
    case ContactState::lift:
      body = fmt::format("N{0} = 0 and S{0} = 0 and gap{0} {1} 0", j, above);
      break;
  }
  return fmt::format("define {}: {}\n", state_name(wheel, state), body);
}

std::string mode_text(ContactMode mode) {
  return state_name(Wheel::rear, mode.rear) + " and " + state_name(Wheel::front, mode.front);
}

/// A claim's truth value in the syntax of statements; nothing where that has no word for it.
std::optional<std::string> formula_text(const Expression& e, bool inner = false) {
  if (e->operation == Operation::truth) return e->truth ? "0 = 0" : "false";
  if (e->operation == Operation::compare) {
    for (const Expression& operand : e->operands) {
      const std::string text = to_string(operand);
      for (const char* function : {"abs(", "sign(", "min(", "max("}) {
        if (text.find(function) != std::string::npos) return std::nullopt;
      }
    }
    return to_string(e);
  }
  const bool both = e->operation == Operation::logical_and;
  if (!both && e->operation != Operation::logical_or) return std::nullopt;
  const auto left = formula_text(e->operands[0], e->operands[0]->operation != e->operation);
  const auto right = formula_text(e->operands[1], true);
  if (!left || !right) return std::nullopt;
  const std::string text = *left + (both ? " and " : " or ") + *right;
  return inner ? "{" + text + "}" : text;
}

/// The parts of statements about a setting.
class SettingWriter {
 public:
  SettingWriter(const Setting& setting, Reading reading) : setting_(setting), reading_(reading) {}

 protected:
  std::string formula(const Expression& e) {
    const auto text = formula_text(e);
    complete_ = complete_ && text;
    return text.value_or("");
  }

  /// `let` lines for every definition that the expressions use, each after those that it uses itself; lines that need
  /// an unknown of the motion do not occur, as definitions are over parameters and the force.
  std::string definitions(const std::vector<Expression>& uses) {
    std::string text;
    for (const Expression& use : uses) {
      if (!use) continue;
      for (const std::string& symbol : symbols(use)) {
        const auto found = std::find_if(setting_.definitions.begin(), setting_.definitions.end(),
                                        [&](const Definition& d) { return d.symbol == symbol; });
        if (found == setting_.definitions.end() || !defined_.insert(symbol).second) continue;
        const Expression& value = reading_ == Reading::repaired && found->repaired ? found->repaired : found->printed;
        text += definitions({value});
        text += fmt::format("let {} = {}\n", symbol, to_string(value));
      }
    }
    return text;
  }

  /// The first lines: the variables, their domain, and what the expressions use.
  std::string opening(const std::string& theorem, const std::string& comment, const std::vector<Expression>& uses,
                      bool scene = true) {
    defined_.clear();
    std::vector<std::string> names;
    std::string domain;
    for (const Parameter& parameter : setting_.parameters) {
      names.push_back(parameter.symbol);
      domain += formula(parameter.domain) + " and ";
    }
    std::string text = fmt::format("slipproof-statement 1\ntheorem {}\n# {}\n", theorem, comment);
    text += fmt::format("real {} {}\n", fmt::join(names, " "), setting_.force.symbol);
    text += fmt::format("assume domain: {}{}\n", domain, formula(setting_.force.domain));
    std::vector<Expression> all = uses;
    if (scene) {
      for (const auto& [symbol, value] : setting_.scene) all.push_back(value);
    }
    text += definitions(all);
    if (!scene) return text;
    if (!has_pitch_inertia() && std::find(names.begin(), names.end(), "J") == names.end()) text += "let J = 0\n";
    for (const auto& [symbol, value] : setting_.scene) {
      const auto definition = std::find_if(setting_.definitions.begin(), setting_.definitions.end(),
                                           [&](const Definition& d) { return d.symbol == symbol; });
      if (defined_.contains(symbol)) {  // the paper may use a symbol of the scene for the same, but for nothing else
        complete_ = complete_ && same(definition->printed, value);
      } else if (to_string(value) != symbol) {
        text += fmt::format("let {} = {}\n", symbol, to_string(value));
      }
    }
    return text;
  }

  std::string assumption(const char* label, const Expression& e) {
    if (!e || (e->operation == Operation::truth && e->truth)) return "";
    return fmt::format("assume {}: {}\n", label, formula(e));
  }

  /// Without it, only motions with both wheels on the road are modelled, and there it drops out.
  bool has_pitch_inertia() const { return setting_.scene.contains("J"); }

  /// The unknowns of the model, and what its equations and contact states are called.
  std::string motion_terms() const {
    return fmt::format("real {}\n", fmt::join(kUnknowns, " ")) + mechanics(setting_.force_kind);
  }
  std::string mode_definition(ContactMode mode) {
    complete_ = complete_ && (mode.on_road() || has_pitch_inertia());
    return state_definition(Wheel::rear, mode.rear, setting_.strict) +
           state_definition(Wheel::front, mode.front, setting_.strict);
  }

  const Setting& setting_;
  Reading reading_;
  std::set<std::string> defined_;
  bool complete_ = true;
};

class Writer : SettingWriter {
 public:
  Writer(const ClaimsFile& claims, const Claim& claim, Reading reading)
      : SettingWriter(claims.settings[claim.setting], claim.repaired ? reading : Reading::printed),
        claims_(claims),
        claim_(claim),
        body_(claim.body(reading)) {
    name_ = claim.id + (reading == Reading::repaired && claim.repaired ? ".repaired" : "");
  }

  std::vector<NamedStatement> write() {
    switch (claim_.kind) {
      case ClaimKind::interval: {
        const ContactMode mode = body_.modes.front();
        implied(".only-then", {}, mode, body_.forces);
        exists(".always", mode);
        break;
      }
      case ClaimKind::impossible:
        for (std::size_t i = 0; i < body_.modes.size(); ++i) {
          implied(body_.modes.size() == 1 ? "" : fmt::format(".{}", i + 1), body_.forces, body_.modes[i],
                  make_truth(false));
        }
        break;
      case ClaimKind::formula:
        complete_ = body_.modes.size() < 2;
        implied("", body_.forces, body_.modes.empty() ? std::nullopt : std::optional(body_.modes.front()), body_.holds);
        break;
      case ClaimKind::cover: {
        Expression regions;
        for (const std::size_t other : body_.claims) {
          const Expression& region = claims_.claims[other].body(reading_).region;
          regions = regions ? make(Operation::logical_or, {regions, region}) : region;
        }
        implied("", {}, std::nullopt, regions);
        break;
      }
      case ClaimKind::motions:
        for (std::size_t i = 0; i < body_.modes.size(); ++i) exists(fmt::format(".{}", i + 1), body_.modes[i]);
        complete();
        break;
      case ClaimKind::unique:
      case ClaimKind::equivalence:
      case ClaimKind::limit:
      case ClaimKind::exists:
      case ClaimKind::consequence:
      case ClaimKind::system:
        break;
    }
    return complete_ ? std::move(statements_) : std::vector<NamedStatement>{};
  }

 private:
  std::string head(const std::string& suffix, const std::vector<Expression>& uses) {
    return opening(name_ + suffix, fmt::format("{} of {}, {} reading", claim_.id, claims_.paper.source, name(reading_)),
                   uses);
  }

  void implied(const std::string& suffix, const Expression& forces, std::optional<ContactMode> mode,
               const Expression& shown) {
    std::string text =
        head(suffix, {body_.region, forces, shown}) + assumption("region", body_.region) + assumption("force", forces);
    if (mode) {
      text += motion_terms() + mode_definition(*mode);
      text += fmt::format("assume motion: {} and {}\n", kDynamics, mode_text(*mode));
    }
    text += fmt::format("show {}\n", formula(shown));
    statements_.push_back({name_ + suffix, std::move(text)});
  }

  void exists(const std::string& suffix, ContactMode mode) {
    std::string text = head(suffix, {body_.region, body_.forces}) + assumption("region", body_.region) +
                       assumption("force", body_.forces);
    text += fmt::format("exists {}\n", fmt::join(kUnknowns, " ")) + mechanics(setting_.force_kind);
    text += mode_definition(mode) + fmt::format("show {} and {}\n", kDynamics, mode_text(mode));
    statements_.push_back({name_ + suffix, std::move(text)});
  }

  /// Every motion of all sixteen modes, boundaries included, is in one of the claim's modes.
  void complete() {
    std::string text = head(".complete", {body_.region, body_.forces}) + assumption("region", body_.region) +
                       assumption("force", body_.forces);
    text += motion_terms();
    constexpr std::array kStates{ContactState::stick, ContactState::slip_forward, ContactState::slip_backward,
                                 ContactState::lift};
    std::string assumptions = fmt::format("assume motion: {}\n", kDynamics);
    for (const Wheel wheel : {Wheel::rear, Wheel::front}) {
      std::vector<std::string> names;
      for (const ContactState state : kStates) {
        text += state_definition(wheel, state, false);
        names.push_back(state_name(wheel, state));
      }
      assumptions += fmt::format("assume {}: {}\n", wheel == Wheel::rear ? "rear" : "front", fmt::join(names, " or "));
    }
    std::vector<std::string> modes;
    for (const ContactMode mode : body_.modes) modes.push_back("{" + mode_text(mode) + "}");
    text += assumptions + fmt::format("show {}\n", fmt::join(modes, " or "));
    statements_.push_back({name_ + ".complete", std::move(text)});
  }

  const ClaimsFile& claims_;
  const Claim& claim_;
  const ClaimBody& body_;
  std::string name_;
  std::vector<NamedStatement> statements_;
};

class ImplicationWriter : SettingWriter {
 public:
  ImplicationWriter(const ClaimsFile& claims, const Implication& implication)
      : SettingWriter(claims.settings[implication.setting], Reading::printed), implication_(implication) {}

  std::optional<std::string> write() {
    const bool moving = implication_.on_road || implication_.mode;
    std::vector<Expression> uses = implication_.given;
    uses.push_back(implication_.shown);
    std::string text = opening(implication_.name, setting_.id, uses, moving);
    if (moving) {
      text += motion_terms();
      if (implication_.mode) text += mode_definition(*implication_.mode);
      text += fmt::format("assume motion: {} and {}\n", kDynamics,
                          implication_.mode ? mode_text(*implication_.mode) : "gap2 = 0 and gap3 = 0");
    } else {
      text += free_unknowns(uses);
    }
    for (std::size_t i = 0; i < implication_.given.size(); ++i) {
      text += assumption(fmt::format("given{}", i + 1).c_str(), implication_.given[i]);
    }
    text += fmt::format("show {}\n", formula(implication_.shown));
    return complete_ ? std::optional(std::move(text)) : std::nullopt;
  }

 private:
  /// The quantities and unknowns that occur, as any numbers; where they hide symbols of the setting, they are those.
  std::string free_unknowns(const std::vector<Expression>& uses) const {
    std::set<std::string> names;
    const auto known = [&](const std::string& symbol) {
      const auto is = [&](const auto& entry) { return entry.symbol == symbol; };
      return symbol == setting_.force.symbol ||
             std::any_of(setting_.parameters.begin(), setting_.parameters.end(), is) ||
             std::any_of(setting_.definitions.begin(), setting_.definitions.end(), is);
    };
    for (const Expression& use : uses) {
      for (const std::string& symbol : symbols(use)) {
        if (!known(symbol)) names.insert(symbol);
      }
    }
    return names.empty() ? "" : fmt::format("real {}\n", fmt::join(names, " "));
  }

  const Implication& implication_;
};

}  // namespace

std::optional<std::string> implication_statement(const ClaimsFile& claims, const Implication& implication) {
  return ImplicationWriter(claims, implication).write();
}

std::vector<NamedStatement> claim_statements(const ClaimsFile& claims, const Claim& claim, Reading reading) {
  return Writer(claims, claim, reading).write();
}

}  // namespace slipproof

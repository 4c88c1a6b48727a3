#include "claims/canonical/canonical_claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "claims/statements/formulas.hpp"

namespace slipproof {

namespace {

std::string canonical(const Expression& e) {
  return to_string(with_quotients(e ? e : make_truth(true)));
}

class MechanismLines {
 public:
  explicit MechanismLines(const Setting& setting) : setting_(setting), mechanism_(*setting.mechanism) {}

  std::string text() {
    for (const MechanismParameter& p : mechanism_.parameters)
      line("parameter {} : {}", p.symbol, canonical(p.domain.expression));
    for (const MechanismAngle& a : mechanism_.angles)
      line("angle {} {} : {}", a.cosine, a.sine, canonical(a.domain.expression));
    for (const MechanismCondition& a : mechanism_.assume) line("assume : {}", canonical(a.condition.expression));
    for (const MechanismDefinition& d : mechanism_.definitions)
      line("let {} = {}", d.symbol, canonical(d.expression.expression));
    if (mechanism_.load) line("load {} : {}", mechanism_.load->symbol, canonical(load_domain()));
    unknowns();
    for (const MechanismEquation& e : mechanism_.equations)
      line("equation {} : {} = {}", e.name, canonical(e.left.expression), canonical(e.right.expression));
    for (std::size_t i = 0; i < mechanism_.contacts.size(); ++i) contact(mechanism_.contacts[i], setting_.starts[i]);
    for (std::size_t i = 0; i < mechanism_.friction.size(); ++i)
      friction(mechanism_.friction[i], setting_.starts[mechanism_.contacts.size() + i]);
    for (const MechanismLink& l : mechanism_.links)
      line("link {} {} : {}", symbol(l.force), l.name, canonical(l.zero.expression));
    return std::move(text_);
  }

 private:
  template <class... Parts>
  void line(fmt::format_string<Parts...> format, Parts&&... parts) {
    text_ += fmt::format(format, std::forward<Parts>(parts)...) + '\n';
  }
  const std::string& symbol(std::size_t unknown) const { return mechanism_.unknowns[unknown].symbol; }

  Expression load_domain() const {
    Expression all = make_truth(true);
    for (const PlacedExpression& part : mechanism_.load->domain) {
      const bool first = all->operation == Operation::truth;
      all = first ? part.expression : make(Operation::logical_and, {all, part.expression});
    }
    return all;
  }

  void unknowns() {
    text_ += "accelerations";
    for (std::size_t i = 0; i < mechanism_.accelerations; ++i) text_ += ' ' + symbol(i);
    text_ += "\nforces";
    for (std::size_t i = 0; i < mechanism_.forces; ++i) text_ += ' ' + symbol(mechanism_.accelerations + i);
    text_ += mechanism_.by_virtual_work ? "\nmotion\n" : "\nequations\n";
  }

  void contact(const MechanismContact& c, ElementKind::Start start) {
    text_ += fmt::format("contact {}{}", name(start), c.bilateral ? " bilateral" : "");
    if (!c.lift_needs.empty()) text_ += " needs";
    for (const std::size_t parameter : c.lift_needs) text_ += ' ' + mechanism_.parameters[parameter].symbol;
    line(" : {}\ngap {} = {}", c.name, c.gap_name, canonical(c.gap.expression));
    if (c.slip) line("slip {} = {}", c.slip_name, canonical(c.slip.expression));
    line("normal {}", symbol(c.normal));
    if (c.frictionless()) return;
    line("tangent {}", symbol(*c.tangent));
    limits(c.static_friction, c.kinetic_friction);
  }

  void friction(const MechanismFriction& f, ElementKind::Start start) {
    line("friction {}{} : {}", name(start), f.contact ? fmt::format(" at {}", *f.contact) : "", f.name);
    line("slip {} = {}", f.slip_name, canonical(f.slip.expression));
    line("tangent {}", symbol(f.force));
    limits(f.static_limit, f.kinetic_limit);
  }

  void limits(const PlacedExpression& at_rest, const PlacedExpression& sliding) {
    line("static = {}", canonical(at_rest.expression));
    line("kinetic = {}", canonical(sliding.expression));
  }

  const Setting& setting_;
  const Mechanism& mechanism_;
  std::string text_;
};

/// The paper's definitions, each after those that it uses.
std::string definitions(const Setting& setting, Reading reading) {
  std::string text;
  std::set<std::string> done;
  const auto add = [&](const auto& self, const Definition& definition) -> void {
    if (!done.insert(definition.symbol).second) return;
    for (const std::string& used : symbols(definition.value(reading))) {
      for (const Definition& other : setting.definitions) {
        if (other.symbol == used) self(self, other);
      }
    }
    text += fmt::format("let {} = {}\n", definition.symbol, canonical(definition.value(reading)));
  };
  for (const Definition& definition : setting.definitions) add(add, definition);
  return text;
}

std::string canonical_setting(std::size_t number, const Setting& setting, Reading reading) {
  std::string text = fmt::format("# {}, {} reading\nsetting {} {}\n", in_ascii(setting.id), name(reading), number,
                                 setting.strict ? "strict" : "closed");
  for (const FreeParameter& parameter : setting.parameters) {
    if (!parameter.angle) text += fmt::format("parameter {} : {}\n", parameter.symbol, canonical(parameter.domain));
  }
  for (const FreeAngle& angle : setting.angles) {
    text += fmt::format("angle {} {} : {}\n", angle.cosine, angle.sine,
                        canonical(setting.parameters[angle.parameter].domain));
  }
  text += fmt::format("force{}{} : {}\n", setting.force.symbol.empty() ? "" : " ", setting.force.symbol,
                      canonical(setting.force.domain));
  text += definitions(setting, reading);
  for (const auto& [symbol, value] : setting.scene) text += fmt::format("scene {} = {}\n", symbol, canonical(value));
  return text + fmt::format("# {}\nmechanism\n", in_ascii(setting.mechanism_name)) + MechanismLines(setting).text();
}

/// Of a consequence or a system: what the equations follow from, and the equations.
std::string about_equations(const ClaimsFile& file, const ClaimBody& body, Reading reading) {
  std::string text = body.from_model() ? "of the model\n" : "";
  if (body.from_model() && body.mode()) text += "mode " + name(*body.mode()) + '\n';
  const auto put = [&](const char* word, const Equations& equations) {
    for (const Expression& equation : equations) text += fmt::format("{} : {}\n", word, canonical(equation));
  };
  const char* from = body.kind->name() == "system" ? "from" : "given";
  for (const std::size_t other : body.given) put("given", file.claims[other].body(reading).equations);
  for (const std::size_t other : body.claims) put(from, file.claims[other].body(reading).equations);
  put(from, body.assume);
  put("follows", body.equations);
  return text;
}

/// `from` is not part of what is claimed: proofs use it.
std::string limit(const ClaimBody& body) {
  std::string text = "holds : " + canonical(body.holds) + '\n';
  const auto from = body.own.find("from");
  if (from != body.own.end()) text += "from = " + canonical(from->second) + '\n';
  return text;
}

std::string reference(std::string_view word, const ClaimBody& its) {
  return fmt::format("{0} region : {1}\n{0} forces : {2}\n", word, canonical(its.region), canonical(its.forces));
}

std::string modes(const ClaimBody& body) {
  std::string text;
  for (const MechanismMode& mode : body.modes) text += "mode " + name(mode) + '\n';
  return text;
}

std::string unique(const ClaimsFile& file, const ClaimBody& body, Reading reading) {
  std::string text;
  for (const std::size_t other : body.claims) {
    const ClaimBody& its = file.claims[other].body(reading);
    text += "one mode " + name(its.modes.front()) + '\n' + reference("one", its);
  }
  for (const std::size_t other : body.except) text += reference("except", file.claims[other].body(reading));
  return text + modes(body);
}

/// What claims of the other kinds are about.
std::string subjects(const ClaimsFile& file, const ClaimBody& body, Reading reading) {
  std::string text = modes(body);
  const std::string_view kind = body.kind->name();
  if (kind == "formula" || kind == "equivalence") text += "holds : " + canonical(body.holds) + '\n';
  for (const std::size_t other : body.claims) text += reference("one", file.claims[other].body(reading));
  return text;
}

std::string canonical_claim(const ClaimsFile& file, const Claim& claim, Reading reading, std::size_t setting) {
  const ClaimBody& body = claim.body(reading);
  const std::string_view kind = body.kind->name();
  const auto said = [&] {
    if (kind == "consequence" || kind == "system") return about_equations(file, body, reading);
    if (kind == "unique") return unique(file, body, reading);
    return kind == "limit" ? limit(body) : subjects(file, body, reading);
  };
  return fmt::format("claim {}{} in {}\n{}{}\n", claim.id, reading == Reading::repaired ? ".repaired" : "", setting,
                     kind, kind == "limit" ? ' ' + body.parameter : "") +
         said() + fmt::format("region : {}\nforces : {}\n", canonical(body.region), canonical(body.forces));
}

}  // namespace

std::string canonical_claims(const ClaimsFile& file) {
  std::map<std::pair<std::size_t, Reading>, std::size_t> numbers;
  std::string settings, claims;
  for (const Claim& claim : file.claims) {
    if (file.settings[claim.setting].mechanism->dimension == 3) continue;
    for (const Reading reading : all_readings) {
      if (reading == Reading::repaired && !claim.repaired) continue;
      const auto [number, is_new] = numbers.try_emplace({claim.setting, reading}, numbers.size());
      if (is_new) settings += canonical_setting(number->second, file.settings[claim.setting], reading);
      claims += canonical_claim(file, claim, reading, number->second);
    }
  }
  return claims.empty() ? claims : "slipproof-claims 1\n" + settings + claims;
}

}  // namespace slipproof

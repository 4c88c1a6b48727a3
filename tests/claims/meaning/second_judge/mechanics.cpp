#include "claims/meaning/second_judge/mechanics.hpp"

namespace slipproof::meaning {

namespace {

using Start = ElementKind::Start;

std::string sum_text(const Sum& sum) {
  std::string result;
  for (const auto& [coefficient, what] : sum) {
    result += (result.empty() ? "" : " + ") + text(coefficient) + (what.empty() ? "" : "*" + what);
  }
  return result.empty() ? "0" : result;
}

std::string key_and_text(const std::string& key, const std::string& value) {
  return key + " = \"" + value + "\"\n";
}

std::string list_of(const std::vector<std::string>& all) {
  std::string result;
  for (const std::string& name : all) result += (result.empty() ? "\"" : ", \"") + name + "\"";
  return "[" + result + "]";
}

std::string element_text(const Mechanics::Element& e) {
  std::string result = (e.is_contact() ? "[[contact]]\n" : "[[friction]]\n") + key_and_text("name", e.name);
  if (e.is_contact()) result += key_and_text("gap", sum_text(e.gap));
  if (!e.slip.empty()) result += key_and_text("slip", sum_text(e.slip));
  if (e.static_friction) {
    result +=
        "friction = { static = \"" + text(e.static_friction) + "\", kinetic = \"" + text(e.kinetic_friction) + "\" }\n";
  }
  if (!e.is_contact()) {
    result +=
        "limit = { static = \"" + sum_text(e.static_limit) + "\", kinetic = \"" + sum_text(e.kinetic_limit) + "\" }\n";
  }
  if (e.start != Start::rest) result += key_and_text("state", std::string(name(e.start)));
  if (e.bilateral) result += "bilateral = true\n";
  if (e.lift_needs_J) result += "lift_needs = [\"J\"]\n";
  return result;
}

const Tree* coefficient_of(const Sum& sum, const std::string& what) {
  for (const auto& [coefficient, name] : sum) {
    if (name == what) return &coefficient;
  }
  return nullptr;
}

}  // namespace

std::string Mechanics::text() const {
  std::string result = "schema = \"slipproof/mechanism/1\"\nname = \"random\"\nreciprocal = false\n[parameters]\n";
  for (const Parameter& parameter : parameters) {
    result += parameter.symbol + " = { domain = \"" + meaning::text(parameter.domain) + "\"" +
              (parameter.symbol == "J" ? ", optional = true }\n" : " }\n");
  }
  if (assume) result += "[assume]\n" + key_and_text("some", meaning::text(assume));
  if (!definitions.empty()) result += "[definitions]\n";
  for (const auto& [symbol, value] : definitions) result += key_and_text(symbol, meaning::text(value));
  if (angle) result += "[angles]\ntheta = { cos = \"c\", sin = \"s\" }\n";
  if (!load.empty())
    result += "[load]\n" + key_and_text("symbol", load) +
              (load_domain ? key_and_text("domain", meaning::text(load_domain)) : "");
  result += "[unknowns]\naccelerations = " + list_of(accelerations) + "\nforces = " + list_of(forces) + "\n";
  result += by_virtual_work ? "[motion]\n" : "[equations]\n";
  for (std::size_t i = 0; i < equations.size(); ++i) {
    const std::string key = by_virtual_work ? accelerations[i] : "eq" + std::to_string(i);
    result += key_and_text(key, sum_text(equations[i].left) + " = " + sum_text(equations[i].right));
  }
  for (const Element& element : elements) result += element_text(element);
  for (const Link& link : links)
    result += "[[link]]\n" + key_and_text("name", link.name) + key_and_text("zero", sum_text(link.zero));
  return result;
}

std::vector<std::string> Mechanics::unknowns() const {
  std::vector<std::string> result = accelerations;
  result.insert(result.end(), forces.begin(), forces.end());
  for (const Element& element : elements) {
    if (element.is_contact()) result.push_back(element.normal());
    if (!element.is_contact() || element.static_friction) result.push_back(element.tangent());
  }
  for (const Link& link : links) result.push_back(link.force());
  return result;
}

std::vector<Tree*> Mechanics::coefficients() {
  std::vector<Tree*> result;
  const auto add = [&](Sum& sum) {
    for (auto& [coefficient, what] : sum) result.push_back(&coefficient);
  };
  for (Equation& equation : equations) {
    add(equation.left);
    add(equation.right);
  }
  for (Element& element : elements) {
    for (Sum* sum : {&element.gap, &element.slip, &element.static_limit, &element.kinetic_limit}) add(*sum);
    if (element.static_friction) result.insert(result.end(), {&element.static_friction, &element.kinetic_friction});
  }
  for (Link& link : links) add(link.zero);
  return result;
}

std::vector<Tree> Mechanics::coefficients() const {
  Mechanics copy = *this;
  std::vector<Tree> result;
  for (const Tree* tree : copy.coefficients()) result.push_back(*tree);
  return result;
}

Sum Mechanics::contact_forces(std::size_t equation) const {
  Sum result;
  if (!by_virtual_work) return result;
  const auto add = [&](const Sum& motion, const std::string& force) {
    if (const Tree* coefficient = coefficient_of(motion, accelerations[equation]))
      result.emplace_back(*coefficient, force);
  };
  for (const Element& element : elements) {
    if (element.is_contact()) add(element.gap, element.normal());
    if (!element.is_contact() || element.static_friction) add(element.slip, element.tangent());
  }
  for (const Link& link : links) add(link.zero, link.force());
  return result;
}

std::vector<ElementState> states_of(const Mechanics::Element& e) {
  using enum ElementState;
  const bool slides = e.start == Start::slides_forward || e.start == Start::slides_backward;
  const ElementState sliding = e.start == Start::slides_forward ? slip_forward : slip_backward;
  if (!e.is_contact()) return slides ? std::vector{sliding} : std::vector{stick, slip_forward, slip_backward};
  if (e.start == Start::open) return {lift};
  if (!e.static_friction) return e.bilateral ? std::vector{touch} : std::vector{touch, lift};
  if (e.bilateral) {
    if (!slides) return {stick, slip_forward, slip_backward, pulled_stick, pulled_slip_forward, pulled_slip_backward};
    return {sliding, sliding == slip_forward ? pulled_slip_forward : pulled_slip_backward};
  }
  if (slides) return {sliding, lift};
  return {stick, slip_forward, slip_backward, lift};
}

std::string text(const Mode& mode) {
  std::string result;
  for (const ElementState state : mode) result += (result.empty() ? "" : "/") + std::string(name(state));
  return result;
}

}  // namespace slipproof::meaning

// Random mechanisms: small ones, which divide by parameters, with all sorts of elements.
#include <algorithm>

#include "claims/meaning/random/random_claims.hpp"

namespace slipproof::meaning {

namespace {

using Element = Mechanics::Element;

const Tree unity = number(1), doubled = number(2), m = symbol("m"), p = symbol("p"), mu = symbol("mu"), w = symbol("w");

class RandomMechanics {
 public:
  explicit RandomMechanics(Dice& dice) : dice_(dice) {}

  Mechanics mechanics(bool loaded) {
    result_ = {};
    if (loaded) result_.load = dice_.one_in(2) ? "L" : "F";
    if (loaded && dice_.one_in(3)) {
      result_.load_domain =
          dice_.of<Tree>({compare(load(), ">=", number(0)), compare(load(), "<=", number(5)), compare(load(), ">", p)});
    }
    result_.angle = dice_.one_in(3);
    result_.parameters = {{"m", compare(m, ">", number(0))},
                          {"p", dice_.of<Tree>({truth(true), truth(true), compare(p, ">", number(0))})},
                          {"mu", compare(mu, ">=", number(0))},
                          {"J", dice_.of<Tree>({truth(true), compare(symbol("J"), ">", number(0))})}};
    if (dice_.one_in(4))
      result_.assume =
          dice_.of<Tree>({compare(p, "!=", m), compare(over(unity, p), "<", number(3)), compare(w, "<=", doubled)});
    result_.definitions = {{"v", dice_.of<Tree>({plus(p, m), over(m, p), minus(unity, p)})},
                           {"w", dice_.of<Tree>({over(unity, minus(p, doubled)), over(symbol("v"), p), minus(p, m),
                                                 over(mu, minus(p, unity))})}};
    const std::vector<std::string> names = {"ax", "ay", "phi"};
    result_.accelerations.assign(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(dice_.below(3) + 1));
    result_.by_virtual_work = !dice_.one_in(4);
    for (std::size_t i = 0; i < result_.accelerations.size(); ++i) equation(i);
    const std::size_t contacts = dice_.below(3);
    for (std::size_t i = 0; i < contacts; ++i) contact(i == 0 ? "u" : "z");
    if (contacts == 0 || dice_.one_in(4)) friction();
    if (dice_.one_in(6)) result_.links.push_back({"j", motion()});
    if (!result_.by_virtual_work) own_equations();
    return result_;
  }

 private:
  Tree load() const { return symbol(result_.load); }

  /// Of a sign that is not known, and perhaps without a value.
  Tree coefficient() {
    if (result_.angle && dice_.one_in(4)) return symbol(dice_.of<std::string>({"c", "s"}));
    switch (dice_.below(12)) {
      case 0:
        return over(unity, p);
      case 1:
        return over(m, minus(p, unity));
      case 2:
        return w;
      case 3:
        return plus(unity, minus(w, w));
      case 4:
        return power(p, -1);
      case 5:
        return p;
      case 6:
        return times(p, m);
      default:
        return number(dice_.of<Rational>({1, 1, -1, 2, Rational(1, 2)}));
    }
  }

  Tree mass() { return dice_.of<Tree>({m, m, unity, doubled, plus(m, symbol("J")), over(m, power(p, 2))}); }

  /// Of accelerations.
  Sum motion() {
    Sum sum;
    const std::size_t first = dice_.below(result_.accelerations.size());
    sum.emplace_back(coefficient(), result_.accelerations[first]);
    const std::size_t other = dice_.below(result_.accelerations.size());
    if (other != first && dice_.one_in(2)) sum.emplace_back(coefficient(), result_.accelerations[other]);
    if (!result_.load.empty() && dice_.one_in(6)) sum.emplace_back(coefficient(), result_.load);
    return sum;
  }

  void equation(std::size_t i) {
    Mechanics::Equation equation;
    equation.left.emplace_back(mass(), result_.accelerations[i]);
    equation.right.emplace_back(times(number(dice_.of<Rational>({0, -10, -1, 3})), m), "");
    if (!result_.load.empty() && (i == 0 || dice_.one_in(2))) equation.right.emplace_back(coefficient(), result_.load);
    result_.equations.push_back(std::move(equation));
  }

  void contact(const std::string& name) {
    Element element;
    element.name = name;
    element.gap = motion();
    element.bilateral = dice_.one_in(6);
    element.lift_needs_J = !element.bilateral && dice_.one_in(5);
    if (dice_.one_in(6)) {
      if (dice_.one_in(2)) element.slip = motion();
    } else {
      element.slip = motion();
      element.static_friction = dice_.of<Tree>({mu, mu, number(Rational(1, 2)), over(mu, p), minus(plus(mu, w), w)});
      element.kinetic_friction = dice_.one_in(3) ? over(element.static_friction, doubled) : element.static_friction;
      using enum ElementKind::Start;
      if (dice_.one_in(6)) element.start = dice_.of<ElementKind::Start>({slides_forward, slides_backward});
    }
    if (!element.bilateral && element.start == ElementKind::Start::rest && dice_.one_in(12)) {
      element.start = ElementKind::Start::open;
    }
    result_.elements.push_back(std::move(element));
  }

  void friction() {
    Element element;
    element.name = "br";
    element.slip = motion();
    element.static_limit.emplace_back(dice_.of<Tree>({unity, m, over(unity, p), plus(w, unity)}), "");
    if (!result_.load.empty() && dice_.one_in(3)) element.static_limit.emplace_back(coefficient(), result_.load);
    const bool beside = !result_.elements.empty() && dice_.one_in(4);
    if (beside) element.static_limit.emplace_back(mu, result_.elements.front().normal());
    element.kinetic_limit = dice_.one_in(3) ? Sum{{over(unity, m), ""}} : element.static_limit;
    if (dice_.one_in(6)) element.start = ElementKind::Start::slides_forward;
    result_.elements.push_back(std::move(element));
  }

  /// With the forces written out, unity of them with another sign, perhaps; or with a force of no element, and what
  /// ties it.
  void own_equations() {
    Mechanics copy = result_;
    copy.by_virtual_work = true;
    for (std::size_t i = 0; i < result_.equations.size(); ++i) {
      for (auto& [coefficient, force] : copy.contact_forces(i)) {
        result_.equations[i].right.emplace_back(dice_.one_in(8) ? minus(number(0), coefficient) : coefficient, force);
      }
    }
    if (!dice_.one_in(2)) return;
    result_.forces = {"H"};
    result_.equations.front().right.emplace_back(coefficient(), "H");
    if (dice_.one_in(4)) {  // it stays undetermined
      result_.equations.push_back(result_.equations.front());
      return;
    }
    Sum right;
    if (!result_.load.empty() && dice_.one_in(2)) {
      right.emplace_back(coefficient(), result_.load);
    } else {
      right.emplace_back(coefficient(), "");
    }
    result_.equations.push_back({{{unity, dice_.one_in(2) ? "H" : result_.accelerations.front()}}, std::move(right)});
  }

  Dice& dice_;
  Mechanics result_;
};

}  // namespace

void add_mechanics(Dice& dice, Setting& setting) {
  const bool loaded = !setting.force.empty();
  setting.mechanics = RandomMechanics(dice).mechanics(loaded);
  const Tree b = symbol("b"), h = symbol("h"), f = symbol("f"), k = symbol("k");
  if (dice.one_in(4)) setting.angle = dice.of<Tree>({truth(true), compare(symbol("cb"), ">", number(0))});
  setting.scene["m"] = dice.of<Tree>({b, unity, times(b, doubled), over(b, f)});
  setting.scene["p"] = dice.of<Tree>({k, k, k, h, minus(k, unity), over(unity, k), plus(unity, minus(h, h))});
  setting.scene["mu"] = dice.of<Tree>({f, f, number(Rational(1, 3)), number(0)});
  const auto& elements = setting.mechanics->elements;
  const bool needs_J = std::any_of(elements.begin(), elements.end(), [](const Element& element) {
    return element.start == ElementKind::Start::open && element.lift_needs_J;
  });
  if (needs_J || !dice.one_in(3)) setting.scene["J"] = dice.of<Tree>({unity, b, minus(number(3), k)});
  if (setting.mechanics->angle) {
    const Tree square = power(k, 2), below = plus(unity, square);
    setting.scene["c"] = setting.angle ? symbol("cb") : over(minus(unity, square), below);
    setting.scene["s"] = setting.angle ? symbol("sb") : over(times(doubled, k), below);
    if (!setting.angle && dice.one_in(3)) {
      setting.scene["c"] = number(Rational(3, 5));
      setting.scene["s"] = number(Rational(dice.one_in(8) ? 1 : 4, 5));  // perhaps no angle
    }
  }
  if (!loaded) return;
  const Tree x = symbol(setting.force);
  setting.scene[setting.mechanics->load] =
      dice.of<Tree>({x, x, x, times(k, x), plus(times(doubled, x), k), over(x, k), minus(unity, x)});
}

}  // namespace slipproof::meaning

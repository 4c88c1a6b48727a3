#include "claims/meaning/random/random_claims.hpp"

#include "claims/meaning/random/random_kinds.hpp"

namespace slipproof::meaning {

namespace {

const Tree k = symbol("k"), zero = number(0), one = number(1);

}  // namespace

Case RandomClaims::next(const std::string& kind) {
  for (;;) {
    Case result;
    result.file.setting = setting();
    Values values = bicycle(result.file.setting);
    try {
      const auto made_for = World::make(result.file.setting, values);
      if (!made_for) continue;
      RandomKinds kinds(dice_, *made_for, result.file);
      kinds.add(kind);
      if (domain_ == Domain::of_parameters && dice_.one_in(2)) kinds.settle(result.file.claims.back());
    } catch (const OutOfReach&) {
      continue;
    }
    result.bicycles.push_back(values);
    values[dice_.of<std::string>({"k", "k", "b", "h", "f"})] = bicycle(result.file.setting)["k"];
    result.bicycles.push_back(values);
    return result;
  }
}

Setting RandomClaims::setting() {
  Setting result;
  result.strict = !dice_.one_in(2);
  result.external = dice_.one_in(3);
  result.force = dice_.one_in(3) ? "F" : "P";
  const bool loaded = !mechanisms_ || !dice_.one_in(6);
  if (!loaded) result.force.clear();
  const Tree x = symbol(loaded ? result.force : "k");
  result.parameters = {
      {"b", compare(symbol("b"), ">", zero)},
      {"h", dice_.of<Tree>({truth(true), compare(symbol("h"), ">", number(-1))})},
      {"f", dice_.of<Tree>({compare(symbol("f"), ">=", zero), compare(zero, "<", symbol("f"))})},
      {"k", dice_.of<Tree>({truth(true), truth(true), compare(k, "<=", number(2)), compare(k, "!=", one),
                            chain({zero, k, number(3)}, {"<", "<"}), compare(k, ">", minus(zero, one)),
                            compare(over(one, minus(k, number(2))), "<", one)})}};
  if (domain_ == Domain::of_parameters && dice_.one_in(4)) {  // with an end that stands alone
    result.parameters.back().domain =
        make(Op::disjunction, {compare(k, "<=", one), compare(k, "=", number(dice_.of<int>({2, 3})))});
  }
  const Tree positive = compare(x, ">", zero);
  result.force_domain = loaded ? positive : truth(true);
  if (loaded && domain_ == Domain::of_parameters) {
    result.force_domain = domain_of_parameters(x);
  } else if (loaded && dice_.one_in(3)) {
    result.force_domain = dice_.of<Tree>(
        {truth(true), compare(x, ">=", zero), compare(x, ">=", k), chain({k, x, number(3)}, {"<=", "<"}),
         make(Op::disjunction, {positive, compare(x, "<", k)}), compare(over(x, k), ">", number(-1)),
         compare(times(k, x), "<=", one), make(Op::disjunction, {positive, compare(over(one, k), ">", zero)})});
  }
  result.definitions = {
      {"d1", dice_.of<Tree>({plus(symbol("b"), symbol("h")), over(symbol("b"), symbol("f")),
                             over(one, minus(symbol("b"), symbol("h"))), times(number(2), symbol("f"))})},
      {"d2", dice_.of<Tree>({over(symbol("d1"), k), minus(k, symbol("d1")), over(k, minus(k, one)), times(k, k),
                             make(Op::maximum, {k, symbol("b")}), power(k, -1)})},
      {"e1", dice_.of<Tree>({plus(x, k), over(x, k), times(symbol("d1"), x), minus(one, x)})}};
  if (dice_.one_in(2)) result.boundaries = {dice_.of<std::string>({"k = 1", "k = d1", "k = b"})};
  if (mechanisms_) {
    add_mechanics(dice_, result);
  } else {
    scene(result);
  }
  return result;
}

/// Each is empty, no interval, or without a value at some k or h.
Tree RandomClaims::domain_of_parameters(const Tree& x) {
  const Tree h = symbol("h"), inverse = over(one, minus(k, one));
  const auto both = [](const Tree& left, const Tree& right) { return make(Op::conjunction, {left, right}); };
  const auto either = [](const Tree& left, const Tree& right) { return make(Op::disjunction, {left, right}); };
  return dice_.of<Tree>(
      {chain({zero, x, k}, {"<", "<"}), both(compare(x, ">", zero), compare(x, "<", k)), chain({k, x, h}, {"<=", "<="}),
       chain({k, x, number(1)}, {"<", "<="}), compare(k, ">", zero), both(compare(x, ">", zero), compare(k, "<=", one)),
       compare(times(k, x), ">", h), compare(x, "<", inverse), chain({zero, x, inverse}, {"<=", "<"}),
       compare(x, "<", over(h, k)), compare(x, "!=", k), either(compare(x, "!=", zero), compare(k, "!=", one)),
       either(compare(x, "<", k), compare(x, ">", h)), compare(make(Op::absolute, {x}), "<", k),
       compare(make(Op::maximum, {x, k}), "<", one), either(compare(x, ">", zero), compare(over(one, k), ">", zero))});
}

void RandomClaims::scene(Setting& setting) {
  const Tree x = symbol(setting.force);
  for (const char* name : {"I1", "I2", "I3"}) setting.scene[name] = number(dice_.one_in(4) ? 0 : 1);
  for (const char* name : {"M", "R", "r1"}) setting.scene[name] = one;
  for (const char* name : {"h", "f"}) setting.scene[name] = symbol(name);
  setting.scene["b2"] = symbol("b");
  setting.scene["b3"] = dice_.of<Tree>({symbol("b"), symbol("b"), one, minus(one, symbol("b"))});
  setting.scene["r2"] = number(dice_.one_in(3) ? 2 : 1);
  setting.scene["L"] = dice_.of<Tree>({one, one, zero, k});
  setting.scene["g"] = dice_.of<Tree>({one, number(10)});
  if (!dice_.one_in(3)) setting.scene["J"] = dice_.of<Tree>({one, one, one, minus(number(3), k)});
  setting.scene["F"] = x;
  if (setting.force != "F") {
    setting.scene["F"] = dice_.of<Tree>({x, x, times(k, x), plus(times(number(2), x), k), over(x, k), minus(one, x)});
  }
}

Values RandomClaims::bicycle(const Setting&) {
  const auto of = [&](std::vector<Rational> choices) { return dice_.of(choices); };
  const Rational half(1, 2), third(1, 3);
  return {{"b", of({half, 1, 2, Rational(3, 2), third, Rational(dice_.below(40) + 1, 8)})},
          {"h", of({-half, 0, half, 1, 2, Rational(dice_.below(40), 8)})},
          {"f", of({0, half, 1, third, 2, Rational(3, 4), Rational(dice_.below(20), 8)})},
          {"k", of({-2, -1, -half, 0, third, half, 1, 1, 2, Rational(5, 2), 3})},
          {"beta", of({0, half, third, 1, -half, 2})}};
}

Rational RandomTrees::small() {
  return dice_.of<Rational>(
      {-2, -1, Rational(-1, 2), 0, 0, Rational(1, 3), Rational(1, 2), 1, 1, Rational(3, 2), 2, 3});
}

Rational RandomTrees::literal() {
  if (world_.ends().empty() || dice_.one_in(3)) return small();
  const std::vector<Rational> ends(world_.ends().begin(), world_.ends().end());
  return dice_.of(ends);
}

std::string RandomTrees::relation() {
  return dice_.of<std::string>({"<", "<=", ">", ">=", "<", "<=", ">", ">=", "=", "!="});
}

Tree RandomTrees::parameter_number(int depth) {
  if (depth == 0 || dice_.one_in(3)) {
    return dice_.one_in(3) ? number(small()) : symbol(dice_.of<std::string>({"b", "h", "f", "k", "k", "d1", "d2"}));
  }
  const Tree left = parameter_number(depth - 1);
  if (dice_.one_in(8)) return power(left, static_cast<int>(dice_.below(5)) - 2);
  if (dice_.one_in(8)) return make(dice_.of<Op>({Op::absolute, Op::signum, Op::negate}), {left});
  const Op op = dice_.of<Op>({Op::add, Op::subtract, Op::multiply, Op::divide, Op::minimum, Op::maximum});
  return make(op, {left, parameter_number(depth - 1)});
}

Tree RandomTrees::region() {
  if (dice_.one_in(2)) return nullptr;
  const Tree any = compare(parameter_number(1), relation(), parameter_number(1));
  if (dice_.one_in(2)) {  // true, but for its end
    return compare(k, dice_.of<std::string>({"<=", ">=", "=", "<"}), number(world_.names().values.at("k")));
  }
  return dice_.one_in(3) ? combined(any, compare(k, relation(), number(small()))) : any;
}

Tree RandomTrees::combined(const Tree& left, const Tree& right) {
  if (dice_.one_in(3)) return make(Op::negation, {make(Op::conjunction, {left, right})});
  return make(dice_.of<Op>({Op::conjunction, Op::disjunction}), {left, right});
}

Tree RandomTrees::forces() {
  switch (dice_.below(8)) {
    case 0:
      return truth(true);
    case 1:
      return dividing();
    case 2:
      return combined(simple(), dividing());
    case 3:
    case 4:
      return combined(simple(), simple());
    case 5:
      return make(Op::negation, {simple()});
    default:
      return simple();
  }
}

Tree RandomTrees::simple() {
  const Tree c = number(literal()), d = number(literal());
  switch (dice_.below(8)) {
    case 0:
      return chain({c, x(), d}, {dice_.of<std::string>({"<", "<="}), dice_.of<std::string>({"<", "<="})});
    case 1:
      return compare(make(Op::absolute, {minus(x(), c)}), relation(), d);
    case 2:
      return compare(make(dice_.of<Op>({Op::minimum, Op::maximum}), {x(), c}), relation(), d);
    case 3:
      return compare(make(Op::signum, {minus(x(), c)}), relation(), number(static_cast<int>(dice_.below(3)) - 1));
    case 4:
      return compare(symbol("e1"), relation(), parameter_number(0));
    case 5:
      return compare(power(minus(x(), c), dice_.of<int>({0, 1, 2})), relation(), dice_.of<Tree>({zero, one}));
    default:
      return dice_.one_in(2) ? compare(x(), relation(), c) : compare(c, relation(), x());
  }
}

/// Undefined somewhere, perhaps.
Tree RandomTrees::dividing() {
  const Tree c = number(literal()), from_c = minus(x(), c);
  switch (dice_.below(6)) {
    case 0:
      return compare(over(one, from_c), relation(), zero);
    case 1:
      return compare(over(from_c, from_c), "=", one);
    case 2:
      return compare(over(one, over(one, from_c)), "=", from_c);
    case 3:
      return make(Op::disjunction, {compare(x(), "<=", c), compare(over(one, from_c), ">", zero)});
    case 4:
      return compare(times(zero, power(from_c, -1)), "=", zero);
    default:
      return compare(over(x(), parameter_number(1)), relation(), c);
  }
}

/// Between the forces at which motions can change, there are motions everywhere or nowhere.
Tree RandomTrees::forces_of(const Mode& mode) {
  if (world_.setting().force.empty()) return truth(world_.has_motion(mode, 0));
  const std::vector<Rational> points = everywhere(world_.ends());
  std::size_t first = points.size(), last = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!world_.has_motion(mode, points[i])) continue;
    first = std::min(first, i);
    last = i;
  }
  if (first == points.size()) return truth(false);
  if (first == last && first % 2 == 1) return compare(x(), "=", number(points[first]));
  // At odd places are the ends themselves; at even ones what lies between them.
  Tree result = truth(true);
  if (first > 0) {
    const bool closed = first % 2 == 1;
    result = compare(x(), closed ? ">=" : ">", number(points[closed ? first : first - 1]));
  }
  if (last + 1 == points.size()) return result;
  const bool closed = last % 2 == 1;
  const Tree upper = compare(x(), closed ? "<=" : "<", number(points[closed ? last : last + 1]));
  return result->op == Op::truth ? upper : make(Op::conjunction, {result, upper});
}

Tree RandomTrees::nearly(Tree condition) {
  if (!dice_.one_in(3)) return condition;
  switch (dice_.below(4)) {
    case 0:
      return make(Op::conjunction, {condition, simple()});
    case 1:
      return make(Op::disjunction, {condition, simple()});
    case 2:
      return make(Op::disjunction, {condition, compare(x(), "=", number(literal()))});
    default:
      return make(Op::conjunction, {condition, compare(x(), "!=", number(literal()))});
  }
}

/// Of a motion in the mode: what is true of all, of most, or of few.
Tree RandomTrees::about_motion(const Mode& mode) {
  const std::vector<std::string>& quantities = world_.quantities();
  const std::string name = dice_.of(quantities);
  const Tree q = symbol(name);
  const Solutions* solutions = world_.solutions(mode);
  if (solutions != nullptr && dice_.one_in(2)) {
    const Plane plane = solutions->motion.at(name);
    const Rational slope = dice_.one_in(4) ? plane.x + 1 : plane.x;
    const Tree value = plus(number(plane.constant), times(number(slope), x()));
    return compare(q, dice_.of<std::string>({"=", "=", "<=", ">=", "<"}), value);
  }
  switch (dice_.below(5)) {
    case 0:
      return compare(symbol(dice_.of(quantities)), dice_.of<std::string>({"<=", "<"}), times(symbol("f"), q));
    case 1:
      return compare(over(q, symbol(dice_.of(quantities))), relation(), number(small()));
    case 2:
      return compare(make(Op::absolute, {q}), relation(), parameter_number(0));
    case 3:
      return combined(compare(q, relation(), number(small())), simple());
    default:
      return compare(q, relation(), dice_.of<Tree>({zero, x(), number(small())}));
  }
}

Tree RandomTrees::about_parameter(const std::string& parameter) {
  const Tree p = symbol(parameter), c = number(small()), other = symbol(dice_.of<std::string>({"b", "h", "f", "d1"}));
  switch (dice_.below(7)) {
    case 0:
      return compare(over(other, minus(p, c)), relation(), zero);
    case 1:
      return compare(times(p, other), relation(), c);
    case 2:
      return compare(over(p, minus(p, c)), relation(), one);
    case 3:
      return combined(compare(p, relation(), c), compare(over(one, minus(p, number(small()))), ">", zero));
    case 4:
      return compare(times(p, p), relation(), times(c, p));
    case 5:
      return compare(symbol("d2"), relation(), c);
    default:
      return compare(p, relation(), c);
  }
}

}  // namespace slipproof::meaning

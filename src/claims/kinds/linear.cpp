#include "claims/kinds/linear.hpp"

#include "claims/statements/formulas.hpp"

namespace slipproof {

namespace {

void append(LinearRows& rows, const LinearRows& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

void append(Equations& equations, const Equations& more) {
  equations.insert(equations.end(), more.begin(), more.end());
}

}  // namespace

LinearKind::LinearKind(std::string_view name)
    : KindBase({.name = name,
                .fields = {{"equations"},
                           {"given", Need::optional, {"consequence", "system"}},
                           {"assume", Need::optional},
                           {"claims", Need::optional, {"consequence", "system"}},
                           {"mode", Need::optional}},
                .needs_no_force = true}) {}

Judgement LinearKind::judge(ClaimJudge& at) const {
  const auto rows_of = [&](const std::vector<Program>& equations) {
    return linear_rows(at.compiled(), at.sample().values(), equations);
  };
  const auto rows_of_claims = [&](const References& claims) -> std::optional<LinearRows> {
    LinearRows rows;
    for (const std::size_t claim : claims) {
      const auto more = rows_of(at.programs(claim).equations);
      if (!more) return std::nullopt;
      append(rows, *more);
    }
    return rows;
  };
  const ClaimBody& claim = at.body();
  const auto given = rows_of_claims(claim.given), claims = rows_of_claims(claim.claims),
             equations = rows_of(at.programs().equations), assumed = rows_of(at.programs().assume);
  if (!given || !claims || !equations || !assumed) return ClaimJudge::undecided();
  Sides rows{*given, *equations, *given};
  append(rows.left, claim.from_model() ? at.sample().equations(claim.mode()) : *claims);
  append(rows.left, *assumed);
  append(rows.right, *equations);
  return judge_rows(at, rows);
}

void LinearKind::refute(ClaimWriter& writer) const {
  const ClaimBody& claim = writer.body();
  std::vector<StatedMotion> motions = {{{}, plainly_true()}};
  if (claim.from_model()) motions = {writer.equations(claim.mode())};
  std::vector<Expression> truths = {claim.region, opposite(all_of(claim.equations))};
  const Equations others = equations_of(writer, sources(claim), claim.assume);
  append(truths, others);
  // If one equation has no value, the claim has none, whatever the others are. The only one is false, and so has one.
  for (const Expression& e : claim.equations) {
    if (claim.equations.size() == 1 || writer.always_defined(e)) continue;
    truths.push_back(make(Operation::logical_or, {e, opposite(e)}));
  }
  give_up_unless_linear(writer, others);
  give_up_unless_linear(writer, claim.equations);
  writer.somewhere(refuted_suffix, truths, motions);
}

void LinearKind::give_up_unless_linear(ClaimWriter& writer, const Equations& equations) {
  const auto linear = [&](const Expression& e) { return writer.is_linear(e); };
  if (!std::all_of(equations.begin(), equations.end(), linear)) writer.give_up();
}

References LinearKind::sources(const ClaimBody& claim) {
  References all = claim.given;
  all.insert(all.end(), claim.claims.begin(), claim.claims.end());
  return all;
}

StatedMotion LinearKind::hypotheses(ClaimWriter& writer, const Equations& others) {
  StatedMotion result;
  if (writer.body().from_model()) result = writer.equations(writer.body().mode());
  result.formula = conjoined({result.formula, writer.formula_of_all(others)});
  return result;
}

void LinearKind::have_values(ClaimWriter& writer, const Equations& equations) {
  give_up_unless_linear(writer, equations);
  const Expression& region = writer.body().region;
  writer.has_value(".defined.region", {}, region);
  Equations divided = equations;
  std::erase_if(divided, [&](const Expression& e) { return writer.always_defined(e); });
  if (divided.empty()) return;
  std::vector<Expression> shown;
  for (const Expression& e : divided)
    shown.push_back(braced(writer.formula(make(Operation::logical_or, {e, opposite(e)}))));
  writer.implied({".defined", {{"region", region}}, StatedMotion{{}, plainly_true()}, false}, conjoined(shown),
                 {all_of(divided)});
}

ClaimChange::Result LinearKind::settle(const ClaimChange& change) const {
  using Kind = Settlement::Kind;
  const ClaimBody &before = change.before(), &after = change.after();
  const Implications in = change.in().of_any_force();
  Lemmas lemmas;
  if (!same(before.region, after.region)) {
    if (in.equivalent({}, before.region, after.region, lemmas)) {
      return change.made(Kind::equivalent, "before and after imply each other", std::move(lemmas));
    }
    if (before.from_model() && change.is_identity()) {
      return change.made(Kind::theorem, "an identity of rational functions");
    }
  }
  // The same solutions, together with the other equations.
  const auto claims_in = [&](std::size_t claim) -> const ClaimBody& { return change.other(claim); };
  std::vector<Expression> beside{before.region};
  Expression x = make_truth(true), y = make_truth(true);
  const bool assumed = !std::equal(before.assume.begin(), before.assume.end(), after.assume.begin(), same);
  const Equations &then = assumed ? before.assume : before.equations, &now = assumed ? after.assume : after.equations;
  for (std::size_t i = 0; i < then.size(); ++i) {
    if (same(then[i], now[i])) {
      beside.push_back(then[i]);
    } else {
      x = conjunction(x, then[i]);
      y = conjunction(y, now[i]);
    }
  }
  append(beside, equations_of(claims_in, assumed ? sources(before) : before.given));
  const bool on_road = assumed && before.from_model() && before.modes.empty();
  if (in.equivalent(beside, x, y, lemmas, on_road ? Obeying::equations_on_road : Obeying::nothing)) {
    return change.made(Kind::equivalent, "with the equations beside it, before and after have the same solutions",
                       std::move(lemmas));
  }
  return assumed ? settle_assumption(change) : settle_equation(change, y);
}

ClaimChange::Result LinearKind::settle_assumption(const ClaimChange&) const {
  return std::nullopt;
}

ClaimChange::Result LinearKind::settle_equation(const ClaimChange&, const Expression&) const {
  return std::nullopt;
}

ClaimWords LinearKind::words(const ClaimBody& claim, std::string_view) const {
  ClaimWords words;
  if (claim.from_model()) {
    words = {"the model's equations "};
  } else {
    if (!claim.claims.empty()) words.push_back(claim.claims);
    if (!claim.claims.empty() && !claim.given.empty()) words.push_back(" with ");
    if (!claim.given.empty()) words.push_back(claim.given);
  }
  if (!claim.modes.empty()) words.insert(words.end(), {" in ", claim.modes});
  if (!claim.assume.empty()) {
    words.push_back(" together with ");
    words.emplace_back(std::in_place_type<Equations>, claim.assume);
  }
  words.push_back(relation());
  words.emplace_back(std::in_place_type<Equations>, claim.equations);
  return words;
}

}  // namespace slipproof

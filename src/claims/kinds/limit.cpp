// As the parameter goes to the upper end of its domain, `holds` is true from some value on.
#include "claims/kinds/kind_base.hpp"
#include "claims/reading/claims_reader.hpp"
#include "mechanics/lines/critical.hpp"

namespace slipproof {

namespace {

using claims_reader::BodyTable;

/// The value of the parameter from which on proofs show it, independent of the parameter.
const Expression* from(const ClaimBody& claim) {
  const auto found = claim.own.find("from");
  return found == claim.own.end() ? nullptr : &found->second;
}

void read_from(const BodyTable& in, std::string_view key) {
  const Expression value = in.read(key, Sort::number, {.definitions = true});
  in.body.own["from"] = value;
  auto& uses = in.context.uses;
  if (!uses.empty() && uses.back().expression == value) uses.back().independent_of = in.body.parameter;
}

void read_parameter(const BodyTable& in, std::string_view key) {
  in.body.parameter.clear();
  const PlacedText* text = in.table.string(key);
  if (text == nullptr || in.in_setting() == nullptr) return;
  std::vector<std::string_view> known;
  for (const FreeParameter& parameter : in.in_setting()->parameters) {
    if (!parameter.angle) known.push_back(parameter.symbol);
  }
  if (std::find(known.begin(), known.end(), text->text()) == known.end()) {
    in.table.refuse(key, claims_reader::unknown("parameter", text->text(), known));
  }
  in.body.parameter = text->text();
}

class LimitKind : public KindBase {
 public:
  LimitKind()
      : KindBase({.name = "limit",
                  .fields = {{.key = "parameter", .expected = "a parameter of the setting", .read = read_parameter},
                             {"holds"},
                             {.key = "from",
                              .need = Need::optional,
                              .expected = "a number, independent of the parameter",
                              .read = read_from,
                              .only_for_proofs = true}},
                  .needs_no_force = true,
                  .says_by_region = true}) {}

  Judgement judge(ClaimJudge& at) const override {
    const std::size_t index = at.setting().parameter_index(at.body().parameter);
    const Program &region = at.programs().region, &holds = at.programs().holds;
    const auto judged = [&](const auto& truth) {
      const Truth inside = truth(region);
      if (ClaimJudge::no_value(inside)) return ClaimJudge::undecided();
      if (inside == Truth::no) return Judgement{};
      const Truth said = truth(holds);
      return ClaimJudge::no_value(said) ? ClaimJudge::undecided()
             : said == Truth::yes       ? ClaimJudge::holds()
                                        : ClaimJudge::refuted({"limit"});
    };
    if (at.sample().eventually(at.compiled().is_point(), index) == Truth::yes) {
      return judged([&](const Program& p) { return at.sample().eventually(p, index); });
    }
    const auto last = last_points(at.compiled(), {&region, &holds}, at.sample().values(), index);
    if (!last) return ClaimJudge::undecided();
    return ClaimJudge::first_of(
        *last, [&](const auto& bicycle) { return judged([&](const Program& p) { return bicycle->region(p); }); });
  }

  /// ID.eventually: `holds` for values of the parameter greater than `from`; ID.from: `from` is defined; ID.beyond,
  /// where the parameter may be bounded: there are greater values; ID.defined: the region has a value.
  void state(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    const Expression* least = from(claim);
    if (least == nullptr) return;
    const Expression beyond = make_comparison({*least, make_symbol(claim.parameter)}, {Relation::less});
    writer.implied({".eventually", {{"region", claim.region}, {"beyond", beyond}}, {}, false}, claim.holds);
    const Expression defined = make_comparison({*least, *least}, {Relation::equal});
    writer.implied({".from", {{"region", claim.region}}, {}, false}, defined);
    writer.goes_beyond(".beyond", claim.parameter, *least);
    // Where `from` has no value, no bicycle is beyond it, and the region may have none either.
    ClaimWriter::Assumptions far;
    if (writer.always_defined(*least)) far.emplace_back("beyond", beyond);
    writer.has_value(".defined", far, claim.region);
  }

  /// No statement can say that `holds` fails however large the parameter is.
  void refute(ClaimWriter&) const override {}

  std::string why_unstated(const ClaimBody& claim) const override {
    if (claim.expect == Expectation::refuted) return "statements cannot say that a limit is false";
    if (from(claim) != nullptr) return {};
    return "a limit needs `from`: a value of " + claim.parameter + " from which on it can be shown";
  }

  bool says_nothing(const Implications& logic, std::size_t claim, const ClaimBody& body) const override {
    Lemmas lemmas;
    return logic.of_any_force().eventually(make_truth(true), opposite(body.region), body.parameter, lemmas) ||
           KindBase::says_nothing(logic, claim, body);
  }

  ClaimWords words(const ClaimBody& claim, std::string_view) const override {
    return {claim.holds, " from some value of ", make_symbol(claim.parameter), " on"};
  }
  std::string failing(const ClaimBody& claim, const Judgement&, std::string_view) const override {
    return "it stays false, however large " + claim.parameter + " becomes";
  }

 protected:
  ClaimChange::Result settle_holds(const ClaimChange& change, const std::vector<Expression>&) const override {
    const ClaimBody& after = change.after();
    Lemmas lemmas;
    if (!change.in().of_any_force().eventually(after.region, after.holds, after.parameter, lemmas)) return std::nullopt;
    return change.made(Settlement::Kind::theorem,
                       "true from some value of " + after.parameter + " on, by leading coefficients",
                       std::move(lemmas));
  }
};

}  // namespace

const ClaimKind& limit_kind() {
  static const LimitKind kind;
  return kind;
}

}  // namespace slipproof

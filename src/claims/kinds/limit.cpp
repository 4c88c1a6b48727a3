// As the parameter goes to the upper end of its domain, `holds` is true from some value on.
#include "claims/kinds/kind_base.hpp"
#include "claims/lines/critical.hpp"

namespace slipproof {

namespace {

class LimitKind : public KindBase {
 public:
  LimitKind()
      : KindBase(
            {.name = "limit", .fields = {{"parameter"}, {"holds"}, {"from", Need::optional}}, .says_by_region = true}) {
  }

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
                                        : ClaimJudge::refuted(Reason::limit);
    };
    if (at.sample().eventually(at.compiled().is_point(), index) == Truth::yes) {
      return judged([&](const Program& p) { return at.sample().eventually(p, index); });
    }
    const auto last = last_points(at.compiled(), {&region, &holds}, at.sample().values(), index);
    if (!last) return ClaimJudge::undecided();
    return ClaimJudge::first_of(
        *last, [&](const auto& bicycle) { return judged([&](const Program& p) { return bicycle->region(p); }); });
  }

  /// Writes three statements: `holds` from a value of the parameter on that the other parameters determine; that this
  /// value is defined; and that there are greater ones.
  void state(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    if (!claim.from) return;
    const Expression beyond = make_comparison({claim.from, make_symbol(claim.parameter)}, {Relation::less});
    writer.implied({".eventually", {{"region", claim.region}, {"beyond", beyond}}, {}, false}, claim.holds);
    const Expression defined = make_comparison({claim.from, claim.from}, {Relation::equal});
    writer.implied({".from", {{"region", claim.region}}, {}, false}, defined);
    writer.goes_beyond(".beyond", claim.parameter, claim.from);
    writer.has_value(".defined", {{"beyond", beyond}}, claim.region);
  }

  /// No statement can say that `holds` fails however large the parameter is.
  void refute(ClaimWriter&) const override {}

  std::string why_unstated(const ClaimBody& claim) const override {
    if (claim.expect == Expectation::refuted) return "statements cannot say that a limit is false";
    if (claim.from) return {};
    return "a limit needs `from`: a value of " + claim.parameter + " from which on it can be shown";
  }

  bool says_nothing(const Implications& logic, std::size_t claim, const ClaimBody& body) const override {
    Lemmas lemmas;
    return logic.eventually(make_truth(true), opposite(body.region), body.parameter, lemmas) ||
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
    if (!change.in().eventually(after.region, after.holds, after.parameter, lemmas)) return std::nullopt;
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

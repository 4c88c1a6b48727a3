#include <utility>

#include "report/papers/explain.hpp"
#include "report/papers/papers_json.hpp"
#include "report/papers/verify_report.hpp"
#include "report/values/motions_json.hpp"

namespace slipproof {

namespace {

Json interval_json(const ForceInterval& interval) {
  if (interval.empty()) return nullptr;
  Json object;
  put_interval(object, "F", interval);
  return object;
}

Json broken_json(const Counterexample& e) {
  Json list = Json::array();
  for (const BrokenComparison& broken : e.broken) {
    Json entry;
    entry["left"] = to_string(broken.left);
    entry["relation"] = spelling(broken.relation);
    entry["right"] = to_string(broken.right);
    entry["values"] = Json::array({to_json(broken.left_value), to_json(broken.right_value)});
    list.push_back(std::move(entry));
  }
  return list;
}

Json counterexample_json(const ClaimsFile& file, const ClaimResult& result, const Counterexample& e) {
  const Setting& setting = file.settings[file.claims[result.claim].setting];
  Json object, parameters = Json::object();
  for (const auto& [symbol, value] : parameters_of(setting, e)) parameters[symbol] = to_json(value);
  object["reason"] = e.judgement.reason.name;
  object["explanation"] = explain(file, result, e);
  object["minimal"] = e.minimal;
  object["realisable"] = setting.realisable.empty() ? Json(nullptr) : Json(e.unrealisable.empty());
  object["unrealisable"] = e.unrealisable;
  object["broken"] = broken_json(e);
  object["parameters"] = std::move(parameters);
  object["scene"] = scene_text(setting, e);
  object["mode"] = e.judgement.mode ? Json(name(*e.judgement.mode)) : Json(nullptr);
  if (e.judgement.claimed) object["claimed"] = interval_json(*e.judgement.claimed);
  if (e.judgement.real) object["real"] = interval_json(*e.judgement.real);
  if (e.judgement.witnesses) object["witnesses"] = interval_json(*e.judgement.witnesses);
  object["force"] = to_json(e.force);
  if (e.motions) put_motions(object, e.scene.mechanism, *e.motions);
  return object;
}

}  // namespace

std::string verify_json(const ClaimsFile& file, const VerifyResult& result) {
  Json document, claims = Json::array();
  document["schema"] = "slipproof/verify/1";
  document["paper"] = file.paper.title;
  document["samples"] = result.samples;
  document["lines"] = result.lines;
  document["seed"] = result.seed;
  if (result.second_checker) document["second_checker"] = to_json(*result.second_checker);
  document["missing"] = result.missing();
  put_origins(document, "judged", count_claims(file, result));
  for (const ClaimResult& r : result.claims) {
    const Claim& claim = file.claims[r.claim];
    Json entry;
    entry["id"] = claim.id;
    entry["reading"] = name(r.reading);
    entry["origin"] = name(claim.origin);
    entry["verdict"] = r.proved ? "proved" : name(r.verdict);
    if (r.from_the_claim_on) entry["from_the_claim_on"] = true;
    const Expectation expect = claim.body(r.reading).expect;
    entry["expected"] = expect == Expectation::none ? "holds" : std::string(name(expect));
    entry["samples"] = r.samples();
    entry["tried"] = r.tried;
    entry["refuted"] = r.refuted;
    entry["undecided"] = r.undecided;
    entry["unsure"] = r.unsure;
    entry["lines"] = r.lines;
    entry["cells"] = r.cells;
    entry["certificates"] = r.certificates;
    if (!r.failure.empty()) entry["failure"] = r.failure;
    if (!r.rejections.empty()) entry["rejected"] = r.rejections;
    if (!r.outdated.empty()) entry["outdated"] = r.outdated;
    for (const CheckedCertificate& statement : r.unproved) {
      entry["unproved"].push_back(
          {{"theorem", statement.theorem}, {"state", to_string(statement.state)}, {"because", statement.message}});
    }
    entry["line"] = claim.line;
    entry["place"] = file.paper.place(claim.line);
    entry["statement"] = claim.statement;
    entry["grade"] = claim.grade ? Json(name(*claim.grade)) : Json(nullptr);
    entry["counterexample"] = r.counterexample ? counterexample_json(file, r, *r.counterexample) : Json(nullptr);
    entry["simplest"] = r.simplest ? counterexample_json(file, r, *r.simplest) : Json(nullptr);
    entry["explanation"] = explain(file, r);
    claims.push_back(std::move(entry));
  }
  document["claims"] = std::move(claims);
  return dump(document);
}

}  // namespace slipproof

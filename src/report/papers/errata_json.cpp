#include <array>

#include "report/papers/errata.hpp"
#include "report/papers/papers_json.hpp"

namespace slipproof {

namespace {

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

}  // namespace

std::string errata_json(const ClaimsFile& file, const Errata& errata) {
  Json document, list = Json::array();
  document["schema"] = "slipproof/errata/1";
  document["paper"] = file.paper.title;
  document["source"] = file.paper.source;
  for (const Finding& f : errata.findings) {
    Json entry;
    entry["id"] = f.id;
    entry["origin"] = name(f.origin);
    entry["line"] = f.line;
    entry["place"] = file.paper.place(f.line);
    entry["grade"] = name(f.grade);
    entry["graded"] = f.graded;
    entry["statement"] = f.statement;
    entry["printed"] = text_or_null(to_string(f.printed));
    entry["wrong"] = f.wrong;
    entry["repair"] = text_or_null(to_string(f.repair));
    entry["why"] = text_or_null(f.why);
    entry["error"] = f.error == Certainty::proved ? "exact" : "sampled";
    entry["repaired"] = f.repair.empty() ? Json(nullptr) : Json(name(f.mended));
    entry["claims"] = f.claims;
    entry["certificates"] = f.certificates;
    entry["disproofs"] = f.disproofs;
    entry["samples"] = f.samples;
    entry["refutations"] = f.refutations;
    list.push_back(std::move(entry));
  }
  document["findings"] = std::move(list);
  const Standing& standing = errata.standing;
  Json claims;
  put_counts(claims, "judged", standing.claims.all());
  put_origins(claims, "judged", standing.claims);
  claims["missing"] = standing.missing;
  document["claims"] = std::move(claims);
  document["standing"] = standing_text(errata);
  return dump(document);
}

std::string errata_sarif(const ClaimsFile& file, const Errata& errata) {
  Json rules = Json::array(), results = Json::array();
  for (const Grade grade : {Grade::misprint, Grade::gap, Grade::boundary, Grade::wrong}) {
    constexpr std::array<const char*, 4> meanings{
        "What stands in print is not what was meant.", "A case that the paper leaves out.",
        "An interval is open where it is closed, or the other way round.", "False in every plausible reading."};
    Json rule;
    rule["id"] = name(grade);
    rule["shortDescription"]["text"] = meanings[static_cast<std::size_t>(grade)];
    rules.push_back(std::move(rule));
  }
  for (const Finding& f : errata.findings) {
    Json result, location;
    result["ruleId"] = name(f.grade);
    result["level"] = f.grade == Grade::wrong ? "error" : "warning";
    result["message"]["text"] = f.id + (f.graded ? "" : " (no grade is given)") + ": " + f.wrong +
                                (f.repair.empty() ? "" : ". Repair: " + to_string(f.repair)) +
                                (f.why.empty() ? "" : ". " + f.why);
    location["physicalLocation"]["artifactLocation"]["uri"] = file.paper.source;
    location["physicalLocation"]["region"]["startLine"] = f.line;
    result["properties"]["origin"] = name(f.origin);
    result["locations"] = Json::array({std::move(location)});
    results.push_back(std::move(result));
  }
  Json run, document;
  run["tool"]["driver"]["name"] = "slipproof";
  run["tool"]["driver"]["rules"] = std::move(rules);
  run["results"] = std::move(results);
  // A list without results does not by itself mean that all is well.
  run["properties"]["standing"] = standing_text(errata);
  put_origins(run["properties"]["claims"], "judged", errata.standing.claims);
  run["properties"]["missing"] = errata.standing.missing;
  document["$schema"] = "https://json.schemastore.org/sarif-2.1.0.json";
  document["version"] = "2.1.0";
  document["runs"] = Json::array({std::move(run)});
  return dump(document);
}

}  // namespace slipproof

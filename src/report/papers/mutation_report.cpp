#include "report/papers/mutation_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof {

namespace {

/// Numbers of statements, from 1.
using Numbers = std::unordered_map<std::string, std::size_t>;

Numbers numbered(const MutationResult& result) {
  Numbers numbers;
  for (const Lemma* lemma : lemmas_of(result)) numbers.emplace(lemma->statement, numbers.size() + 1);
  return numbers;
}

std::string change(const MutantResult& m) {
  return fmt::format("column {}, {}: {}", m.mutant.mutant.column, m.mutant.mutant.description,
                     to_string(m.mutant.mutant.expression));
}

std::string witness(const MutationResult& result, const MutantResult& m) {
  const Setting& setting = result.file.settings[m.mutant.setting];
  std::string text;
  for (std::size_t k = 0; k < m.sample.size(); ++k) {
    text += fmt::format("{}{} = {}", k == 0 ? "" : " ", setting.parameters[k].symbol, exact_text(m.sample[k]));
  }
  if (m.force && !setting.force.symbol.empty())
    text += fmt::format(", {} = {}", setting.force.symbol, exact_text(*m.force));
  return text;
}

bool is_caught_by_failure(const MutantResult& m) {
  return m.end == MutantEnd::refuted || m.end == MutantEnd::no_value;
}

/// In which claim the mutant is noticed, or why it is not.
std::string argument(const MutationResult& result, const MutantResult& m, const Numbers& numbers) {
  if (m.end == MutantEnd::survivor) return m.argument;
  const std::string& claim = result.file.claims[m.claim].id;
  if (m.end == MutantEnd::reach) return "only one of the two speaks, in " + claim + ", at " + witness(result, m);
  const auto number = [&](const Lemma& lemma) { return std::to_string(numbers.at(lemma.statement)); };
  return claim + ": " + m.argument + (m.lemmas.empty() ? "" : " (lemmas " + listed(m.lemmas, number) + ")");
}

std::string ids(const MutationResult& result, const std::vector<std::size_t>& claims) {
  return listed(
      claims, [&](std::size_t c) { return result.file.claims[c].id; }, " ");
}

std::string last_line(const MutationResult& result) {
  const std::uint64_t survivors = result.count(MutantEnd::survivor);
  std::string line = fmt::format("s {} mutants {}", survivors == 0 ? "TIGHT" : "LOOSE", result.mutants.size());
  for (const MutantEnd end : all_mutant_ends) {
    if (end != MutantEnd::survivor) line += fmt::format(" {} {}", name(end), result.count(end));
  }
  return line + fmt::format(" survivors {}", survivors);
}

}  // namespace

std::vector<const Lemma*> lemmas_of(const MutationResult& result) {
  std::vector<const Lemma*> all;
  Numbers seen;
  for (const MutantResult& m : result.mutants) {
    for (const Lemma& lemma : m.lemmas) {
      if (seen.emplace(lemma.statement, 0).second) all.push_back(&lemma);
    }
  }
  return all;
}

Document mutation_document(const MutationResult& result) {
  const Numbers numbers = numbered(result);
  Document document;
  document.title(result.file.paper.title);
  document.line(
      fmt::format("{} bicycles for each setting, {} more and {} lines a claim for what survives them, seed {}",
                  result.samples, result.more_samples, result.lines, result.seed));
  if (!result.not_mutated.empty()) {
    document.line("left out, as they are refuted or undecided unchanged, or hold at none of these bicycles: " +
                  ids(result, result.not_mutated));
  }
  if (!result.vacuous.empty()) {
    document.line("true whatever the motion, so that they say nothing of it: " + ids(result, result.vacuous));
  }
  for (auto first = result.mutants.begin(); first != result.mutants.end();) {
    const auto last = std::find_if(first, result.mutants.end(),
                                   [&](const MutantResult& m) { return m.mutant.where != first->mutant.where; });
    const auto caught = std::count_if(first, last, is_caught_by_failure);
    Document& formula =
        document.section(first->mutant.where + ": " + to_string(first->mutant.original(result.file)), {2});
    formula.line(fmt::format("{} of {} make a claim fail", caught, last - first));
    ReportTable& table = formula.table({{{"", false, 14}, ""}});
    for (; first != last; ++first) {
      if (is_caught_by_failure(*first)) continue;
      table.row({name(first->end), change(*first)}).line(argument(result, *first, numbers));
    }
  }
  document.status(last_line(result));
  return document;
}

std::string mutation_json(const MutationResult& result) {
  const Numbers numbers = numbered(result);
  Json document, counts, list = Json::array(), lemmas = Json::array();
  document["schema"] = "slipproof/mutants/1";
  document["paper"] = result.file.paper.title;
  document["samples"] = result.samples;
  document["more_samples"] = result.more_samples;
  document["lines"] = result.lines;
  document["seed"] = result.seed;
  for (const MutantEnd end : all_mutant_ends) counts[std::string(name(end))] = result.count(end);
  document["counts"] = std::move(counts);
  const auto claims = [&](const std::vector<std::size_t>& indices) {
    Json array = Json::array();
    for (const std::size_t c : indices) array.push_back(result.file.claims[c].id);
    return array;
  };
  document["left_out"] = claims(result.not_mutated);
  document["vacuous"] = claims(result.vacuous);
  for (const MutantResult& m : result.mutants) {
    Json entry, parameters = Json::object(), used = Json::array();
    entry["where"] = m.mutant.where;
    entry["column"] = m.mutant.mutant.column;
    entry["change"] = m.mutant.mutant.description;
    entry["mutant"] = to_string(m.mutant.mutant.expression);
    entry["end"] = name(m.end);
    entry["claim"] = m.end == MutantEnd::survivor ? Json(nullptr) : Json(result.file.claims[m.claim].id);
    if (!m.sample.empty()) {
      const Setting& setting = result.file.settings[m.mutant.setting];
      for (std::size_t k = 0; k < m.sample.size(); ++k) {
        parameters[setting.parameters[k].symbol] = to_json(m.sample[k]);
      }
      entry["parameters"] = std::move(parameters);
      entry["force"] = to_json(m.force);
    }
    if (m.end == MutantEnd::refuted) entry["reason"] = m.reason.name;
    if (!m.argument.empty()) entry["argument"] = m.argument;
    for (const Lemma& lemma : m.lemmas) used.push_back(numbers.at(lemma.statement));
    if (!used.empty()) entry["lemmas"] = std::move(used);
    list.push_back(std::move(entry));
  }
  document["mutants"] = std::move(list);
  for (const Lemma* lemma : lemmas_of(result)) {
    Json entry;
    entry["statement"] = lemma->statement;
    entry["certificate"] = lemma->certificate;
    lemmas.push_back(std::move(entry));
  }
  document["lemmas"] = std::move(lemmas);
  return dump(document);
}

}  // namespace slipproof

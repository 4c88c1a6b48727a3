#include "report/uniqueness/uniqueness_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "claims/uniqueness/ranges.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "report/values/every_load.hpp"
#include "report/values/exact_json.hpp"
#include "report/values/number_text.hpp"

namespace slipproof {

namespace {

/// An irrational number is given by the two rational numbers that enclose it.
std::string end_text(const std::optional<RealRoot>& end, int digits) {
  if (!end) return "oo";
  if (end->is_rational()) return short_text(end->lower, digits);
  return fmt::format("({} .. {})", decimal_text(end->lower, digits), decimal_text(end->upper, digits));
}

bool is_point(const ParameterRange& range) {
  return range.lower_closed && range.upper_closed && range.lower->lower == range.upper->lower;
}

std::string range_text(const std::string& symbol, const ParameterRange& range, int digits) {
  if (is_point(range)) return symbol + " = " + end_text(range.lower, digits);
  return fmt::format("{} in {}{}{}, {}{}", symbol, range.lower_closed ? "[" : "(", range.lower ? "" : "-",
                     end_text(range.lower, digits), end_text(range.upper, digits), range.upper_closed ? "]" : ")");
}

/// Neighbouring loads without one motion: the largest number of motions, and where it occurs.
struct Ambiguity {
  ForceInterval loads;
  std::size_t motions = 0;
  bool continuum = false, none = false;
};

std::vector<Ambiguity> ambiguities(const MotionsAtParameter& motions) {
  std::vector<Ambiguity> result;
  for (const LoadsApart& a : motions.apart) {
    const bool joins = !result.empty() && result.back().loads.upper() &&
                       a.loads.lower() == result.back().loads.upper() &&
                       (a.loads.lower_closed() || result.back().loads.upper_closed());
    if (!joins) {
      result.push_back({a.loads, a.motions, a.continuum, a.none()});
      continue;
    }
    Ambiguity& last = result.back();
    last.loads =
        ForceInterval::between(last.loads.lower(), last.loads.lower_closed(), a.loads.upper(), a.loads.upper_closed());
    last.motions = std::max(last.motions, a.motions);
    last.continuum = last.continuum || a.continuum;
    last.none = last.none || a.none();
  }
  return result;
}

std::string in_words(const Ambiguity& a) {
  std::vector<std::string> all;
  if (a.none) all.emplace_back("no motion");
  if (a.motions > 0)
    all.push_back((a.motions > 1 && !a.loads.is_point() ? "up to " : "") + counted(a.motions, "motion"));
  if (a.continuum) all.emplace_back("a continuum");
  return listed(all);
}

std::string loads_text(const std::string& symbol, const ForceInterval& loads, int digits) {
  return (loads.is_point() ? "" : symbol + " in ") + interval_text(symbol, loads, digits);
}

class UniquenessText {
 public:
  UniquenessText(const MechanismScene& scene, const UniquenessAlong& along, int digits)
      : scene_(scene), along_(along), digits_(digits) {}

  Document whole() const {
    Document document = scene_document(scene_, scene_.mechanism.name);
    write(document.section("As it is, " + along_.parameter + " = " + short_text(along_.own, digits_), {0, 6}),
          along_.at_own);
    Document& section = document.section("Along " + along_.parameter + ", all else as it is");
    const std::vector<ParameterRange> all = ranges(along_);
    for (const ParameterRange& range : all) write(section, range);
    write_exact(document, all);
    document.status(last_line());
    return document;
  }

 private:
  void write(Document& document, const MotionsAtParameter& motions) const {
    const auto& load = scene_.mechanism.load;
    if (motions.apart.empty()) document.line(load ? "one motion at every " + load->symbol : "one motion");
    for (const Ambiguity& a : ambiguities(motions)) {
      document.line(in_words(a) + (load ? ": " + loads_text(load->symbol, a.loads, digits_) : ""));
    }
    if (motions.for_every_q) document.paragraph(in_words(*motions.for_every_q));
  }

  void write(Document& document, const ParameterRange& range) const {
    std::string text = range_text(along_.parameter, range, digits_);
    const bool of_sample = !range.motions.apart.empty() && scene_.mechanism.load && !is_point(range);
    if (of_sample) text += "; at " + along_.parameter + " = " + short_text(range.sample, digits_);
    Document& below = document.item(text, {0, 4});
    write(below, range.motions);
    if (range.unseen.empty()) return;
    const bool one = range.unseen.size() == 1;
    below.line("except perhaps at " + counted(range.unseen.size(), "single irrational value") +
               (one ? ", which was not tried" : ", which were not tried"));
  }

  /// Writes the exact values of ends that were rounded.
  void write_exact(Document& document, const std::vector<ParameterRange>& all) const {
    std::vector<std::string> lines;
    for (const ParameterRange& range : all) {
      if (!range.lower || !range.lower->is_rational()) continue;
      const std::string rounded = short_text(range.lower->lower, digits_), exact = exact_text(range.lower->lower);
      std::string line = rounded + " is " + exact;
      if (rounded != exact && (lines.empty() || lines.back() != line)) lines.push_back(std::move(line));
    }
    if (lines.empty()) return;
    Document& section = document.section("Exactly:");
    for (std::string& line : lines) section.line(std::move(line));
  }

  std::string last_line() const {
    const auto& apart = along_.at_own.apart;
    const auto any = [&](const auto& is) { return std::any_of(apart.begin(), apart.end(), is); };
    const std::string_view word = any([](const LoadsApart& a) { return a.none(); })      ? "NONE"
                                  : any([](const LoadsApart& a) { return a.continuum; }) ? "CONTINUUM"
                                  : apart.empty()                                        ? "UNIQUE"
                                                                                         : "SEVERAL";
    const auto first = along_.first_apart();
    return fmt::format("s {} at {} = {}; critical {} {}", word, along_.parameter, short_text(along_.own, digits_),
                       along_.parameter, first ? end_text(first, digits_) : "none");
  }

  const MechanismScene& scene_;
  const UniquenessAlong& along_;
  int digits_;
};

Json end_json(const std::optional<RealRoot>& end) {
  if (!end) return nullptr;
  if (end->is_rational()) return to_json(end->lower);
  return Json::array({to_json(end->lower), to_json(end->upper)});
}

Json motions_json(const MotionsAtParameter& motions) {
  Json apart = Json::array();
  for (const LoadsApart& a : motions.apart) {
    Json entry{{"motions", a.motions}, {"continuum", a.continuum}};
    put_interval(entry, "load", a.loads);
    apart.push_back(std::move(entry));
  }
  Json object;
  object["one_motion"] = motions.apart.empty();
  object["apart"] = std::move(apart);
  object["every_q"] = every_load_json(motions.for_every_q);
  return object;
}

}  // namespace

Document uniqueness_document(const MechanismScene& scene, const UniquenessAlong& along, int digits) {
  return UniquenessText(scene, along, digits).whole();
}

std::string uniqueness_json(const MechanismScene& scene, const UniquenessAlong& along) {
  Json document, cells = Json::array();
  document["schema"] = "slipproof/critical/1";
  document["scene"] = scene.name;
  document["mechanism"] = scene.mechanism.name;
  document["parameter"] = along.parameter;
  document["value"] = to_json(along.own);
  document["at_value"] = motions_json(along.at_own);
  document["critical"] = end_json(along.first_apart());
  for (const ParameterRange& range : ranges(along)) {
    Json cell;
    cell["from"] = end_json(range.lower);
    cell["to"] = end_json(range.upper);
    cell["closed"] = Json::array({range.lower_closed, range.upper_closed});
    cell["sample"] = to_json(range.sample);
    cell["at_sample"] = motions_json(range.motions);
    cell["not_looked_at"] = Json::array();
    for (const RealRoot& root : range.unseen) cell["not_looked_at"].push_back(end_json(root));
    cells.push_back(std::move(cell));
  }
  document["ranges"] = std::move(cells);
  return dump(document);
}

}  // namespace slipproof

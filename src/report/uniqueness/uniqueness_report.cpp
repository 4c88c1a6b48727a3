#include "report/uniqueness/uniqueness_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "base/input/utf8.hpp"
#include "base/number/format.hpp"
#include "claims/uniqueness/ranges.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "report/values/every_load.hpp"
#include "report/values/exact_json.hpp"
#include "report/values/number_text.hpp"

namespace slipproof {

namespace {

using Out = std::back_insert_iterator<std::string>;

/// A short number exactly, a longer one as a decimal.
std::string short_text(const Rational& x, int digits) {
  const std::string exact = exact_text(x);
  return exact.size() <= 8 ? exact : decimal_text(x, digits);
}

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
  return fmt::format("{}", fmt::join(all, ", "));
}

std::string loads_text(const std::string& symbol, const ForceInterval& loads, int digits) {
  return (loads.is_point() ? "" : symbol + " in ") + interval_text(symbol, loads, digits);
}

class UniquenessText {
 public:
  UniquenessText(const MechanismScene& scene, const UniquenessAlong& along, int digits)
      : scene_(scene), along_(along), digits_(digits) {}

  std::string whole() {
    fmt::format_to(out_, "{}: {}\n", scene_.name, scene_.mechanism.name);
    text_ += notes_text(scene_);
    fmt::format_to(out_, "\nAs it is, {} = {}\n", along_.parameter, short_text(along_.own, digits_));
    write(along_.at_own);
    fmt::format_to(out_, "\nAlong {}, all else as it is\n", along_.parameter);
    const std::vector<ParameterRange> all = ranges(along_);
    for (const ParameterRange& range : all) write(range);
    write_exact(all);
    write_end();
    return std::move(text_);
  }

 private:
  void write(const MotionsAtParameter& motions) {
    const auto& load = scene_.mechanism.load;
    if (motions.apart.empty()) fmt::format_to(out_, "      one motion{}\n", load ? " at every " + load->symbol : "");
    for (const Ambiguity& a : ambiguities(motions)) {
      fmt::format_to(out_, "      {}{}\n", in_words(a), load ? ": " + loads_text(load->symbol, a.loads, digits_) : "");
    }
    if (motions.for_every_q) text_ += wrapped("      ", in_words(*motions.for_every_q));
  }

  void write(const ParameterRange& range) {
    fmt::format_to(out_, "  {}", range_text(along_.parameter, range, digits_));
    const bool of_sample = !range.motions.apart.empty() && scene_.mechanism.load && !is_point(range);
    if (of_sample) fmt::format_to(out_, "; at {} = {}", along_.parameter, short_text(range.sample, digits_));
    fmt::format_to(out_, "\n");
    write(range.motions);
    if (range.unseen.empty()) return;
    fmt::format_to(out_, "      not looked at: {} where something may change\n",
                   counted(range.unseen.size(), "irrational value"));
  }

  /// Writes the exact values of ends that were rounded.
  void write_exact(const std::vector<ParameterRange>& all) {
    std::vector<std::string> lines;
    for (const ParameterRange& range : all) {
      if (!range.lower || !range.lower->is_rational()) continue;
      const std::string rounded = short_text(range.lower->lower, digits_), exact = exact_text(range.lower->lower);
      std::string line = rounded + " is " + exact;
      if (rounded != exact && (lines.empty() || lines.back() != line)) lines.push_back(std::move(line));
    }
    if (!lines.empty()) fmt::format_to(out_, "\nExactly:\n  {}\n", fmt::join(lines, "\n  "));
  }

  void write_end() {
    const auto& apart = along_.at_own.apart;
    const auto any = [&](const auto& is) { return std::any_of(apart.begin(), apart.end(), is); };
    const std::string_view word = any([](const LoadsApart& a) { return a.none(); })      ? "NONE"
                                  : any([](const LoadsApart& a) { return a.continuum; }) ? "CONTINUUM"
                                  : apart.empty()                                        ? "UNIQUE"
                                                                                         : "SEVERAL";
    const auto first = along_.first_apart();
    fmt::format_to(out_, "\ns {} at {} = {}; critical {} {}\n", word, along_.parameter, short_text(along_.own, digits_),
                   along_.parameter, first ? end_text(first, digits_) : "none");
  }

  const MechanismScene& scene_;
  const UniquenessAlong& along_;
  int digits_;
  std::string text_;
  Out out_{text_};
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

std::string uniqueness_text(const MechanismScene& scene, const UniquenessAlong& along, int digits) {
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

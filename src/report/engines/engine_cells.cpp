#include "report/engines/engine_cells.hpp"

#include <fmt/format.h>

#include <array>
#include <numeric>

#include "report/html/sections.hpp"

namespace slipproof {

namespace {

constexpr std::array<std::string_view, engine_verdict_count> chips{"proved",    "holds",   "refuted",
                                                                   "undecided", "vacuous", "undecided"};
constexpr std::array<std::string_view, engine_verdict_count> signs{"✓ ", "≈ ", "✗ ", "? ", "– ", "! "};

/// The answers that can be judged: those that were not refused.
std::size_t answered(const EngineCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0}) -
         counts[static_cast<std::size_t>(EngineVerdict::refused)];
}

}  // namespace

std::string error_text(double error) {
  return fmt::format("{:.1e}", error);
}

std::string share_text(const EngineCounts& counts) {
  if (answered(counts) == 0) return "–";
  return fmt::format("{} of {}", counts[static_cast<std::size_t>(EngineVerdict::right)], answered(counts));
}

ReportCell by_design(ReportCell cell) {
  cell += ReportSpan(" ");
  cell += drawn("(its design, not a mistake)",
                [](const Element& parent) { parent.add("small", "design").text("its design, not a mistake"); });
  return cell;
}

void add_verdict(const Element& parent, EngineVerdict verdict, std::string_view words) {
  const auto i = static_cast<std::size_t>(verdict);
  add_chip(parent, chips[i], signs[i], words);
}

void add_sign(const Element& parent, EngineVerdict verdict) {
  const auto i = static_cast<std::size_t>(verdict);
  parent.add("span", "chip " + std::string(chips[i])).text(signs[i].substr(0, signs[i].size() - 1));
}

std::string verdict_words(const JudgedEngineAnswer& one) {
  const bool off = one.distance && one.verdict != EngineVerdict::right;
  return std::string(name(one.verdict)) + (off ? ", " + error_text(*one.distance) : "");
}

ReportCell verdict_cell(const JudgedEngineAnswer& one, const std::string& href) {
  std::string words = std::string(name(one.verdict));
  if (one.distance && one.verdict != EngineVerdict::right) words = error_text(*one.distance);
  return drawn(words, [=, verdict = one.verdict](const Element& cell) {
    add_verdict(href.empty() ? cell : cell.add("a").set("href", href), verdict, words);
  });
}

std::string impact_text(const JudgedEngineAnswer& one) {
  if (!one.energy_gained && one.laws.empty()) return {};
  std::string text;
  for (const ImpactLaw law : one.laws) text += (text.empty() ? "; right by " : ", ") + std::string(name(law));
  if (one.energy_gained) text += fmt::format("; energy {:+.4g} %", 100 * *one.energy_gained);
  return text;
}

std::string answer_text(const EngineAnswer& answer) {
  if (!answer.refused.empty()) return answer.refused;
  if (!answer.failed.empty()) return answer.failed;
  if (answer.threshold) {
    const EngineThreshold& found = *answer.threshold;
    return fmt::format("changes at {} = {:.8g}", found.parameter, found.changes_at) +
           (found.floor ? fmt::format(", where motion exceeds a floor of {:g}", *found.floor) : "");
  }
  std::string text;
  for (const auto& [steps, moved] : answer.drift) {
    text += fmt::format("{}{} of the size in {} step{}", text.empty() ? "moves by " : ", ", error_text(moved), steps,
                        steps == "1" ? "" : "s");
  }
  for (const auto& [steps, rise] : answer.energy) {
    text += fmt::format("{}{} in {} step{}", text.empty() ? "energy rises by " : ", ", error_text(rise), steps,
                        steps == "1" ? "" : "s");
  }
  for (const auto& [name, value] : answer.motion) {
    text += fmt::format("{}{} = {:.6g}", text.empty() ? "" : ", ", name, value);
  }
  return text;
}

}  // namespace slipproof

#include "report/picture/space/space_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "report/markup/symbol.hpp"
#include "report/picture/labels/contact_table.hpp"

namespace slipproof {

namespace {

constexpr double narrow_share = 1e-5;

std::vector<Range> numbers_of(const MechanismScene& scene, const std::vector<SpaceMotion>& motions) {
  std::vector<Range> all;
  for (const SpaceMotion& motion : motions) {
    for (const auto& force : motion.forces) {
      if (force) all.push_back(*force);
    }
  }
  if (scene.mechanism.load && scene.load) all.push_back({scene.load, scene.load});
  return all;
}

}  // namespace

std::string heading_of(const SpaceMotion& motion) {
  constexpr std::size_t longest = 34;
  std::string text = mode_of(motion);
  if (text.size() > longest) {
    std::vector<std::string> words;
    for (const char* mode : {"stick", "slip", "touch", "lift"}) {
      const auto count = std::ranges::count(motion.modes, mode);
      if (count > 0) words.push_back(fmt::format("{} {}", count, mode));
    }
    text = listed(words);
  }
  return text + (motion.strict ? "" : " (boundary)");
}

std::string counted_motions(const SolvedSpace& solved) {
  const std::string word = solved.scene.mechanism.impact ? "outcome" : "motion";
  if (solved.motions.empty() && !solved.complete()) return "no " + word + " found, and there may be some";
  const auto continua = static_cast<std::size_t>(std::ranges::count_if(solved.motions, &SpaceMotion::is_continuum));
  const std::size_t others = solved.motions.size() - continua;
  std::vector<std::string> words;
  if (others > 0 || continua == 0) words.push_back(others == 0 ? "no " + word : counted(others, word));
  if (continua == 1) words.push_back("a continuum of " + word + "s");
  if (continua > 1) words.push_back(fmt::format("{} continua of {}s", continua, word));
  return listed(words, " and ") + (solved.complete() ? "" : ", and there may be others");
}

std::string kind_of(const SpaceMotion& motion) {
  std::vector<std::string> words;
  if (motion.others_within) {
    words.emplace_back("others may be near");
  } else if (motion.is_continuum()) {
    words.emplace_back("one of a continuum");
  }
  if (!motion.open_directions) {
    words.emplace_back("forces may be open");
  } else if (motion.may_be_open()) {
    words.push_back("forces open along " + counted(*motion.open_directions, "direction"));
  }
  return listed(words);
}

std::string angle_text(const Range& degrees) {
  const auto one = [](double angle) {
    std::string text = fmt::format("{:.1f}°", angle);
    if (text == "-0.0°") text.erase(0, 1);
    if (text[0] == '-') text.replace(0, 1, "−");
    return text;
  };
  const double low = nearest_binary64(*degrees.lower), high = nearest_binary64(*degrees.upper);
  return high - low < 0.05 ? one((low + high) / 2) : "[" + one(low) + ", " + one(high) + "]";
}

double range_middle(const Range& range) {
  return nearest_binary64(*shown_value(range));
}

SpaceNumbers::SpaceNumbers(const MechanismScene& scene, const std::vector<SpaceMotion>& motions)
    : words_(numbers_of(scene, motions)) {
  for (const Range& range : numbers_of(scene, motions)) scale_ = std::max(scale_, std::abs(range_middle(range)));
}

bool SpaceNumbers::is_narrow(const Range& range) const {
  if (range.is_point()) return true;
  if (!range.lower || !range.upper) return false;
  return nearest_binary64(Rational(*range.upper - *range.lower)) <= narrow_share * scale_;
}

std::string SpaceNumbers::text(const std::optional<Range>& range) const {
  if (!range) return "open";
  if (range->is_point() || !is_narrow(*range)) return words_.range(*range);
  if (std::abs(range_middle(*range)) <= narrow_share * scale_) return "≈ 0";
  const std::string text = words_.value(*shown_value(*range));
  return "≈ " + text.substr(text.find(' ') + 1);
}

std::string SpaceNumbers::pair(const std::optional<Range>& first, const std::optional<Range>& second) const {
  std::string both = "(", sign = "= ";
  for (const auto* one : {&first, &second}) {
    std::string whole = text(*one);
    if (whole.starts_with("≈ ") || whole.starts_with("in ≈ ")) sign = "≈ ";
    for (const std::string_view prefix : {"in ", "= ", "≈ "}) {
      if (whole.starts_with(prefix)) whole.erase(0, prefix.size());
    }
    both += whole + (one == &first ? ", " : ")");
  }
  return sign + both;
}

std::vector<std::vector<std::string>> contact_rows(const MechanismScene& scene, const SpaceMotion* motion,
                                                   const SpaceNumbers& numbers, bool lettered) {
  const Mechanism& m = scene.mechanism;
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < m.contacts.size() && (motion != nullptr || lettered); ++i) {
    const MechanismContact& c = m.contacts[i];
    std::vector<std::string> row{lettered ? contact_letter(i) + "  " + c.name : c.name, {}, {}, {}};
    if (motion != nullptr) {
      const auto force = [&](std::size_t unknown) { return motion->forces[unknown - m.accelerations]; };
      row[1] = motion->modes[i] + (motion->slips[i] ? " at " + angle_text(*motion->slips[i]) : "");
      if (motion->modes[i] != "lift")
        row[2] = plain_symbol(force_symbol(m, i, c.normal)) + " " + numbers.text(force(c.normal));
      if (motion->modes[i] != "lift" && c.second)
        row[3] = "T " + numbers.pair(force(*c.tangent), force(c.second->force));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string force_symbol(const Mechanism& mechanism, std::size_t contact, std::size_t unknown) {
  std::string symbol = mechanism.unknowns[unknown].symbol;
  const std::string name = "_" + mechanism.contacts[contact].name;
  if (symbol.ends_with(name)) symbol.resize(symbol.size() - name.size());
  return symbol;
}

std::string contact_text(const MechanismScene& scene, const SpaceMotion* motion, std::size_t contact) {
  return scene.mechanism.contacts[contact].name + (motion == nullptr ? "" : ": " + motion->modes[contact]);
}

}  // namespace slipproof

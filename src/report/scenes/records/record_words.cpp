#include "report/scenes/records/record_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/input/utf8.hpp"
#include "base/number/format.hpp"
#include "base/number/parse.hpp"
#include "base/output/json.hpp"
#include "base/output/listed.hpp"
#include "base/output/terminal.hpp"

namespace slipproof {

namespace {

std::string text_at(const Json& object, const char* key) {
  return object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : std::string();
}

std::string joined(const Json& texts, std::string_view between = ", ") {
  return listed(
      texts, [](const Json& text) { return text.is_string() ? text.get<std::string>() : text.dump(); }, between);
}

/// `-3/250` as `-0.012`; what is no fraction stays.
std::string decimal_of(const Json& number) {
  if (!number.is_string()) return number.dump();
  try {
    return decimal_text(parse_rational(number.get<std::string>()), 6);
  } catch (const NumberError&) {
    return number.get<std::string>();
  }
}

/// `2.97`; a range whose ends do not say the same: `[2.96, 2.98]`.
std::string value_of(const Json& value) {
  if (!value.is_array()) return decimal_of(value);
  const std::string from = decimal_of(value.at(0)), to = decimal_of(value.at(1));
  return from == to ? from : "[" + from + "," + to + "]";
}

/// `a=2.97 N2=9.64`, at most eight of them.
std::string numbers_of(const Json& numbers) {
  constexpr std::size_t most = 8;
  std::string text;
  std::size_t shown = 0;
  for (const auto& [name, value] : numbers.items()) {
    if (shown == most) return text + ", ...";
    text += (shown++ == 0 ? "" : ", ") + name + "=" + value_of(value);
  }
  return text;
}

/// Writes one record.
class Words {
 public:
  Words(const Json& line, bool colours) : line_(line), colours_(colours) {}

  std::string whole() {
    const std::string verdict = text_at(line_, "verdict");
    text_ = fmt::format("record {}: {}\n", line_["record"].get<std::uint64_t>(),
                        colours_ ? emphasised(verdict, emphasis_of(verdict)) : verdict);
    add_nearest(verdict);
    add_wrong();
    add_others();
    add_found(verdict);
    if (verdict == "inaccurate") add_tolerance();
    if (line_.contains("remarks")) {
      for (const Json& remark : line_["remarks"]) say("Note: " + remark.get<std::string>() + ".");
    }
    return std::move(text_);
  }

 private:
  static Emphasis emphasis_of(const std::string& verdict) {
    constexpr std::array<std::string_view, 5> good{"certified", "unique", "solution within rho",
                                                   "velocities within rho", "velocities of a solution within rho"};
    constexpr std::array<std::string_view, 4> open{"ambiguous", "inaccurate", "eps-solution", "undecided"};
    const auto is_in = [&](const auto& words) { return std::ranges::find(words, verdict) != words.end(); };
    return is_in(good) ? Emphasis::good : is_in(open) ? Emphasis::open : Emphasis::bad;
  }

  void say(const std::string& sentence) { text_ += wrapped("  ", sentence); }

  bool is_problem() const { return line_.contains("solutions") || line_.contains("contacts"); }

  /// The motion or solution that the answer is.
  void add_nearest(const std::string& verdict) {
    if (const std::string rho = text_at(line_, "rho"); !rho.empty()) {
      say("An exact solution is within " + rho + " of the answer in each component.");
    }
    const std::string error = text_at(line_, "max_relative_error"), worst = text_at(line_, "worst");
    if (!line_.contains("modes") || line_["modes"].empty()) {
      if (!worst.empty()) say("The error is largest in " + worst + ".");
      return;
    }
    const bool only = verdict == "certified";
    say(fmt::format("It is {} {}{}, with a relative error of {}{}.", only ? "the one" : "the",
                    is_problem() ? "solution" : "motion", " " + joined(line_["modes"], " = "),
                    error.empty() ? "0" : "at most " + error, worst.empty() ? "" : ", in " + worst));
  }

  /// What a wrong answer violates, and other reasons.
  void add_wrong() {
    const std::string claimed = text_at(line_, "claimed"), suggested = text_at(line_, "looks_like"),
                      violated = text_at(line_, "violated"), reason = text_at(line_, "reason");
    std::string start = claimed.empty() ? suggested.empty() ? "It" : "It suggests the mode " + suggested
                                        : "It claims the mode " + claimed;
    if (!violated.empty()) {
      say(start + (start == "It" ? "" : ", which") + " violates " + violated + ": the margin is " +
          decimal_of(line_["margin"]) + ".");
    } else if (line_.contains("because")) {
      say(start + ", in which " + joined(line_["because"], " and ") + " cannot hold together.");
    } else if (!reason.empty()) {
      say(start == "It" ? reason + "." : start + ": " + reason + ".");
    }
    if (line_.contains("worst") && line_["worst"].is_array() && text_at(line_, "rho").empty()) {
      for (const Json& one : line_["worst"]) {
        say(fmt::format("{} {} violates {} by {}.", one.contains("contact") ? "Contact" : "Row",
                        (one.contains("contact") ? one["contact"] : one["row"]).dump(), text_at(one, "violates"),
                        text_at(one, "by")));
      }
    }
    if (const std::string law = text_at(line_, "right_for"); !law.empty()) {
      say("It is right for the " + law + ": not the answer, but the law is another.");
    }
  }

  void add_others() {
    if (const std::string left = text_at(line_, "unexamined"); !left.empty()) say("Not examined: " + left + ".");
    if (!text_at(line_, "others").empty()) say("It is not proved that there is no other.");
  }

  /// All motions or solutions, where the verdict depends on them.
  void add_found(const std::string& verdict) {
    if (!line_.contains("found") || verdict == "certified") return;
    const std::string noun = is_problem() ? "solution" : "motion";
    const Json& found = line_["found"];
    if (found.empty() && !line_.contains("continua")) return say("There is no " + noun + ".");
    say(counted(found.size(), noun) + (found.size() == 1 ? " exists:" : " exist:"));
    constexpr std::size_t most = 8;
    for (std::size_t i = 0; i < std::min(most, found.size()); ++i) {
      const Json& modes = found[i].contains("modes") ? found[i]["modes"] : Json::array();
      const Json& shown = modes.empty() && found[i].contains("boundary_modes") ? found[i]["boundary_modes"] : modes;
      const std::string numbers = found[i].contains("accelerations") ? numbers_of(found[i]["accelerations"]) : "";
      text_ += wrapped("    ", joined(shown, " = ") + (numbers.empty() ? "" : ": " + numbers));
    }
    if (found.size() > most) say(fmt::format("  and {} more", found.size() - most));
    if (line_.contains("continua")) say("Continua: " + joined(line_["continua"]) + ".");
  }

  void add_tolerance() {
    std::string error = text_at(line_, "error");
    if (error.empty()) error = text_at(line_, "max_relative_error");
    say(tolerance_advice(error.empty() ? "0.01" : error));  // within a hundredth, as inaccurate says
  }

  const Json& line_;
  const bool colours_;
  std::string text_;
};

}  // namespace

std::string record_words(std::string_view lines, bool colours) {
  std::string text;
  for (std::size_t end = 0; !lines.empty(); lines.remove_prefix(end + 1)) {
    end = lines.find('\n');
    text += Words(Json::parse(lines.substr(0, end)), colours).whole();
  }
  return text;
}

std::string tolerance_advice(const std::string& error) {
  return "To accept it: --tolerance " + error + ".";
}

}  // namespace slipproof

#include "records/engines/engine_answers.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

#include "base/input/text_file.hpp"

namespace slipproof {

namespace {

using Line = nlohmann::json;

/// Reads one line; what is wrong goes to `mistakes`.
class AnswerReader {
 public:
  AnswerReader(const Line& line, Place place, Mistakes& mistakes) : line_(line), place_(place), mistakes_(mistakes) {}

  EngineAnswer read() {
    EngineAnswer answer;
    answer.place = place_;
    if (text("schema", true) != "slipproof/engine-answer/1") wrong("schema", "\"slipproof/engine-answer/1\"");
    answer.engine = text("engine", true);
    answer.version = text("version", false);
    answer.scene = text("scene", true);
    answer.asked = text("asked", true);
    answer.law = text("law", false);
    answer.date = text("date", false);
    answer.refused = text("refused", false);
    answer.failed = text("failed", false);
    if (line_.contains("settings")) answer.settings = line_["settings"].dump();
    if (line_.contains("motion") && answer.failed.empty()) read_motion(answer);
    if (line_.contains("changes_at")) {
      answer.threshold = {text("parameter", true), number("changes_at"), number("within"), {}};
      if (line_.contains("floor")) answer.threshold->floor = number("floor");
    }
    read_by_steps("drift", answer.drift);
    read_by_steps("energy", answer.energy);
    const bool says_why = !answer.refused.empty() || !answer.failed.empty();
    if (answer.motion.empty() && !answer.threshold && answer.drift.empty() && answer.energy.empty() && !says_why) {
      mistakes_.add(place_, "found no motion, changes_at, drift, energy, refused or failed, expected one of them");
    }
    return answer;
  }

 private:
  void wrong(const char* key, const std::string& expected) {
    mistakes_.add(place_, std::string(key) + ": found " + (line_.contains(key) ? line_[key].dump() : "nothing") +
                              ", expected " + expected);
  }

  std::string text(const char* key, bool needed) {
    const auto found = line_.find(key);
    if (found != line_.end() && found->is_string()) return found->get<std::string>();
    if (needed || (found != line_.end() && !found->is_null())) wrong(key, "a text");
    return {};
  }

  double number(const char* key) {
    const auto found = line_.find(key);
    if (found != line_.end() && found->is_number()) return found->get<double>();
    wrong(key, "a number");
    return 0;
  }

  /// JSON has no NaN: adapters write null.
  void read_motion(EngineAnswer& answer) {
    const Line& motion = line_["motion"];
    if (!motion.is_object()) return wrong("motion", "an object of numbers");
    for (const auto& [name, value] : motion.items()) {
      if (value.is_null()) {
        answer.failed = name + " is not finite";
      } else if (value.is_number()) {
        answer.motion.emplace_back(name, value.get<double>());
      } else {
        wrong("motion", "an object of numbers");
      }
    }
    if (!answer.failed.empty()) answer.motion.clear();
  }

  /// Numbers by the number of steps.
  void read_by_steps(const char* key, std::map<std::string, double>& values) {
    if (!line_.contains(key)) return;
    const Line& given = line_[key];
    if (!given.is_object()) return wrong(key, "an object of numbers");
    for (const auto& [steps, value] : given.items()) {
      if (!value.is_number()) return wrong(key, "an object of numbers");
      values.emplace(steps, value.get<double>());
    }
  }

  const Line& line_;
  const Place place_;
  Mistakes& mistakes_;
};

}  // namespace

std::vector<EngineAnswer> read_engine_answers(const std::filesystem::path& path) {
  constexpr std::size_t longest = 1U << 26U;
  std::istringstream text(read_text_file(path, longest));
  Mistakes mistakes(path.string());
  std::vector<EngineAnswer> answers;
  std::string line;
  for (std::size_t number = 1; std::getline(text, line); ++number) {
    if (line.find_first_not_of(" \t\r") == line.npos) continue;
    const Line parsed = Line::parse(line, nullptr, false);
    if (!parsed.is_object()) {
      mistakes.add({number, 0}, "found no JSON object, expected an answer of an engine");
      continue;
    }
    answers.push_back(AnswerReader(parsed, {number, 0}, mistakes).read());
  }
  mistakes.refuse_if_any();
  return answers;
}

}  // namespace slipproof

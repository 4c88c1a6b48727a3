#include "records/problems/problem_reader.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/input/json_words.hpp"
#include "base/number/binary64.hpp"
#include "base/number/parse.hpp"
#include "contact/formats/problem_check.hpp"
#include "records/reading/record_reader.hpp"

namespace slipproof {

namespace {

/// A number as written, or a list.
struct Value {
  std::string text;
  std::size_t column = 0;  ///< for a word that is not JSON
  std::vector<Value> list;
  bool is_list = false, is_text = false;
};

/// nlohmann's SAX interface: keeps numbers as they were written.
class ProblemJson {
 public:
  ProblemJson(const JsonLine& line, bool ignore_unknown) : texts_(line.texts), ignore_unknown_(ignore_unknown) {}

  /// Nothing if the key is missing.
  const Value* find(std::string_view key) const {
    for (const auto& [name, value] : values_) {
      if (name == key) return &value;
    }
    return nullptr;
  }

  bool null() { return refuse("null"); }
  bool boolean(bool) { return refuse("a truth value"); }
  bool number_integer(std::int64_t x) { return put(std::to_string(x)); }
  bool number_unsigned(std::uint64_t x) { return put(std::to_string(x)); }
  bool number_float(double, const std::string& text) { return put(text); }
  bool string(std::string& text) {
    const JsonWord& word = texts_[next_text_++];
    return word.column == 0 ? put(text, true) : put(std::string(word.text), false, word.column);
  }
  bool binary(std::vector<std::uint8_t>&) { return refuse("binary data"); }
  bool start_object(std::size_t) {
    if (!begun_) return begun_ = true;
    return refuse("an object");
  }
  bool end_object() { return true; }
  bool start_array(std::size_t) {
    if (!begun_) return refuse("a list");
    if (open_.size() == 2) refuse("a list in a list in a list");
    Value& value = next();
    value.is_list = true;
    open_.push_back(&value);
    return true;
  }
  bool end_array() {
    open_.pop_back();
    return true;
  }
  bool key(std::string& name) {
    const JsonWord& word = texts_[next_text_++];
    if (word.column != 0) throw BrokenRecord{word.column, "found " + std::string(word.text) + ", expected a key"};
    if (find(name) != nullptr) throw BrokenRecord{0, "found " + in_quotes(name) + " twice, expected it once"};
    constexpr std::array<std::string_view, 11> known{"W", "M", "q",    "mu",        "z",    "w",
                                                     "r", "u", "mode", "dimension", "title"};
    if (!ignore_unknown_ && std::find(known.begin(), known.end(), name) == known.end()) {
      throw BrokenRecord{0, "found the key " + in_quotes(name) +
                                ", expected W or M, q, mu, dimension, z (or r), w (or u), mode or title"};
    }
    values_.emplace_back(name, Value());
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) {
    const std::string_view message = error.what();
    throw BrokenRecord{position, "found no JSON object: " + std::string(message.substr(message.find(':') + 2))};
  }

 private:
  Value& next() {
    if (open_.empty()) return values_.back().second;
    return open_.back()->list.emplace_back();
  }
  bool put(std::string text, bool is_text = false, std::size_t column = 0) {
    if (!begun_) return refuse("a bare value");
    Value& value = next();
    value.text = std::move(text);
    value.is_text = is_text;
    value.column = column;
    return true;
  }
  bool refuse(const std::string& found) const {
    const std::string where = values_.empty() ? "" : values_.back().first + ": ";
    throw BrokenRecord{0, where + "found " + found + ", expected " + (begun_ ? "numbers" : "an object")};
  }

  const std::vector<JsonWord>& texts_;
  std::size_t next_text_ = 0;
  bool ignore_unknown_, begun_ = false;
  std::vector<std::pair<std::string, Value>> values_;
  std::vector<Value*> open_;
};

class ProblemReader {
 public:
  ProblemReader(const ProblemJson& json, bool decimal_exact) : json_(json), decimal_exact_(decimal_exact) {}

  ProblemRecord read() {
    ProblemRecord record;
    ContactProblem& problem = record.problem;
    problem.q = numbers(need("q"), "q");
    const bool is_M = json_.find("M") != nullptr;
    if (is_M && json_.find("W") != nullptr) throw BrokenRecord{0, "found W and M, expected one of them"};
    const char* matrix = is_M ? "M" : "W";
    const Value& rows = need(matrix);
    if (!rows.is_list) throw BrokenRecord{0, std::string(matrix) + ": found no list, expected a list of rows"};
    for (std::size_t i = 0; i < rows.list.size(); ++i) {
      problem.W.push_back(numbers(rows.list[i], matrix + place(i)));
    }
    if (const Value* mu = json_.find("mu")) {
      // A single number is for all contacts.
      problem.mu = mu->is_list ? numbers(*mu, "mu") : std::vector<Rational>(problem.size() / 2, number(*mu, "mu"));
      if (json_.find("dimension") == nullptr) need_planar(problem, mu->is_list);
    }
    refuse_dimension(problem.frictional());
    if (const std::string reason = mistake_in(problem); !reason.empty()) throw BrokenRecord{0, reason};

    answer_ = true;
    const std::string z = one_of("z", "r"), w = one_of("w", "u");
    record.answer.z = sized(numbers(need(z), z), z, problem.size());
    if (const Value* value = json_.find(w)) record.answer.w = sized(numbers(*value, w), w, problem.size());
    if (const Value* mode = json_.find("mode")) {
      if (mode->is_text) record.answer.mode = parse_mode(problem, mode->text);
      if (!record.answer.mode) {
        throw BrokenRecord{0, "mode: found " + in_quotes(mode->text) + ", expected " +
                                  (problem.frictional() ? "states like stick/slip+/lift, one for each contact"
                                                        : "letters z and w, one for each component")};
      }
    }
    record.not_finite = not_finite_;
    return record;
  }

 private:
  /// Refuses other dimensions, which the reader of larger problems reads; and dimension 2 without friction.
  void refuse_dimension(bool frictional) const {
    const Value* dimension = json_.find("dimension");
    if (dimension == nullptr || (dimension->text == "2" && frictional)) return;
    const std::string found = dimension->is_list ? "a list" : dimension->text + (frictional ? "" : " without mu");
    throw BrokenRecord{0, "dimension: found " + found + ", expected 2 with mu, 3 with mu, or none"};
  }

  /// If no key gives the dimension, the sizes do; refuses all but planar contacts.
  static void need_planar(const ContactProblem& problem, bool one_each) {
    const DimensionBySizes found =
        dimension_by_sizes(problem.size(), one_each ? std::optional<std::size_t>(problem.mu.size()) : std::nullopt);
    if (!found.mistake.empty()) throw BrokenRecord{0, found.key + ": " + found.mistake};
    if (found.dimension == 2) return;
    throw BrokenRecord{0,
                       "dimension: found nothing, and contacts of 3 components, expected \"dimension\": 3 for those"};
  }

  static std::string place(std::size_t i) { return "[" + std::to_string(i + 1) + "]"; }

  /// Problems at real size have other keys for the parts of an answer.
  std::string one_of(const char* usual, const char* other) const {
    if (json_.find(other) == nullptr) return usual;
    if (json_.find(usual) == nullptr) return other;
    throw BrokenRecord{0, std::string("found ") + usual + " and " + other + ", expected one of them"};
  }

  const Value& need(const std::string& key) const {
    const Value* value = json_.find(key);
    if (value == nullptr) throw BrokenRecord{0, "found no " + key + ", expected W, q and z"};
    return *value;
  }

  static std::vector<Rational> sized(std::vector<Rational> values, const std::string& key, std::size_t size) {
    if (values.size() == size) return values;
    throw BrokenRecord{0, key + ": found " + std::to_string(values.size()) + " components, expected " +
                              std::to_string(size) + " as in q"};
  }

  std::vector<Rational> numbers(const Value& value, const std::string& where) {
    if (!value.is_list) throw BrokenRecord{0, where + ": found no list, expected a list of numbers"};
    std::vector<Rational> result;
    for (std::size_t i = 0; i < value.list.size(); ++i) result.push_back(number(value.list[i], where + place(i)));
    return result;
  }

  Rational number(const Value& value, const std::string& where) {
    if (value.is_list) throw BrokenRecord{0, where + ": found a list, expected a number"};
    try {
      const Rational exact = parse_rational(value.text);
      if (decimal_exact_ || !is_decimal(value.text)) return exact;
      const double rounded = nearest_binary64(exact);
      if (std::isfinite(rounded)) return to_rational(rounded);
      if (!answer_)
        throw BrokenRecord{0, where + ": found " + value.text + ", expected a number that binary64 can hold"};
    } catch (const NumberError& error) {
      // NaN and infinities are possible values of a solver, although they are not JSON numbers.
      std::string lower = value.text;
      for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      if (lower.starts_with('-') || lower.starts_with('+')) lower.erase(0, 1);
      const bool special = lower == "nan" || lower == "inf" || lower == "infinity";
      if (!answer_ || !special) throw BrokenRecord{value.column, where + ": " + error.what()};
    }
    const bool is_number = value.text.find_first_of("0123456789") != std::string::npos;
    if (!not_finite_) {
      not_finite_ = {value.column,
                     where + ": found " + value.text +
                         (is_number ? ", expected a number that binary64 can hold" : ", expected a finite number")};
    }
    return 0;
  }

  const ProblemJson& json_;
  bool decimal_exact_, answer_ = false;
  std::optional<NotFinite> not_finite_;
};

}  // namespace

bool is_problem(std::string_view line) {
  const std::size_t key = line.find("\"q\"");
  if (key == std::string_view::npos) return false;
  const auto after = [&](std::size_t from, char c) {
    const std::size_t at = line.find_first_not_of(" \t", from);
    return at != std::string_view::npos && line[at] == c ? at + 1 : 0;
  };
  const std::size_t colon = after(key + 3, ':');
  return colon != 0 && after(colon, '[') != 0;
}

ProblemRecord read_problem(std::string_view line, bool decimal_exact, bool ignore_unknown) {
  const JsonLine plain = without_words(line);
  ProblemJson json(plain, ignore_unknown);
  nlohmann::json::sax_parse(plain.text, &json);
  return ProblemReader(json, decimal_exact).read();
}

}  // namespace slipproof

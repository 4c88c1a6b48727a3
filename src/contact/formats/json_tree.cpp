#include "contact/formats/json_tree.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/files/words.hpp"
#include "base/input/json_words.hpp"
#include "base/number/binary64.hpp"
#include "base/number/parse.hpp"

namespace slipproof {

namespace {

JsonNode number_node(double x) {
  JsonNode node;
  node.kind = JsonNode::Kind::number;
  node.number = x;
  return node;
}

/// nlohmann's SAX interface, which does not recurse.
class JsonTreeReader {
 public:
  JsonTreeReader(const JsonLine& json, std::string_view text, const std::string& file)
      : words_(json.texts), text_(text), file_(file) {}

  JsonNode take() {
    if (root_.items.empty() || root_.items[0].kind != JsonNode::Kind::object) {
      refuse(file_, "found no object, expected one in { }");
    }
    return std::move(root_.items[0]);
  }

  bool null() { return put({}); }
  bool boolean(bool) { return put({}); }
  bool number_integer(std::int64_t x) { return number(static_cast<double>(x)); }
  bool number_unsigned(std::uint64_t x) { return number(static_cast<double>(x)); }
  bool number_float(double, const std::string& digits) { return number(read_binary64(digits).value_or(0)); }
  bool string(std::string& text) {
    const JsonWord& word = words_[next_word_++];
    if (word.column != 0) return number(*read_binary64(word.text));
    JsonNode node;
    node.kind = JsonNode::Kind::text;
    node.text = text;
    return put(std::move(node));
  }
  bool binary(std::vector<std::uint8_t>&) { return put({}); }
  bool start_object(std::size_t) { return start(JsonNode::Kind::object); }
  bool end_object() { return end(); }
  bool start_array(std::size_t) { return start(JsonNode::Kind::list); }
  bool end_array() { return end(); }
  bool key(std::string& name) {
    const JsonWord& word = words_[next_word_++];
    if (word.column != 0)
      refuse(file_, text_, {word.column - 1, "found " + std::string(word.text) + ", expected a key"});
    std::vector<std::string>& keys = open_.back()->keys;
    if (std::ranges::find(keys, name) != keys.end()) {
      refuse(file_, "found the key " + in_quotes(name) + " twice, expected it once");
    }
    keys.push_back(name);
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) {
    const std::string_view message = error.what();
    const std::size_t colon = std::min(message.find(": "), message.size() - 2);
    refuse(file_, text_,
           {std::min(position - std::min<std::size_t>(position, 1), text_.size()),
            "found no JSON object: " + std::string(message.substr(colon + 2))});
  }

 private:
  bool number(double x) {
    JsonNode& list = *open_.back();
    if (list.kind != JsonNode::Kind::list || !list.items.empty()) return put(number_node(x));
    list.numbers.push_back(x);
    return true;
  }
  bool put(JsonNode node) {
    JsonNode& to = *open_.back();
    for (const double x : to.numbers) to.items.push_back(number_node(x));
    to.numbers.clear();
    to.items.push_back(std::move(node));
    return true;
  }
  bool start(JsonNode::Kind kind) {
    if (open_.size() > 8) refuse(file_, "found values nested more than 8 deep, expected lists of numbers");
    JsonNode node;
    node.kind = kind;
    put(std::move(node));
    open_.push_back(&open_.back()->items.back());
    return true;
  }
  bool end() {
    open_.pop_back();
    return true;
  }

  const std::vector<JsonWord>& words_;
  std::size_t next_word_ = 0;
  std::string_view text_;
  const std::string& file_;
  JsonNode root_;  ///< a list of the one value
  std::vector<JsonNode*> open_ = {&root_};
};

}  // namespace

const JsonNode* JsonNode::find(std::string_view key) const {
  const auto at = std::ranges::find(keys, key);
  return at == keys.end() ? nullptr : &items[static_cast<std::size_t>(at - keys.begin())];
}

JsonNode JsonNode::item(std::size_t k) const {
  return numbers.empty() ? items[k] : number_node(numbers[k]);
}

JsonNode read_json_tree(std::string_view text, const std::string& file) {
  const JsonLine plain = without_words(text);
  JsonTreeReader reader(plain, text, file);
  nlohmann::json::sax_parse(plain.text, &reader);
  return reader.take();
}

double JsonNumbers::number(const JsonNode& node, const std::string& where, bool any) const {
  double value = node.number;
  if (node.kind == JsonNode::Kind::text) {
    const std::optional<double> decimal = read_binary64(node.text);
    try {
      // Beyond the decimals are fractions and hexadecimal numbers, which claim to be exact.
      const Rational exact = decimal ? Rational(0) : parse_rational(node.text);
      value = decimal ? *decimal : nearest_binary64(exact);
      if (!decimal && std::isfinite(value) && to_rational(value) != exact) ++rounded_;
    } catch (const NumberError& error) {
      refuse(where, error.what());
    }
  } else if (node.kind != JsonNode::Kind::number) {
    refuse(where, "found no number, expected one");
  }
  if (!any && !std::isfinite(value)) {
    refuse(where, std::string("found ") + (std::isnan(value) ? "NaN" : "an infinity, or a number that becomes one") +
                      ", expected a finite number within binary64's range");
  }
  return value;
}

std::vector<double> JsonNumbers::list(const JsonNode& node, const std::string& where, bool any) const {
  if (node.kind != JsonNode::Kind::list) refuse(where, "found no list, expected a list of numbers");
  std::vector<double> result = node.numbers;
  const auto place = [&](std::size_t k) { return where + "[" + std::to_string(k + 1) + "]"; };
  for (std::size_t k = 0; k < result.size() && !any; ++k) {
    if (!std::isfinite(result[k])) number(number_node(result[k]), place(k));
  }
  for (std::size_t k = 0; k < node.items.size(); ++k) result.push_back(number(node.items[k], place(k), any));
  return result;
}

std::size_t JsonNumbers::count(const JsonNode& node, const std::string& where) const {
  const double x = number(node, where);
  if (x < 0 || x > 0x1p53 || x != std::floor(x)) refuse(where, "found no count, expected 0, 1, 2, ...");
  return static_cast<std::size_t>(x);
}

void JsonNumbers::refuse(const std::string& where, const std::string& message) const {
  slipproof::refuse(file_, where + ": " + message);
}

}  // namespace slipproof

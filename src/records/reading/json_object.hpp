// Reads a line of JSON with numbers and texts under its keys.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/input/json_words.hpp"
#include "records/record/cells.hpp"

namespace slipproof {

/// nlohmann's SAX interface: keeps numbers as they were written. Sink has key(name), which returns the column of a key,
/// or ignored_column, and put(column, text, place). Throws BrokenRecord.
template <class Sink>
class JsonObject {
 public:
  static void read(std::string_view line, Sink& sink) {
    const JsonLine plain = without_words(line);
    JsonObject object(sink, plain);
    nlohmann::json::sax_parse(plain.text, &object);
  }

  bool null() { return true; }
  bool boolean(bool) { return refuse("a truth value"); }
  bool number_integer(std::int64_t x) { return put(std::to_string(x)); }
  bool number_unsigned(std::uint64_t x) { return put(std::to_string(x)); }
  bool number_float(double, const std::string& text) { return put(text); }
  bool string(std::string& text) {
    const JsonWord& word = texts_[next_text_++];
    return word.column == 0 ? put(text) : put(word.text, word.column);
  }
  bool binary(std::vector<std::uint8_t>&) { return refuse("binary data"); }
  bool start_object(std::size_t) {
    if (depth_++ == 0) return true;
    return refuse("an object");
  }
  bool end_object() { return true; }
  bool start_array(std::size_t) { return refuse("a list"); }
  bool end_array() { return true; }
  bool key(std::string& name) {
    const JsonWord& word = texts_[next_text_++];
    if (word.column != 0) throw BrokenRecord{word.column, "found " + std::string(word.text) + ", expected a key"};
    name_ = name;
    column_ = sink_.key(name);
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) {
    const std::string_view message = error.what();
    throw BrokenRecord{position, "found no JSON object: " + std::string(message.substr(message.find(':') + 2))};
  }

 private:
  JsonObject(Sink& sink, const JsonLine& line) : sink_(sink), texts_(line.texts) {}

  bool refuse(const std::string& found) const {
    if (depth_ > 0 && column_ == ignored_column && !name_.empty()) {
      throw BrokenRecord{
          0, "found " + found + " under the ignored key " + in_quotes(name_) + ", expected a number or a text"};
    }
    throw BrokenRecord{0, "found " + found + ", expected an object of numbers"};
  }
  bool put(std::string_view text, std::size_t place = 0) {
    if (depth_ == 0) return refuse("a bare value");
    if (column_ != ignored_column) sink_.put(column_, text, place);
    return true;
  }

  Sink& sink_;
  const std::vector<JsonWord>& texts_;
  std::size_t next_text_ = 0;
  int depth_ = 0, column_ = ignored_column;
  std::string name_;
};

}  // namespace slipproof

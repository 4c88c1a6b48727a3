#include "certify/record_reader.hpp"

#include <fast_float/fast_float.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "certify/json_words.hpp"
#include "number/binary64.hpp"
#include "number/parse.hpp"

namespace slipproof {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return text;
}

}  // namespace

std::string place_text(std::uint64_t line, std::size_t column) {
  return "line " + std::to_string(line) + (column == 0 ? "" : ", column " + std::to_string(column)) + ": ";
}

bool is_decimal(std::string_view text) {
  return text.find_first_of("/xXpP") == std::string_view::npos;
}

RecordReader::RecordReader(const CertifyOptions& options, std::string_view header)
    : options_(options), csv_(options.format != RecordFormat::json_lines) {
  if (options.scene) base_ = to_record(*options.scene);
  if (csv_) read_header(header);
}

void RecordReader::read_header(std::string_view header) {
  Mistakes mistakes(options_.file);
  if (header.substr(0, 3) == "\xEF\xBB\xBF") header.remove_prefix(3);
  std::uint32_t seen = 0;
  bool mode = false, kind = false;
  std::size_t place = 1;
  while (true) {
    const std::size_t comma = header.find(',');
    const std::string_view name = trimmed(header.substr(0, comma));
    int column = ignored_column;
    bool twice = false;
    if (const auto field = parse_field(name)) {
      column = static_cast<int>(index(*field));
      twice = (seen & bit(*field)) != 0;
      seen |= bit(*field);
    } else if (name == "mode") {
      column = mode_column;
      twice = std::exchange(mode, true);
    } else if (name == "kind") {
      column = kind_column;
      twice = std::exchange(kind, true);
    } else if (!options_.ignore_unknown) {
      mistakes.add({1, place},
                   "found the column " + in_quotes(name) + ", expected a parameter or a part of the answer");
    }
    if (twice) mistakes.add({1, place}, "found the column " + in_quotes(name) + " twice, expected it once");
    columns_.push_back(column);
    if (comma == std::string_view::npos) break;
    place += comma + 1;
    header.remove_prefix(comma + 1);
  }
  Record all = base_;
  for (const int column : columns_) {
    if (column >= 0) all.replace_other_forms(static_cast<Field>(column));
  }
  base_.present = all.present;
  complete_ = all.present | seen;
  if (const std::string reason = incomplete(complete_); !reason.empty()) mistakes.add({1, 1}, reason);
  mistakes.refuse_if_any();
}

void RecordReader::put(Record& record, int column, std::string_view text, std::size_t place) const {
  if (column == mode_column) {
    if (text.empty()) return;
    record.mode = parse_mode(text);
    if (!record.mode)
      throw BrokenRecord{place, "found the mode " + in_quotes(text) + ", expected one like stick/slip+"};
    return;
  }
  if (column == kind_column) {
    if (text != "internal" && text != "external") {
      throw BrokenRecord{place, "found the kind " + in_quotes(text) + ", expected internal or external"};
    }
    record.force_kind = text == "internal" ? ForceKind::internal : ForceKind::external;
    return;
  }
  const auto field = static_cast<Field>(column);
  put_number(record, field, text, place);
  const double value = record[field];
  if (std::isfinite(value) || record.not_finite) return;
  record.not_finite = {place, std::string(field_names[index(field)]) + ": found " +
                                  (std::isnan(value) ? "NaN" : "infinity or a number beyond the largest binary64") +
                                  ", expected a finite number"};
}

void RecordReader::put_number(Record& record, Field field, std::string_view text, std::size_t place) const {
  if (!options_.decimal_exact || !is_decimal(text)) {
    double value = 0;
    const char* begin = text.data() + (text.size() > 1 && text.front() == '+' ? 1 : 0);
    const auto [end, error] = fast_float::from_chars(begin, text.data() + text.size(), value);
    if (error == std::errc() && end == text.data() + text.size() && (begin == text.data() || *begin != '-')) {
      record.set(field, value);
      return;
    }
  }
  try {
    const Rational exact = parse_rational(text);
    if (is_decimal(text) && !options_.decimal_exact) {
      record.set(field, nearest_binary64(exact));
    } else {
      record.set(field, exact);
    }
  } catch (const NumberError& error) {
    double value = 0;  // NaN and infinities are values of a solver, though no numbers
    const auto [end, code] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || std::isfinite(value)) {
      throw BrokenRecord{place == 0 ? 0 : place + error.position(),
                         std::string(field_names[index(field)]) + ": " + error.what()};
    }
    record.set(field, value);
  }
}

/// The scene's parameters, their exact values by reference.
Record RecordReader::fresh() const {
  Record record;
  record.values = base_.values;
  record.present = base_.present;
  record.force_kind = base_.force_kind;
  record.base = &base_;
  return record;
}

Record RecordReader::read_csv(std::string_view line) const {
  Record record = fresh();
  const char* at = line.data();
  const char* const end = at + line.size();
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const bool last = i + 1 == columns_.size();
    const int column = columns_[i];
    if (column >= 0 && !options_.decimal_exact) {  // the usual cell: a decimal, then a comma or the end
      double value = 0;
      const auto [stop, error] = fast_float::from_chars(at, end, value);
      if (error == std::errc() && std::isfinite(value) && (last ? stop == end : stop != end && *stop == ',')) {
        record.set(static_cast<Field>(column), value);
        at = last ? end : stop + 1;
        continue;
      }
    }
    const auto rest = std::string_view(at, static_cast<std::size_t>(end - at));
    const std::size_t comma = rest.find(',');
    const std::size_t place = static_cast<std::size_t>(at - line.data()) + 1;
    if ((comma == std::string_view::npos) != last) {
      throw BrokenRecord{place, "found " + std::string(last ? "more" : "fewer") + " cells, expected " +
                                    std::to_string(columns_.size()) + " as in the header"};
    }
    const std::string_view cell = trimmed(rest.substr(0, comma));
    if (!cell.empty() || column < 0) {
      if (column != ignored_column) put(record, column, cell, place);
    }
    if (!last) at += comma + 1;
  }
  // An empty cell leaves what the scene says, and may leave nothing.
  if (record.present == complete_) return record;
  if (const std::string reason = incomplete(record.present); !reason.empty()) throw BrokenRecord{1, reason};
  return record;
}

/// nlohmann's SAX interface: numbers as they were written.
class JsonRecord {
 public:
  JsonRecord(const RecordReader& reader, const JsonLine& line)
      : reader_(reader), texts_(line.texts), record_(reader.fresh()) {}
  Record take() { return std::move(record_); }

  bool null() { return skip(); }
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
    column_ = RecordReader::ignored_column;
    if (const auto field = parse_field(name)) {
      column_ = static_cast<int>(index(*field));
      if ((seen_ & bit(*field)) != 0) throw BrokenRecord{0, "found " + in_quotes(name) + " twice, expected it once"};
      seen_ |= bit(*field);
      // Over the scene's own forms only: two forms in one record are a mistake, which incomplete() reports.
      const auto here = record_.present & seen_;
      record_.replace_other_forms(*field);
      record_.present |= here;
    } else if (name == "mode") {
      column_ = RecordReader::mode_column;
    } else if (name == "kind") {
      column_ = RecordReader::kind_column;
    } else if (!reader_.options_.ignore_unknown) {
      throw BrokenRecord{0, "found the key " + in_quotes(name) + ", expected a parameter or a part of the answer"};
    }
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) {
    const std::string_view message = error.what();
    throw BrokenRecord{position, "found no JSON object: " + std::string(message.substr(message.find(':') + 2))};
  }

 private:
  bool skip() const { return true; }
  bool refuse(const std::string& found) const {
    if (depth_ > 0 && column_ == RecordReader::ignored_column && !name_.empty()) {
      throw BrokenRecord{
          0, "found " + found + " under the ignored key " + in_quotes(name_) + ", expected a number or a text"};
    }
    throw BrokenRecord{0, "found " + found + ", expected an object of numbers"};
  }
  bool put(std::string_view text, std::size_t place = 0) {
    if (depth_ == 0) return refuse("a bare value");
    if (column_ != RecordReader::ignored_column) reader_.put(record_, column_, text, place);
    return true;
  }

  const RecordReader& reader_;
  const std::vector<JsonWord>& texts_;
  std::size_t next_text_ = 0;
  Record record_;
  int depth_ = 0, column_ = RecordReader::ignored_column;
  std::uint32_t seen_ = 0;
  std::string name_;
};

Record RecordReader::read_json(std::string_view line) const {
  const JsonLine plain = without_words(line);
  JsonRecord json(*this, plain);
  nlohmann::json::sax_parse(plain.text, &json);
  Record record = json.take();
  if (const std::string reason = incomplete(record.present); !reason.empty()) throw BrokenRecord{0, reason};
  return record;
}

}  // namespace slipproof

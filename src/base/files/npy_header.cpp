#include "base/files/npy_header.hpp"

#include <charconv>
#include <optional>
#include <utility>

#include "base/files/words.hpp"

namespace slipproof {

namespace {

/// A Python value of the kinds that headers contain: texts, whole numbers, words, tuples and lists.
struct Literal {
  enum class Kind : std::uint8_t { text, number, word, list } kind = Kind::word;
  std::string text;            ///< of a text, a word or a number
  std::vector<Literal> items;  ///< of a list or a tuple; of a dictionary keys and values by turns
};

class LiteralReader {
 public:
  explicit LiteralReader(std::string_view text) : text_(text) {}

  /// The whole text; nothing where it is no literal.
  std::optional<Literal> whole() {
    std::optional<Literal> value = read(0);
    if (!value || peek() != '\0') return std::nullopt;
    return value;
  }
  std::size_t position() const { return at_; }

 private:
  static constexpr int deepest = 16;

  char peek() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\t')) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  std::optional<Literal> read(int depth) {
    const char c = peek();
    if (depth > deepest) return std::nullopt;
    if (c == '\'' || c == '"') return quoted(c);
    if (c == '{') return list('}', depth);
    if (c == '[') return list(']', depth);
    if (c == '(') return list(')', depth);
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::string_view(" \n\t,:()[]{}'\"").find(text_[at_]) == std::string_view::npos) ++at_;
    if (at_ == begin) return std::nullopt;
    const std::string word(text_.substr(begin, at_ - begin));
    const bool number = word.find_first_not_of("-0123456789") == std::string::npos;
    return Literal{number ? Literal::Kind::number : Literal::Kind::word, word, {}};
  }

  std::optional<Literal> quoted(char quote) {
    Literal result{Literal::Kind::text, {}, {}};
    for (++at_; at_ < text_.size() && text_[at_] != quote; ++at_) {
      if (text_[at_] == '\\' && ++at_ == text_.size()) return std::nullopt;
      result.text += text_[at_];
    }
    if (at_ == text_.size()) return std::nullopt;
    ++at_;
    return result;
  }

  std::optional<Literal> list(char end, int depth) {
    Literal result{Literal::Kind::list, {}, {}};
    ++at_;
    while (peek() != end) {
      auto item = read(depth + 1);
      if (!item) return std::nullopt;
      result.items.push_back(std::move(*item));
      const char c = peek();
      if (c == ',' || (c == ':' && end == '}')) {
        ++at_;
      } else if (c != end) {
        return std::nullopt;
      }
    }
    ++at_;
    return result;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

std::string text_of(const Literal& literal) {
  if (literal.kind != Literal::Kind::list) return literal.text;
  std::string text;
  for (const Literal& item : literal.items) text += (text.empty() ? "" : ", ") + text_of(item);
  return '(' + text + ')';
}

class HeaderReader {
 public:
  explicit HeaderReader(const std::string& file) : file_(file) {}

  NpyHeader read(std::string_view text) {
    LiteralReader reader(text);
    const auto dictionary = reader.whole();
    if (!dictionary || dictionary->kind != Literal::Kind::list) {
      fail("found a header that is no dictionary, at its byte " + std::to_string(reader.position() + 1) +
           ", expected 'descr', 'fortran_order' and 'shape'");
    }
    read_type(value(*dictionary, "descr"));
    const Literal& order = value(*dictionary, "fortran_order");
    if (order.kind != Literal::Kind::word || (order.text != "True" && order.text != "False")) {
      fail("found the fortran_order " + in_quotes(text_of(order)) + ", expected True or False");
    }
    header_.fortran = order.text == "True";
    read_shape(value(*dictionary, "shape"));
    return std::move(header_);
  }

  [[noreturn]] void fail(const std::string& message) const { refuse(file_, message); }

 private:
  const Literal& value(const Literal& dictionary, const std::string& key) const {
    for (std::size_t k = 0; k + 1 < dictionary.items.size(); k += 2) {
      const Literal& found = dictionary.items[k];
      if (found.kind == Literal::Kind::text && found.text == key) return dictionary.items[k + 1];
    }
    fail("found no '" + key + "' in the header of an array");
  }

  CellType type(const Literal& descr, const std::string& column) const {
    if (descr.kind == Literal::Kind::list) {
      fail(column + "found a type with fields of its own, expected a number or a text");
    }
    CellType type = cell_type(descr.text);
    if (type.name.find('O') != std::string::npos) {
      fail(column + "found Python objects (" + in_quotes(descr.text) +
           "), which only Python could read by running them, expected numbers, or texts as S or U");
    }
    if (type.size == 0 && type.kind != CellType::Kind::other) type.kind = CellType::Kind::other;
    if (type.size == 0 && !known_empty(type.name)) {
      fail(column + "found the type " + in_quotes(descr.text) + ", expected f8 or f4, an integer, S or U");
    }
    return type;
  }

  static bool known_empty(std::string_view name) { return name == "|S0" || name == "|V0" || name.ends_with("U0"); }

  void read_type(const Literal& descr) {
    if (descr.kind == Literal::Kind::text) {
      header_.fields.push_back({"", type(descr, ""), 0});
      header_.item = header_.fields[0].type.size;
      return;
    }
    if (descr.kind != Literal::Kind::list)
      fail("found the type " + in_quotes(text_of(descr)) + ", expected one like '<f8'");
    header_.structured = true;
    for (const Literal& field : descr.items) read_field(field);
  }

  /// ('name', '<f8'), or ('name', '<f8', (3,)); a name may be ('title', 'name').
  void read_field(const Literal& field) {
    if (field.kind != Literal::Kind::list || field.items.size() < 2 || field.items.size() > 3) {
      fail("found the field " + in_quotes(text_of(field)) + ", expected a name and a type");
    }
    const Literal& first = field.items[0];
    const bool titled = first.kind == Literal::Kind::list && first.items.size() == 2;
    const std::string name = titled ? first.items[1].text : first.text;
    NpyField result{name, type(field.items[1], name + ": "), header_.item};
    if (field.items.size() == 3) {
      result.type.kind = CellType::Kind::other;
      result.type.name += " " + text_of(field.items[2]);
      std::uint64_t size = result.type.size;
      for (const std::uint64_t n : shape(field.items[2])) {
        if (__builtin_mul_overflow(size, n, &size)) fail(name + ": found a shape that is too large");
      }
      result.type.size = size;
    }
    if (__builtin_add_overflow(header_.item, result.type.size, &header_.item)) fail("found items that are too large");
    header_.fields.push_back(std::move(result));
  }

  std::vector<std::uint64_t> shape(const Literal& literal) const {
    std::vector<std::uint64_t> sizes;
    if (literal.kind != Literal::Kind::list)
      fail("found the shape " + in_quotes(text_of(literal)) + ", expected a tuple");
    for (const Literal& item : literal.items) {
      std::uint64_t size = 0;
      const char* const end = item.text.data() + item.text.size();
      const auto [stop, error] = std::from_chars(item.text.data(), end, size);
      if (item.kind != Literal::Kind::number || stop != end || item.text.empty()) {
        fail("found the size " + in_quotes(text_of(item)) + " in the shape, expected a whole number from 0 on");
      }
      if (error != std::errc()) fail("found the shape " + in_quotes(text_of(literal)) + ", which is too large");
      sizes.push_back(size);
    }
    return sizes;
  }

  void read_shape(const Literal& literal) {
    header_.shape = shape(literal);
    for (const std::uint64_t size : header_.shape) {
      if (__builtin_mul_overflow(header_.items, size, &header_.items)) {
        fail("found the shape " + in_quotes(text_of(literal)) + ", which is too large");
      }
    }
  }

  const std::string& file_;
  NpyHeader header_;
};

}  // namespace

CellType cell_type(std::string_view name) {
  CellType type{CellType::Kind::other, 0, false, std::string(name)};
  if (name.size() < 2) return type;
  const bool order = std::string_view("<>|=").find(name[0]) != std::string_view::npos;
  const std::string_view rest = order ? name.substr(1) : name;
  const char letter = rest[0];
  std::size_t size = 0;
  const auto [end, error] = std::from_chars(rest.data() + 1, rest.data() + rest.size(), size);
  if (error != std::errc() || size > std::size_t{1} << 32U) return type;
  type.big_endian = name[0] == '>';
  type.size = letter == 'U' ? 4 * size : size;
  if (end != rest.data() + rest.size()) return type;
  const bool whole = size == 1 || size == 2 || size == 4 || size == 8;
  if (letter == 'f' && (size == 4 || size == 8)) type.kind = CellType::Kind::real;
  if (letter == 'i' && whole) type.kind = CellType::Kind::integer;
  if (letter == 'u' && whole) type.kind = CellType::Kind::natural;
  if (letter == 'S') type.kind = CellType::Kind::bytes;
  if (letter == 'U') type.kind = CellType::Kind::utf32;
  return type;
}

NpyHeader read_npy_header(ByteRun& run, std::uint64_t size, const std::string& file) {
  HeaderReader reader(file);
  const auto next = [&](std::size_t count) {
    std::string bytes(count, '\0');
    run.read(bytes.data(), count);
    return bytes;
  };
  const std::string begin = size < 12 ? std::string() : next(8);
  if (!begin.starts_with(npy_signature)) reader.fail("found no .npy array, expected one");
  const CellType count{CellType::Kind::natural, begin[6] == 1 ? std::size_t{2} : std::size_t{4}, false, {}};
  const auto length = static_cast<std::uint64_t>(integer_at(count, next(count.size).data()));
  const std::uint64_t start = begin.size() + count.size;
  if (length > size - start) reader.fail("found a header that is cut off");
  constexpr std::uint64_t longest = 1U << 20U;
  if (length > longest) reader.fail("found a header of " + std::to_string(length) + " bytes, expected at most 1048576");
  NpyHeader header = reader.read(next(static_cast<std::size_t>(length)));
  header.start = start + length;
  std::uint64_t expected = 0;
  const bool overflow = __builtin_mul_overflow(header.items, header.item, &expected);
  if (overflow || expected != size - header.start) {
    reader.fail("found " + std::to_string(size - header.start) + " bytes of data, expected " +
                std::to_string(header.items) + " items of " + std::to_string(header.item) + " bytes");
  }
  return header;
}

}  // namespace slipproof

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "records/certify/certify.hpp"

namespace slipproof {

namespace {

/// Builds the fixed part of a line without a call for each word.
class LineText {
 public:
  void put(std::string_view text) {
    std::memcpy(end_, text.data(), text.size());
    end_ += text.size();
  }
  void put(char c) { *end_++ = c; }
  void put(std::uint64_t x) {
    const fmt::format_int text(x);
    put(std::string_view(text.data(), text.size()));
  }
  void put_upper_bound(double x);

  void append_to(std::string& out) {
    out.append(text_.data(), static_cast<std::size_t>(end_ - text_.data()));
    end_ = text_.data();
  }

 private:
  std::array<char, 256> text_;  ///< the longest line has 190
  char* end_ = text_.data();
};

/// "1.3e-16": two digits, rounded up, as JSON text. printf and similar functions take longer than the whole judgement.
void LineText::put_upper_bound(double x) {
  constexpr int lowest = -40, highest = 4;
  if (!(x >= 1e-39 && x < 1e4)) {
    end_ = fmt::format_to(end_, "\"{:.3g}\"", x * 1.01);  // multiplying by 1.01 compensates for rounding to three
                                                          // digits, which takes away less than a hundredth
    return;
  }
  static const auto powers = [] {  // 10^(1 - e) for each possible exponent e
    std::array<double, highest - lowest + 1> result{};
    for (int e = lowest; e <= highest; ++e) result[static_cast<std::size_t>(e - lowest)] = std::pow(10.0, 1 - e);
    return result;
  }();
  const auto digits_at = [&](int e) {
    return static_cast<int>(std::ceil(x * powers[static_cast<std::size_t>(e - lowest)] * (1 + 0x1p-48)));
  };
  const int binary = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52U) - 1023;
  int exponent = (binary * 78913) >> 18;  // of the power of ten below 2^binary, by log10(2): right or one too low
  int digits = digits_at(exponent);
  if (digits >= 100) digits = digits_at(++exponent);
  const int size = std::abs(exponent);
  const auto digit = [](int d) { return static_cast<char>('0' + d); };
  const char text[] = {'"',
                       digit(digits / 10),
                       '.',
                       digit(digits % 10),
                       'e',
                       exponent < 0 ? '-' : '+',
                       digit(size / 10),
                       digit(size % 10),
                       '"'};
  put(std::string_view(text, sizeof text));
}

}  // namespace

void append_line(std::string& out, std::uint64_t record, const RecordJudgement& j) {
  using namespace std::literals;
  if (!j.members.empty()) {
    out += fmt::format("{{\"record\":{}{}}}\n", record, j.members);
    return;
  }
  LineText line;
  line.put("{\"record\":"sv);
  line.put(record);
  line.put(",\"verdict\":\""sv);
  line.put(name(j.verdict));
  line.put('"');
  if (j.verdict != RecordVerdict::invalid) {
    line.put(",\"modes\":["sv);
    if (!j.mode_names.empty()) {
      line.append_to(out);
      out += j.mode_names;
    }
    line.put(j.contact_problem ? "],\"solutions\":"sv : "],\"motions\":"sv);
    if (j.verdict == RecordVerdict::undecided || !j.counted) {
      line.put("null"sv);  // nobody has counted the motions
    } else {
      line.put(std::uint64_t{j.motions});
    }
    line.put(",\"max_relative_error\":"sv);
    if (j.mode_names.empty()) {
      line.put("null"sv);
    } else {
      line.put_upper_bound(j.max_error);
    }
    line.put(",\"tier\":\""sv);
    line.put(name(j.tier));
    line.put('"');
  }
  if (!j.details.empty()) {
    line.append_to(out);
    out += j.details;
  }
  line.put("}\n"sv);
  line.append_to(out);
}

}  // namespace slipproof

#include "proofs/statement/undecided.hpp"

#include <algorithm>

#include "base/number/parse.hpp"

namespace slipproof {

namespace {

constexpr std::string_view begins = "it is false at ", between = ", ", is = " = ";

}  // namespace

std::string undecided_text(const std::string& theorem, const std::vector<std::string>& reasons) {
  std::string text = "slipproof-undecided 1\ntheorem " + theorem + '\n';
  for (std::string reason : reasons) {
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    text += "because " + reason + '\n';
  }
  return text;
}

std::string at_numbers(const NamedValues& values) {
  std::string text;
  for (const auto& [name, value] : values) {
    text += (text.empty() ? "" : std::string(between)) + name + std::string(is) + value.str();
  }
  return text;
}

std::string false_at(const NamedValues& values) {
  return std::string(begins) + at_numbers(values);
}

std::optional<NamedValues> numbers_of(std::string_view undecided) {
  const std::string reason = "\nbecause " + std::string(begins);
  const std::size_t found = undecided.find(reason);
  if (found == undecided.npos) return std::nullopt;
  std::string_view rest = undecided.substr(found + reason.size());
  rest = rest.substr(0, rest.find('\n'));
  NamedValues values;
  while (!rest.empty()) {
    const std::string_view one = rest.substr(0, rest.find(between));
    rest.remove_prefix(std::min(rest.size(), one.size() + between.size()));
    const std::size_t equals = one.find(is);
    if (equals == one.npos) return std::nullopt;
    try {
      values.emplace_back(one.substr(0, equals), parse_rational(std::string(one.substr(equals + is.size()))));
    } catch (const NumberError&) {
      return std::nullopt;
    }
  }
  return values;
}

}  // namespace slipproof

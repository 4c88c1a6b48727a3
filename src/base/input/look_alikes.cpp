#include "base/input/look_alikes.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "base/input/utf8.hpp"

namespace slipproof {

namespace {

struct LookAlike {
  char32_t character;
  std::string_view ascii;
};
constexpr std::array<LookAlike, 25> look_alikes{
    {{0xa0, " "},      {0xb2, "^2"},   {0xb3, "^3"},       {0xb5, "mu"},  {0xb7, "*"},   {0xd7, "*"},   {0xf7, "/"},
     {0x3d1, "theta"}, {0x3d5, "phi"}, {0x3f5, "epsilon"}, {0x2009, " "}, {0x2010, "-"}, {0x2011, "-"}, {0x2012, "-"},
     {0x2013, "-"},    {0x2014, "-"},  {0x202f, " "},      {0x2044, "/"}, {0x2212, "-"}, {0x2215, "/"}, {0x2217, "*"},
     {0x22c5, "*"},    {0x2260, "!="}, {0x2264, "<="},     {0x2265, ">="}}};
/// From U+03B1 on.
constexpr std::array<std::string_view, 25> greek{
    "alpha", "beta",    "gamma", "delta", "epsilon", "zeta",  "eta", "theta",   "iota", "kappa", "lambda", "mu",   "nu",
    "xi",    "omicron", "pi",    "rho",   "sigma",   "sigma", "tau", "upsilon", "phi",  "chi",   "psi",    "omega"};
constexpr char32_t alpha = 0x3b1;

/// Of a character of this many bytes.
char32_t decoded(std::string_view bytes) {
  const auto byte = [&](std::size_t i) { return static_cast<char32_t>(static_cast<unsigned char>(bytes[i])); };
  constexpr std::array<char32_t, 5> masks{0, 0x7f, 0x1f, 0x0f, 0x07};
  char32_t code = byte(0) & masks[bytes.size()];
  for (std::size_t i = 1; i < bytes.size(); ++i) code = code << 6U | (byte(i) & 0x3fU);
  return code;
}

}  // namespace

std::string_view in_ascii(char32_t character) {
  if (character >= alpha && character < alpha + greek.size()) return greek[character - alpha];
  const auto found = std::ranges::find(look_alikes, character, &LookAlike::character);
  return found == look_alikes.end() ? std::string_view() : found->ascii;
}

std::optional<OddCharacter> first_odd_character(std::string_view text) {
  for (std::size_t position = 0; position < text.size();) {
    const std::size_t length = utf8_length(text.substr(position));
    if (length == 0) return std::nullopt;
    const std::string_view bytes = text.substr(position, length);
    if (length > 1) return OddCharacter{position, bytes, decoded(bytes)};
    position += length;
  }
  return std::nullopt;
}

std::string describe(const OddCharacter& character) {
  std::array<char, 16> code{};
  std::snprintf(code.data(), code.size(), "U+%04X", static_cast<unsigned>(character.code));
  const std::string_view ascii = in_ascii(character.code);
  if (ascii.empty()) return code.data();
  const std::string meant = ascii == " " ? "a blank" : "`" + std::string(ascii) + "`";
  return "`" + std::string(character.bytes) + "` (" + code.data() + "; write " + meant + ")";
}

}  // namespace slipproof

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

#include "report/html/headline.hpp"
#include "report/html/sections.hpp"

namespace slipproof {

namespace {

/// Text whose addresses and references are links.
void add_linked(const Element& parent, std::string_view text) {
  while (!text.empty()) {
    const std::size_t begin = std::min(text.find("https://"), text.find("http://"));
    add_reference(parent, text.substr(0, begin));
    if (begin == text.npos) return;
    text.remove_prefix(begin);
    std::size_t end = std::min(text.find_first_of(" \"<>"), text.size());
    const auto of_sentence = [&](char c) {
      return c == ')' ? text.substr(0, end).find('(') == text.npos : std::string_view(".,;:").find(c) != text.npos;
    };
    while (of_sentence(text[end - 1])) --end;
    const std::string address(text.substr(0, end));
    parent.add("a").set("href", address).text(address);
    text.remove_prefix(end);
  }
}

/// The claims about a line, as links.
void add_claims_of(const Element& item, const PageInput& input, std::size_t line) {
  const auto& claims = input.claims->claims;
  const Element list = item.add("span", "judged-by");
  std::size_t last = claims.size();
  for (const ClaimResult& result : input.result->claims) {
    const Claim& claim = claims[result.claim];
    if (claim.line != line || result.claim == last) continue;
    last = result.claim;
    list.text(" ");
    list.add("a").set("href", "#claim-" + claim.id).text(claim.id);
    list.text(" ");
    add_chip(list, verdict_name(result));
  }
}

}  // namespace

void add_source_line(const Element& parent, const PageInput& input, std::size_t line) {
  if (!input.source) return;
  const auto found = input.source->lines.find(line);
  if (found == input.source->lines.end()) return;
  const Element quote = parent.add("blockquote", "source-line");
  quote.add("a").set("href", "#source-" + std::to_string(line)).text("Line " + std::to_string(line));
  quote.text(" ");
  add_linked(quote, found->second);
}

void add_source_section(const Element& main, const PageInput& input) {
  if (!input.source) return;
  const Element section = add_section(main, "source", "What was judged");
  section.add("p", "lead").text("The lines that the claims refer to, each with its claims and their verdicts.");
  const Element list = section.add("ol", "source-lines");
  for (const auto& [number, text] : input.source->lines) {
    const Element item =
        list.add("li").set("id", "source-" + std::to_string(number)).set("value", static_cast<int>(number));
    add_linked(item, text);
    add_claims_of(item, input, number);
  }
  for (const std::string& paragraph : input.source->about) add_linked(section.add("p"), paragraph);
}

}  // namespace slipproof

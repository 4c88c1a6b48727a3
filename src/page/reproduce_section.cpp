#include "page/sections.hpp"

namespace slipproof {

void add_reproduce_section(const Element& main, const PageInput& input) {
  const Element section = add_section(main, "reproduce", "Reproduce");
  section.add("p", "lead")
      .text(
          "The same inputs, seed and version give the same bytes of this page, on any machine and "
          "at any number of threads.");
  section.add("pre").set("tabindex", 0).add("code").text(input.command);
  const Element facts = section.add("dl");
  const auto fact = [&](std::string_view term, const std::string& value) {
    facts.add("dt").text(term);
    facts.add("dd").text(value);
  };
  fact("version", "slipproof " + input.version);
  fact("seed", std::to_string(input.result->seed));
  fact("samples of each setting", std::to_string(input.result->samples));
  if (input.sources.empty()) return;
  const Element details = section.add("details", "data");
  details.add("summary").text("SHA-256 of the " + counted(input.sources.size(), "input"));
  const Element scroll = details.add("div", "scroll").set("tabindex", 0).set("role", "region");
  scroll.set("aria-label", "Inputs");
  const Element table = scroll.add("table", "inputs");
  const Element head = table.add("thead").add("tr");
  head.add("th").set("scope", "col").text("file");
  head.add("th").set("scope", "col").text("SHA-256");
  const Element body = table.add("tbody");
  for (const PageSource& source : input.sources) {
    const Element row = body.add("tr");
    row.add("th").set("scope", "row").text(source.name);
    row.add("td").add("code").text(source.sha256);
  }
}

}  // namespace slipproof

#include "report/engines/engine_sections.hpp"

namespace slipproof {

ReportCell EnginePageInput::with_design(const std::string& engine, ReportCell cell) const {
  return judged().designs.contains(engine) ? by_design(std::move(cell)) : cell;
}

Element add_title(const Element& main, const std::string& kicker, const std::string& title) {
  const Element section = main.add("section", "overview").set("id", "overview").set("aria-labelledby", "title");
  section.add("p", "kicker").text(kicker);
  section.add("h1").set("id", "title").text(title);
  return section;
}

void add_key(const Element& top) {
  const Element list = top.add("p", "how");
  for (std::size_t i = 0; i < engine_verdict_count; ++i) {
    const auto verdict = static_cast<EngineVerdict>(i);
    add_verdict(list, verdict, name(verdict));
    list.text(" ");
  }
}

}  // namespace slipproof

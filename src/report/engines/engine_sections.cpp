#include "report/engines/engine_sections.hpp"

namespace slipproof {

const std::string_view search_script =
    R"js("use strict";
document.querySelectorAll("input[type=search]").forEach(function (field) {
  const items = document.querySelectorAll("#" + field.dataset.list + " .item");
  field.parentElement.hidden = false;
  field.addEventListener("input", function () {
    const words = field.value.toLowerCase().split(/\s+/);
    items.forEach(function (item) {
      const text = item.textContent.toLowerCase();
      item.hidden = !words.every(function (word) { return text.includes(word); });
    });
  });
});
)js";

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

void add_search(const Element& section, const std::string& list, std::string_view label) {
  const Element line = section.add("p", "search").set("hidden", "hidden");
  line.add("input").set("type", "search").set("data-list", list).set("aria-label", label).set("placeholder", label);
}

}  // namespace slipproof

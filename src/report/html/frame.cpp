#include "report/html/frame.hpp"

#include "report/html/assets.hpp"
#include "report/picture/palette.hpp"

namespace slipproof {

const std::string_view search_script =
    R"js("use strict";
// Small letters without accents: "Painlevé" is found as "painleve".
const plain = function (text) { return text.toLowerCase().normalize("NFD").replace(/\p{M}/gu, ""); };
document.querySelectorAll("input[type=search]").forEach(function (field) {
  const items = document.querySelectorAll("#" + field.dataset.list + " .item");
  const count = field.parentElement.querySelector("output");
  field.parentElement.hidden = false;
  field.addEventListener("input", function () {
    const words = plain(field.value).split(/\s+/);
    let shown = 0;
    items.forEach(function (item) {
      const text = plain(item.textContent);
      item.hidden = !words.every(function (word) { return text.includes(word); });
      if (!item.hidden) shown += 1;
    });
    count.textContent = field.value.trim() ? shown + " of " + items.length : "";
  });
});
)js";

namespace {

void add_head(const Element& html, const PageFrame& frame) {
  const Element head = html.add("head");
  head.add("meta").set("charset", "utf-8");
  head.add("meta").set("name", "viewport").set("content", "width=device-width, initial-scale=1");
  head.add("meta").set("name", "color-scheme").set("content", "light dark");
  head.add("meta").set("name", "generator").set("content", "slipproof " + frame.version);
  // Prevents browsers from fetching an icon.
  head.add("link").set("rel", "icon").set("href", "data:,");
  head.add("title").text(frame.title);
  if (!frame.description.empty()) {
    head.add("meta").set("name", "description").set("content", frame.description);
    head.add("meta").set("property", "og:title").set("content", frame.title);
    head.add("meta").set("property", "og:description").set("content", frame.description);
    head.add("meta").set("property", "og:type").set("content", "article");
  }
  if (!frame.image.empty()) {
    head.add("meta").set("property", "og:image").set("content", frame.image);
    head.add("meta").set("name", "twitter:card").set("content", "summary_large_image");
  }
  head.add("style").code(std::string(assets::style_css) + picture_style());
}

void add_header(const Element& body, const PageFrame& frame) {
  body.add("a", "skip").set("href", frame.skip).text(frame.skip_words);
  const Element header = body.add("header", "top");
  header.add("a", "brand").set("href", frame.brand).text("slipproof");
  if (frame.links.empty()) return;
  const Element list = header.add("nav").set("aria-label", "Sections").add("ul");
  for (const auto& [target, words] : frame.links) list.add("li").add("a").set("href", target).text(words);
}

}  // namespace

std::string framed(const PageFrame& frame, const std::function<void(const Element& main)>& fill) {
  const ElementTree document("html");
  const Element html = document.root().set("lang", "en");
  add_head(html, frame);
  const Element body = html.add("body");
  add_header(body, frame);
  fill(body.add("main"));
  body.add("footer").add("p").text(frame.footer);
  if (!frame.script.empty()) body.add("script").code(frame.script);
  return document.html();
}

Element add_section(const Element& main, const char* id, std::string_view heading) {
  const Element section = main.add("section").set("id", id).set("aria-labelledby", std::string(id) + "-heading");
  section.add("h2").set("id", std::string(id) + "-heading").text(heading);
  return section;
}

void add_search(const Element& section, const std::string& list, std::string_view label) {
  const Element line = section.add("p", "search").set("hidden", "hidden");
  line.add("input").set("type", "search").set("data-list", list).set("aria-label", label).set("placeholder", label);
  line.text(" ");
  line.add("output").set("aria-live", "polite");
}

}  // namespace slipproof

#include "contact/imported/tags.hpp"

#include <algorithm>
#include <sstream>

#include "base/output/listed.hpp"

namespace slipproof::imported {

namespace {

Place place_of(std::string_view text, std::ptrdiff_t offset) {
  if (offset < 0) return {};
  const std::string_view before = text.substr(0, static_cast<std::size_t>(offset));
  const std::size_t line = static_cast<std::size_t>(std::ranges::count(before, '\n')) + 1;
  const std::size_t begin = before.rfind('\n');
  return {line, before.size() - (begin == std::string_view::npos ? 0 : begin + 1) + 1};
}

bool has(const std::vector<std::string_view>& list, std::string_view word) {
  return std::ranges::find(list, word) != list.end();
}

}  // namespace

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

TaggedFile::TaggedFile(std::string text, std::string file) : text_(std::move(text)), file_(std::move(file)) {
  const auto parsed = document_.load_buffer(text_.data(), text_.size());
  if (parsed.status == pugi::status_ok && root()) return;
  Mistakes mistakes(file_);
  mistakes.add(place_of(text_, parsed.offset), std::string("found no XML, expected it: ") + parsed.description());
  mistakes.refuse_if_any();
}

void TaggedFile::check(const Tags& tags, Scene& scene, Mistakes& mistakes) {
  left_out_.clear();
  check(root(), tags, scene, mistakes);
  for (const auto& [tag, lines] : left_out_) {
    scene.import_notes.push_back("left out: " + tag + " (line" + (lines.size() == 1 ? " " : "s ") +
                                 listed(lines, [](std::size_t line) { return std::to_string(line); }) + ")");
  }
}

void TaggedFile::check(pugi::xml_node node, const Tags& tags, Scene& scene, Mistakes& mistakes) {
  for (pugi::xml_node child = node.first_child(), next; child; child = next) {
    next = child.next_sibling();
    if (child.type() != pugi::node_element) continue;
    const std::string_view tag = child.name();
    const std::string found = "found <" + std::string(tag) + "> in <" + node.name() +
                              ">, which is not read and may exert a force, expected a file without it";
    if (has(tags.left_out, tag)) {
      left_out_[std::string(tag)].push_back(place(child).line);
      node.remove_child(child);
    } else if (has(tags.only_in_space, tag)) {
      const Place at = place(child);
      scene.only_in_space.push_back({at, found,
                                     "left out, though it may exert a force: " + std::string(tag) + " in " +
                                         node.name() + " " + node.attribute("name").value() + " (line " +
                                         std::to_string(at.line) + ")"});
      node.remove_child(child);
    } else if (tags.reads_all_others || has(tags.read, tag)) {
      check(child, tags, scene, mistakes);
    } else {
      mistakes.add(place(child), found);
    }
  }
}

Place TaggedFile::place(const pugi::xml_node& node) const {
  Place place = place_of(text_, node.offset_debug());
  if (place.column > 1) --place.column;  // pugixml points behind the <
  return place;
}

Place TaggedFile::place(std::string_view tag, std::string_view name) const {
  const auto found = document_.find_node(
      [&](const pugi::xml_node& node) { return node.name() == tag && node.attribute("name").value() == name; });
  return found ? place(found) : Place{};
}

std::string TaggedFile::rest() const {
  std::ostringstream text;
  document_.save(text);
  return text.str();
}

}  // namespace slipproof::imported

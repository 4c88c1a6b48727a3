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

TaggedFile::TaggedFile(std::string text, std::string file) : text_(std::move(text)), file_(std::move(file)) {
  const auto parsed = document_.load_buffer(text_.data(), text_.size());
  if (parsed.status == pugi::status_ok && root()) return;
  Mistakes mistakes(file_);
  mistakes.add(place_of(text_, parsed.offset), std::string("found no XML, expected it: ") + parsed.description());
  mistakes.refuse_if_any();
}

std::vector<std::string> TaggedFile::check(const Tags& tags, Mistakes& mistakes) {
  left_out_.clear();
  check(root(), tags, mistakes);
  std::vector<std::string> import_notes;
  for (const auto& [tag, lines] : left_out_) {
    import_notes.push_back("left out: " + tag + " (line" + (lines.size() == 1 ? " " : "s ") +
                           listed(lines, [](std::size_t line) { return std::to_string(line); }) + ")");
  }
  return import_notes;
}

void TaggedFile::check(pugi::xml_node node, const Tags& tags, Mistakes& mistakes) {
  for (pugi::xml_node child = node.first_child(), next; child; child = next) {
    next = child.next_sibling();
    if (child.type() != pugi::node_element) continue;
    const std::string_view tag = child.name();
    if (has(tags.left_out, tag)) {
      left_out_[std::string(tag)].push_back(place(child).line);
      node.remove_child(child);
    } else if (tags.reads_all_others || has(tags.read, tag)) {
      check(child, tags, mistakes);
    } else {
      mistakes.add(place(child), "found <" + std::string(tag) + "> in <" + node.name() +
                                     ">, which is not read and may exert a force, expected a file without it");
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

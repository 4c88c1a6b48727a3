#include "report/markup/element.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <stdexcept>

#include "base/input/utf8.hpp"
#include "report/markup/number.hpp"

namespace slipproof {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

/// True unless HTML calls it a control character or noncharacter.
bool allowed(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 1) {
    return (byte(0) >= 0x20 && byte(0) != 0x7F) || character == "\n" || character == "\t";
  }
  if (character.size() == 2) return byte(0) != 0xC2 || byte(1) >= 0xA0;
  if (character.size() == 3) return !(byte(0) == 0xEF && byte(1) == 0xBF && byte(2) >= 0xBE);
  return true;
}

std::string clean(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    result += length != 0 && allowed(character) ? character : replacement;
    text.remove_prefix(character.size());
  }
  return result;
}

bool one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether HTML writes the element without an end tag.
bool is_void(std::string_view name) {
  return one_of(name, {"meta", "link", "br", "hr", "input", "img", "col", "wbr"});
}

/// Whether the children of the element may be on lines of their own.
bool is_block(std::string_view name) {
  return one_of(name,
                {"html", "head", "body",  "main",  "header", "footer", "nav",     "section", "article", "div", "ul",
                 "ol",   "dl",   "table", "thead", "tbody",  "tr",     "details", "figure",  "svg",     "g",   "defs"});
}

/// Adds line breaks. For HTML, also adds an empty text to each empty element, so that pugixml writes its end tag.
void prepare(pugi::xml_node node, bool html) {
  const std::string_view name = node.name();
  if (html && !node.first_child() && !is_void(name)) node.append_child(pugi::node_pcdata);
  const bool block = is_block(name);
  const bool inside_html = html && !one_of(name, {"svg", "math"});
  for (pugi::xml_node child = node.first_child(); child; child = child.next_sibling()) {
    if (child.type() != pugi::node_element) continue;
    if (block) node.insert_child_before(pugi::node_pcdata, child).set_value("\n");
    prepare(child, inside_html);
  }
}

struct StringWriter : pugi::xml_writer {
  std::string text;
  void write(const void* data, std::size_t size) override { text.append(static_cast<const char*>(data), size); }
};

std::string written(const pugi::xml_document& tree, bool html) {
  pugi::xml_document copy;
  copy.reset(tree);
  prepare(copy.document_element(), html);
  StringWriter writer;
  copy.document_element().print(writer, "", pugi::format_raw, pugi::encoding_utf8);
  return std::move(writer.text);
}

}  // namespace

Element Element::add(const char* name) const {
  return Element(pugi::xml_node(node_).append_child(name).internal_object());
}

Element Element::add(const char* name, std::string_view css_class) const {
  return add(name).set("class", css_class);
}

Element Element::set(const char* attribute, std::string_view value) const {
  pugi::xml_node node(node_);
  pugi::xml_attribute there = node.attribute(attribute);
  (there ? there : node.append_attribute(attribute)).set_value(clean(value).c_str());
  return *this;
}

Element Element::set(const char* attribute, int value) const {
  return set(attribute, std::string_view(std::to_string(value)));
}

Element Element::set(const char* attribute, double value) const {
  return set(attribute, std::string_view(short_number(value)));
}

Element Element::text(std::string_view text) const {
  pugi::xml_node(node_).append_child(pugi::node_pcdata).set_value(clean(text).c_str());
  return *this;
}

Element Element::code(std::string_view code) const {
  pugi::xml_node node(node_);
  const bool style = std::string_view(node.name()) == "style";
  if (code.find("</") != code.npos || code.find("<!--") != code.npos || code.find("]]>") != code.npos) {
    throw std::invalid_argument("a script or style must not contain </, <!-- or ]]>");
  }
  node.append_child(pugi::node_pcdata).set_value(style ? "/*" : "//");
  const std::string inside = (style ? "*/\n" : "\n") + std::string(code) + (style ? "\n/*" : "\n//");
  node.append_child(pugi::node_cdata).set_value(inside.c_str());
  if (style) node.append_child(pugi::node_pcdata).set_value("*/");
  return *this;
}

Element Element::add(const Element& other) const {
  return Element(pugi::xml_node(node_).append_copy(pugi::xml_node(other.node_)).internal_object());
}

Element Element::add_children_of(const Element& other) const {
  for (const pugi::xml_node child : pugi::xml_node(other.node_).children()) pugi::xml_node(node_).append_copy(child);
  return *this;
}

std::string Element::xml() const {
  pugi::xml_document own;
  own.append_copy(pugi::xml_node(node_));
  return written(own, false);
}

ElementTree::ElementTree(const char* root) : tree_(std::make_unique<pugi::xml_document>()) {
  tree_->append_child(root);
}
ElementTree::~ElementTree() = default;
ElementTree::ElementTree(ElementTree&&) noexcept = default;
ElementTree& ElementTree::operator=(ElementTree&&) noexcept = default;

Element ElementTree::root() const {
  return Element(tree_->document_element().internal_object());
}

std::string ElementTree::html() const {
  return "<!DOCTYPE html>\n" + written(*tree_, true) + "\n";
}

std::string ElementTree::xml() const {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + written(*tree_, false) + "\n";
}

}  // namespace slipproof
